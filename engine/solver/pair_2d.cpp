#include "solver/pair_2d.h"

#include <algorithm>
#include <cmath>

#include "solver/dependent_rows.h"

namespace flyrock {

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;

constexpr double at_bound = 1 - 1e-9;  // share of its bound from which on a row moves
constexpr int freedoms = 3;            // of a body
constexpr int point_freedoms = 2;      // a point does not turn

int direction_of(double impulse, double bound) {
  if (std::abs(impulse) < at_bound * bound) return 0;
  return impulse < 0 ? 1 : -1;
}

PairState state_of(const Problem::Contact& contact, const Row& r) {
  if (r[0] <= 0) return {};
  return {true, direction_of(r[1], contact.mu * r[0]), direction_of(r[2], contact.mu_r * r[0])};
}

/// The states of one contact. A row that nothing resists moves, which makes its impulse 0.
boost::container::static_vector<PairState, 10> states_of(const Problem::Contact& contact) {
  boost::container::static_vector<PairState, 10> states{{}};
  for (const int slides : {0, 1, -1})
    for (const int rolls : {0, 1, -1})
      if (rolls == 1 || contact.mu_r > 0) states.push_back({true, slides, rolls});
  return states;
}

/// In how many rows two states differ.
int distance(const PairState& a, const PairState& b) {
  return (a.closed != b.closed) + (a.slides != b.slides) + (a.rolls != b.rolls);
}

/// Whether a factorised system has dependent rows, up to rounding.
template <class Lu>
bool is_singular(const Lu& lu) {
  constexpr double rounding = 1e-13;
  const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
  return pivots.minCoeff() <= rounding * pivots.maxCoeff();
}

/// N rows of each contact.
template <int N>
bool solve_rows(const Problem& problem, const PairStates& states, std::vector<Row>& r) {
  using Matrix = Eigen::Matrix<double, 2 * N, 2 * N>;
  using Vector = Eigen::Matrix<double, 2 * N, 1>;
  Matrix equations;
  Vector right, start;
  int resting = 0;
  for (int a = 0; a < 2; ++a) {
    const Problem::Contact& contact = problem.contacts[a];
    const int first = N * a;
    equations.template block<N, N>(first, first) = contact.w.topLeftCorner<N, N>();
    equations.template block<N, N>(first, N * (1 - a)) = problem.block<N>(problem.first[a]);
    right.template segment<N>(first) = -contact.q.head<N>();
    start.template segment<N>(first) = r[a].head<N>();
    const std::array<int, 3> moves{0, states[a].slides, states[a].rolls};
    for (int row = 0; row < N; ++row) {
      if (states[a].closed && moves[row] == 0) {
        ++resting;
        continue;
      }
      equations.row(first + row).setZero();
      equations(first + row, first + row) = 1;
      right[first + row] = 0;
      if (states[a].closed)
        equations(first + row, first) = moves[row] * (row == 1 ? contact.mu : contact.mu_r);
    }
  }
  const auto lu = equations.partialPivLu();
  Vector x;
  if (resting > freedoms || (resting > point_freedoms && is_singular(lu)))
    x = start + solve_dependent(equations, right - equations * start).col(0);
  else
    x = lu.solve(right);
  if (!x.allFinite()) return false;
  for (int a = 0; a < 2; ++a) {
    const double normal = x[N * a];
    if (normal < 0) return false;
    for (int row = 1; row < N; ++row)
      if (std::abs(x[N * a + row]) > problem.contacts[a].radius(row - 1, normal) * (1 + 1e-12)) return false;
  }
  for (int a = 0; a < 2; ++a) r[a].head<N>() = x.template segment<N>(N * a);
  return true;
}

}  // namespace

bool is_pair(const Problem& problem) {
  return problem.size() == 2 && problem.couplings() == 2 &&
         std::all_of(problem.contacts.begin(), problem.contacts.end(),
                     [](const Problem::Contact& c) { return c.normal && !c.resists_open(); });
}

boost::container::static_vector<PairStates, 100> pair_states(const Problem& problem,
                                                             const std::vector<Row>& r) {
  boost::container::static_vector<PairStates, 100> states;
  for (const PairState& a : states_of(problem.contacts[0]))
    for (const PairState& b : states_of(problem.contacts[1])) states.push_back({a, b});
  const PairStates likely{state_of(problem.contacts[0], r[0]), state_of(problem.contacts[1], r[1])};
  const auto unlikely = [&](const PairStates& s) {
    return distance(s[0], likely[0]) + distance(s[1], likely[1]);
  };
  // Insertion keeps the order of equals, and needs no memory of its own.
  for (auto end = states.begin(); end != states.end(); ++end)
    std::rotate(
        std::upper_bound(states.begin(), end, *end,
                         [&](const PairStates& x, const PairStates& y) { return unlikely(x) < unlikely(y); }),
        end, end + 1);
  return states;
}

bool solve_pair(const Problem& problem, const PairStates& states, std::vector<Row>& r) {
  return problem.width() == 2 ? solve_rows<2>(problem, states, r) : solve_rows<3>(problem, states, r);
}

}  // namespace flyrock
