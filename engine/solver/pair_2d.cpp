#include "solver/pair_2d.h"

#include <cmath>

namespace flyrock {

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;
using Matrix = Eigen::Matrix4d;
using Vector = Eigen::Vector4d;

constexpr std::array all_states{PairState::open, PairState::sticks, PairState::slides_forward,
                                PairState::slides_backward};
constexpr double at_bound = 1 - 1e-9;  // share of the friction bound from which on a contact slides

PairState state_of(const Problem::Contact& contact, const Row& r) {
  if (r[0] <= 0) return PairState::open;
  if (std::abs(r[1]) < at_bound * contact.mu * r[0]) return PairState::sticks;
  return r[1] < 0 ? PairState::slides_forward : PairState::slides_backward;
}

}  // namespace

std::array<std::array<PairState, 2>, 16> pair_states(const Problem& problem, const std::vector<Row>& r) {
  const std::array<PairState, 2> likely{state_of(problem.contacts[0], r[0]),
                                        state_of(problem.contacts[1], r[1])};
  std::array<std::array<PairState, 2>, 16> states;
  states[0] = likely;
  std::size_t k = 1;
  for (const PairState a : all_states)
    for (const PairState b : all_states)
      if (const std::array<PairState, 2> both{a, b}; both != likely) states[k++] = both;
  return states;
}

bool solve_pair(const Problem& problem, const std::array<PairState, 2>& states, std::vector<Row>& r) {
  // The rows (n, t) of both contacts: W and q, then the equations of the states.
  Matrix w;
  Vector q, start;
  for (int a = 0; a < 2; ++a) {
    w.block<2, 2>(2 * a, 2 * a) = problem.contacts[a].w.topLeftCorner<2, 2>();
    w.block<2, 2>(2 * a, 2 * (1 - a)) = problem.full_block(problem.first[a]).topLeftCorner<2, 2>();
    q.segment<2>(2 * a) = problem.contacts[a].q.head<2>();
    start.segment<2>(2 * a) = r[a].head<2>();
  }
  Matrix equations = w;
  Vector right = -q;
  for (int a = 0; a < 2; ++a) {
    const int n = 2 * a, t = n + 1;
    if (states[a] == PairState::sticks) continue;
    equations.row(t).setZero();
    equations(t, t) = 1;
    right[t] = 0;
    if (states[a] == PairState::open) {
      equations.row(n).setZero();
      equations(n, n) = 1;
      right[n] = 0;
    } else {
      equations(t, n) =
          states[a] == PairState::slides_forward ? problem.contacts[a].mu : -problem.contacts[a].mu;
    }
  }
  const bool both_stick = states[0] == PairState::sticks && states[1] == PairState::sticks;
  Vector x;
  if (both_stick)
    x = start + equations.completeOrthogonalDecomposition().solve(right - equations * start);
  else
    x = equations.partialPivLu().solve(right);
  if (!x.allFinite()) return false;
  for (int a = 0; a < 2; ++a)
    if (x[2 * a] < 0 || std::abs(x[2 * a + 1]) > problem.contacts[a].mu * x[2 * a] * (1 + 1e-12))
      return false;
  for (int a = 0; a < 2; ++a) r[a].head<2>() = x.segment<2>(2 * a);
  return true;
}

}  // namespace flyrock
