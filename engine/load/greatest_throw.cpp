#include "load/greatest_throw.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "document/value.h"
#include "flight/shroud.h"
#include "scenario/blast_readers.h"
#include "scenario/plan.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

constexpr double matters = 0.99;  // share of the formula's distance; a smaller share is short
constexpr std::size_t most_trials_flown = 200, most_builds = 1000;

/// The greatest distances [m] of the rocks of a group.
struct Throws {
  std::size_t point = 0;
  double published = 0;
  double flown = 0;   ///< over level ground, as the scenario gives it
  double vacuum = 0;  ///< the same without air: the effect of the angle alone

  double share() const { return flown / published; }
  bool by_drag() const { return flown < matters * vacuum; }
  bool by_angle() const { return vacuum < matters * published; }
};
using ThrowsOfGroups = std::map<int, Throws>;

template <int D>
void add_flight(const TrialRock& rock, const World<D>& world, double longest, Throws& throws) {
  const Body<D>& body = world.bodies[rock.body];
  Vec<D> level = body.v;
  level[D - 1] = 0;
  const double across = level.norm();
  const Vec2 velocity(across, body.v[D - 1]);
  const Vec<D> direction = across > 0 ? Vec<D>(level / across) : Vec<D>(Vec<D>::UnitX());
  Forces<2> forces;
  forces.gravity = {0, world.gravity()[D - 1]};
  if (!(forces.gravity.y() < 0)) return;  // nothing falls
  const double vacuum = level_range(forces, velocity, 0, longest);
  forces.air = {body.air.drag, {body.air.wind.dot(direction), body.air.wind[D - 1]}};
  throws.published = std::max(throws.published, rock.greatest_throw);
  throws.vacuum = std::max(throws.vacuum, vacuum);
  throws.flown =
      std::max(throws.flown, body.air.drag > 0 ? level_range(forces, velocity, 0, longest) : vacuum);
}

/// The throws of the groups whose model was fitted to distances. Stops after the first trial if there is
/// none.
template <int D>
ThrowsOfGroups throws_in(const Scenario& scenario, std::size_t point, std::uint64_t trials) {
  ThrowsOfGroups groups;
  TrialBuilder<D> builder(scenario);
  for (std::uint64_t t = 0; t < trials && (t == 0 || !groups.empty()); ++t) {
    const Trial<D> trial = builder.build(t);
    for (const TrialRock& rock : trial.rocks) {
      if (rock.world < 0 || !(rock.greatest_throw > 0)) continue;
      Throws& throws = groups[rock.group];
      throws.point = point;
      add_flight<D>(rock, trial.worlds[rock.world], scenario.stop.time, throws);
    }
  }
  return groups;
}

/// The throws of each group, at the sweep point where it lands shortest relative to its formula.
ThrowsOfGroups shortest_throws(const Plan& plan) {
  ThrowsOfGroups shortest;
  const std::size_t points = std::min(plan.points.size(), most_builds);
  const std::size_t trials = std::clamp<std::size_t>(most_builds / points, 1, most_trials_flown);
  for (std::size_t p = 0; p < points; ++p) {
    const Scenario& scenario = plan.points[p];
    const std::uint64_t flown = std::min<std::uint64_t>(trials, scenario.trials);
    const ThrowsOfGroups found =
        scenario.dimension == 2 ? throws_in<2>(scenario, p, flown) : throws_in<3>(scenario, p, flown);
    if (p == 0 && found.empty()) return {};
    for (const auto& [group, throws] : found) {
      const auto [known, is_new] = shortest.try_emplace(group, throws);
      if (!is_new && throws.share() < known->second.share()) known->second = throws;
    }
  }
  std::erase_if(shortest, [](const auto& group) { return group.second.share() >= matters; });
  return shortest;
}

std::string cause(const Throws& throws) {
  if (throws.by_drag() && throws.by_angle()) return "With drag, and at other angles,";
  return throws.by_drag() ? "With drag, which these distances already contain," : "At other angles";
}

ThrowsOfGroups::const_iterator worst_of(const ThrowsOfGroups& groups) {
  return std::min_element(groups.begin(), groups.end(),
                          [](const auto& a, const auto& b) { return a.second.share() < b.second.share(); });
}

std::string text_of(const Plan& plan, const ThrowsOfGroups& groups) {
  const auto worst = worst_of(groups);
  const Throws& throws = worst->second;
  const std::vector<RockGroup>& rocks = plan.points.front().rocks;
  const RockGroup& group = rocks[static_cast<std::size_t>(worst->first)];
  std::string text = fmt::format(
      "{} was fitted to the greatest throw, in air and at its best angle. {} the farthest rock of `{}` lands "
      "at {:.3g} m on level ground, where the published formula gives {:.3g} m",
      model_text(*group.launch), cause(throws), group.name, throws.flown, throws.published);
  if (plan.points.size() > 1) text += fmt::format(" (point {})", throws.point);
  std::vector<std::string> others;
  for (const auto& [g, other] : groups)
    if (g != worst->first)
      others.push_back(fmt::format("`{}` {:.3g} of {:.3g} m", rocks[static_cast<std::size_t>(g)].name,
                                   other.flown, other.published));
  if (!others.empty()) text += fmt::format("; also short: {}", fmt::join(others, ", "));
  return text + ". Leave out `air` and `elevation`, or take a model of launch speeds (docs/which-model.md)";
}

bool may_be_short(const Plan& plan) {
  const std::vector<RockGroup>& rocks = plan.points.front().rocks;
  return std::any_of(rocks.begin(), rocks.end(),
                     [](const RockGroup& group) { return group.launch && reads_blast(*group.launch); });
}

}  // namespace

void warn_of_short_throws(const Value& root, const Plan& plan, Diagnostics& diagnostics) {
  if (!may_be_short(plan)) return;
  try {
    const ThrowsOfGroups groups = shortest_throws(plan);
    if (groups.empty()) return;
    const auto rocks = Node::root(root).find("rocks");
    const Node group = rocks->items().at(static_cast<std::size_t>(worst_of(groups)->first));
    const Node launch = group.find("launch").value_or(group);
    diagnostics.warning(launch.value->at, launch.path, text_of(plan, groups));
  } catch (const TrialError&) {
    return;  // the run reports it, with the trial
  }
}

std::string model_text(const PluginUse& use) {
  const PluginSpec& spec = use.plugin->spec;
  std::string settings;
  const auto add = [&](const std::string& text) { settings += (settings.empty() ? "" : ", ") + text; };
  for (std::size_t i = 0; i < spec.params.size(); ++i) {
    const ParamSpec& param = spec.params[i];
    const ParamValue& value = use.values[i];
    if (!value.given) continue;
    if (param.type == ParamType::choice) add(value.text);
    if (param.type == ParamType::number && param.unit.empty() && value.numbers[0].is_constant())
      add(fmt::format("{} {:.6g}", param.name, value.numbers[0].constant));
  }
  return settings.empty() ? spec.name : fmt::format("{} ({})", spec.name, settings);
}

}  // namespace flyrock
