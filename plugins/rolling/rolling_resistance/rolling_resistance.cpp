#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class RollingResistance : public RollingLaw {
 public:
  explicit RollingResistance(Params& params) : mu_r_(params.slot("mu_r")), mu_spin_(params.slot("mu_spin")) {}

  bool constant() const override { return true; }
  std::string origin() const override { return "rolling_resistance"; }
  Rolling rolling(Values values, const ContactState&) const override {
    return {values[mu_r_], values[mu_spin_]};
  }

 private:
  int mu_r_, mu_spin_;
};

}  // namespace

std::unique_ptr<RollingLaw> make_rolling_resistance(Params& params) {
  return std::make_unique<RollingResistance>(params);
}

}  // namespace flyrock::plugins
