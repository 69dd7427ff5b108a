#include "math/free_rotation.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

namespace {

const Vec3 box_moments(0.6 * 0.6 + 0.4 * 0.4, 1 + 0.4 * 0.4, 1 + 0.6 * 0.6);  // of 1 x 0.6 x 0.4, times m/12

Vec3 momentum(const Vec3& moments, const Turn& turn) {
  return turn.rotation * moments.cwiseProduct(turn.rotation.inverse(turn.spin));
}
double energy(const Vec3& moments, const Turn& turn) { return 0.5 * turn.spin.dot(momentum(moments, turn)); }

/// Holds a rotation against its differential equations by central differences. Of nearly equal moments the
/// angle about the momentum is a difference of long integrals, right to 1e-16 over the square root of their
/// difference.
void check_motion(const Vec3& moments, const FreeRotation& free, double t) {
  Vec3 sorted = moments;
  std::sort(sorted.data(), sorted.data() + 3);
  const double apart = std::min(sorted[1] - sorted[0], sorted[2] - sorted[1]);
  const double tolerance = apart > 0 && apart < 1e-4 ? 1e-6 : 1e-8;
  const double h = 1e-5;
  const Turn before = free.at(t - h), now = free.at(t), after = free.at(t + h);
  const Vec3 spin = (after.rotation * before.rotation.inverse()).vector() / (2 * h);
  CHECK((spin - now.spin).norm() <= tolerance * (1 + now.spin.norm()));
  const Vec3 w = now.rotation.inverse(now.spin);
  const Vec3 rate = (after.rotation.inverse(after.spin) - before.rotation.inverse(before.spin)) / (2 * h);
  const Vec3 euler = Vec3(moments.cwiseProduct(w)).cross(w).cwiseQuotient(moments);
  CHECK((rate - euler).norm() <= tolerance * (1 + euler.norm()));
}

}  // namespace

TEST_CASE("free rotation keeps momentum and energy and solves Euler's equations") {
  const Vec3 moments =
      GENERATE(Vec3(2, 2, 2), Vec3(1, 1, 3), Vec3(3, 1, 1), Vec3(1, 3, 1), Vec3(1, 2, 2.5), Vec3(2.5, 1, 2),
               Vec3(2, 2.5, 1), Vec3(1, 1 + 1e-6, 1.5), Vec3(1, 1.5, 1.5 + 1e-9));
  const Rotation3 start = Rotation3::from_vector({0.3, -1, 0.7});
  for (const Vec3& w :
       {Vec3(1, 2, 3), Vec3(-3, 0.5, 0.1), Vec3(0.01, 1, 0), Vec3(0, 0.2, -4), Vec3(1e-3, -2, 1e-3),
        Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, -2), Vec3(0, 0, 0), Vec3(-1, 0, 1)}) {
    const FreeRotation free(moments, start, start * w);
    const Turn first = free.at(0);
    CHECK((first.spin - start * w).norm() <= 1e-13);
    CHECK((first.rotation.matrix() - start.matrix()).norm() <= 1e-11);
    const Vec3 momentum_0 = momentum(moments, first);
    for (const double t : {0.1, 1.0, 7.3, 100.0}) {
      const Turn turn = free.at(t);
      CHECK((momentum(moments, turn) - momentum_0).norm() <= 1e-13 * momentum_0.norm());
      CHECK(std::abs(energy(moments, turn) - energy(moments, first)) <= 1e-12 * energy(moments, first));
      CHECK(turn.spin.norm() <= free.greatest_spin() * (1 + 1e-14));
      const double rate = (free.at(t + 1e-6).spin - free.at(t - 1e-6).spin).norm() / 2e-6;
      CHECK(rate <= free.greatest_spin_rate() * (1 + 1e-6) + 1e-8);
      check_motion(moments, free, t);
    }
  }
}

TEST_CASE("a spin that leaves the middle axis by next to nothing turns about it for a while") {
  // As of a rock that topples about an edge: rounding is all that its spin is away from the axis. In a
  // thousandth of a radian it comes no farther from it.
  for (const double away : {1e-15, 1e-14, 1e-12, 1e-10, 1e-8})
    for (int i = 0; i < 100; ++i) {
      const Vec3 spin(away * std::sin(1 + 7 * i), i % 2 == 0 ? 3 : -3, away * std::cos(2 + 5 * i));
      const FreeRotation free(box_moments, {}, spin);
      const double t = 1e-3 / spin.norm();
      const Turn turn = free.at(t);
      CHECK((turn.rotation.matrix() - Rotation3::from_vector(t * spin).matrix()).norm() < 1e-11);
      CHECK((turn.spin - spin).norm() < 1e-11);
    }
}

TEST_CASE("a box spun about its middle axis flips at the time of the elliptic integral, for 100 turns") {
  const Vec3 w0(0.01, 1, 0);
  const FreeRotation free(box_moments, {}, w0);
  const Vec3 momentum_0 = momentum(box_moments, free.at(0));
  const double energy_0 = energy(box_moments, free.at(0));
  double least = 1;
  std::vector<double> crossings;  // of the middle component through 0
  double before = 1;
  const double step = 0.01;
  for (int i = 1; i * step < 2 * pi * 100; ++i) {
    const Turn turn = free.at(i * step);
    CHECK((momentum(box_moments, turn) - momentum_0).norm() <= 1e-10 * momentum_0.norm());
    CHECK(std::abs(energy(box_moments, turn) - energy_0) <= 1e-10 * energy_0);
    const double middle = turn.rotation.inverse(turn.spin).y();
    if (before * middle <= 0) crossings.push_back((i - middle / (middle - before)) * step);
    before = middle;
    least = std::min(least, middle);
  }
  CHECK(least < -0.999);
  REQUIRE(crossings.size() > 20);
  // Landau and Lifshitz, Mechanics, 37: the component about the middle axis is sn, of half period 2 K /
  // lambda.
  const double i1 = box_moments.x(), i2 = box_moments.y(), i3 = box_moments.z();
  const double twice = 2 * energy_0, square = momentum_0.squaredNorm();
  double lambda = std::sqrt((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3));
  double m = (i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1));
  if (m > 1) {
    lambda *= std::sqrt(m);
    m = 1 / m;
  }
  const double flip = 2 * boost::math::ellint_1(std::sqrt(m)) / lambda;
  const double measured = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  CHECK(measured == Approx(flip).epsilon(1e-6));
}
