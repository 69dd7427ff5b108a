#include "plugin/module.h"

namespace {

/// A contact that holds against a pull, 0 <= gap, r_n >= -pull, as clay sticks.
class MyCondition : public flyrock::UnilateralLaw {
 public:
  explicit MyCondition(flyrock::Params& params) : pull_(params.slot("pull")) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "my_condition"; }
  flyrock::Unilateral condition(flyrock::Values values, const flyrock::ContactState&) const override {
    return {flyrock::NormalCondition::cohesive, {}, values[pull_]};
  }

 private:
  int pull_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::unilateral, "my_condition"}] = flyrock::FactoryOf<flyrock::UnilateralLaw>(
      [](flyrock::Params& params) { return std::make_unique<MyCondition>(params); });
  return nullptr;
}
