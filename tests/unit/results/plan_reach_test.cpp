// Where rocks were: the window of pictures and the line of the long section.
#include "results/measured/plan_reach.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

RockRecord rock_between(const Vec2& start, const Vec2& stop, StopReason reason = StopReason::stopped) {
  RockRecord r;
  r.reason = reason;
  r.start_x = start.x();
  r.start_y = start.y();
  r.stop_x = stop.x();
  r.stop_y = stop.y();
  r.stop_z = 400;
  return r;
}

}  // namespace

TEST_CASE("The window holds all places of rocks without faults, and a tenth of their extent beyond") {
  PlanReach reach;
  CHECK(reach.empty());
  TrialRecords records;
  records.rocks = {rock_between({2.6e6, 1.2e6}, {2.6e6 + 100, 1.2e6}),
                   rock_between({2.6e6, 1.2e6 + 10}, {2.6e6 + 80, 1.2e6 + 10}),
                   rock_between({0, 0}, {0, 0}, StopReason::not_started)};
  TrajectoryRecord row;
  row.point.state.position = {2.6e6 + 50, 1.2e6 + 40, 450};
  records.trajectories = {row};
  reach.add(records);
  CHECK(reach.window().min() == Vec2(2.6e6 - 10, 1.2e6 - 10));
  CHECK(reach.window().max() == Vec2(2.6e6 + 110, 1.2e6 + 50));
}

TEST_CASE("The long section leads from the mean release towards the mean end over the whole window") {
  PlanReach reach;
  TrialRecords records;
  records.rocks = {rock_between({2.6e6, 1.2e6}, {2.6e6 + 30, 1.2e6 + 40}),
                   rock_between({2.6e6 + 2, 1.2e6}, {2.6e6 + 32, 1.2e6 + 40})};
  reach.add(records);
  const PlanReach::Line line = reach.mean_line();
  CHECK(line.release == Vec2(2.6e6 + 1, 1.2e6));
  CHECK((line.direction - Vec2(0.6, 0.8)).norm() < 1e-12);
  const Vec2 far = reach.window().max() - line.release, near = reach.window().min() - line.release;
  CHECK(line.to == Approx(far.dot(line.direction)));
  CHECK(line.from == Approx(near.dot(line.direction)));
}

TEST_CASE("The section of rocks that stay where they began leads towards +x") {
  PlanReach reach;
  TrialRecords records;
  records.rocks = {rock_between({5, 5}, {5, 5})};
  reach.add(records);
  CHECK(reach.mean_line().direction == Vec2(1, 0));
  CHECK(reach.window().sizes().minCoeff() > 0);
}
