#include "plugin/contact_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace flyrock {

namespace {

constexpr std::array<std::string_view, 5> form_names = {"newton", "newton_mean", "poisson", "energy",
                                                        "velocity"};
constexpr std::array<std::string_view, 4> condition_names = {"signorini", "quasi_shock", "cohesive",
                                                             "penalty"};

template <class Kind, std::size_t n>
std::optional<Kind> find_name(const std::array<std::string_view, n>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Kind>(found - names.begin());
}

/// Checks the numbers of one answer.
class Answer {
 public:
  Answer(const Law& law, std::string_view entry) : law_(law), entry_(entry) {}

  void require(bool fine, std::string_view name, double value, std::string_view expected) const {
    if (!fine) refuse(name, value, expected);
  }
  [[noreturn]] void refuse(std::string_view name, double value, std::string_view expected) const {
    if (std::isnan(value)) value = std::abs(value);  // the sign of NaN differs between machines
    throw PluginError(fmt::format("plugin {}: {}() returned {} = {:.6g}, must be {}", law_.origin(), entry_,
                                  name, value, expected));
  }
  void not_negative(std::string_view name, double value) const {
    require(std::isfinite(value), name, value, "finite");
    require(value >= 0, name, value, "at least 0");
  }

 private:
  const Law& law_;
  std::string_view entry_;
};

}  // namespace

std::string_view name_of(RestitutionForm form) { return form_names[static_cast<std::size_t>(form)]; }
std::optional<RestitutionForm> restitution_form(std::string_view name) {
  return find_name<RestitutionForm>(form_names, name);
}
std::string_view name_of(NormalCondition condition) {
  return condition_names[static_cast<std::size_t>(condition)];
}
std::optional<NormalCondition> normal_condition(std::string_view name) {
  return find_name<NormalCondition>(condition_names, name);
}

void set_on_level_ground(ContactState& contact, int dimension) {
  contact.dimension = dimension;
  contact.normal = Vec3::Unit(dimension - 1);
  contact.slip = contact.slip_speed * Vec3::UnitX();
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
      {"area", &ContactState::area, {}},
      {"age", &ContactState::age, {}},
      {"pair_age", &ContactState::pair_age, {}},
      {"was_sticking", &ContactState::was_sticking, {}},
      {"impact_number", &ContactState::impact_number, {}},
      {"time", &ContactState::time, {}},
      {"step", &ContactState::step, {}},
      {"normal", {}, {}, &ContactState::normal},
      {"place", {}, {}, &ContactState::place},
      {"slip", {}, {}, &ContactState::slip},
      {"group_a", {}, &ContactState::group_a},
      {"group_b", {}, &ContactState::group_b},
      {"material", {}, &ContactState::material},
  };
  return fields;
}

void check_answer(const Law& law, const Restitution& answer) {
  const Answer impact(law, "impact");
  impact.not_negative("e_n", answer.e_n);
  impact.require(std::isfinite(answer.e_t), "e_t", answer.e_t, "finite");
  const bool has_e_t = answer.form == RestitutionForm::newton || answer.form == RestitutionForm::velocity;
  if (!has_e_t && answer.e_t != 0)
    impact.refuse("e_t", answer.e_t,
                  fmt::format("0: the form {} has no tangential restitution", name_of(answer.form)));
}

void check_answer(const Law& law, const Friction& answer) {
  const Answer friction(law, "friction");
  friction.not_negative("mu_s", answer.mu_s);
  friction.not_negative("mu_d", answer.mu_d);
  friction.require(answer.mu_d <= answer.mu_s, "mu_d", answer.mu_d, "at most mu_s");
  friction.not_negative("c_n", answer.c_n);
  friction.not_negative("c_t", answer.c_t);
  if (!(answer.c_t >= answer.mu_s * answer.c_n * (1 - 1e-12)))
    friction.refuse(
        "c_t", answer.c_t,
        fmt::format(
            "at least mu_s c_n = {:.6g}: a pull c_n beyond c_t / mu_s is outside the cone of friction",
            answer.mu_s * answer.c_n));
}

void check_answer(const Law& law, const Rolling& answer) {
  const Answer rolling(law, "rolling");
  rolling.not_negative("mu_r", answer.mu_r);
  rolling.not_negative("mu_spin", answer.mu_spin);
}

void check_answer(const Law& law, const Unilateral& answer) {
  const Answer condition(law, "condition");
  if (answer.condition == NormalCondition::penalty) {
    const Spring& spring = answer.spring;
    condition.not_negative("a stiffness", spring.stiffness);
    condition.require(spring.stiffness > 0, "a stiffness", spring.stiffness, "above 0");
    condition.not_negative("a damping", spring.damping);
    condition.require(spring.exponent >= 1 && spring.exponent <= 1.5, "an exponent", spring.exponent,
                      "from 1 to 1.5");
    condition.not_negative("a tangential stiffness", spring.tangential_stiffness);
  }
  condition.not_negative("a pull", answer.pull);
}

}  // namespace flyrock
