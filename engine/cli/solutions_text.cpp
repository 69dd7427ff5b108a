#include "cli/solutions_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "cli/command.h"
#include "cli/explain_text.h"

namespace flyrock::cli {

namespace {

constexpr std::size_t most_listed = 4096;  // states: all of 12 contacts without friction
constexpr std::size_t most_shown = 64;     // in a terminal

using Out = std::back_insert_iterator<std::string>;

const char* name_of(ContactMode state) {
  switch (state) {
    case ContactMode::open:
      return "open";
    case ContactMode::closed:
      return "closed";
    case ContactMode::sticks:
      return "sticks";
    case ContactMode::slides_forward:
      return "slides +t";
    case ContactMode::slides_back:
      return "slides -t";
  }
  return "";
}

const char* name_of(StateFault fault) {
  switch (fault) {
    case StateFault::none:
      return "feasible";
    case StateFault::no_impulse:
      return "no impulse satisfies its equations";
    case StateFault::penetrates:
      return "penetrates, u_n < 0";
    case StateFault::pulls:
      return "pulls, r_n < 0";
    case StateFault::exceeds:
      return "exceeds friction, |r_t| > mu r_n";
    case StateFault::along_slip:
      return "slips the other way";
  }
  return "";
}

std::string names_of(const std::vector<ContactMode>& states) {
  std::string text;
  for (const ContactMode state : states)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name_of(state));
  return text;
}

/// Throws InputError unless a contact has Coulomb's friction alone, in 3D none.
void require_plain(const Explanation& all, int contact) {
  const auto index = static_cast<std::size_t>(contact);
  if (!std::visit([&](const auto& stored) { return stored.problem.contacts[index].is_plain(); }, all.problem))
    throw InputError(fmt::format(
        "--solutions: contact {} has a spring, cohesion, rolling resistance, or an impulse that was found "
        "alone; expected contacts with Coulomb's friction",
        contact + 1));
  if (all.dimension == 3 && all.contacts[index].mu > 0)
    throw InputError(fmt::format(
        "--solutions: contact {} has friction in 3D, where slip has any direction and states have no end; "
        "expected contacts without friction, or a scenario in 2D",
        contact + 1));
}

/// The rows n, or n and t, of some contacts; `q` is of all of them.
FewContacts few_contacts(const Explanation& all, const std::vector<int>& contacts, const Eigen::VectorXd& q) {
  FewContacts problem;
  for (const int contact : contacts)
    problem.contacts.push_back({all.contacts[static_cast<std::size_t>(contact)].mu, 0});
  const bool has_friction = std::any_of(problem.contacts.begin(), problem.contacts.end(),
                                        [](const FewContacts::Contact& contact) { return contact.mu > 0; });
  problem.rows = has_friction ? 2 : 1;
  std::vector<Eigen::Index> rows;
  for (const int contact : contacts)
    for (Eigen::Index row = 0; row < problem.rows; ++row)
      rows.push_back(Eigen::Index{contact} * all.rows + row);
  problem.w = all.w(rows, rows);
  problem.q = q(rows);
  return problem;
}

/// The problem of forces at the begin of a step.
FewContacts problem_of_forces(const Explanation& all, const std::vector<int>& contacts) {
  constexpr double still = 1e-9;  // of the greatest velocity before
  Eigen::VectorXd before(all.free.size());
  for (std::size_t i = 0; i < all.contacts.size(); ++i)
    before.segment(static_cast<Eigen::Index>(i) * all.rows, all.rows) = all.contacts[i].before.head(all.rows);
  FewContacts problem = few_contacts(all, contacts, (all.free - before) / all.step);
  const double least = still * before.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double slip = all.contacts[static_cast<std::size_t>(contacts[i])].before[1];
    if (problem.contacts[i].mu > 0 && std::abs(slip) > least) problem.contacts[i].slip = slip > 0 ? 1 : -1;
  }
  return problem;
}

SolvedStates solve(const std::vector<int>& contacts, FewContacts problem) {
  SolvedStates solved;
  solved.contacts = contacts;
  solved.survey = survey_states(problem, most_listed);
  solved.lcp = lcp_of(problem);
  solved.path = lemke(solved.lcp.m, solved.lcp.q);
  solved.problem = std::move(problem);
  return solved;
}

// ---- as text

/// What the numbers of a problem are called.
struct Words {
  const char *push, *push_unit;      // "impulse", "N s"
  const char *motion, *motion_unit;  // "velocity", "m/s"
  const char *r, *u;
};
constexpr Words of_impulses{"impulse", "N s", "velocity", "m/s", "r", "u"};
constexpr Words of_forces{"force", "N", "acceleration", "m/s2", "f", "a"};

/// "contact 2 pulls: r_n = -0.1 N s"
std::string verdict(const SolvedStates& solved, const ComplementaryState& state, const Words& words) {
  const auto blame = [&](const char* what, const std::string& value) {
    return fmt::format("contact {} {}: {}", solved.contacts[static_cast<std::size_t>(state.contact)] + 1,
                       what, value);
  };
  switch (state.fault) {
    case StateFault::none:
      return state.many ? "FEASIBLE, with many loads" : "FEASIBLE";
    case StateFault::no_impulse:
      return fmt::format("no {} satisfies its equations", words.push);
    case StateFault::penetrates:
      return blame("penetrates", fmt::format("{}_n = {:.6g} {}", words.u, state.value, words.motion_unit));
    case StateFault::pulls:
      return blame("pulls", fmt::format("{}_n = {:.6g} {}", words.r, state.value, words.push_unit));
    case StateFault::exceeds:
      return blame("exceeds its friction",
                   fmt::format("|{0}_t| - mu {0}_n = {1:.6g} {2}", words.r, -state.value, words.push_unit));
    case StateFault::along_slip:
      return blame("slips the other way", fmt::format("{}_t = {:.6g} {}", words.u,
                                                      state.u[2 * state.contact + 1], words.motion_unit));
  }
  return "";
}

/// "n 0.3, t -0.4" of one contact; numbers below `least` are 0.
std::string by_rows(const FewContacts& problem, const Eigen::VectorXd& values, int contact, double least) {
  const auto shown = [&](Eigen::Index row) { return std::abs(values[row]) <= least ? 0 : values[row]; };
  std::string text = fmt::format("n {:.6g}", shown(problem.normal(contact)));
  if (problem.rows > 1) text += fmt::format(", t {:.6g}", shown(problem.tangential(contact)));
  return text;
}

void put_states(const SolvedStates& solved, const Words& words, Out out) {
  const StateSurvey& survey = solved.survey;
  const bool shows_all = survey.count <= most_shown;
  if (!shows_all) {
    fmt::format_to(out, "{:>10} states\n", survey.count);
    for (std::size_t fault = 0; fault < survey.by_fault.size(); ++fault)
      if (survey.by_fault[fault] > 0)
        fmt::format_to(out, "{:>10} {}\n", survey.by_fault[fault], name_of(static_cast<StateFault>(fault)));
  }
  std::size_t width = 0, shown = 0;
  for (const ComplementaryState& state : survey.states)
    width = std::max(width, names_of(state.states).size());
  for (const ComplementaryState& state : survey.states)
    if (shows_all || (state.fault == StateFault::none && shown < most_shown)) {
      ++shown;
      fmt::format_to(out, "    {:<{}}  {}\n", names_of(state.states), width, verdict(solved, state, words));
    }
}

/// The first state of each motion with its numbers. `run`: velocities that the run found, or empty.
void put_motions(const SolvedStates& solved, const Words& words, const Eigen::VectorXd& run, Out out) {
  const StateSurvey& survey = solved.survey;
  for (std::size_t k = 0; k < survey.motions.size(); ++k) {
    const ComplementaryState& state = survey.states[survey.motions[k].front()];
    const bool is_run =
        run.size() > 0 && (state.u - run).norm() <= 1e-6 * std::max(solved.problem.q.norm(), run.norm());
    fmt::format_to(out, "  solution {}{}{}\n", k + 1, is_run ? ", which the run found" : "",
                   state.many ? fmt::format("; its {}s are one of infinitely many choices", words.push) : "");
    for (int i = 0; i < solved.problem.size(); ++i)
      fmt::format_to(out, "{:>8}  {:<10} {} [{}]: {}; {} [{}]: {}\n",
                     solved.contacts[static_cast<std::size_t>(i)] + 1,
                     name_of(state.states[static_cast<std::size_t>(i)]), words.push, words.push_unit,
                     by_rows(solved.problem, state.r, i, 0), words.motion, words.motion_unit,
                     by_rows(solved.problem, state.u, i, 1e-12 * solved.problem.q.norm()));
  }
}

/// What a contact problem with this number of solutions means.
std::string conclusion(const SolvedStates& solved, const Words& words) {
  const StateSurvey& survey = solved.survey;
  const std::uint64_t feasible = survey.by_fault[static_cast<std::size_t>(StateFault::none)];
  if (feasible == 0)
    return fmt::format("No state is feasible: the problem has no solution in {}s.", words.push);
  if (survey.motions.size() == 1 && feasible == 1)
    return "One state is feasible: the problem has one solution.";
  const std::string states = fmt::format("{} state{} feasible", feasible, feasible == 1 ? " is" : "s are");
  if (survey.motions.size() == 1)
    return fmt::format("{}, with the same {}: the motion is unique.", states, words.motion);
  return fmt::format(
      "{}, with {} different motions: the problem has several solutions, and the laws do not choose one.",
      states, survey.motions.size());
}

/// "r_n 2", the component of z or w.
std::string name_of(const LcpVariable& variable, const SolvedStates& solved, const Words& words) {
  if (variable.kind == LcpVariable::Kind::artificial) return "z_0";
  const auto [contact, row] = solved.lcp.pairs[static_cast<std::size_t>(variable.index)];
  const bool is_z = variable.kind == LcpVariable::Kind::z;
  const auto name = [&](const std::string& z, const std::string& w) {
    return fmt::format("{} of {}", is_z ? z : w, solved.contacts[static_cast<std::size_t>(contact)] + 1);
  };
  const std::string r = words.r, u = words.u;
  switch (row) {
    case ContactLcp::Row::normal:
      return name(r + "_n", u + "_n");
    case ContactLcp::Row::forward:
      return name(r + "_t+", u + "_t + s");
    case ContactLcp::Row::back:
      return name(r + "_t-", "s - " + u + "_t");
    case ContactLcp::Row::slip:
      return name("s", fmt::format("mu {0}_n - |{0}_t|", r));
  }
  return "";
}

void put_lemke(const SolvedStates& solved, const Words& words, Out out) {
  const LemkePath& path = solved.path;
  const bool sticks = solved.lcp.pairs.size() > solved.problem.contacts.size();
  fmt::format_to(out, "  Lemke's path, w = q + z_0 + M z with {} pair{}{}\n", solved.lcp.pairs.size(),
                 solved.lcp.pairs.size() == 1 ? "" : "s",
                 sticks ? fmt::format(" ({0}_t = {0}_t+ - {0}_t-, s: the speed of slip)", words.r) : "");
  if (path.pivots.empty()) {
    fmt::format_to(out, "  q >= 0, so that z = 0 is a solution before the first pivot.\n");
    return;
  }
  fmt::format_to(out, "{:>8}  {:<22} {:<22} {:>10}\n", "pivot", "enters", "leaves",
                 fmt::format("z_0 [{}]", words.motion_unit));
  for (std::size_t k = 0; k < path.pivots.size(); ++k)
    fmt::format_to(out, "{:>8}  {:<22} {:<22} {:>10.6g}\n", k + 1,
                   name_of(path.pivots[k].entering, solved, words),
                   name_of(path.pivots[k].leaving, solved, words), path.pivots[k].artificial);
  switch (path.end) {
    case LemkeEnd::solution:
      fmt::format_to(out, "  z_0 has left: the path ends at a solution.\n");
      break;
    case LemkeEnd::ray:
      fmt::format_to(out,
                     "  The path ends on a ray: {} grows without bound, because no other variable decreases "
                     "to 0. Lemke's "
                     "method finds no solution.\n",
                     name_of(path.on_ray, solved, words));
      break;
    case LemkeEnd::too_long:
      fmt::format_to(out, "  The path is longer than {} pivots.\n", path.pivots.size());
      break;
  }
}

void put(const SolvedStates& solved, const Words& words, const Eigen::VectorXd& run, Out out) {
  put_states(solved, words, out);
  fmt::format_to(out, "  {}\n", conclusion(solved, words));
  put_motions(solved, words, run, out);
  put_lemke(solved, words, out);
}

/// The velocities that the run found, in the rows of a problem.
Eigen::VectorXd found_by_run(const Explanation& all, const SolvedStates& solved) {
  Eigen::VectorXd u(solved.problem.q.size());
  for (int i = 0; i < solved.problem.size(); ++i)
    u.segment(solved.problem.normal(i), solved.problem.rows) = all.phases[0].u.segment(
        Eigen::Index{solved.contacts[static_cast<std::size_t>(i)]} * all.rows, solved.problem.rows);
  return u;
}

/// "contact 3", "contacts 1, 2"
std::string contacts_text(const SolvedStates& solved) {
  std::string text = solved.contacts.size() == 1 ? "contact" : "contacts";
  for (std::size_t i = 0; i < solved.contacts.size(); ++i)
    text += fmt::format("{} {}", i ? "," : "", solved.contacts[i] + 1);
  return text;
}

// ---- as JSON

nlohmann::ordered_json json_of(const SolvedStates& solved, const Words& words) {
  nlohmann::ordered_json states = nlohmann::ordered_json::array(), pivots = states, motions = states;
  for (const ComplementaryState& state : solved.survey.states) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const ContactMode one : state.states) names.push_back(name_of(one));
    states.push_back({{"states", names},
                      {"feasible", state.fault == StateFault::none},
                      {"verdict", verdict(solved, state, words)},
                      {"many_loads", state.many},
                      {words.r, list_of(state.r)},
                      {words.u, list_of(state.u)}});
  }
  for (const std::vector<std::size_t>& motion : solved.survey.motions) motions.push_back(motion);
  for (const LemkePivot& pivot : solved.path.pivots)
    pivots.push_back({{"enters", name_of(pivot.entering, solved, words)},
                      {"leaves", name_of(pivot.leaving, solved, words)},
                      {"z_0", pivot.artificial}});
  const char* end = solved.path.end == LemkeEnd::solution ? "solution"
                    : solved.path.end == LemkeEnd::ray    ? "ray"
                                                          : "too_long";
  return {{"count", solved.survey.count},
          {"feasible", solved.survey.by_fault[0]},
          {"states", states},
          {"motions", motions},
          {"conclusion", conclusion(solved, words)},
          {"lemke", {{"pivots", pivots}, {"end", end}}}};
}

}  // namespace

std::vector<IslandSolutions> solutions_of(const Explanation& all) {
  if (all.contacts.empty())
    throw InputError("--solutions: there is no problem, because nothing is in contact");
  std::vector<IslandSolutions> solutions;
  for (const std::vector<int>& contacts : all.islands) {
    if (contacts.size() > most_enumerated_contacts)
      throw InputError(fmt::format(
          "--solutions tries the states of {} contacts that act on each other at most; here are {}",
          most_enumerated_contacts, contacts.size()));
    for (const int contact : contacts) require_plain(all, contact);
    solutions.push_back({solve(contacts, few_contacts(all, contacts, all.phases[0].q)), {}});
    if (all.step > 0) solutions.back().forces = solve(contacts, problem_of_forces(all, contacts));
  }
  return solutions;
}

std::string text_of(const Explanation& all, const std::vector<IslandSolutions>& solutions) {
  std::string text;
  const Out out(text);
  for (const IslandSolutions& island : solutions) {
    fmt::format_to(out, "\nall states of {}: impulses{} and velocities, u = q + W r\n",
                   contacts_text(island.impulses), all.phases.size() > 1 ? " of compression" : "");
    put(island.impulses, of_impulses, found_by_run(all, island.impulses), out);
    if (!island.forces) continue;
    fmt::format_to(
        out,
        "all states of {}: forces and accelerations, a = (free velocity - velocity before)/step + W f,\n"
        "where a contact that slips keeps its slip, because no force changes a velocity at once\n",
        contacts_text(*island.forces));
    put(*island.forces, of_forces, {}, out);
  }
  return text;
}

nlohmann::ordered_json json_of(const std::vector<IslandSolutions>& solutions) {
  nlohmann::ordered_json islands = nlohmann::ordered_json::array();
  for (const IslandSolutions& island : solutions) {
    nlohmann::ordered_json contacts = nlohmann::ordered_json::array();
    for (const int contact : island.impulses.contacts) contacts.push_back(contact + 1);
    islands.push_back({{"contacts", contacts}, {"impulses", json_of(island.impulses, of_impulses)}});
    if (island.forces) islands.back()["forces"] = json_of(*island.forces, of_forces);
  }
  return islands;
}

}  // namespace flyrock::cli
