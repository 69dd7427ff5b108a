// Lower bounds of a gap over time, by which the search for the time of impact advances.

#include <catch2/catch.hpp>
#include <random>

#include "collision/safe_root.h"

using namespace flyrock;

TEST_CASE(
    "a vertex that turns and falls stays open for the safe time, and the third order leaves less of the "
    "gap") {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const GapScale scale(1);
  double left2 = 0, left3 = 0;  // shares of a small gap that are left
  for (int k = 0; k < 5000; ++k) {
    const double arm = 0.1 + unit(rng), spin = 20 * unit(rng), phase = 7 * unit(rng), g = 9.81;
    const double rate = 6 * unit(rng) - 4, lift = 1e-4 + unit(rng) * unit(rng) * unit(rng);
    const auto gap = [&](double t) {
      return lift + arm * (std::cos(phase + spin * t) - std::cos(phase)) + t * (rate - 0.5 * g * t);
    };
    const double slope = rate - arm * spin * std::sin(phase);
    const double curvature = -g - arm * spin * spin * std::cos(phase);
    const double bend = g + arm * spin * spin, jerk = arm * spin * spin * spin, longest = 2 * unit(rng);
    const double second = std::min(longest, safe_time(lift, slope, bend, scale, Counts::fully));
    const double third =
        GapBound{lift, slope, curvature, jerk, bend}.safe_time(longest, scale, Counts::fully);
    INFO("case " << k << ": " << second << " s and " << third << " s of " << longest << " s");
    REQUIRE(third >= second * (1 - 1e-12));
    for (int i = 1; i <= 100; ++i) REQUIRE(gap(third * i / 100) > -1e-12);
    const GapBound bound{lift, slope, curvature, jerk, bend};
    if (bound.stays_open(longest))
      for (int i = 1; i <= 100; ++i) REQUIRE(gap(longest * i / 100) > 0);
    if (lift > 1e-3 || slope > 0 || third >= longest) continue;
    left2 += gap(second) / lift;
    left3 += gap(third) / lift;
  }
  CHECK(left3 < 0.3 * left2);
}

TEST_CASE("a pair that has just separated is open until its bound returns to zero") {
  const GapScale scale(1);
  const GapBound thrown{0, 2, -9.81, 0, 9.81};
  CHECK(thrown.safe_time(10, scale, Counts::from_zero) == Approx(2 * 2 / 9.81).epsilon(1e-12));
  CHECK(thrown.safe_time(0.1, scale, Counts::from_zero) == 0.1);
  CHECK(GapBound{0, -1, -9.81, 0, 9.81}.safe_time(10, scale, Counts::from_zero) == 0);
  CHECK(GapBound{-1e-3, 1, 0, 0, 0}.safe_time(10, scale, Counts::fully) == 0);  // too deep to recover
}

TEST_CASE("the root of a concave bound is found at any scale, also where the bound rises first") {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> unit(0, 1);
  const GapScale scale(1);
  const auto any = [&](double low, double high) { return low * std::pow(high / low, unit(rng)); };
  for (int k = 0; k < 5000; ++k) {
    const double gap = any(1e-11, 1), bend = any(1, 1e7), slope = (unit(rng) < 0.5 ? -1 : 1) * any(1e-6, 100);
    const double speed = std::sqrt(slope * slope + 2 * gap * bend);  // at the root
    const double root = slope > 0 ? (slope + speed) / bend : 2 * gap / (speed - slope);
    const double end = root * any(1.1, 1e6);
    const auto bound = [&](double t) { return gap + t * (slope - 0.5 * bend * t); };
    const double time = safe_root(bound, slope, end, scale, Counts::fully);
    INFO("case " << k << ": " << time << " s of " << root << " s");
    REQUIRE(time <= root * (1 + 1e-9));
    REQUIRE(time >= root * (1 - 1e-5));
  }
}
