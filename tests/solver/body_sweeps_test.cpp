// Sweeps that carry the velocities of bodies give the same impulses as those with the blocks of W.

#include <catch2/catch.hpp>
#include <random>

#include "solver/nlgs.h"

using namespace flyrock;

namespace body_sweeps_test {

/// A chain of bodies, each of which touches the next at a few points: random columns, random mobilities.
template <int D>
ContactProblem<D> chain(int bodies, int points, int width) {
  using Problem = ContactProblem<D>;
  using Columns = decltype(Problem::Side::columns);
  constexpr int freedoms = Space<D>::dof;
  std::mt19937 dice(5);
  const auto random = [&] { return std::uniform_real_distribution<double>(-1, 1)(dice); };
  Problem problem;
  problem.clear(width);
  problem.bodies = bodies;
  std::vector<Eigen::Matrix<double, freedoms, 1>> inverse(bodies);
  for (auto& mass : inverse) mass = mass.NullaryExpr([&] { return 1.5 + random(); });
  for (int i = 0; i + 1 < bodies; ++i)
    for (int k = 0; k < points; ++k) {
      auto& sides = problem.sides.emplace_back();
      for (const int s : {0, 1}) {
        const Columns columns = Columns::NullaryExpr([&] { return random(); });
        sides[s] = {i + s, columns, inverse[i + s].asDiagonal() * columns};
      }
      auto& contact = problem.contacts.emplace_back();
      contact.q = contact.q.NullaryExpr([&] { return random(); });
      contact.mu = 0.4;
      if (width > D) contact.mu_r = 0.1;
      contact.w =
          sides[0].columns.transpose() * sides[0].mobility + sides[1].columns.transpose() * sides[1].mobility;
    }
  for (int a = 0; a < problem.size(); ++a) {
    problem.first.push_back(problem.couplings());
    for (int b = 0; b < problem.size(); ++b) {
      typename Problem::Block w = Problem::Block::Zero();
      for (const auto& own : problem.sides[a])
        for (const auto& other : problem.sides[b])
          if (own.body == other.body) w += own.columns.transpose() * other.mobility;
      if (a != b && !w.isZero(0)) problem.couple(b, w);
    }
  }
  problem.first.push_back(problem.couplings());
  return problem;
}

template <int D>
double difference(int width) {
  const ContactProblem<D> by_bodies = chain<D>(80, 3, width);
  ContactProblem<D> by_blocks = by_bodies;
  by_blocks.sides.clear();
  REQUIRE(by_bodies.size() >= many_contacts);
  const auto after_sweeps = [](const ContactProblem<D>& problem) {
    std::vector<typename ContactProblem<D>::Row> r(problem.contacts.size(), ContactProblem<D>::Row::Zero());
    SolveSettings settings;
    settings.max_iterations = 12;
    settings.tolerance = 1e-15;
    Nlgs<D>().solve(problem, settings, r);
    return r;
  };
  const auto a = after_sweeps(by_bodies), b = after_sweeps(by_blocks);
  double greatest = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    greatest = std::max(greatest, (a[i] - b[i]).norm());
    size = std::max(size, a[i].norm());
  }
  REQUIRE(size > 0);
  return greatest / size;
}

}  // namespace body_sweeps_test

TEST_CASE("sweeps with the velocities of bodies give the impulses of those with the blocks of W") {
  using namespace body_sweeps_test;
  CHECK(difference<2>(2) < 1e-9);
  CHECK(difference<2>(3) < 1e-9);
  CHECK(difference<3>(3) < 1e-9);
  CHECK(difference<3>(6) < 1e-9);
}
