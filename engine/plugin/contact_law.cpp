#include "plugin/contact_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace flyrock {

namespace {

void require(bool fine, const Law& law, std::string_view entry, std::string_view name, double value,
             std::string_view expected) {
  if (!fine)
    throw PluginError(
        fmt::format("plugin {}: {}() returned {} = {:.6g}, must be {}", law.origin(), entry, name, value, expected));
}

}  // namespace

namespace {
constexpr std::array<std::string_view, 5> form_names = {"newton", "newton_mean", "poisson", "energy", "velocity"};
}

std::string_view name_of(RestitutionForm form) { return form_names[static_cast<std::size_t>(form)]; }

std::optional<RestitutionForm> restitution_form(std::string_view name) {
  const auto found = std::find(form_names.begin(), form_names.end(), name);
  if (found == form_names.end()) return std::nullopt;
  return static_cast<RestitutionForm>(found - form_names.begin());
}

const std::vector<ContactField>& contact_fields() {
  static const std::vector<ContactField> fields{
      {"approach_speed", &ContactState::approach_speed, {}},
      {"slip_speed", &ContactState::slip_speed, {}},
      {"impact_angle", &ContactState::impact_angle, {}},
      {"gap", &ContactState::gap, {}},
      {"effective_mass", &ContactState::effective_mass, {}},
      {"mass", &ContactState::mass, {}},
      {"radius", &ContactState::radius, {}},
      {"spin", &ContactState::spin, {}},
      {"kinetic_energy", &ContactState::kinetic_energy, {}},
      {"length", &ContactState::length, {}},
      {"age", &ContactState::age, {}},
      {"was_sticking", &ContactState::was_sticking, {}},
      {"impact_number", &ContactState::impact_number, {}},
      {"time", &ContactState::time, {}},
      {"group_a", {}, &ContactState::group_a},
      {"group_b", {}, &ContactState::group_b},
      {"material", {}, &ContactState::material},
  };
  return fields;
}

void check_answer(const Law& law, const Restitution& answer) {
  require(std::isfinite(answer.e_n), law, "impact", "e_n", answer.e_n, "finite");
  require(answer.e_n >= 0, law, "impact", "e_n", answer.e_n, "at least 0");
  require(std::isfinite(answer.e_t), law, "impact", "e_t", answer.e_t, "finite");
  require(std::abs(answer.e_t) <= 1, law, "impact", "e_t", answer.e_t, "from -1 to 1");
}

void check_answer(const Law& law, const Friction& answer) {
  require(std::isfinite(answer.mu_s), law, "friction", "mu_s", answer.mu_s, "finite");
  require(answer.mu_s >= 0, law, "friction", "mu_s", answer.mu_s, "at least 0");
  require(std::isfinite(answer.mu_d), law, "friction", "mu_d", answer.mu_d, "finite");
  require(answer.mu_d >= 0, law, "friction", "mu_d", answer.mu_d, "at least 0");
  require(answer.mu_d <= answer.mu_s, law, "friction", "mu_d", answer.mu_d, "at most mu_s");
}

void check_rolling(const Law& law, double mu_r) {
  require(std::isfinite(mu_r), law, "rolling", "mu_r", mu_r, "finite");
  require(mu_r >= 0, law, "rolling", "mu_r", mu_r, "at least 0");
}

}  // namespace flyrock
