#include "batch/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

namespace flyrock {

namespace {

using Names = std::vector<std::string>;

Names split(const std::string& text) {
  Names words(1);
  for (char c : text) {
    if (c == '.')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

[[noreturn]] void unknown(const std::string& what, const std::string& word, const Names& names) {
  std::string text = fmt::format("unknown {} `{}`, expected one of: {}", what, word, fmt::join(names, ", "));
  if (const std::string near = nearest_name(word, names); !near.empty())
    text += fmt::format("; did you mean `{}`?", near);
  throw MeasureError(text);
}

/// The index of `word` in `names`; throws where it is not there.
template <class List>
int index_of(const std::string& what, const std::string& word, const List& names) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) unknown(what, word, Names(names.begin(), names.end()));
  return static_cast<int>(found - names.begin());
}

const Names solver_fields = {"max_residual", "not_converged", "max_penetration", "energy_gains"};
const Names impact_fields = {"time",     "x",        "y",  "z",  "vn_before",    "vn_after",
                             "vt_before", "vt_after", "pn", "pt", "energy_change"};
const Names apex_fields = {"time", "height"};
const Names body_tables = {"final", "max", "min", "stop_time", "contact_time", "impact[n]", "apex[n]"};

Names state_fields(int dimension) {
  if (dimension == 2) return {"x", "y", "vx", "vy", "speed", "spin", "wz", "angle", "kinetic_energy"};
  return {"x", "y", "z", "vx", "vy", "vz", "speed", "spin", "wx", "wy", "wz", "angle", "kinetic_energy"};
}

/// "impact[3]" to "impact" and 3; the number is 0 where there is none.
std::pair<std::string, int> numbered(const std::string& word) {
  const std::size_t open = word.find('[');
  if (open == std::string::npos || word.back() != ']') return {word, 0};
  int number = 0;
  const char* end = word.data() + word.size() - 1;
  const auto read = std::from_chars(word.data() + open + 1, end, number);
  if (read.ptr != end || number < 1)
    throw MeasureError(fmt::format("`{}`: expected a whole number from 1 in the brackets", word));
  return {word.substr(0, open), number};
}

double impact_value(const Impact& impact, const std::string& field) {
  const std::array<double, 11> values = {impact.time,      impact.place.x(),  impact.place.y(), impact.place.z(),
                                         impact.vn_before, impact.vn_after,   impact.vt_before, impact.vt_after,
                                         impact.pn,        impact.pt,         impact.energy_change};
  return values[index_of("field of an impact", field, impact_fields)];
}

}  // namespace

Measure::Measure(const std::string& name, const Scenario& scenario) : name_(name) {
  const Names words = split(name);
  const auto expect_words = [&](std::size_t count) {
    if (words.size() != count) throw MeasureError(fmt::format("`{}`: expected {} words between dots", name, count));
  };
  switch (index_of("measure", words[0], Names{"body", "energy", "rocks", "solver"})) {
    case 0: read_body(words, scenario); break;
    case 1:
      kind_ = Kind::energy;
      if (name != "energy.total.relative_change")
        throw MeasureError(fmt::format("`{}`: expected energy.total.relative_change", name));
      break;
    case 2: read_rocks(words, scenario); break;
    default:
      expect_words(2);
      kind_ = Kind::solver;
      index_of("measure of the solver", words[1], solver_fields);
      field_ = words[1];
  }
}

void Measure::read_rocks(const Names& words, const Scenario& scenario) {
  const std::string& last = words.back();
  const bool counted = last == "count" || last == "censored";
  const std::size_t without_group = counted ? 2 : 3;
  if (words.size() != without_group && words.size() != without_group + 1)
    throw MeasureError(fmt::format("`{}`: expected rocks[.<group>].<quantity>.<statistic>, "
                                   "rocks[.<group>].count or rocks[.<group>].censored",
                                   name_));
  if (words.size() == without_group + 1) {
    const Names groups = group_names(scenario);
    index_ = index_of("group", words[1], groups);
    index_ = groups.size() > 1 ? index_ + 1 : 0;  // a single group is not summarised twice
  }
  if (counted) {
    kind_ = last == "count" ? Kind::count : Kind::censored;
  } else {
    quantity_ = static_cast<RockQuantity>(index_of("quantity", words[words.size() - 2], quantity_names));
    statistic_ = static_cast<Statistic>(index_of("statistic", last, statistic_names));
  }
}

void Measure::read_body(const Names& words, const Scenario& scenario) {
  kind_ = Kind::body;
  if (words.size() < 3)
    throw MeasureError(fmt::format("`{}`: expected body.<name>. and one of: {}", name_, fmt::join(body_tables, ", ")));
  Names bodies;
  for (const BodyPlan& body : scenario.bodies) bodies.push_back(body.name);
  index_ = index_of("body", words[1], bodies);
  std::tie(table_, number_) = numbered(words[2]);

  const bool of_state = table_ == "final" || table_ == "max" || table_ == "min";
  const bool of_list = (table_ == "impact" || table_ == "apex") && number_ > 0;
  if (!of_state && !of_list && table_ != "stop_time" && table_ != "contact_time")
    unknown("measure of a body", words[2], body_tables);
  const std::size_t expected = of_state || of_list ? 4 : 3;
  if (words.size() != expected)
    throw MeasureError(fmt::format("`{}`: expected {} words between dots", name_, expected));
  if (expected == 3) return;
  field_ = words[3];
  if (of_state)
    index_of("field of a state", field_, state_fields(scenario.dimension));
  else
    index_of("field", field_, table_ == "impact" ? impact_fields : apex_fields);
}

Measured Measure::value(const PointResult& result) const {
  switch (kind_) {
    case Kind::count: return {static_cast<double>(result.groups.at(index_).count), false, {}};
    case Kind::censored: return {result.groups.at(index_).censored_share(), false, {}};
    case Kind::energy: return {result.records.quality.energy_relative_change, false, {}};
    case Kind::solver: {
      const SolverQuality& q = result.records.quality;
      const std::array<double, 4> values = {q.max_residual, static_cast<double>(q.not_converged), q.max_penetration,
                                            static_cast<double>(q.energy_gains)};
      return {values[index_of("measure of the solver", field_, solver_fields)], false, {}};
    }
    case Kind::statistic: {
      const Bounded& number = result.groups.at(index_).at(quantity_, statistic_);
      return {number.value, number.censored, std::isnan(number.value) ? "too few rocks" : ""};
    }
    case Kind::body: break;
  }
  if (static_cast<std::size_t>(index_) >= result.records.bodies.size()) return {0, false, "the body was not run"};
  const BodyHistory& body = result.records.bodies[index_];
  if (is_fault(body.reason)) return {0, false, fmt::format("{}: {}", name_of(body.reason), body.fault)};
  return body_value(body);
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
  // The extremes of speed are not those of its components: they are kept beside.
  if (field_ == "speed" && table_ != "final") return table_ == "max" ? body.max_speed : body.min_speed;
  const BodyState& s = table_ == "final" ? body.last : table_ == "max" ? body.max : body.min;
  const std::array<double, 13> values = {s.position.x(), s.position.y(), s.position.z(), s.velocity.x(),
                                         s.velocity.y(), s.velocity.z(), s.velocity.norm(), s.spin.z(),
                                         s.spin.x(),     s.spin.y(),     s.spin.z(),     s.angle,
                                         s.kinetic_energy};
  return values[index_of("field of a state", field_, state_fields(3))];
}

}  // namespace flyrock
