#include "record/plan_cells.h"

#include <catch2/catch.hpp>
#include <random>
#include <set>

using namespace flyrock;

namespace {

const PlanGrid small_grid{{-2, 10}, 0.5, 40, 30};

struct Stretch {
  std::uint32_t index;
  double from, to;
};

std::vector<Stretch> visited(const Vec2& place, const Vec2& rate, double to) {
  PlanCells cells(small_grid);
  std::vector<Stretch> list;
  cells.visit(place, rate, 0, to, [&](PlanCell& cell, double t0, double t1) {
    list.push_back({cell.index, t0, t1});
  });
  return list;
}

}  // namespace

TEST_CASE("a line in plan passes each cell under it, one after the other without a gap") {
  std::mt19937 draw(1);
  std::uniform_real_distribution<double> x(-8, 24), y(4, 31), share(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 from(x(draw), y(draw)), rate = Vec2(x(draw), y(draw)) - from;
    const std::vector<Stretch> list = visited(from, rate, 1);
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k > 0) CHECK(list[k].from == list[k - 1].to);
      const Vec2 middle = from + 0.5 * (list[k].from + list[k].to) * rate;
      if (list[k].to - list[k].from > 1e-9) CHECK(small_grid.index(middle) == list[k].index);
    }
    // A place on the line lies in the cell of its time.
    const double t = share(draw);
    const auto at = small_grid.index(from + t * rate);
    const auto of_time =
        std::find_if(list.begin(), list.end(), [&](const Stretch& s) { return s.from <= t && t <= s.to; });
    CHECK(at.has_value() == (of_time != list.end()));
    if (at && of_time != list.end() && t > of_time->from + 1e-9 && t < of_time->to - 1e-9)
      CHECK(*at == of_time->index);
  }
}

TEST_CASE("a body keeps the greatest value of each cell, however often it comes back") {
  PlanCells cells(small_grid);
  for (int i = 0; i < 5000; ++i)
    cells.visit({-1, 12}, {10, 0}, 0, 1,
                [&](PlanCell& cell, double t0, double) { cell.speed = std::max(cell.speed, i + t0); });
  const std::vector<PlanCell>& list = cells.cells();
  REQUIRE(list.size() == 21);
  for (std::size_t k = 0; k < list.size(); ++k)
    CHECK(list[k].speed == Approx(4999 + 0.05 * double(k)).epsilon(1e-12));
}

TEST_CASE("nothing is recorded without a grid, or beside it") {
  PlanCells none;
  none.visit({0, 0}, {1, 1}, 0, 1, [](PlanCell&, double, double) { FAIL("a cell"); });
  CHECK(none.cells().empty());
  CHECK(visited({-3, 12}, {0, 1}, 5).empty());
  CHECK(visited({0, 12}, {0, 0}, 5).size() == 1);
  CHECK_FALSE(small_grid.index({18, 12}));
  CHECK(small_grid.index({-2, 10}) == 0u);
}
