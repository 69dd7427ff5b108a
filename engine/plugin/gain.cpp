#include "plugin/gain.h"

#include <fmt/format.h>

#include <cmath>

#include "plugin/contact_law.h"

namespace flyrock {

namespace {

/// A law that may not answer with more than 1.
class LimitedRestitution : public RestitutionLaw {
 public:
  explicit LimitedRestitution(std::unique_ptr<RestitutionLaw> law) : law_(std::move(law)) {}

  bool constant() const override { return law_->constant(); }
  std::string origin() const override { return law_->origin(); }
  Restitution impact(Values values, const ContactState& contact) const override {
    const Restitution answer = law_->impact(values, contact);
    if (answer.e_n > 1 && std::isfinite(answer.e_n)) refuse("e_n", answer.e_n, "at most 1");
    if (std::abs(answer.e_t) > 1 && std::isfinite(answer.e_t)) refuse("e_t", answer.e_t, "from -1 to 1");
    return answer;
  }

 private:
  [[noreturn]] void refuse(std::string_view name, double value, std::string_view expected) const {
    throw PluginError(
        fmt::format("plugin {}: impact() returned {} = {:.6g}, must be {}: the impact would gain "
                    "energy, which `{}: true` among the law's parameters permits",
                    law_->origin(), name, value, expected, allow_gain));
  }

  std::unique_ptr<RestitutionLaw> law_;
};

}  // namespace

void add_allow_gain(PluginSpec& spec) {
  ParamSpec allows;
  allows.name = allow_gain;
  allows.type = ParamType::boolean;
  allows.optional = true;
  allows.doc = "permits more than 1: such an impact gains energy";
  spec.params.push_back(std::move(allows));
}

bool is_limit_of_gain(const PluginSpec& spec, const ParamSpec& param) {
  return spec.kind == PluginKind::restitution && spec.find(allow_gain) >= 0 &&
         param.type == ParamType::number && param.dimension == dimension::none && param.max == 1.0;
}

void limit_gain(Plugin& plugin) {
  auto* make = std::get_if<FactoryOf<RestitutionLaw>>(&plugin.make);
  if (!make || plugin.spec.find(allow_gain) < 0) return;
  *make = [make = *make](Params& params) -> std::unique_ptr<RestitutionLaw> {
    auto law = make(params);
    if (params.slot(allow_gain) >= 0 && params.constant(allow_gain) != 0) return law;
    return std::make_unique<LimitedRestitution>(std::move(law));
  };
}

}  // namespace flyrock
