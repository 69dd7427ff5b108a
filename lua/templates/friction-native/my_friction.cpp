#include "plugin/module.h"

namespace {

/// Dry friction |r_t| <= mu r_n.
class MyFriction : public flyrock::FrictionLaw {
 public:
  explicit MyFriction(flyrock::Params& params) : mu_(params.slot("mu")) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "my_friction"; }
  /// mu_s and mu_d.
  flyrock::Friction friction(flyrock::Values values, const flyrock::ContactState&) const override {
    return {values[mu_], values[mu_]};
  }

 private:
  int mu_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::friction, "my_friction"}] = flyrock::FactoryOf<flyrock::FrictionLaw>(
      [](flyrock::Params& params) { return std::make_unique<MyFriction>(params); });
  return nullptr;
}
