#include "cli/explain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace flyrock::cli {

namespace {

constexpr int most_columns = 10;  // of a table that a terminal shows

using Out = std::back_insert_iterator<std::string>;

/// The rows of a contact: "n", "t", ...
std::vector<std::string> row_names(const Explanation& all) {
  static const std::array<std::string, 3> plane = {"n", "t", "roll"};
  static const std::array<std::string, 6> space = {"n", "t", "s", "spin", "roll_t", "roll_s"};
  const auto* names = all.dimension == 2 ? plane.data() : space.data();
  return {names, names + all.rows};
}

std::string join(const Vec3& v, int dimension) {
  return dimension == 2 ? fmt::format("({:.6g}, {:.6g})", v.x(), v.y())
                        : fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

/// "n -3.1, t 0.2"
std::string by_rows(const Eigen::VectorXd& values, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{} {:.6g}", i ? ", " : "", names[i],
                        values[static_cast<Eigen::Index>(i)] + 0.0);  // + 0.0: no -0
  return text;
}

/// ", k = 1e+05 N/m, c = 20 N s/m"
std::string spring_text(const Spring& spring) {
  const std::string unit = spring.exponent == 1 ? "m" : fmt::format("m^{:.6g}", spring.exponent);
  std::string text = fmt::format(", k = {:.6g} N/{}", spring.stiffness, unit);
  if (spring.damping > 0) text += fmt::format(", c = {:.6g} N s/{}", spring.damping, unit);
  if (spring.tangential_stiffness > 0) text += fmt::format(", k_t = {:.6g} N/m", spring.tangential_stiffness);
  return text;
}

std::string law_text(const ExplainedContact& contact) {
  const ContactLaw& law = contact.law;
  std::string text;
  if (contact.impact && law.condition != NormalCondition::penalty)
    text = fmt::format("restitution {}, e_n = {:.6g}{}; ", name_of(law.form), law.e_n,
                       law.e_t != 0 ? fmt::format(", e_t = {:.6g}", law.e_t) : "");
  text += fmt::format("{}, mu = {:.6g}", name_of(law.condition), contact.mu);
  if (law.condition == NormalCondition::penalty) text += spring_text(law.spring);
  if (law.c_n > 0 || law.c_t > 0) text += fmt::format(", c_n = {:.6g} N, c_t = {:.6g} N", law.c_n, law.c_t);
  if (law.mu_r > 0) text += fmt::format(", mu_r = {:.6g} m", law.mu_r);
  if (law.mu_spin > 0) text += fmt::format(", mu_spin = {:.6g} m", law.mu_spin);
  return text;
}

void put_contacts(const Explanation& all, Out out) {
  const std::vector<std::string> names = row_names(all);
  fmt::format_to(out, "\ncontacts (n points from the second body to the first{})\n",
                 all.dimension == 2 ? "" : "; s = n x t");
  for (std::size_t i = 0; i < all.contacts.size(); ++i) {
    const ExplainedContact& contact = all.contacts[i];
    fmt::format_to(out, "{:>4}  {} on {} at {} m, n = {}, t = {}, gap {:.3g} m\n", i + 1, contact.a,
                   contact.b, join(contact.place, all.dimension), join(contact.normal, all.dimension),
                   join(contact.tangent, all.dimension), contact.gap);
    fmt::format_to(out, "      {}\n      velocity before [m/s]: {}\n", law_text(contact),
                   by_rows(contact.before, names));
  }
}

/// "3n", the row of a contact in a table.
std::string column_name(const Explanation& all, Eigen::Index i) {
  return fmt::format("{}{}", i / all.rows + 1, row_names(all)[static_cast<std::size_t>(i % all.rows)]);
}

void put_matrix(const Explanation& all, Out out) {
  const Eigen::Index size = all.w.rows();
  fmt::format_to(out,
                 "\nu = q + W r, 0 <= u_n _|_ r_n >= 0, |r_t| <= mu r_n against u_t"
                 " (u, q in m/s; r in N s; W in 1/kg)\n");
  if (size > most_columns) {
    fmt::format_to(out, "W has {} rows: --json holds them\n", size);
  } else {
    fmt::format_to(out, "{:>8}", "W");
    for (Eigen::Index k = 0; k < size; ++k) fmt::format_to(out, "{:>13}", column_name(all, k));
    fmt::format_to(out, "{:>14}{:>14}\n", "free velocity", "q");
    for (Eigen::Index i = 0; i < size; ++i) {
      fmt::format_to(out, "{:>8}", column_name(all, i));
      for (Eigen::Index k = 0; k < size; ++k) fmt::format_to(out, "{:>13.5g}", all.w(i, k));
      fmt::format_to(out, "{:>14.6g}{:>14.6g}\n", all.free[i], all.phases[0].q[i]);
    }
  }
  if (std::any_of(all.contacts.begin(), all.contacts.end(), [](const auto& c) { return c.alone; }))
    fmt::format_to(out,
                   "An impulse that was found by following the path of an isolated contact is part of q.\n");
  const Eigen::VectorXd& s = all.singular_values;
  const Eigen::Index missing = size - all.rank;
  fmt::format_to(out, "rank of W: {} of {} (singular values {:.4g} to {:.4g}): ", all.rank, size, s[0],
                 s[size - 1]);
  if (missing == 0)
    fmt::format_to(out, "every impulse moves a body, so the impulses are unique\n");
  else
    fmt::format_to(out, "{} combination{} of impulses move{} no body, so the impulses may not be unique\n",
                   missing, missing == 1 ? "" : "s", missing == 1 ? "s" : "");
}

/// The first ten sweeps, then the 20th, the 50th, the 100th ... and the last one.
bool shown(std::size_t sweep, std::size_t last) {
  if (sweep <= 10 || sweep == last) return true;
  std::size_t power = 1;
  while (power * 10 <= sweep) power *= 10;
  return sweep == power || sweep == 2 * power || sweep == 5 * power;
}

void put_sweeps(const Explanation& all, const ExplainedPhase& phase, Out out) {
  fmt::format_to(out, "Gauss-Seidel from r = 0: a sweep solves one contact after the other [N s]\n");
  const Eigen::Index size = all.w.rows(), columns = std::min<Eigen::Index>(size, most_columns);
  fmt::format_to(out, "{:>8}", "sweep");
  for (Eigen::Index k = 0; k < columns; ++k) fmt::format_to(out, "{:>13}", "r " + column_name(all, k));
  fmt::format_to(out, "{:>14}\n", "residual m/s");
  for (std::size_t sweep = 1; sweep <= phase.sweeps.size(); ++sweep) {
    if (!shown(sweep, phase.sweeps.size())) continue;
    const ExplainedSweep& row = phase.sweeps[sweep - 1];
    fmt::format_to(out, "{:>8}", sweep);
    for (Eigen::Index k = 0; k < columns; ++k) fmt::format_to(out, "{:>13.6g}", row.r[k]);
    fmt::format_to(out, "{:>14.3g}\n", row.residual);
  }
  if (columns < size) fmt::format_to(out, "  ({} of {} rows; --json holds all)\n", columns, size);
}

void put_phase(const Explanation& all, const ExplainedPhase& phase, Out out) {
  if (!phase.name.empty()) fmt::format_to(out, "\n{}\n", phase.name);
  put_sweeps(all, phase, out);
  fmt::format_to(out, "the run{} found, with residual {:.3g} m/s:\n",
                 phase.warm ? ", which began with the impulses of the step before," : "", phase.residual);
  fmt::format_to(out, "{:>8}{:>14}{:>14}{:>14}{:>14}\n", "", "q", "r", "u = q + W r", "u r");
  for (Eigen::Index i = 0; i < phase.r.size(); ++i)
    fmt::format_to(out, "{:>8}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.3g}\n", column_name(all, i), phase.q[i] + 0.0,
                   phase.r[i] + 0.0, phase.u[i] + 0.0, phase.u[i] * phase.r[i] + 0.0);
}

/// "slips; ", if one problem was solved: an impulse on the cone of friction slips, one inside of it sticks.
/// Without friction the contact is closed.
std::string state_of(const Explanation& all, const ExplainedContact& contact) {
  if (contact.alone || all.phases.size() != 1) return "";
  const Eigen::VectorXd& r = contact.impulse;
  if (r.isZero(0)) return "open; ";
  const double cohesion = all.step > 0 ? contact.law.c_t * all.step : 0;
  const double bound = contact.mu * r[0] + cohesion;
  if (bound <= 0) return "closed; ";
  return r.segment(1, all.dimension - 1).norm() < (1 - 1e-9) * bound ? "sticks; " : "slips; ";
}

void put_result(const Explanation& all, Out out) {
  const std::vector<std::string> names = row_names(all);
  fmt::format_to(out, "\nresult\n");
  for (std::size_t i = 0; i < all.contacts.size(); ++i) {
    const ExplainedContact& contact = all.contacts[i];
    fmt::format_to(out, "{:>4}  {}impulse [N s]: {}{}\n      velocity after [m/s]: {}; work {:.6g} J\n",
                   i + 1, state_of(all, contact), by_rows(contact.impulse, names),
                   contact.alone ? " (alone: followed along its path in impulse space)" : "",
                   by_rows(contact.after, names), contact.energy);
    if (all.step > 0)
      fmt::format_to(out, "      force [N]: {}\n", by_rows(contact.impulse / all.step, names));
  }
  fmt::format_to(out, "energy: the contacts {} {:.6g} J\n", all.energy > 0 ? "give" : "take",
                 std::abs(all.energy));
}

nlohmann::ordered_json coordinates_of(const Vec3& v, int dimension) {
  return std::vector<double>(v.data(), v.data() + dimension);
}

nlohmann::ordered_json json_of(const ExplainedContact& contact, int dimension) {
  const ContactLaw& law = contact.law;
  return {{"a", contact.a},
          {"b", contact.b},
          {"place_m", coordinates_of(contact.place, dimension)},
          {"normal", coordinates_of(contact.normal, dimension)},
          {"tangent", coordinates_of(contact.tangent, dimension)},
          {"gap_m", contact.gap},
          {"condition", name_of(law.condition)},
          {"impact", contact.impact},
          {"form", name_of(law.form)},
          {"e_n", law.e_n},
          {"e_t", law.e_t},
          {"mu", contact.mu},
          {"c_n_N", law.c_n},
          {"c_t_N", law.c_t},
          {"mu_r_m", law.mu_r},
          {"mu_spin_m", law.mu_spin},
          {"stiffness", law.spring.stiffness},
          {"damping", law.spring.damping},
          {"exponent", law.spring.exponent},
          {"tangential_stiffness_N_m", law.spring.tangential_stiffness},
          {"solved_alone", contact.alone},
          {"before_m_s", list_of(contact.before)},
          {"after_m_s", list_of(contact.after)},
          {"impulse_N_s", list_of(contact.impulse)},
          {"work_J", contact.energy}};
}

nlohmann::ordered_json json_of(const ExplainedPhase& phase) {
  nlohmann::ordered_json sweeps = nlohmann::ordered_json::array();
  for (const ExplainedSweep& sweep : phase.sweeps)
    sweeps.push_back({{"r", list_of(sweep.r)}, {"residual_m_s", sweep.residual}});
  return {{"name", phase.name},    {"q", list_of(phase.q)},          {"r", list_of(phase.r)},
          {"u", list_of(phase.u)}, {"residual_m_s", phase.residual}, {"warm_start", phase.warm},
          {"sweeps", sweeps}};
}

}  // namespace

nlohmann::ordered_json list_of(const Eigen::VectorXd& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

std::string text_of(const Explanation& all, const std::string& title) {
  std::string text;
  const Out out(text);
  fmt::format_to(out, "{}, at {:.9g} s: {} contact{} in {}D{}\n", title, all.time, all.contacts.size(),
                 all.contacts.size() == 1 ? "" : "s", all.dimension,
                 all.step > 0 ? fmt::format(", step of {:.6g} s", all.step) : "");
  if (all.contacts.empty()) return text + "There is nothing to solve.\n";
  put_contacts(all, out);
  put_matrix(all, out);
  fmt::format_to(out, "\n");
  for (const ExplainedPhase& phase : all.phases) put_phase(all, phase, out);
  put_result(all, out);
  return text;
}

nlohmann::ordered_json json_of(const Explanation& all) {
  nlohmann::ordered_json contacts = nlohmann::ordered_json::array(), phases = contacts, w = contacts;
  for (const ExplainedContact& contact : all.contacts) contacts.push_back(json_of(contact, all.dimension));
  for (const ExplainedPhase& phase : all.phases) phases.push_back(json_of(phase));
  for (Eigen::Index i = 0; i < all.w.rows(); ++i) w.push_back(list_of(Eigen::VectorXd(all.w.row(i))));
  return {{"time_s", all.time},
          {"step_s", all.step},
          {"dimension", all.dimension},
          {"rows", row_names(all)},
          {"contacts", contacts},
          {"W", w},
          {"free_velocity_m_s", list_of(all.free)},
          {"rank", all.rank},
          {"singular_values", list_of(all.singular_values)},
          {"phases", phases},
          {"work_J", all.energy}};
}

}  // namespace flyrock::cli
