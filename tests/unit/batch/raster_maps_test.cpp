// The cells of maps over a raster are its own, so that a GIS lays one over the other.

#include "load.h"
#include "trial/map_cells.h"

using namespace flyrock;

namespace raster_maps_test {

namespace {

PlanGrid cells_with(const std::vector<std::string>& set) {
  const LoadedScenario scenario = loaded("plugins/terrain/raster/example.yaml", {.set = set});
  const Scenario& point = scenario.plan.points.front();
  TrialRunner runner(point);
  return map_grid(point, *runner.picture_of(0).ground);
}

}  // namespace

TEST_CASE("maps of a raster have its cells, also after a move of the origin, and within a region") {
  const PlanGrid raster{{2600000, 1200000}, 5, 25, 21};  // as the header of slope.asc says
  CHECK(cells_with({}) == raster);
  CHECK(cells_with({"terrain.origin=[2590000, 1199900, 0]"}) == raster);
  // The corners of a region move outwards to those of cells.
  CHECK(cells_with({"output.maps.region=[[2600011, 1200010], [2600060, 1200052]]"}) ==
        PlanGrid{{2600010, 1200010}, 5, 10, 9});
  CHECK(cells_with({"output.maps.cell=2", "output.maps.region=[[2600011, 1200010], [2600061, 1200050]]"}) ==
        PlanGrid{{2600011, 1200010}, 2, 25, 20});
}

}  // namespace raster_maps_test
