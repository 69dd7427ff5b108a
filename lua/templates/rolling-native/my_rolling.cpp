#include "plugin/module.h"

namespace {

/// Rolling resistance whose arm is a share of the radius of the rock.
class MyRolling : public flyrock::RollingLaw {
 public:
  explicit MyRolling(flyrock::Params& params) : share_(params.slot("share")) {}
  bool constant() const override { return false; }  // it reads the contact
  std::string origin() const override { return "my_rolling"; }
  /// mu_r and mu_spin [m].
  flyrock::Rolling rolling(flyrock::Values values, const flyrock::ContactState& contact) const override {
    return {values[share_] * contact.radius, 0};
  }

 private:
  int share_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::rolling, "my_rolling"}] = flyrock::FactoryOf<flyrock::RollingLaw>(
      [](flyrock::Params& params) { return std::make_unique<MyRolling>(params); });
  return nullptr;
}
