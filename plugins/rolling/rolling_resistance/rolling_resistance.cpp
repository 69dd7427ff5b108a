#include "plugin/contact_law.h"
#include "plugin/pivoting.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class RollingResistance : public RollingLaw {
 public:
  explicit RollingResistance(Params& params)
      : mu_r_(params.slot("mu_r")), share_(params.slot("share")), mu_spin_(params.slot("mu_spin")) {
    if ((mu_r_ < 0) == (share_ < 0))
      throw PluginError("plugin rolling_resistance: expected either `mu_r` or `share`");
  }

  bool constant() const override { return share_ < 0; }
  std::string origin() const override { return "rolling_resistance"; }
  Rolling rolling(Values values, const ContactState& contact) const override {
    const double mu_r = mu_r_ >= 0 ? values[mu_r_] : values[share_] * contact.radius;
    return {mu_r, mu_spin_ >= 0 ? values[mu_spin_] : usual_mu_spin(mu_r)};
  }

 private:
  int mu_r_, share_, mu_spin_;
};

}  // namespace

std::unique_ptr<RollingLaw> make_rolling_resistance(Params& params) {
  return std::make_unique<RollingResistance>(params);
}

}  // namespace flyrock::plugins
