#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Newton : public RestitutionLaw {
 public:
  explicit Newton(Params& params) : e_n_(params.slot("en")), e_t_(params.slot("et")) {}

  bool constant() const override { return true; }
  std::string origin() const override { return "newton"; }
  Restitution impact(Values values, const ContactState&) const override {
    return {values[e_n_], values[e_t_]};
  }

 private:
  int e_n_, e_t_;
};

}  // namespace

std::unique_ptr<RestitutionLaw> make_newton(Params& params) { return std::make_unique<Newton>(params); }

}  // namespace flyrock::plugins
