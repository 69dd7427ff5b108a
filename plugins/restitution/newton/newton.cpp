#include <fmt/format.h>

#include "plugin/contact_law.h"
#include "plugins/factories.h"

namespace flyrock::plugins {

namespace {

class Newton : public RestitutionLaw {
 public:
  explicit Newton(Params& params)
      : e_n_(params.slot("en")),
        e_t_(params.slot("et")),
        as_lmgc90_(params.slot("as_lmgc90")),
        form_(*restitution_form(params.text("form"))) {
    if (form_ == RestitutionForm::newton) return;
    for (const auto& [name, slot] : {std::pair("et", e_t_), std::pair("as_lmgc90", as_lmgc90_)})
      if (slot >= 0)
        throw PluginError(fmt::format("plugin newton: `{}` belongs to the form newton; the form {} has none",
                                      name, name_of(form_)));
  }

  bool constant() const override { return true; }
  std::string origin() const override { return "newton"; }
  Restitution impact(Values values, const ContactState&) const override {
    return {values[e_n_], e_t_ >= 0 ? values[e_t_] : 0, form_, as_lmgc90_ >= 0 && values[as_lmgc90_] != 0};
  }

 private:
  int e_n_, e_t_, as_lmgc90_;
  RestitutionForm form_;
};

}  // namespace

std::unique_ptr<RestitutionLaw> make_newton(Params& params) { return std::make_unique<Newton>(params); }

}  // namespace flyrock::plugins
