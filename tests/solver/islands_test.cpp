// Islands: contacts that do not act on each other are solved as if each island were alone.

#include "solver/islands.h"

#include <catch2/catch.hpp>

#include "solver/solve.h"

using namespace flyrock;

namespace islands_test {

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;

/// A box of mass 1 kg on two corners, which meets the ground with a speed and slips.
struct Box {
  double speed, slip, mu;
};

/// The contacts of boxes: first the left corners of all, then the right ones, so that islands are
/// interleaved.
Problem problem_of(const std::vector<Box>& boxes) {
  const double inertia = 1.0 / 6;
  const int n = static_cast<int>(boxes.size());
  const auto columns = [](double side) {
    Eigen::Matrix3d h = Eigen::Matrix3d::Identity();  // rows: v_n, v_t, w; columns: the rows of a contact
    h(2, 0) = 0.5 * side, h(2, 1) = 0.5;
    return h;
  };
  const Eigen::DiagonalMatrix<double, 3> mobility(1, 1, 1 / inertia);
  Problem problem;
  problem.clear(2);
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < n; ++i) {
      Problem::Contact contact;
      contact.w = columns(side).transpose() * mobility * columns(side);
      contact.q = columns(side).transpose() * Eigen::Vector3d(-boxes[i].speed, boxes[i].slip, 0.1 * i);
      contact.mu = boxes[i].mu;
      problem.contacts.push_back(contact);
      problem.first.push_back(problem.couplings());
      const Problem::Block w = columns(side).transpose() * mobility * columns(-side);
      problem.couple(side < 0 ? n + i : i, w);
    }
  problem.first.push_back(problem.couplings());
  return problem;
}

SolveSettings settings_of_a_step() {
  SolveSettings settings;
  settings.to_rounding = true;
  return settings;
}

std::vector<Row> zeros(const Problem& problem) { return {problem.contacts.size(), Row::Zero()}; }

}  // namespace

TEST_CASE("islands are the contacts that act on each other", "[solver]") {
  const Problem problem = problem_of({{1, 2, 0.5}, {3, 1, 0.1}, {2, 0, 0.9}});
  Islands<2> islands;
  islands.find(problem);
  REQUIRE(islands.count() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(std::vector<int>(islands.contacts(i).begin(), islands.contacts(i).end()) ==
          std::vector<int>{i, i + 3});
    CHECK(islands.of(i) == i);
    CHECK(islands.of(i + 3) == i);
  }
  Problem part;
  islands.extract(problem, 1, part);
  REQUIRE(part.size() == 2);
  CHECK(part.contacts[1].q == problem.contacts[4].q);
  CHECK(part.other(part.first[0]) == 1);
  CHECK(part.block<2>(part.first[1]) == problem.block<2>(problem.first[4]));
}

TEST_CASE("an island gets the same bits alone and among others", "[solver]") {
  const std::vector<Box> boxes = {{1, 2, 0.5}, {3, 1, 0.1}, {2, 0, 0.9}, {1e-3, 40, 1.4}, {0.5, -1, 0}};
  const Problem problem = problem_of(boxes);
  std::vector<Row> together = zeros(problem);
  const SolveResult all = solve<2>(problem, settings_of_a_step(), together);
  CHECK(all.converged);
  std::uint64_t work = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Problem alone;
    Islands<2> islands;
    islands.find(problem);
    islands.extract(problem, static_cast<int>(i), alone);
    std::vector<Row> r = zeros(alone);
    work += solve<2>(alone, settings_of_a_step(), r).work;
    CHECK(r[0] == together[i]);
    CHECK(r[1] == together[i + boxes.size()]);
  }
  CHECK(all.work == work);
}

TEST_CASE("an island that fails is named, whatever the error of the others", "[solver]") {
  // A body that lands, and one that two walls press slowly from both sides: W = [1 -1; -1 1], both closing.
  Problem problem;
  problem.clear(2);
  for (const double speed : {1.0, 1e-9, 1e-9}) {
    Problem::Contact contact;
    contact.w.setIdentity();
    contact.q = Row(-speed, 0, 0);
    contact.speed_scale = speed;
    problem.contacts.push_back(contact);
  }
  const Problem::Block against = -Problem::Block::Identity();
  problem.first = {0, 0};
  problem.couple(2, against);
  problem.first.push_back(problem.couplings());
  problem.couple(1, against);
  problem.first.push_back(problem.couplings());
  SolveSettings settings;
  settings.solver = SolverKind::nlgs;  // Newton steps let impulses grow until rounding hides the error
  settings.max_iterations = 50;
  std::vector<Row> r = zeros(problem);
  const SolveResult result = solve<2>(problem, settings, r);
  CHECK_FALSE(result.converged);
  CHECK((result.worst_contact == 1 || result.worst_contact == 2));
}

}  // namespace islands_test
