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
  contact.shape_type = dimension == 2 ? "disk" : "sphere";
  if (dimension == 3) contact.shape_flatness = 1;
}

std::string_view ContactField::table() const {
  const std::size_t dot = name.find('.');
  return dot == name.npos ? std::string_view() : name.substr(0, dot);
}
std::string_view ContactField::own_name() const {
  return table().empty() ? name : name.substr(table().size() + 1);
}
std::string ContactField::read_name() const {
  return fmt::format("contact.{}", table().empty() ? name : table());
}

const std::vector<ContactField>& contact_fields() {
  using State = ContactState;
  static const std::vector<ContactField> fields{
      {"approach_speed", "m/s", "speed at which the bodies approach; 0 if they separate",
       &State::approach_speed},
      {"slip_speed", "m/s", "magnitude of the tangential velocity", &State::slip_speed},
      {"impact_angle", "rad", "from the surface: pi/2 is a normal impact", &State::impact_angle},
      {"gap", "m", "distance; below 0: penetration", &State::gap},
      {"effective_mass", "kg", "1/W_nn", &State::effective_mass},
      {"mass", "kg", "of the rock", &State::mass},
      {"radius", "m", "of the sphere (2D: disk) of equal volume (area)", &State::radius},
      {"spin", "rad/s", "of the rock", &State::spin},
      {"kinetic_energy", "J", "of the rock", &State::kinetic_energy},
      {"length", "m", "share of a face that this contact point stands for; 2D", &State::length},
      {"area", "m2", "the same as an area", &State::area},
      {"age", "s", "since the contact closed", &State::age},
      {"pair_age", "s", "greatest age of the contacts of its pair", &State::pair_age},
      {"was_sticking", "", "1 if the contact stuck in the last step, otherwise 0", &State::was_sticking},
      {"impact_number", "", "impacts of the rock so far, this one included; from 1", &State::impact_number},
      {"time", "s", "since the start of the trial", &State::time},
      {"step", "s", "length of this step; 0 for an impact", &State::step},
      {.name = "normal_force",
       .unit = "N",
       .doc = "of the last step; nil when the contact closes and at impacts",
       .number = &State::normal_force,
       .only_if_read = true},
      {.name = "points",
       .unit = "",
       .doc = "contact points of the pair with this normal, this one included",
       .number = &State::points,
       .only_if_read = true},
      {.name = "shape.type",
       .unit = "",
       .doc = "name of the rock's shape: \"polygon\"; of a shape that a population gives, the population's",
       .text = &State::shape_type,
       .only_if_read = true},
      {.name = "shape.elongation",
       .unit = "",
       .doc = "intermediate (2D: shorter) axis of the rock over its longest, by its moments of inertia",
       .number = &State::shape_elongation,
       .only_if_read = true},
      {.name = "shape.flatness",
       .unit = "",
       .doc = "its shortest axis over the intermediate one; nil in 2D",
       .number = &State::shape_flatness,
       .only_if_read = true},
      {.name = "shape.corners",
       .unit = "",
       .doc = "number of its corners, rounded ones too; 0 of disks, spheres, pills and bodies with rims",
       .number = &State::shape_corners,
       .only_if_read = true},
      {.name = "partner.mass",
       .unit = "kg",
       .doc = "of the other body; nil if contacts do not move it, as the terrain",
       .number = &State::partner_mass,
       .only_if_read = true},
      {.name = "partner.radius",
       .unit = "m",
       .doc = "the same as `radius`, of the other body; nil of the terrain",
       .number = &State::partner_radius,
       .only_if_read = true},
      {.name = "partner.moves",
       .unit = "",
       .doc = "whether contacts move the other body: false of the terrain, of fixed and driven bodies",
       .flag = &State::partner_moves,
       .only_if_read = true},
      {.name = "slip_length",
       .unit = "m",
       .doc = "way that the contact has slipped since it closed; 0 for features that touch anew",
       .number = &State::slip_length,
       .only_if_read = true},
      {"normal", "", "unit vector towards the rock", {}, {}, &State::normal},
      {"place", "m", "contact point in the coordinates of the scenario", {}, {}, &State::place},
      {"slip", "m/s", "tangential velocity of the rock", {}, {}, &State::slip},
      {"group_a", "", "name of the rock's group or body", {}, &State::group_a},
      {"group_b", "", "the other body; of the terrain `terrain.PART`, or `terrain`", {}, &State::group_b},
      {"material", "", "name of the material", {}, &State::material},
  };
  return fields;
}

bool may_read(const PluginSpec& spec, const ContactField& field) {
  if (!field.only_if_read) return true;
  const std::string name = field.read_name();
  return std::any_of(spec.reads.begin(), spec.reads.end(),
                     [&](const FieldRead& read) { return read.field == name; });
}

void ContactReads::add(const ContactReads& other) {
  normal_force = normal_force || other.normal_force;
  points = points || other.points;
  shape = shape || other.shape;
  partner = partner || other.partner;
  slip_length = slip_length || other.slip_length;
}

ContactReads contact_reads(const PluginSpec& spec) {
  const auto has = [&](std::string_view field) {
    return std::any_of(spec.reads.begin(), spec.reads.end(),
                       [&](const FieldRead& read) { return read.field == field; });
  };
  return {.normal_force = has("contact.normal_force"),
          .points = has("contact.points"),
          .shape = has("contact.shape"),
          .partner = has("contact.partner"),
          .slip_length = has("contact.slip_length")};
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
