// One contact in space: random blocks against the natural map, and what friction must do.

#include "solver/local_3d.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <random>

#include "solver/residual.h"

using namespace flyrock;

namespace local_3d_test {

namespace {

using Problem = ContactProblem<3>;
using Block = Problem::Block;
using Row = Problem::Row;

struct Random {
  std::mt19937 engine;
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  double positive() { return std::abs(unit()); }
  /// Log-uniform over `decades` around 1.
  double scale(double decades) { return std::pow(10, 0.5 * decades * unit()); }
};

/// G^T G + a small diagonal over the leading n rows, scaled by s; each entry off by up to `unsymmetric`,
/// which leaves the block positive definite.
Block random_block(Random& random, int n, double s, double unsymmetric) {
  Block g = Block::Zero(), w = Block::Zero();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) g(i, j) = random.unit();
  w.topLeftCorner(n, n) = (g.transpose() * g + 1e-3 * Block::Identity()).topLeftCorner(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) w(i, j) *= s * (1 + unsymmetric * random.unit());
  return w;
}

/// The local error relative to the velocities at hand.
double relative_error(const Problem::Contact& contact, const Row& r) {
  const Row u = contact.q + contact.w * r;
  return local_error<3>(contact, u, r) /
         (contact.q.head<3>().norm() + contact.w.topRows<3>().norm() * r.norm());
}

}  // namespace

TEST_CASE(
    "100,000 random blocks in space are solved to rounding: mu 0 to 10, scales over 12 decades, slightly "
    "unsymmetric") {
  Random random{std::mt19937(3)};
  int slides = 0, sticks = 0;
  for (int k = 0; k < 100000; ++k) {
    Problem::Contact contact;
    contact.w = random_block(random, 3, random.scale(12), k % 3 ? 0 : 1e-4);
    contact.mu = k % 10 == 0 ? 0 : k % 2 ? random.positive() : 10 * random.positive();
    contact.q.setZero();
    for (int i = 0; i < 3; ++i) contact.q[i] = random.unit() * random.scale(4);
    Row guess = Row::Zero();
    if (k % 4 == 0) guess << random.positive(), random.unit(), random.unit(), 0, 0, 0;
    const Row r = solve_local(contact, contact.q, guess);
    INFO("case " << k << " mu " << contact.mu);
    REQUIRE(r.allFinite());
    REQUIRE(r[0] >= 0);
    const double bound = contact.mu * r[0], t = r.segment<2>(1).norm();
    REQUIRE(t <= bound * (1 + 1e-14));
    const double error = relative_error(contact, r);
    REQUIRE(error < 1e-11);
    if (r[0] == 0) continue;
    const Row u = contact.q + contact.w * r;
    if (t < bound * (1 - 1e-12)) {
      ++sticks;
    } else if (bound > 0) {
      ++slides;
      // Friction opposes the slip: the part of u_t across r_t, and along it with the wrong sign, are
      // rounding.
      const Eigen::Vector2d d = r.segment<2>(1) / t;
      const double size = contact.q.head<3>().norm() + contact.w.norm() * r.norm();
      REQUIRE(d.dot(u.segment<2>(1)) <= 1e-11 * size);
      REQUIRE(std::abs(d.x() * u[2] - d.y() * u[1]) <= 1e-11 * size);
    }
  }
  CHECK(slides > 10000);
  CHECK(sticks > 10000);
}

TEST_CASE("an ill-scaled block in space is solved: normal and tangential rows many decades apart") {
  Random random{std::mt19937(4)};
  for (int k = 0; k < 20000; ++k) {
    Problem::Contact contact;
    contact.w = random_block(random, 3, 1, 0);
    const Eigen::Vector3d rows(random.scale(4), random.scale(4), random.scale(4));
    contact.w.topLeftCorner<3, 3>() = rows.asDiagonal() * contact.w.topLeftCorner<3, 3>() * rows.asDiagonal();
    contact.mu = 2 * random.positive();
    contact.q << -random.positive(), random.unit(), random.unit(), 0, 0, 0;
    const Row r = solve_local(contact, contact.q, Row::Zero());
    INFO("case " << k << " mu " << contact.mu << " rows " << rows.transpose());
    REQUIRE(r.allFinite());
    REQUIRE(relative_error(contact, r) < 1e-11);
  }
}

TEST_CASE("singular blocks give a finite impulse, exact where there is one") {
  Problem::Contact contact;
  contact.w.setZero();
  contact.mu = 0.5;
  contact.q << -1, 3, 4, 0, 0, 0;
  CHECK(solve_local(contact, contact.q, Row::Zero()).isZero());  // nothing can move: no impulse helps
  contact.w(0, 0) = 2;  // the tangential rows do not answer: a slide along the given slip
  const Row r = solve_local(contact, contact.q, Row::Zero());
  CHECK(r[0] == Approx(0.5));
  CHECK(r[1] == Approx(-0.25 * 0.6));
  CHECK(r[2] == Approx(-0.25 * 0.8));
  contact.q << -1, 0, 0, 0, 0, 0;
  CHECK(solve_local(contact, contact.q, Row::Zero())[0] == Approx(0.5));
  // Rank two with q in its range: sticks.
  Eigen::Matrix<double, 3, 2> g;
  g << 1, 0.2, 0.1, 1, 0.3, -0.4;
  contact.w.topLeftCorner<3, 3>() = g * g.transpose();
  contact.mu = 2;
  contact.q.head<3>() = -contact.w.topLeftCorner<3, 3>() * Eigen::Vector3d(1, 0.1, 0.1);
  const Row stick = solve_local(contact, contact.q, Row::Zero());
  CHECK(relative_error(contact, stick) < 1e-13);
}

TEST_CASE("contacts that resist rolling and spinning are solved to rounding") {
  Random random{std::mt19937(5)};
  for (int k = 0; k < 20000; ++k) {
    Problem::Contact contact;
    contact.w = random_block(random, 6, 1, 0);
    contact.mu = 2 * random.positive();
    contact.mu_spin = k % 3 == 0 ? 0 : 0.3 * random.positive();
    contact.mu_r = k % 3 == 1 ? 0 : 0.5 * random.positive() + 1e-6;
    for (int i = 0; i < 6; ++i) contact.q[i] = random.unit();
    const Row r = solve_local(contact, contact.q, Row::Zero());
    INFO("case " << k << " mu " << contact.mu << " spin " << contact.mu_spin << " roll " << contact.mu_r
                 << " r " << r.transpose());
    REQUIRE(r.allFinite());
    REQUIRE(r[0] >= 0);
    REQUIRE(std::abs(r[3]) <= contact.mu_spin * r[0] * (1 + 1e-14));
    REQUIRE(r.tail<2>().norm() <= contact.mu_r * r[0] * (1 + 1e-14));
    REQUIRE(relative_error(contact, r) < 1e-12);
  }
}

TEST_CASE("a contact that resists rolling and is solved already costs less than half of a new solve") {
  Random random{std::mt19937(6)};
  std::vector<Problem::Contact> contacts(500);
  std::vector<Row> zero(contacts.size(), Row::Zero()), answers = zero;
  for (Problem::Contact& contact : contacts) {
    contact.w = random_block(random, 6, 1, 0);
    contact.mu = 0.6, contact.mu_r = 0.1, contact.mu_spin = 0.04;
    for (int i = 0; i < 6; ++i) contact.q[i] = random.unit();
    contact.q[0] = -std::abs(contact.q[0]);
  }
  const auto solve_from =
      [&](const std::vector<Row>& starts) {  // the least of several times of the processor
        std::clock_t least = std::numeric_limits<std::clock_t>::max();
        for (int round = 0; round < 9; ++round) {
          const std::clock_t begin = std::clock();
          std::vector<Row> found;
          for (std::size_t a = 0; a < contacts.size(); ++a)
            found.push_back(solve_local(contacts[a], contacts[a].q, starts[a]));
          least = std::min(least, std::clock() - begin);
          answers = found;
        }
        return least;
      };
  const auto anew = static_cast<double>(solve_from(zero));
  const std::vector<Row> solved = answers;
  CHECK(static_cast<double>(solve_from(solved)) < 0.5 * anew);
}

TEST_CASE("cohesion holds a contact in space that is open, and adds to its friction where it is closed") {
  Random random{std::mt19937(7)};
  int open_and_held = 0, closed = 0;
  for (int k = 0; k < 20000; ++k) {
    Problem::Contact contact;
    contact.w = random_block(random, k % 2 ? 3 : 6, 1, 0);
    contact.mu = random.positive();
    contact.c_t = random.positive();
    contact.mu_r = k % 2 ? 0 : 0.3 * random.positive();
    contact.normal = k % 5 != 0;
    for (int i = 0; i < (k % 2 ? 3 : 6); ++i) contact.q[i] = random.unit();
    if (k % 2) contact.q.tail<3>().setZero();
    const Row r = solve_local(contact, contact.q, Row::Zero()), u = contact.q + contact.w * r;
    INFO("case " << k);
    REQUIRE(r.allFinite());
    REQUIRE(relative_error(contact, r) < 1e-11);
    if (!contact.normal) REQUIRE(r[0] == 0);
    open_and_held += r[0] == 0 && u.segment<2>(1).norm() < 1e-12;
    closed += r[0] > 0;
  }
  CHECK(open_and_held > 1000);
  CHECK(closed > 1000);
}

TEST_CASE("more friction never makes a contact slip faster where the rows are not coupled") {
  Random random{std::mt19937(6)};
  for (int k = 0; k < 200; ++k) {
    Problem::Contact contact;
    contact.w = Block::Zero();
    contact.w.diagonal() << 1, random.positive() + 0.1, random.positive() + 0.1, 0, 0, 0;
    contact.q << -random.positive(), random.unit(), random.unit(), 0, 0, 0;
    double last = 1e300;
    for (double mu = 0; mu < 3; mu += 0.05) {
      contact.mu = mu;
      const Row u = contact.q + contact.w * solve_local(contact, contact.q, Row::Zero());
      const double power = u[1] * u[1] / contact.w(1, 1) + u[2] * u[2] / contact.w(2, 2);
      REQUIRE(power <= last * (1 + 1e-12) + 1e-24);
      last = power;
    }
  }
}

}  // namespace local_3d_test
