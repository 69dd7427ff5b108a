#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Penalty : public UnilateralLaw {
 public:
  explicit Penalty(Params& params) : stiffness_(params.slot("stiffness")) {}

  bool constant() const override { return true; }
  std::string origin() const override { return "penalty"; }
  Unilateral condition(Values values, const ContactState&) const override {
    return {NormalCondition::penalty, values[stiffness_], 0};
  }

 private:
  int stiffness_;
};

}  // namespace

std::unique_ptr<UnilateralLaw> make_penalty(Params& params) { return std::make_unique<Penalty>(params); }

}  // namespace flyrock::plugins
