// The law of Liu, Zhao and Brogliato against closed forms.
#include "solver/distributing.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace distributing_test {

DistributingSprings springs(int contacts, double exponent, double restitution = 1) {
  return {exponent, Eigen::VectorXd::Ones(contacts), Eigen::VectorXd::Constant(contacts, restitution)};
}

/// Contacts of three equal balls of 1 kg in a row; the first comes with 1 m/s.
const Eigen::Matrix2d cradle{{2, -1}, {-1, 2}};
const Eigen::Vector2d arrival(-1, 0);

/// The velocities of the balls after the path.
Eigen::Vector3d balls(const std::vector<DistributingPoint>& path) {
  const Eigen::VectorXd& p = path.back().impulse;
  return {1 - p[0], p[0] - p[1], p[1]};
}

TEST_CASE("one contact rebounds with its coefficient, whatever its spring") {
  for (const double exponent : {1.0, 1.5, 3.0})
    for (const double e : {1.0, 0.5, 0.1}) {
      const auto path = distributing_path(Eigen::MatrixXd::Constant(1, 1, 2),
                                          Eigen::VectorXd::Constant(1, -3), springs(1, exponent, e));
      CHECK(path.back().velocity[0] == Approx(3 * e).epsilon(1e-5));
      CHECK(path.back().impulse[0] == Approx(1.5 * (1 + e)).epsilon(1e-5));
    }
}

// An ordinary differential equation of six numbers, by Runge and Kutta: -0.07095, 0.07640, 0.99455 m/s.
TEST_CASE("three balls with Hertz's contacts leave as on springs") {
  const Eigen::Vector3d after = balls(distributing_path(cradle, arrival, springs(2, 1.5)));
  CHECK(after[0] == Approx(-0.070952).margin(2e-6));
  CHECK(after[1] == Approx(0.076403).margin(2e-6));
  CHECK(after[2] == Approx(0.994549).margin(2e-6));
  CHECK(after.sum() == Approx(1));
  CHECK(after.squaredNorm() == Approx(1).epsilon(1e-6));
}

// y = (sin t + sin(sqrt 3 t)/sqrt 3, sin t - sin(sqrt 3 t)/sqrt 3)/2 until contact 1 opens; contact 2 then
// swings alone.
TEST_CASE("three balls with linear contacts have the closed form of two modes") {
  const double root = std::sqrt(3.0);
  const auto first = [&](double t) { return 0.5 * (std::sin(t) + std::sin(root * t) / root); };
  double low = 2, high = 3;
  for (int k = 0; k < 60; ++k) (first(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const double t = low;
  const double p1 = 0.5 * (1 - std::cos(t)) + (1 - std::cos(root * t)) / 6;
  const double p2 = 0.5 * (1 - std::cos(t)) - (1 - std::cos(root * t)) / 6;
  const double y2 = 0.5 * (std::sin(t) - std::sin(root * t) / root), v2 = 2 * p2 - p1;
  const double end = (std::sqrt(v2 * v2 + 2 * y2 * y2) - v2) / 2;  // further impulse of contact 2
  const Eigen::Vector3d after = balls(distributing_path(cradle, arrival, springs(2, 1)));
  CHECK(after[0] == Approx(1 - p1).margin(2e-5));
  CHECK(after[1] == Approx(p1 - p2 - end).margin(2e-5));
  CHECK(after[2] == Approx(p2 + end).margin(2e-5));
}

TEST_CASE("a contact that is much stiffer ends first: the balls collide one by one") {
  DistributingSprings stiff = springs(2, 1.5);
  stiff.stiffness[0] = 1e4;
  const Eigen::Vector3d after = balls(distributing_path(cradle, arrival, stiff, 20000));
  CHECK((after - Eigen::Vector3d(0, 0, 1)).norm() < 1e-4);
}

TEST_CASE("only ratios of stiffness matter, and losses are those of the coefficients") {
  DistributingSprings scaled = springs(2, 1.5);
  scaled.stiffness *= 1e9;
  const Eigen::Vector3d one = balls(distributing_path(cradle, arrival, springs(2, 1.5)));
  CHECK((balls(distributing_path(cradle, arrival, scaled)) - one).norm() < 1e-9);
  const Eigen::Vector3d lossy = balls(distributing_path(cradle, arrival, springs(2, 1.5, 0.5)));
  CHECK(lossy.sum() == Approx(1));
  CHECK(lossy.squaredNorm() < 0.9);
}

TEST_CASE("the primary contact changes while the wave passes, and nothing is stored at the end") {
  const auto path = distributing_path(cradle, arrival, springs(2, 1.5));
  CHECK(path[1].primary == 0);
  CHECK(path[path.size() - 10].primary == 1);
  CHECK(path.back().energy.isZero(0));
  CHECK(path.back().velocity.minCoeff() >= 0);
}

TEST_CASE("contacts that do not approach have a path of one point") {
  CHECK(distributing_path(cradle, Eigen::Vector2d(0, 1), springs(2, 1.5)).size() == 1);
}

}  // namespace distributing_test
