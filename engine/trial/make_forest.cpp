#include "trial/make_forest.h"

#include <fmt/format.h>

#include <cmath>

#include "geometry/ground.h"
#include "geometry/place_text.h"
#include "trial/scenario_error.h"

namespace flyrock {

namespace {

constexpr double most_trees = 2e6;

/// The box in plan in which trees are drawn: of the outline of the zone, else of the ground.
Box2 box_of(const Scenario& scenario, const Ground3& ground) {
  const std::string& name = scenario.forest->zone;
  for (const Zone& zone : scenario.terrain.zones) {
    if (zone.name != name || (zone.polygon.empty() && zone.outlines.empty())) continue;
    const std::vector<std::vector<Vec2>> outlines =
        zone.polygon.empty() ? zone.outlines : std::vector<std::vector<Vec2>>{zone.polygon};
    Box2 box = Box2::empty();
    for (const std::vector<Vec2>& outline : outlines) box.add(Box2::around(outline));
    const Vec2 origin = scenario.terrain.origin.head<2>();
    return {box.low - origin, box.high - origin};
  }
  return {ground.extent().low.head<2>(), ground.extent().high.head<2>()};
}

bool stands_in(const std::string& zone, const Ground3& ground, const Vec2& place) {
  const auto top = ground.top(place.x(), place.y());
  if (!top) return false;
  return zone.empty() || ground.parts().at(static_cast<std::size_t>(ground.part(top->facet))) == zone;
}

std::vector<Stem> drawn(const Scenario& scenario, const Ground3& ground) {
  const ForestPlan& plan = *scenario.forest;
  if (plan.density == 0) return {};
  const Box2 box = box_of(scenario, ground);
  const Vec2 size = box.size();
  const double count = std::round(plan.density * size.x() * size.y());
  if (!std::isfinite(count))
    throw ScenarioError("forest", "the ground has no ends, expected a `zone` with a `polygon`");
  if (count > most_trees)
    throw ScenarioError(
        "forest.density",
        fmt::format("{:.4g} stems would be drawn on {:.4g} m x {:.4g} m, expected at most {:g}", count,
                    size.x(), size.y(), most_trees));
  std::vector<Stem> stems;
  DrawKey key;
  for (key.rock = 1; static_cast<double>(key.rock) <= count; ++key.rock) {
    RandomStream rng(scenario.streams, "forest.place", key);
    const double x = rng.uniform(), y = rng.uniform();
    const Vec2 place = box.low + Vec2(x * size.x(), y * size.y());
    if (!stands_in(plan.zone, ground, place)) continue;
    stems.push_back({.place = place,
                     .radius = plan.diameter.value(plan.draws, scenario.streams, key) / 2,
                     .height = plan.height.value(plan.draws, scenario.streams, key)});
  }
  return stems;
}

std::vector<Stem> of_file(const Scenario& scenario) {
  std::vector<Stem> stems = scenario.forest->stems;
  for (Stem& stem : stems) stem.place -= scenario.terrain.origin.head<2>();
  return stems;
}

}  // namespace

std::shared_ptr<const Forest> make_forest(const Scenario& scenario, const Ground3& ground) {
  if (!scenario.forest) return nullptr;
  const auto make = [&] {
    return std::make_shared<const Forest>(scenario.forest->is_drawn ? drawn(scenario, ground)
                                                                    : of_file(scenario));
  };
  const auto& store = scenario.terrain.grounds;
  if (!store) return make();
  const std::string key =
      fmt::format("forest {} {} {}", scenario.streams.seed, scenario.forest->text, scenario.terrain.text);
  return std::static_pointer_cast<const Forest>(store->get(key, [&] {
    const std::shared_ptr<const Forest> forest = make();
    return GroundStore::Made{forest, forest->stems().size() * (sizeof(Stem) + 2 * sizeof(int))};
  }));
}

std::string trees_off_ground(const Scenario& scenario, const Forest& forest, const Ground3& ground) {
  if (scenario.forest->is_drawn || forest.stems().empty()) return {};
  const Vec2 origin = scenario.terrain.origin.head<2>();
  std::size_t off = 0;
  Vec2 first = Vec2::Zero();
  for (const Stem& stem : forest.stems())
    if (!ground.top(stem.place.x(), stem.place.y()) && off++ == 0) first = stem.place + origin;
  if (off == 0) return {};
  const Vec2 low = ground.extent().low.head<2>() + origin, high = ground.extent().high.head<2>() + origin;
  const std::string text =
      fmt::format("{} of {} trees have no ground below them, the first at {}; the terrain spans {} to {}",
                  off, forest.stems().size(), place_text(first), place_text(low), place_text(high));
  if (off == forest.stems().size()) throw ScenarioError("forest.file", text);
  return text;
}

}  // namespace flyrock
