#include "plugin/contact_law.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Penalty : public UnilateralLaw {
 public:
  explicit Penalty(Params& params)
      : stiffness_(params.slot("stiffness")),
        damping_(params.slot("damping")),
        exponent_(params.slot("exponent")),
        tangential_stiffness_(params.slot("tangential_stiffness")) {}

  bool constant() const override { return true; }
  std::string origin() const override { return "penalty"; }
  Unilateral condition(Values values, const ContactState&) const override {
    const Spring spring{values[stiffness_], values[damping_], values[exponent_],
                        values[tangential_stiffness_]};
    return {NormalCondition::penalty, spring, 0};
  }

 private:
  int stiffness_, damping_, exponent_, tangential_stiffness_;
};

}  // namespace

std::unique_ptr<UnilateralLaw> make_penalty(Params& params) { return std::make_unique<Penalty>(params); }

}  // namespace flyrock::plugins
