#include <algorithm>

#include "plugin/contact_law.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class SlipWeakening : public FrictionLaw {
 public:
  explicit SlipWeakening(Params& params)
      : mu_s_(params.slot("mu_s")), mu_d_(params.slot("mu_d")), distance_(params.slot("distance")) {}

  bool constant() const override { return false; }
  std::string origin() const override { return "slip_weakening"; }
  Friction friction(Values values, const ContactState& contact) const override {
    double& slip = contact.history[0];
    if (contact.was_sticking == 0) slip += contact.slip_speed * contact.step;
    const double worn = std::min(slip / values[distance_], 1.0);
    const double mu = values[mu_s_] + worn * (values[mu_d_] - values[mu_s_]);
    return {mu, mu};
  }

 private:
  int mu_s_, mu_d_, distance_;
};

}  // namespace

std::unique_ptr<FrictionLaw> make_slip_weakening(Params& params) {
  return std::make_unique<SlipWeakening>(params);
}

}  // namespace flyrock::plugins
