#include "results/measured/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/ground.h"
#include "load/greatest_throw.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

double lowest(const Terrain2& terrain, const Vec2&) {
  const auto& points = terrain.profile().points;
  return std::min_element(points.begin(), points.end(),
                          [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); })
      ->y();
}
double lowest(const Terrain3& terrain, const Vec3& at) {
  const double end = terrain.ground().extent().low.z();
  return std::isinf(end) ? terrain.ground().height(at.x(), at.y()).value_or(at.z()) : end;
}

/// Stores where the first rock of a group starts, and which forces act on it.
template <int D>
void place(LaunchReach& reach, const World<D>& world, const Body<D>& body) {
  reach.origin = {body.x.x(), body.x[D - 1]};
  reach.height = std::max(0.0, body.x[D - 1] - lowest(world.terrain(), body.x));
  reach.mass = body.mass;
  reach.forces.gravity = {0, world.gravity()[D - 1]};
  reach.forces.air = {body.air.drag, {body.air.wind.x(), body.air.wind[D - 1]}};
}

template <int D>
std::vector<LaunchReach> reaches_in(const Scenario& scenario, const std::vector<GroupSummary>& groups) {
  std::vector<LaunchReach> reaches;
  const Trial<D> trial = TrialBuilder<D>(scenario).build(0);
  for (int g = 0; g < static_cast<int>(scenario.rocks.size()); ++g) {
    if (!scenario.rocks[g].launch) continue;
    const auto rock = std::find_if(trial.rocks.begin(), trial.rocks.end(),
                                   [&](const TrialRock& r) { return r.group == g && r.world >= 0; });
    const GroupSummary& summary =
        groups.size() > 1 ? groups.at(1 + static_cast<std::size_t>(g)) : groups.front();
    if (rock == trial.rocks.end() || summary.count == summary.faults) continue;
    LaunchReach reach;
    reach.group = g;
    reach.model = model_text(*scenario.rocks[g].launch);
    reach.longest = scenario.stop.time;
    const World<D>& world = trial.worlds[rock->world];
    place<D>(reach, world, world.bodies[rock->body]);
    if (!(reach.forces.gravity.y() < 0)) continue;  // nothing falls
    for (const Statistic statistic : {Statistic::p50, Statistic::p95, Statistic::max}) {
      const double speed = summary.at(rock_statistic("launch_speed"), statistic).value;
      reach.speeds.push_back(
          {statistic, speed,
           speed > 0 ? farthest(reach.forces, speed, reach.height, reach.longest) : Farthest{}});
    }
    reaches.push_back(std::move(reach));
  }
  return reaches;
}

}  // namespace

std::vector<LaunchReach> reaches_of(const Scenario& scenario, const std::vector<GroupSummary>& groups) {
  try {
    return scenario.dimension == 2 ? reaches_in<2>(scenario, groups) : reaches_in<3>(scenario, groups);
  } catch (const TrialError&) {
    return {};  // the trial could not be built; its row in the results says why
  }
}

}  // namespace flyrock
