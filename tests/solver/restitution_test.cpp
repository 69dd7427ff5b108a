// Restitution: every problem of the verification suite, and what the paths and phases must keep everywhere.

#include <catch2/catch.hpp>
#include <random>

#include "samples.h"
#include "verify/check.h"
#include "verify/single_impact.h"

using namespace flyrock;

namespace {

void require_all(const Checks& checks) {
  for (const Check& check : checks) {
    INFO(check.name << ": computed " << check.computed << ", expected " << check.expected << " +- "
                    << check.tolerance);
    CHECK(check.passed);
  }
}

Eigen::Matrix3d random_mobility(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3d half;
  for (int i = 0; i < 9; ++i) half(i) = normal(rng);
  return half * half.transpose() + 0.05 * Eigen::Matrix3d::Identity();
}

/// The same impact by small steps of the midpoint rule in P, slip taken as it comes: slow and rough, but told
/// otherwise.
Eigen::Vector3d marched(const Eigen::Matrix3d& w, const Eigen::Vector3d& v, double mu, ImpactEnd end,
                        double e, int steps) {
  const auto stick_impulse = [&]() -> Eigen::Vector3d {
    Eigen::Vector3d p(1, 0, 0);
    p.tail<2>() = -w.block<2, 2>(1, 1).ldlt().solve(w.block<2, 1>(1, 0));
    return p;
  };
  const bool can_stick = stick_impulse().tail<2>().norm() <= mu;
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), u = v;
  bool stuck = false;
  double turn_impulse = -1, turn_work = 0, work = 0;
  const double dp = 1.0 / steps;
  for (;;) {
    const auto direction = [&](const Eigen::Vector3d& at) -> Eigen::Vector3d {
      if (stuck) return stick_impulse();
      Eigen::Vector3d d(1, 0, 0);
      d.tail<2>() = -mu * at.tail<2>().normalized();
      return d;
    };
    const Eigen::Vector3d half = u + 0.5 * dp * w * direction(u), step = dp * direction(half),
                          next = u + w * step;
    if (!stuck && can_stick && next.tail<2>().dot(u.tail<2>()) <= 0) {
      stuck = true;
      continue;
    }
    p += step;
    work += 0.5 * dp * (u[0] + next[0]);
    u = next;
    if (turn_impulse < 0 && u[0] >= 0) turn_impulse = p[0], turn_work = work;
    if (turn_impulse < 0) continue;
    if (end == ImpactEnd::newton && u[0] >= -e * v[0]) return p;
    if (end == ImpactEnd::poisson && p[0] >= (1 + e) * turn_impulse) return p;
    if (end == ImpactEnd::energy && work - turn_work >= -e * e * turn_work) return p;
  }
}

}  // namespace

TEST_CASE("worked impacts: rods A to G, the double pendulum, the box on its corner") {
  Checks checks;
  check_worked_impacts(checks);
  CHECK(checks.size() > 50);
  require_all(checks);
}

TEST_CASE("an oblique ball, rows of balls, a rod beyond the paradox") {
  Checks checks;
  check_oblique_ball(checks);
  check_ball_rows(checks);
  check_painleve_rod(checks);
  require_all(checks);
}

TEST_CASE("random rod impacts: only newton gains energy", "[slow]") {
  Checks checks;
  check_random_impacts(checks);
  WARN("newton gains energy in " << 100 * checks.at(0).computed << " % of the impacts");
  require_all(checks);
}

TEST_CASE("the path agrees with small steps in impulse space, turning slip and all") {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  for (int k = 0; k < samples(60); ++k) {
    const Eigen::Matrix3d w = random_mobility(rng);
    const Eigen::Vector3d v(-unit(rng), both(rng), both(rng));
    const double mu = unit(rng), e = unit(rng);
    if (w(0, 0) <= mu * w.block<2, 1>(1, 0).norm()) continue;  // the march has no care for jams
    const auto end = static_cast<ImpactEnd>(k % 3);
    const Eigen::Vector3d p = impact_path(w, v, mu, end, e), rough = marched(w, v, mu, end, e, 200000);
    INFO("case " << k << " p " << p.transpose() << " marched " << rough.transpose());
    CHECK((p - rough).norm() < 3e-5);
  }
}

TEST_CASE("in the plane and in space a straight path is the same, and the axes do not matter") {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  for (int k = 0; k < 300; ++k) {
    const Eigen::Matrix3d w = random_mobility(rng);
    const Eigen::Vector3d v(-unit(rng), both(rng), both(rng));
    const double mu = 3 * unit(rng), e = unit(rng), angle = 6 * unit(rng);
    const auto end = static_cast<ImpactEnd>(k % 3);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.bottomRightCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Eigen::Vector3d p = impact_path(w, v, mu, end, e);
    const Eigen::Matrix3d turned_w = turn * w * turn.transpose();
    const Eigen::Vector3d turned_v = turn * v, turned = impact_path(turned_w, turned_v, mu, end, e);
    REQUIRE(p.allFinite());
    INFO("case " << k << " p " << p.transpose() << " turned back "
                 << (turn.transpose() * turned).transpose());
    CHECK((turn.transpose() * turned - p).norm() < 1e-9 * (1 + p.norm()));
  }
}

TEST_CASE("paths of poisson and energy never gain energy and end apart, whatever the friction") {
  std::mt19937 rng(6);
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Matrix3d w = random_mobility(rng);
    const Eigen::Vector3d v(-unit(rng), both(rng), both(rng));
    const double mu = std::pow(10, 2 * both(rng)), e = unit(rng);
    for (const ImpactEnd end : {ImpactEnd::poisson, ImpactEnd::energy}) {
      const Eigen::Vector3d p = impact_path(w, v, mu, end, e), after = v + w * p;
      INFO("case " << k << " p " << p.transpose() << " after " << after.transpose());
      REQUIRE(p.allFinite());
      CHECK(after[0] >= -1e-9);
      CHECK(p.tail<2>().norm() <= mu * p[0] * (1 + 1e-9));
      CHECK(p.dot(v + after) <= 1e-9);
    }
  }
}
