#include "scenario/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "document/node.h"
#include "document/wording.h"
#include "record/rock_statistics.h"
#include "record/series.h"
#include "units/units.h"

namespace flyrock {

namespace {

struct Named {
  std::string_view name;
  Dimension dimension;
};
using Table = std::vector<Named>;

constexpr Dimension impulse{1, 1, -1, 0};

const Table state_components_2d{
    {"x", dimension::length}, {"y", dimension::length},    {"vx", dimension::speed},
    {"vy", dimension::speed}, {"speed", dimension::speed}, {"spin", dimension::spin},
    {"wz", dimension::spin},  {"angle", dimension::angle}, {"kinetic_energy", dimension::energy}};
const Table extreme_components_3d{{"x", dimension::length},
                                  {"y", dimension::length},
                                  {"z", dimension::length},
                                  {"vx", dimension::speed},
                                  {"vy", dimension::speed},
                                  {"vz", dimension::speed},
                                  {"speed", dimension::speed},
                                  {"wx", dimension::spin},
                                  {"wy", dimension::spin},
                                  {"wz", dimension::spin},
                                  {"kinetic_energy", dimension::energy}};

/// A number that is described with its unit.
Named measured_in(std::string_view unit, std::string_view name) {
  return {name, parse_unit(unit).value_or(Unit{}).dimension};
}

/// `base` and one more entry.
Table with(Table base, Named entry) {
  base.push_back(entry);
  return base;
}
const Table state_components_3d = with(extreme_components_3d, {"spin", dimension::spin});

/// Measures of the last states of all bodies that move.
const Table assembly_components_2d{{"x", dimension::length},
                                   {"y", dimension::length},
                                   {"vx", dimension::speed},
                                   {"vy", dimension::speed},
                                   {"kinetic_energy", dimension::energy}};
const Table assembly_components_3d = [] {
  Table table = assembly_components_2d;
  table.push_back({"z", dimension::length});
  table.push_back({"vz", dimension::speed});
  return table;
}();

const Table impact_quantities{{"time", dimension::time},
                              {"x", dimension::length},
                              {"y", dimension::length},
                              {"vn_before", dimension::speed},
                              {"vn_after", dimension::speed},
                              {"vt_before", dimension::speed},
                              {"vt_after", dimension::speed},
                              {"pn", impulse},
                              {"pt", impulse},
                              {"energy_change", dimension::energy}};
const Table impact_quantities_3d = with(impact_quantities, {"z", dimension::length});
const Table apex_quantities{{"time", dimension::time}, {"height", dimension::length}};
const Table solver_quantities{
    {"max_residual", dimension::speed},           {"not_converged", dimension::none},
    {"max_penetration", dimension::length},       {"energy_gains", dimension::none},
    {"gains_by_slip", dimension::none},           {"iterations", dimension::none},
    {"max_iterations_of_a_step", dimension::none}};
constexpr Dimension force{1, 1, -2, 0};
const Table contact_quantities{{"gap", dimension::length},
                               {"un", dimension::speed},
                               {"ut", dimension::speed},
                               {"rn", force},
                               {"rt", force}};
const Table link_quantities{
    {"force", force}, {"length", dimension::length}, {"angle", dimension::angle}, {"impulse", impulse}};
/// Measures of a region, over the rows of its series.
Table region_table(int dimension) {
  Table table;
  for (const RegionQuantity& number : region_quantities)
    if (dimension == 3 || !number.in_space) table.push_back(measured_in(number.unit, number.name));
  return table;
}
/// Measures of a deformable body, over the rows of its series.
const Table stress_table = [] {
  Table table;
  for (const StressQuantity& number : stress_quantities)
    table.push_back(measured_in(number.unit, number.name));
  return table;
}();
const Table rock_distributions = [] {
  Table table;
  for (const RockStatistic& number : rock_statistics)
    table.push_back(measured_in(number.column.unit, number.name()));
  return table;
}();
const Table rock_totals{{"count", dimension::none}, {"censored", dimension::none}};
const Table gate_quantities{{"passed", dimension::none},
                            {"mean_energy", dimension::energy},
                            {"p95_energy", dimension::energy},
                            {"p95_height", dimension::length}};
/// `passed.per_trial` by its short name.
const Named passed_per_trial{"per_trial", dimension::none};
const Table barrier_quantities{{"reached", dimension::none},
                               {"caught", dimension::none},
                               {"over_top", dimension::none},
                               {"over_energy", dimension::none},
                               {"past", dimension::none}};
const Table tree_quantities{
    {"hit", dimension::none}, {"stopped", dimension::none}, {"hits", dimension::none}};
const Table clearance_quantities{{"distance", dimension::length},
                                 {"lower", dimension::length},
                                 {"upper", dimension::length},
                                 {"with_factor", dimension::length}};
const Table exposure_quantities{
    {"per_blast", dimension::none}, {"per_year", dimension::none}, {"hits_per_m2", {-2, 0, 0, 0}}};
const std::vector<std::string> statistics{"mean", "sd", "min", "max", "p50", "p90", "p95", "p99"};

/// Reads a measure from left to right. The first step that does not fit becomes the fault.
class MeasureParser {
 public:
  MeasureParser(std::string_view measure, const MeasureNames& names)
      : measure_(measure), names_(names), steps_(measure_steps(measure)) {}

  MeasureInfo parse() {
    static const std::vector<std::string> kinds{"body",     "assembly", "contact", "link",  "region",
                                                "rocks",    "gate",     "barrier", "trees", "clearance",
                                                "exposure", "energy",   "solver"};
    const std::string kind = next(kinds);
    if (kind == "body") parse_body();
    if (kind == "assembly") parse_assembly();
    if (kind == "contact") parse_contact();
    if (kind == "link") parse_link();
    if (kind == "region") parse_region();
    if (kind == "rocks") parse_rocks();
    if (kind == "gate") {
      Table quantities = gate_quantities;
      quantities.push_back(passed_per_trial);
      parse_named("gates", names_.gates, quantities);
      if (steps_.size() > 3 && steps_[2] == "passed") next({"per_trial"});
    }
    if (kind == "barrier") {
      parse_named("barriers", names_.barriers, barrier_quantities);
      if (steps_.size() > 3) next({"of_arriving", "per_trial"});
    }
    if (kind == "trees") {
      if (!names_.forest) fail("the scenario has no forest");
      finish(tree_quantities);
    }
    if (kind == "clearance") parse_clearance();
    if (kind == "exposure") parse_named("exposure", names_.exposures, exposure_quantities);
    if (kind == "solver") {
      finish(solver_quantities);
      if (steps_.size() > 1 && steps_[1] == "max_iterations_of_a_step") need_series();
    }
    if (kind == "energy") {
      next({"total"});
      next({"relative_change"});
    }
    if (info_.fault.empty() && at_ < steps_.size())
      fail(fmt::format("nothing may follow `{}`", steps_[at_ - 1]));
    return info_;
  }

 private:
  void fail(const std::string& text) {
    if (info_.fault.empty()) info_.fault = fmt::format("`{}` is not a measure: {}", measure_, text);
  }

  /// The next step, if it is one of `known`. Otherwise empty, and the fault is set.
  std::string next(const std::vector<std::string>& known) {
    if (!info_.fault.empty()) return {};
    if (at_ >= steps_.size()) {
      fail("it ends early" + suggestion("", known));
      return {};
    }
    const std::string& step = steps_[at_++];
    if (std::find(known.begin(), known.end(), step) != known.end()) return step;
    fail(fmt::format("unknown `{}`{}", step, suggestion(step, known)));
    return {};
  }

  void finish(const Table& table) {
    const std::string name = next(names_of(table));
    for (const Named& entry : table)
      if (entry.name == name) info_.dimension = entry.dimension;
  }

  /// Turns "impact[2]" into "impact" if the index is a whole number of at least 1.
  void strip_index(const std::string& list) {
    if (at_ >= steps_.size() || !steps_[at_].starts_with(list + "[") || !steps_[at_].ends_with(']')) return;
    const std::string index = steps_[at_].substr(list.size() + 1, steps_[at_].size() - list.size() - 2);
    int number = 0;
    const auto [end, code] = std::from_chars(index.data(), index.data() + index.size(), number);
    if (code != std::errc() || end != index.data() + index.size() || number < 1)
      return fail(fmt::format("`{}` is not an index, expected a whole number from 1", index));
    steps_[at_] = list + "[n]";
  }

  void parse_body() {
    if (names_.bodies.empty()) return fail("the scenario has no bodies");
    next(names_.bodies);
    strip_index("impact");
    strip_index("apex");
    for (const Named& entry : stress_table)
      if (at_ < steps_.size() && steps_[at_] == entry.name) return parse_stress();
    const std::string kind =
        next({"final", "max", "min", "stop_time", "contact_time", "impact[n]", "apex[n]"});
    const bool plane = names_.dimension == 2;
    if (kind == "final") finish(plane ? state_components_2d : state_components_3d);
    if (kind == "max" || kind == "min") finish(plane ? state_components_2d : extreme_components_3d);
    if (kind == "impact[n]") finish(plane ? impact_quantities : impact_quantities_3d);
    if (kind == "apex[n]") finish(apex_quantities);
    if (kind == "stop_time" || kind == "contact_time") info_.dimension = dimension::time;
  }

  /// What a deformable body has in its series.
  void parse_stress() {
    finish(stress_table);
    next({"max", "min", "final"});
    need_series();
  }

  void parse_assembly() {
    if (names_.bodies.empty()) return fail("the scenario has no bodies");
    if (at_ < steps_.size() && steps_[at_] == "at_rest") {
      ++at_;
      return;
    }
    finish(names_.dimension == 2 ? assembly_components_2d : assembly_components_3d);
    next({"mean", "min", "max"});
  }

  void need_series() {
    if (!names_.series) fail("it needs `output.series`, which the scenario does not ask for");
  }

  void parse_contact() {
    if (names_.bodies.empty()) return fail("the scenario has no bodies");
    std::vector<std::string> others = names_.bodies;
    others.emplace_back("terrain");
    next(others);
    next(others);
    finish(contact_quantities);
    parse_over_time();
  }

  void parse_link() {
    parse_named("links", names_.links, link_quantities);
    if (!info_.fault.empty()) return;
    if (steps_[2] == "angle" &&
        std::find(names_.hinges.begin(), names_.hinges.end(), steps_[1]) == names_.hinges.end())
      return fail(fmt::format("the link `{}` is no hinge, it has no angle", steps_[1]));
    parse_over_time();
  }

  void parse_region() {
    parse_named("output.series.regions", names_.regions, region_table(names_.dimension));
    parse_over_time();
  }

  /// What becomes of a quantity of a series.
  void parse_over_time() {
    if (at_ < steps_.size() && time_of_step(steps_[at_])) steps_[at_] = "at[time]";
    next({"mean", "max", "min", "final", "at[time]"});
    need_series();
  }

  void parse_rocks() {
    if (names_.groups.empty()) return fail("the scenario has no rocks");
    std::vector<std::string> known = rock_quantities();
    if (at_ < steps_.size() &&
        std::find(names_.groups.begin(), names_.groups.end(), steps_[at_]) != names_.groups.end())
      ++at_;
    else
      known.insert(known.end(), names_.groups.begin(), names_.groups.end());
    const std::string quantity = next(known);
    for (const Named& entry : rock_distributions)
      if (entry.name == quantity) {
        info_.dimension = entry.dimension;
        next(statistics);
      }
  }

  void parse_named(std::string_view section, const std::vector<std::string>& names, const Table& quantities) {
    if (names.empty()) return fail(fmt::format("the scenario has no {}", section));
    next(names);
    finish(quantities);
  }

  void parse_clearance() {
    parse_named("clearance", names_.clearances, clearance_quantities);
    if (!info_.fault.empty() || steps_[2] != "with_factor") return;
    if (std::find(names_.with_factor.begin(), names_.with_factor.end(), steps_[1]) ==
        names_.with_factor.end())
      fail(fmt::format("the clearance `{}` has no `factor`", steps_[1]));
  }

  std::string_view measure_;
  const MeasureNames& names_;
  std::vector<std::string> steps_;
  std::size_t at_ = 0;
  MeasureInfo info_;
};

std::vector<std::string> list_of_rocks(const MeasureNames& names) {
  std::vector<std::string> list;
  const auto add = [&](const std::string& subject, const Table& quantities,
                       const std::vector<std::string>& ends) {
    for (const Named& quantity : quantities)
      for (const std::string& end : ends) list.push_back(fmt::format("{}.{}{}", subject, quantity.name, end));
  };
  std::vector<std::string> of_rocks, alone{""};
  for (const std::string& statistic : statistics) of_rocks.push_back("." + statistic);
  std::vector<std::string> groups{"rocks"};
  if (names.groups.size() > 1)
    for (const std::string& group : names.groups) groups.push_back("rocks." + group);
  for (const std::string& group : groups) {
    add(group, rock_totals, alone);
    add(group, rock_distributions, of_rocks);
  }
  for (const std::string& gate : names.gates) {
    add("gate." + gate, gate_quantities, alone);
    list.push_back(fmt::format("gate.{}.passed.per_trial", gate));
  }
  for (const std::string& barrier : names.barriers)
    add("barrier." + barrier, barrier_quantities, {"", ".of_arriving", ".per_trial"});
  if (names.forest) add("trees", tree_quantities, alone);
  for (const std::string& clearance : names.clearances) {
    list.push_back(fmt::format("clearance.{}.distance", clearance));
    if (std::find(names.with_factor.begin(), names.with_factor.end(), clearance) != names.with_factor.end())
      list.push_back(fmt::format("clearance.{}.with_factor", clearance));
  }
  for (const std::string& exposure : names.exposures) add("exposure." + exposure, exposure_quantities, alone);
  return list;
}

}  // namespace

std::vector<std::string> measure_steps(std::string_view measure) {
  std::vector<std::string> steps(1);
  int depth = 0;  // a point between brackets belongs to a number
  for (const char c : measure) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == '.' && depth <= 0)
      steps.emplace_back();
    else
      steps.back() += c;
  }
  return steps;
}

std::optional<double> time_of_step(std::string_view step) {
  if (!step.starts_with("at[") || !step.ends_with(']')) return std::nullopt;
  const std::optional<Quantity> quantity = parse_quantity(step.substr(3, step.size() - 4));
  if (!quantity || (quantity->has_unit && quantity->unit.dimension != dimension::time)) return std::nullopt;
  return quantity->si();
}

std::vector<std::string> rock_quantities() {
  std::vector<std::string> names = names_of(rock_distributions);
  for (const Named& entry : rock_totals) names.emplace_back(entry.name);
  return names;
}

std::vector<std::string> measures_of_rocks(const MeasureNames& names) { return list_of_rocks(names); }

MeasureInfo check_measure(std::string_view measure, const MeasureNames& names) {
  return MeasureParser(measure, names).parse();
}

}  // namespace flyrock
