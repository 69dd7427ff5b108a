// Blocks between joints in motion: what slides, how fast, and what holds.

#include <catch2/catch.hpp>
#include <cmath>

#include "load.h"

using namespace flyrock;

namespace joints_in_motion {

/// The distance of the moving body, or of the rock with the greatest number, from its start.
double way_of(const std::string& file, std::vector<std::string> set) {
  Overrides overrides;
  overrides.set = std::move(set);
  const TrialRecords records = first_trial(loaded("tests/data/joints/" + file, overrides));
  REQUIRE_FALSE(records.rocks.empty());
  if (records.totals.bodies.empty()) {
    double most = 0;
    for (const RockRecord& rock : records.rocks) {
      CHECK(rock.fault.empty());
      most = std::max(most, rock.runout);
    }
    return most;
  }
  const BodyHistory& body = records.totals.bodies.back();
  return (body.last.position - body.first.position).norm();
}

TEST_CASE(
    "a wedge slides with the acceleration of Hoek and Bray, and stands where friction acts across its line") {
  CHECK(way_of("wedge.yaml", {}) == Approx(0.3635097).epsilon(1e-5));
  CHECK(way_of("wedge.yaml", {"stop.time=0.5 s"}) == Approx(0.3635097 / 4).epsilon(1e-4));
  CHECK(way_of("wedge.yaml", {"materials.joint.friction.angle=33 deg"}) < 1e-5);
  // A push of 1 cm/s along the line: friction then acts along it alone.
  CHECK(way_of("wedge.yaml",
               {"materials.joint.friction.angle=33 deg",
                "bodies.wedge.velocity=[0.0032651709075189, -0.0072816684209884, -0.0060262728075879]"}) ==
        Approx(0.01 + 0.5 * 0.0799261).epsilon(1e-3));
}

TEST_CASE("a slab holds or slides by its cohesion, as its factor says") {
  CHECK(way_of("slab.yaml", {}) < 1e-4);
  CHECK(way_of("slab.yaml", {"materials.joint.friction.cohesion=9450 Pa"}) > 0.1);
}

TEST_CASE("the whole of a hexagonal face bears cohesion, not the four points of its manifold alone") {
  CHECK(way_of("hexagon.yaml", {"materials.joint.friction.cohesion=1986.7 Pa"}) < 1e-4);  // 1.01
  CHECK(way_of("hexagon.yaml", {"materials.joint.friction.cohesion=1947.3 Pa"}) > 0.1);   // 0.99
}

}  // namespace joints_in_motion
