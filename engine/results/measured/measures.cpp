#include "results/measured/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "document/wording.h"
#include "results/measured/assembly.h"
#include "results/statistics/unknown.h"
#include "scenario/measure.h"

namespace flyrock {

namespace {

template <class List>
int index_of(const std::string& word, const List& names) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) throw std::logic_error("a measure that the decoder did not check: " + word);
  return static_cast<int>(found - names.begin());
}

constexpr std::array<std::string_view, 4> gate_fields = {"passed", "mean_energy", "p95_energy", "p95_height"};
constexpr std::array<std::string_view, 3> tree_fields = {"hit", "stopped", "hits"};
constexpr std::array<std::string_view, 4> clearance_fields = {"distance", "lower", "upper", "with_factor"};
constexpr std::array<std::string_view, 3> exposure_fields = {"per_blast", "per_year", "hits_per_m2"};
constexpr std::array<std::string_view, 7> solver_fields = {
    "max_residual",  "not_converged", "max_penetration",         "energy_gains",
    "gains_by_slip", "iterations",    "max_iterations_of_a_step"};
constexpr std::array<std::string_view, 11> impact_fields = {
    "time", "x", "y", "z", "vn_before", "vn_after", "vt_before", "vt_after", "pn", "pt", "energy_change"};
constexpr std::array<std::string_view, 13> state_fields = {
    "x", "y", "z", "vx", "vy", "vz", "speed", "spin", "wx", "wy", "wz", "angle", "kinetic_energy"};

double impact_value(const Impact& impact, const std::string& field) {
  const std::array<double, impact_fields.size()> values = {
      impact.time,      impact.place.x(), impact.place.y(),    impact.place.z(),
      impact.vn_before, impact.vn_after,  impact.vt_before,    impact.vt_after,
      impact.pn,        impact.pt,        impact.energy_change};
  return values[index_of(field, impact_fields)];
}

}  // namespace

Measure::Measure(const std::string& name, const Scenario& scenario) : dimension_(scenario.dimension) {
  const std::vector<std::string> words = measure_steps(name);
  if (words[0] == "body") {
    read_body(words, scenario);
  } else if (words[0] == "assembly") {
    kind_ = Kind::assembly;
    moves_ = moving_bodies(scenario);
    field_ = words[1];
    if (words.size() > 2) table_ = words[2];
  } else if (words[0] == "contact") {
    read_contact(words);
  } else if (words[0] == "link") {
    read_link(words);
  } else if (words[0] == "region") {
    read_region(words);
  } else if (words[0] == "rocks") {
    read_rocks(words, scenario);
  } else if (words[0] == "gate") {
    kind_ = Kind::gate;
    index_ = index_of(words[1], names_of(scenario.gates));
    read_share(words);
  } else if (words[0] == "barrier") {
    kind_ = Kind::barrier;
    index_ = index_of(words[1], names_of(scenario.barriers));
    read_share(words);
  } else if (words[0] == "trees") {
    kind_ = Kind::trees;
    field_ = words[1];
  } else if (words[0] == "clearance") {
    kind_ = Kind::clearance;
    index_ = index_of(words[1], names_of(scenario.clearances));
    field_ = words[2];
  } else if (words[0] == "exposure") {
    kind_ = Kind::exposure;
    index_ = index_of(words[1], names_of(scenario.exposures));
    field_ = words[2];
  } else {
    kind_ = words[0] == "energy" ? Kind::energy : Kind::solver;
    field_ = words[1];
  }
}

/// "passed", "caught": a field, and "per_trial", "of_arriving": of what it is a share.
void Measure::read_share(const std::vector<std::string>& words) {
  field_ = words[2];
  if (field_ == "per_trial") sense_ = &Shares::per_trial;
  if (words.size() > 3) sense_ = words[3] == "per_trial" ? &Shares::per_trial : &Shares::of_arriving;
}

void Measure::read_rocks(const std::vector<std::string>& words, const Scenario& scenario) {
  const std::string& last = words.back();
  const bool total = last == "count" || last == "censored";
  if (words.size() == (total ? 3u : 4u)) {
    const std::vector<std::string> groups = group_names(scenario);
    index_ = index_of(words[1], groups);
    index_ = groups.size() > 1 ? index_ + 1 : 0;  // a single group has no summary of its own
  }
  if (total) {
    kind_ = last == "count" ? Kind::count : Kind::censored;
  } else {
    quantity_ = find_rock_statistic(words[words.size() - 2]);
    statistic_ = static_cast<Statistic>(index_of(last, statistic_names));
  }
}

void Measure::read_body(const std::vector<std::string>& words, const Scenario& scenario) {
  const auto is_stress = [&](const StressQuantity& number) { return words[2] == number.name; };
  if (std::any_of(stress_quantities.begin(), stress_quantities.end(), is_stress)) {
    kind_ = Kind::stress;
    body_ = words[1];
    field_ = words[2];
    table_ = words[3];
    return;
  }
  kind_ = Kind::body;
  index_ = index_of(words[1], names_of(scenario.bodies));
  const std::size_t bracket = words[2].find('[');  // impact[3]
  table_ = words[2].substr(0, bracket);
  if (bracket != std::string::npos)
    std::from_chars(words[2].data() + bracket + 1, words[2].data() + words[2].size(), number_);
  if (words.size() > 3) field_ = words[3];
}

void Measure::read_contact(const std::vector<std::string>& words) {
  kind_ = Kind::contact;
  const std::optional<double> time = time_of_step(words[4]);
  contact_ = {words[1], words[2], words[3], {time ? "at" : words[4], time.value_or(0), false}};
}

void Measure::read_link(const std::vector<std::string>& words) {
  kind_ = Kind::link;
  const std::optional<double> time = time_of_step(words[3]);
  link_ = {words[1], words[2], {time ? "at" : words[3], time.value_or(0), words[2] == "impulse"}};
}

void Measure::read_region(const std::vector<std::string>& words) {
  kind_ = Kind::region;
  region_.region = words[1];
  for (const RegionQuantity& number : region_quantities)
    if (words[2] == number.name) region_.quantity = number.value;
  const std::optional<double> time = time_of_step(words[3]);
  region_.over = {time ? "at" : words[3], time.value_or(0), false};
}

Measured Measure::value(const PointResult& result) const {
  switch (kind_) {
    case Kind::count:
      return {static_cast<double>(result.groups.at(index_).count), false, {}};
    case Kind::censored:
      return {result.groups.at(index_).censored_share.value, false, {}};
    case Kind::energy:
      return {result.totals.quality.energy_relative_change, false, {}};
    case Kind::solver:
      return solver_value(result, field_);
    case Kind::assembly:
      return {assembly_value(result.totals), false, {}};
    case Kind::contact: {
      const OverSteps::Answer answer = contact_.value(result.series.contacts);
      return {answer.value, false, answer.fault};
    }
    case Kind::link: {
      const OverSteps::Answer answer = link_.value(result.series.links);
      return {answer.value, false, answer.fault};
    }
    case Kind::region: {
      const OverSteps::Answer answer = region_.value(result.series.regions);
      return {answer.value, false, answer.fault};
    }
    case Kind::stress:
      return stress_value(result.series.stresses);
    case Kind::statistic: {
      const Bounded& number = result.groups.at(index_).at(quantity_, statistic_);
      return {number.value, number.censored, std::isnan(number.value) ? "too few rocks" : ""};
    }
    case Kind::gate:
      return gate_value(result.crossings.front().gates.at(index_));
    case Kind::barrier:
      return barrier_value(result.crossings.front().barriers.at(index_));
    case Kind::trees:
      return trees_value(result.trees.value(), field_);
    case Kind::clearance:
      return clearance_value(result.clearances.at(index_), field_);
    case Kind::exposure:
      return exposure_value(result.exposures.at(index_), field_);
    case Kind::body:
      break;
  }
  if (static_cast<std::size_t>(index_) >= result.totals.bodies.size())
    return {0, false, "the body was not run"};
  const BodyHistory& body = result.totals.bodies[index_];
  if (is_fault(body.reason)) return {0, false, fmt::format("{}: {}", name_of(body.reason), body.fault)};
  return body_value(body);
}

Interval Measure::interval(const PointResult& result) const {
  const auto at = [](const Intervals& intervals, Statistic statistic) {
    return intervals[static_cast<std::size_t>(statistic)];
  };
  switch (kind_) {
    case Kind::statistic:
      return result.groups.at(index_).interval(quantity_, statistic_);
    case Kind::censored:
      return result.groups.at(index_).censored_share.interval;
    case Kind::gate: {
      const GateSummary& gate = result.crossings.front().gates.at(index_);
      if (field_ == "mean_energy") return at(gate.energy_intervals, Statistic::mean);
      if (field_ == "p95_energy") return at(gate.energy_intervals, Statistic::p95);
      if (field_ == "p95_height") return at(gate.height_intervals, Statistic::p95);
      return (gate.shares.*sense_).interval;
    }
    case Kind::barrier: {
      const BarrierSummary& barrier = result.crossings.front().barriers.at(index_);
      return (barrier.shares[index_of(field_, barrier_share_names)].*sense_).interval;
    }
    case Kind::trees:
      if (field_ == "hit") return result.trees.value().hit_share.interval;
      if (field_ == "stopped") return result.trees.value().stopped_share.interval;
      break;
    case Kind::clearance:
      if (field_ == "distance") return result.clearances.at(index_).interval;
      break;
    case Kind::exposure:
      if (field_ == "per_blast") return result.exposures.at(index_).per_blast.interval;
      if (field_ == "per_year") return result.exposures.at(index_).per_year_interval;
      break;
    default:
      break;
  }
  return {unknown, unknown};
}

Measured Measure::solver_value(const PointResult& result, const std::string& field) {
  const SolverQuality& q = result.totals.quality;
  int most = 0;
  for (const SeriesSolve& solve : result.series.solves) most = std::max(most, solve.sweeps);
  const std::array<double, solver_fields.size()> values = {q.max_residual,
                                                           static_cast<double>(q.not_converged),
                                                           q.max_penetration,
                                                           static_cast<double>(q.energy_gains),
                                                           static_cast<double>(q.gains_by_slip),
                                                           static_cast<double>(q.iterations),
                                                           static_cast<double>(most)};
  return {values[index_of(field, solver_fields)], false, {}};
}

double Measure::assembly_value(const TrialTotals& totals) const {
  const Assembly assembly = assembly_of(moves_, totals.bodies);
  if (field_ == "at_rest") return assembly.at_rest;
  const BodyState& state = table_ == "mean" ? assembly.mean : table_ == "min" ? assembly.low : assembly.high;
  return value_of(state);
}

Measured Measure::gate_value(const GateSummary& gate) const {
  const std::array<Bounded, gate_fields.size()> values = {
      gate.shares.of_all, gate.energy[static_cast<int>(Statistic::mean)],
      gate.energy[static_cast<int>(Statistic::p95)], gate.height[static_cast<int>(Statistic::p95)]};
  const Bounded number =
      sense_ == &Shares::of_all ? values[index_of(field_, gate_fields)] : Bounded(gate.shares.*sense_);
  return {number.value, number.censored, std::isnan(number.value) ? "no rock passed" : ""};
}

Measured Measure::barrier_value(const BarrierSummary& barrier) const {
  const Share& share = barrier.shares[index_of(field_, barrier_share_names)].*sense_;
  return {share.value, share.censored, std::isnan(share.value) ? "too few rocks" : ""};
}

Measured Measure::trees_value(const TreeSummary& trees, const std::string& field) {
  const std::array<Bounded, tree_fields.size()> values = {
      Bounded(trees.hit_share), trees.stopped_share, {trees.mean_hits, trees.stopped_share.censored}};
  const Bounded& number = values[index_of(field, tree_fields)];
  return {number.value, number.censored, std::isnan(number.value) ? "too few rocks" : ""};
}

Measured Measure::clearance_value(const ClearanceSummary& clearance, const std::string& field) {
  if (clearance.interval.trials_needed > 0)
    return {0, false, fmt::format("too few trials, it needs about {}", clearance.interval.trials_needed)};
  if (!clearance.enough())
    return {0, false,
            fmt::format("it needs {} rocks or blasts, there are {}", clearance.needed, clearance.count)};
  const bool bound = clearance.distance.censored;
  // The ends of an interval are either known or absent, and never censored.
  const std::array<Bounded, clearance_fields.size()> values = {{clearance.distance,
                                                                {clearance.interval.lower, false},
                                                                {clearance.interval.upper, false},
                                                                {clearance.with_factor, bound}}};
  const Bounded& number = values[index_of(field, clearance_fields)];
  return {number.value, number.censored,
          std::isnan(number.value) ? "censored rocks hide that end of the interval" : ""};
}

Measured Measure::exposure_value(const ExposureSummary& exposure, const std::string& field) {
  const std::array<double, exposure_fields.size()> values = {exposure.per_blast.upper, exposure.per_year,
                                                             exposure.hits_per_m2};
  const double value = values[index_of(field, exposure_fields)];
  return {value, false, std::isnan(value) ? "no rock landed" : ""};
}

Measured Measure::body_value(const BodyHistory& body) const {
  if (table_ == "stop_time")
    return {body.stop_time, false, std::isnan(body.stop_time) ? "the body never came to rest" : ""};
  if (table_ == "contact_time") return {body.contact_time, false, {}};
  if (table_ == "impact") {
    if (static_cast<std::size_t>(number_) > body.impacts.size())
      return {0, false, fmt::format("the body had {} impacts", body.impacts.size())};
    return {impact_value(body.impacts[number_ - 1], field_), false, {}};
  }
  if (table_ == "apex") {
    if (static_cast<std::size_t>(number_) > body.apexes.size())
      return {0, false, fmt::format("the body had {} apexes", body.apexes.size())};
    const Apex& apex = body.apexes[number_ - 1];
    return {field_ == "time" ? apex.time : apex.height, false, {}};
  }
  return {state_value(body), false, {}};
}

double Measure::state_value(const BodyHistory& body) const {
  // The extremes of speed do not follow from those of its components, so they are stored separately.
  if (field_ == "speed" && table_ != "final") return table_ == "max" ? body.max_speed : body.min_speed;
  return value_of(table_ == "final" ? body.last : table_ == "max" ? body.max : body.min);
}

Measured Measure::stress_value(const std::vector<SeriesStress>& rows) const {
  const auto quantity = std::find_if(stress_quantities.begin(), stress_quantities.end(),
                                     [&](const StressQuantity& number) { return field_ == number.name; });
  std::vector<double> values;
  for (const SeriesStress& row : rows)
    if (row.body == body_ && !std::isnan(row.*quantity->value)) values.push_back(row.*quantity->value);
  if (values.empty())
    return {0, false,
            field_ == "share_above_strength" ? "the body has no tensile_strength" : "the body is rigid"};
  if (table_ == "final") return {values.back(), false, {}};
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {table_ == "max" ? *greatest : *least, false, {}};
}

double Measure::value_of(const BodyState& s) const {
  const std::array<double, state_fields.size()> values = {
      s.position.x(),  s.position.y(), s.position.z(),    s.velocity.x(),
      s.velocity.y(),  s.velocity.z(), s.velocity.norm(), dimension_ == 2 ? s.spin.z() : s.spin.norm(),
      s.spin.x(),      s.spin.y(),     s.spin.z(),        s.angle,
      s.kinetic_energy};
  return values[index_of(field_, state_fields)];
}

}  // namespace flyrock
