#include "plugin/module.h"

namespace {

/// Newton's law with a constant e_n.
class MyRestitution : public flyrock::RestitutionLaw {
 public:
  explicit MyRestitution(flyrock::Params& params) : en_(params.slot("en")) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "my_restitution"; }
  flyrock::Restitution impact(flyrock::Values values, const flyrock::ContactState&) const override {
    return {values[en_], 0, flyrock::RestitutionForm::newton, false};
  }

 private:
  int en_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::restitution, "my_restitution"}] = flyrock::FactoryOf<flyrock::RestitutionLaw>(
      [](flyrock::Params& params) { return std::make_unique<MyRestitution>(params); });
  return nullptr;
}
