// Routh's diagram against closed forms of the legs.
#include "solver/routh.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace routh_test {

// A rod at 30 degrees, mu 0.3, e 0.5, v = (-1, -0.2): it slips back until P = 0.10965, then forward, and is
// compressed until 0.31974.
TEST_CASE("the path in impulse space has the corners and ends of the closed form") {
  const double nt = 0.75 * std::sqrt(3.0);
  const Eigen::Matrix2d w{{3.25, nt}, {nt, 1.75}};
  const RouthDiagram diagram = routh_diagram(w, {-1, -0.2}, 0.3, 0.5);
  REQUIRE(diagram.path.size() == 3);
  const double slip_end = 0.2 / (nt + 0.3 * 1.75), first = 3.25 + 0.3 * nt, second = 3.25 - 0.3 * nt;
  const double compression_end = slip_end + (1 - first * slip_end) / second;
  CHECK(diagram.slip_end.impulse[0] == Approx(slip_end));
  CHECK(diagram.slip_end.velocity[1] == Approx(0).margin(1e-15));
  CHECK(diagram.compression_end.impulse[0] == Approx(compression_end));
  CHECK(diagram.compression_end.velocity[0] == Approx(0).margin(1e-15));
  CHECK(diagram.newton.velocity[0] == Approx(0.5));
  CHECK(diagram.newton.impulse[0] == Approx(compression_end + 0.5 / second));
  CHECK(diagram.poisson.impulse[0] == Approx(1.5 * compression_end));
  // The work of restitution is a quarter of that of compression: v_n dP over both legs, then one.
  const double turned = -1 + first * slip_end;
  const double compression = -0.5 * (1 - turned * turned) / first - 0.5 * turned * turned / second;
  CHECK(0.5 * std::pow(diagram.energy.velocity[0], 2) / second == Approx(-0.25 * compression));
  for (const RouthPoint* end : {&diagram.newton, &diagram.poisson, &diagram.energy}) {
    const double along = end->impulse[0] - slip_end;
    CHECK(end->impulse[1] == Approx(0.3 * slip_end - 0.3 * along));
  }
}

TEST_CASE("the lines of sticking and of greatest compression are where the velocities vanish") {
  const double nt = 0.75 * std::sqrt(3.0);
  const Eigen::Matrix2d w{{3.25, nt}, {nt, 1.75}};
  const RouthDiagram diagram = routh_diagram(w, {-1, -0.2}, 0.3, 0.5);
  const double width = diagram.path.back().impulse[0], height = 0.3 * width;
  REQUIRE(diagram.sticking.size() == 2);
  REQUIRE(diagram.greatest_compression.size() == 2);
  for (const RouthPoint& end : diagram.sticking) CHECK(end.velocity[1] == Approx(0).margin(1e-12));
  for (const RouthPoint& end : diagram.greatest_compression)
    CHECK(end.velocity[0] == Approx(0).margin(1e-12));
  for (const auto* line : {&diagram.sticking, &diagram.greatest_compression}) {
    CHECK(((*line)[0].impulse - (*line)[1].impulse).norm() > 0.1 * height);
    for (const RouthPoint& end : *line) {
      CHECK(end.impulse[0] >= -1e-12);
      CHECK(end.impulse[0] <= width + 1e-12);
      CHECK(std::abs(end.impulse[1]) <= height + 1e-12);
    }
  }
  // A push along the normal turns a central contact not at all: no P within reach makes v_t = 0.
  CHECK(routh_diagram(Eigen::Matrix2d{{1, 0}, {0, 3}}, {-2, 30}, 0.2, 0.5).sticking.empty());
}

TEST_CASE("a contact that sticks, or slips throughout, has two legs or one") {
  const Eigen::Matrix2d w{{2.5, 1.5}, {1.5, 2.5}};
  const RouthDiagram sticks = routh_diagram(w, {-1, -0.6}, 1, 0.9);
  REQUIRE(sticks.path.size() == 3);
  CHECK(sticks.path[2].velocity[1] == Approx(0).margin(1e-15));
  CHECK(sticks.slip_end.impulse[0] == Approx(0.15));
  CHECK(sticks.compression_end.impulse[0] == Approx(0.4));
  const RouthDiagram slips = routh_diagram(w, {-1, 5}, 0.1, 0.9);
  REQUIRE(slips.path.size() == 2);
  CHECK(slips.path[1].impulse[1] == Approx(-0.1 * slips.path[1].impulse[0]));
}

}  // namespace routh_test
