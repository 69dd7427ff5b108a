// Ten thousand random problems: singular, hyperstatic, ill-scaled. Never a NaN, never a false word about the
// answer.

#include <catch2/catch.hpp>
#include <iostream>
#include <random>

#include "solver/residual.h"
#include "solver/solve.h"

using namespace flyrock;

namespace random_problems_test {

namespace {

struct Random {
  std::mt19937 engine;
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(engine); }
  double scale(double decades) { return std::pow(10, 0.5 * decades * unit()); }
};

/// Contacts between a few bodies and the ground: W = H^T M^-1 H, of the rank of the bodies at most, so that
/// many contacts make it singular. Masses spread over `decades`. Where `possible`, q = H^T v of moving
/// bodies, so that there is a solution (bodies at rest break no condition); else q is anything, and contacts
/// may ask what no motion gives.
template <int D>
ContactProblem<D> random_problem(Random& random, int contacts, int bodies, double decades, bool rolling,
                                 bool possible) {
  using Problem = ContactProblem<D>;
  constexpr int dof = D == 2 ? 3 : 6;
  const int width = rolling ? Problem::rows : D;
  using Columns = Eigen::Matrix<double, dof, Problem::rows>;
  using Velocity = Eigen::Matrix<double, dof, 1>;
  std::vector<double> mobility;
  std::vector<Velocity> velocity;
  for (int i = 0; i < bodies; ++i) {
    mobility.push_back(random.scale(decades));
    velocity.push_back(Velocity::NullaryExpr([&] { return random.unit(); }));
  }
  struct Pair {
    int body[2];
    Columns h[2];
  };
  std::vector<Pair> pairs;
  for (int a = 0; a < contacts; ++a) {
    Pair pair{{random.whole(0, bodies - 1), random.whole(-1, bodies - 1)},
              {Columns::Zero(), Columns::Zero()}};
    if (pair.body[1] == pair.body[0]) pair.body[1] = -1;
    for (auto& h : pair.h)
      for (int j = 0; j < width; ++j)
        for (int i = 0; i < dof; ++i) h(i, j) = random.unit();
    // Now and then a contact that is a copy of the last: a singular pair.
    if (a > 0 && random.whole(0, 4) == 0) pair = pairs.back();
    pairs.push_back(pair);
  }
  Problem problem;
  problem.clear(width);
  for (int a = 0; a < contacts; ++a) {
    typename Problem::Contact contact;
    contact.w.setZero(), contact.q.setZero();
    if (possible) {
      for (int i = 0; i < 2; ++i)
        if (pairs[a].body[i] >= 0) contact.q += pairs[a].h[i].transpose() * velocity[pairs[a].body[i]];
    } else {
      for (int j = 0; j < width; ++j) contact.q[j] = random.unit();
    }
    contact.mu = random.whole(0, 5) == 0 ? 0 : 2 * std::abs(random.unit());
    if (rolling) contact.mu_r = 0.2 * std::abs(random.unit());
    problem.first.push_back(problem.couplings());
    for (int b = 0; b < contacts; ++b) {
      typename Problem::Block w = Problem::Block::Zero();
      bool coupled = false;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          if (pairs[a].body[i] >= 0 && pairs[a].body[i] == pairs[b].body[j]) {
            w += mobility[pairs[a].body[i]] * pairs[a].h[i].transpose() * pairs[b].h[j];
            coupled = true;
          }
      if (b == a)
        contact.w = w;
      else if (coupled)
        problem.couple(b, w);
    }
    problem.contacts.push_back(contact);
  }
  problem.first.push_back(problem.couplings());
  return problem;
}

bool is_possible(int k) { return k % 8 < 6; }

/// Whether the friction of every sliding contact opposes its slip, and what is said about convergence holds.
template <int D>
bool try_one(Random& random, int k) {
  const int contacts = random.whole(1, 60), bodies = random.whole(1, 30);
  const auto problem =
      random_problem<D>(random, contacts, bodies, k % 3 == 0 ? 8 : 2, k % 5 == 0, is_possible(k));
  SolveSettings settings;
  settings.tolerance = 1e-8;
  settings.max_iterations = 400;
  std::vector<typename ContactProblem<D>::Row> r(static_cast<std::size_t>(contacts),
                                                 ContactProblem<D>::Row::Zero());
  const SolveResult result = solve(problem, settings, r);
  REQUIRE(std::isfinite(result.residual));
  bool within = true;
  for (int a = 0; a < contacts; ++a) {
    const auto& contact = problem.contacts[a];
    REQUIRE(r[a].allFinite());
    const auto u = problem.velocity(a, r);
    const double rounding = rounding_error(problem, a, r);
    within = within && local_error<D>(contact, u, r[a]) <= settings.tolerance + rounding;
    if (!result.converged) continue;
    REQUIRE(r[a][0] >= 0);
    const auto t = r[a].template segment<D - 1>(1), slip = u.template segment<D - 1>(1);
    const double friction = t.norm(), speed = slip.norm();
    REQUIRE(friction <= contact.mu * r[a][0] * (1 + 1e-10));
    // Sliding: an error e of the map leaves an angle of e / v between slip and friction, or of e / (w |r_t|)
    // where the friction is weak; its cosine differs from 1 by half its square.
    if (speed > 1e-6 + 10 * rounding && friction > 0) {
      const double w = contact.w.diagonal().template head<D>().maxCoeff();
      const double angle = (settings.tolerance + rounding) / std::min(speed, w * friction);
      REQUIRE(t.dot(slip) <= -friction * speed * (1 - 1e-10 - 2 * angle * angle));
    }
  }
  REQUIRE(result.converged == within);
  return result.converged;
}

void try_many(int problems) {
  Random random{std::mt19937(6)};
  int converged[2] = {0, 0}, tried[2] = {0, 0};
  for (int k = 0; k < problems; ++k) {
    INFO("problem " << k);
    converged[is_possible(k)] += k % 2 ? try_one<3>(random, k) : try_one<2>(random, k);
    ++tried[is_possible(k)];
  }
  std::cout << "converged: " << converged[1] << " of " << tried[1] << " that have a solution, "
            << converged[0] << " of " << tried[0] << " others\n";
  CHECK(converged[1] > 0.85 * tried[1]);
}

}  // namespace

TEST_CASE("a thousand random problems: no NaN, no hang, converged or reported, friction against slip",
          "[slow]") {
  try_many(1000);
}

TEST_CASE("ten thousand random problems: no NaN, no hang, converged or reported, friction against slip",
          "[heavy]") {
  try_many(10000);
}

}  // namespace random_problems_test
