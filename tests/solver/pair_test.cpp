// Two contacts in 2D are solved by their states.

#include <catch2/catch.hpp>
#include <random>

#include "solver/pair_2d.h"
#include "solver/residual.h"
#include "solver/solve.h"

using namespace flyrock;

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;

struct Point {
  Eigen::Vector2d lever, normal;
};

/// Two contacts of one body of 1 kg; its velocity without them is (v, w). With mu_r, rolling resistance [m].
Problem pair_of(const std::array<Point, 2>& points, double inertia, const Eigen::Vector3d& velocity,
                double mu, double mu_r = 0) {
  std::array<Eigen::Matrix3d, 2> columns;
  for (int a = 0; a < 2; ++a) {
    const Eigen::Vector2d &n = points[a].normal, &l = points[a].lever, t(n.y(), -n.x());
    columns[a] << n.x(), t.x(), 0, n.y(), t.y(), 0, l.x() * n.y() - l.y() * n.x(),
        l.x() * t.y() - l.y() * t.x(), 1;
  }
  const Eigen::Matrix3d mobility = Eigen::Vector3d(1, 1, 1 / inertia).asDiagonal();
  Problem problem;
  problem.clear(mu_r > 0 ? 3 : 2);
  for (int a = 0; a < 2; ++a) {
    Problem::Contact contact;
    contact.w = columns[a].transpose() * mobility * columns[a];
    contact.q = columns[a].transpose() * velocity;
    contact.mu = mu;
    contact.mu_r = mu_r;
    problem.contacts.push_back(contact);
    problem.first.push_back(a);
    problem.couple(1 - a, columns[a].transpose() * mobility * columns[1 - a]);
  }
  problem.first.push_back(2);
  return problem;
}

SolveSettings to_rounding() {
  SolveSettings settings;
  settings.to_rounding = true;
  return settings;
}

}  // namespace

TEST_CASE("two contacts of a body are solved to rounding in a few sweeps and one exact solution") {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  const bool rolls = GENERATE(false, true);
  CAPTURE(rolls);
  int most = 0, sliding = 0, sticking = 0, turning = 0;
  for (int k = 0; k < 5000; ++k) {
    // The corners of a box on ground that is bent a little between them
    const double width = 0.2 + std::abs(unit(rng)), height = 0.2 + std::abs(unit(rng));
    std::array<Point, 2> points;
    for (int a = 0; a < 2; ++a) {
      const double tilt = 0.2 * unit(rng);
      points[a] = {{(a == 0 ? -0.5 : 0.5) * width, -0.5 * height}, {-std::sin(tilt), std::cos(tilt)}};
    }
    const double inertia = (width * width + height * height) / 12;
    const Problem problem = pair_of(points, inertia, {unit(rng), -std::abs(unit(rng)), unit(rng)},
                                    0.2 + 0.6 * std::abs(unit(rng)), rolls ? 0.1 * std::abs(unit(rng)) : 0);
    std::vector<Row> r(2, Row::Zero());
    const SolveResult result = solve<2>(problem, to_rounding(), r);
    INFO("case " << k << ": " << r[0].transpose() << ", " << r[1].transpose());
    REQUIRE(result.converged);
    most = std::max(most, result.iterations);
    for (int a = 0; a < 2; ++a) {
      const auto& contact = problem.contacts[a];
      REQUIRE(local_error<2>(contact, problem.velocity(a, r), r[a]) < 1e-12);
      if (r[a][0] > 0) (std::abs(r[a][1]) < 0.999 * contact.mu * r[a][0] ? sticking : sliding)++;
      turning += r[a][0] > 0 && std::abs(r[a][2]) > 0.999 * contact.mu_r * r[a][0];
    }
  }
  CHECK(most <= (rolls ? 60 : 20));
  if (rolls) CHECK(turning > 500);
  CHECK(sliding > 500);
  CHECK(sticking > 500);
}

TEST_CASE("contacts that both nearly stick, but cannot, end with one that slides slowly") {
  // The tangential velocities of two corners of one edge differ by 3e-7 m/s: no impulse stops both.
  const std::array<Point, 2> points{Point{{-0.5, -0.5}, {0, 1}}, Point{{0.5, -0.5}, {0, 1}}};
  Problem problem = pair_of(points, 1.0 / 6, {0.001, -0.05, 0}, 0.6);
  problem.contacts[0].q[1] += 3e-7;
  std::vector<Row> r(2, Row::Zero());
  const SolveResult result = solve<2>(problem, to_rounding(), r);
  REQUIRE(result.converged);
  CHECK(result.iterations <= 20);
  int slides = 0;
  for (int a = 0; a < 2; ++a) {
    CHECK(local_error<2>(problem.contacts[a], problem.velocity(a, r), r[a]) < 1e-15);
    slides += std::abs(problem.velocity(a, r)[1]) > 1e-7;
  }
  CHECK(slides == 1);
}

TEST_CASE("a box that sticks on two corners keeps the share of the thrust that it starts with") {
  const std::array<Point, 2> points{Point{{-0.5, -0.5}, {0, 1}}, Point{{0.5, -0.5}, {0, 1}}};
  const Problem problem = pair_of(points, 1.0 / 6, {0.001, -0.05, 0}, 0.6);
  for (const double thrust : {-0.01, 0.0, 0.005}) {
    std::vector<Row> r{{0.025, -0.0005 + thrust, 0}, {0.025, -0.0005 - thrust, 0}};
    REQUIRE(solve_pair(problem, {PairState{true, 0, 1}, PairState{true, 0, 1}}, r));
    CHECK(r[0][1] - r[1][1] == Approx(2 * thrust).margin(1e-15));
    CHECK(r[0][1] + r[1][1] == Approx(-0.001).epsilon(1e-12));
    CHECK(r[0][0] + r[1][0] == Approx(0.05).epsilon(1e-12));
  }
}
