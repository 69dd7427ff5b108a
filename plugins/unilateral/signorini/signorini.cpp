#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Signorini : public UnilateralLaw {
 public:
  bool constant() const override { return true; }
  std::string origin() const override { return "signorini"; }
  NormalCondition condition(Values, const ContactState&) const override { return NormalCondition::signorini; }
};

}  // namespace

std::unique_ptr<UnilateralLaw> make_signorini(Params&) { return std::make_unique<Signorini>(); }

}  // namespace flyrock::plugins
