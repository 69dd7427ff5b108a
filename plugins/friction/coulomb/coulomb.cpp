#include <cmath>

#include "plugin/contact_law.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Coulomb : public FrictionLaw {
 public:
  explicit Coulomb(Params& params) : mu_(params.slot("mu")), angle_(params.slot("angle")) {
    if ((mu_ < 0) == (angle_ < 0)) throw PluginError("plugin coulomb: expected either `mu` or `angle`");
  }

  bool constant() const override { return true; }
  std::string origin() const override { return "coulomb"; }
  Friction friction(Values values, const ContactState&) const override {
    const double mu = mu_ >= 0 ? values[mu_] : std::tan(values[angle_]);
    return {mu, mu};
  }

 private:
  int mu_, angle_;
};

}  // namespace

std::unique_ptr<FrictionLaw> make_coulomb(Params& params) { return std::make_unique<Coulomb>(params); }

}  // namespace flyrock::plugins
