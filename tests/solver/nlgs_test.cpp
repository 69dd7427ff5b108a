#include "solver/nlgs.h"

#include <catch2/catch.hpp>
#include <random>

#include "solver/local_2d.h"
#include "solver/residual.h"

using namespace flyrock;

namespace nlgs_test {

namespace {

using Problem = ContactProblem<2>;

/// A contact of one body of mass 1 and inertia `inertia` with lever r.
Problem::Contact single(const Eigen::Vector2d& r, double inertia, const Problem::Row& q, double mu,
                        double mu_r = 0) {
  Eigen::Matrix3d columns;  // n = (0, 1), t = (1, 0)
  columns << 0, 1, 0, 1, 0, 0, r.x(), -r.y(), 1;
  Problem::Contact contact;
  contact.w = columns.transpose() * Eigen::Vector3d(1, 1, 1 / inertia).asDiagonal() * columns;
  contact.q = q;
  contact.mu = mu;
  contact.mu_r = mu_r;
  return contact;
}

}  // namespace

TEST_CASE("the local solve satisfies Signorini, Coulomb and rolling for random contacts") {
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 20000; ++k) {
    const double mu = std::abs(unit(rng)) * 2, mu_r = k % 2 ? std::abs(unit(rng)) * 0.3 : 0;
    const auto contact = single({unit(rng), unit(rng)}, 0.05 + std::abs(unit(rng)),
                                {unit(rng), unit(rng), unit(rng)}, mu, mu_r);
    const Problem::Row r = solve_local(contact, contact.q);
    const Problem::Row u = contact.q + contact.w * r;
    INFO("case " << k << " r " << r.transpose() << " u " << u.transpose());
    REQUIRE(r.allFinite());
    REQUIRE(local_error<2>(contact, u, r) < 1e-12);
    REQUIRE(r[0] >= 0);
    REQUIRE(std::abs(r[1]) <= mu * r[0] * (1 + 1e-15));
    if (r[0] > 0 && std::abs(u[1]) > 1e-9) REQUIRE(r[1] * u[1] <= 0);  // friction opposes slip
  }
}

TEST_CASE("a contact with cohesion is solved exactly, open or closed, sliding or sticking") {
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  int open_and_held = 0;
  for (int k = 0; k < 20000; ++k) {
    const double mu_r = k % 2 ? std::abs(unit(rng)) * 0.3 : 0;
    auto contact = single({0.3 * unit(rng), unit(rng)}, 0.3 + std::abs(unit(rng)),
                          {unit(rng), unit(rng), unit(rng)}, std::abs(unit(rng)), mu_r);
    contact.c_t = std::abs(unit(rng));
    const Problem::Row r = solve_local(contact, contact.q);
    const Problem::Row u = contact.q + contact.w * r;
    INFO("case " << k << " r " << r.transpose() << " u " << u.transpose());
    REQUIRE(local_error<2>(contact, u, r) < 1e-12);
    REQUIRE(std::abs(r[1]) <= (contact.mu * r[0] + contact.c_t) * (1 + 1e-15));
    open_and_held += r[0] == 0 && std::abs(u[1]) < 1e-12;
  }
  CHECK(open_and_held > 1000);
}

TEST_CASE("worked rod impacts of the reference, algebraic Newton") {
  // Uniform rod, m = 1, L = 1, at 30 degrees: W_tt 1.75, W_tn 1.299038, W_nn 3.25.
  const auto impact = [](double degrees, double mu, double e, double vx, double vy) {
    const double a = degrees * 3.14159265358979323846 / 180;
    Problem::Contact contact = single({0.5 * std::cos(a), -0.5 * std::sin(a)}, 1.0 / 12, {vy, vx, 0}, mu);
    contact.q[0] += e * vy;
    return solve_local(contact, contact.q);
  };
  const auto a = impact(30, 0.3, 0.5, 1, -1);
  CHECK(a[0] == Approx(0.524423).epsilon(1e-5));
  CHECK(a[1] == Approx(-0.157327).epsilon(1e-5));
  const auto b = impact(30, 0.3, 0.5, -1.2, -1);
  CHECK(b[0] == Approx(0.412121).epsilon(1e-5));
  CHECK(b[1] == Approx(0.123636).epsilon(1e-5));
  const auto d = impact(30, 0.8, 0.5, -0.5, -1);
  CHECK(d[0] == Approx(0.493870).epsilon(1e-5));
  CHECK(d[1] == Approx(-0.080889).epsilon(1e-5));
  const auto g = impact(45, 1, 0.9, -0.6, -1);
  CHECK(g[0] == Approx(0.9625).epsilon(1e-5));
  CHECK(g[1] == Approx(-0.3375).epsilon(1e-5));
}

TEST_CASE("a rod beyond the Painleve paradox gets an impulse") {
  const double angle = 63.435 * 3.14159265358979323846 / 180;
  for (const double mu : {1.2, 1.4, 2.0, 5.0}) {
    for (const double slip : {-1.0, 0.0, 1.0}) {
      const auto contact =
          single({0.5 * std::cos(angle), -0.5 * std::sin(angle)}, 1.0 / 12, {-1, slip, 0}, mu);
      const Problem::Row r = solve_local(contact, contact.q);
      REQUIRE(r.allFinite());
      CHECK(r[0] > 0);
      CHECK(local_error<2>(contact, contact.q + contact.w * r, r) < 1e-12);
    }
  }
}

TEST_CASE("two contacts of a resting block share its weight, whatever the start") {
  // Square of side 1, mass 1, on two corners; free velocity g h downwards.
  Problem problem;
  const double inertia = 1.0 / 6, gh = 9.81e-3;
  const auto columns = [](double x) {
    Eigen::Matrix3d c;
    c << 0, 1, 0, 1, 0, 0, x, 0.5, 1;
    return c;
  };
  const Eigen::Vector3d inverse_mass(1, 1, 1 / inertia);
  for (const double x : {-0.5, 0.5}) {
    Problem::Contact contact;
    contact.w = columns(x).transpose() * inverse_mass.asDiagonal() * columns(x);
    contact.q = {-gh, 0, 0};
    contact.mu = 0.5;
    contact.speed_scale = gh;
    problem.contacts.push_back(contact);
  }
  problem.first = {0, 1, 2};
  problem.couple(1, columns(-0.5).transpose() * inverse_mass.asDiagonal() * columns(0.5));
  problem.couple(0, columns(0.5).transpose() * inverse_mass.asDiagonal() * columns(-0.5));
  std::vector<Problem::Row> r{Problem::Row(gh, 0.1 * gh, 0), Problem::Row(0, 0, 0)};
  const SolveResult result = Nlgs<2>().solve(problem, {1e-12, 1000}, r);
  CHECK(result.converged);
  CHECK(r[0][0] + r[1][0] == Approx(gh).epsilon(1e-10));
  CHECK(r[0][1] + r[1][1] == Approx(0).margin(1e-12));
}

}  // namespace nlgs_test
