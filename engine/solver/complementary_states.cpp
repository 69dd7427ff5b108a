#include "solver/complementary_states.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/nonnegative.h"

namespace flyrock {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double same = 1e-9;        // numbers that differ by less of the greatest are equal
constexpr double dependent = 1e-12;  // pivots below this share of the greatest are 0

/// An unknown x >= 0 of a state: r_n = x and r_t = tangential x at a contact.
struct Push {
  int contact;
  double tangential;
};

/// A row of u that may not have the other sign.
struct SignedRow {
  Index row;
  double sign;
};

/// The equations of a state: u vanishes in the rows `zero`, and the pushes make r. A contact that sticks has
/// the edges of its cone as pushes, so that x >= 0 says |r_t| <= mu r_n.
struct StateEquations {
  std::vector<Push> pushes;
  std::vector<Index> zero;
  std::vector<SignedRow> signs;
};

int slide_of(ContactMode state) {
  return state == ContactMode::slides_forward ? 1 : state == ContactMode::slides_back ? -1 : 0;
}

StateEquations equations_of(const FewContacts& problem, const std::vector<ContactMode>& states) {
  StateEquations all;
  for (int i = 0; i < problem.size(); ++i) {
    const FewContacts::Contact& contact = problem.contacts[i];
    if (states[i] == ContactMode::open) {
      all.signs.push_back({problem.normal(i), 1});
      continue;
    }
    all.zero.push_back(problem.normal(i));
    if (states[i] == ContactMode::sticks) {
      all.zero.push_back(problem.tangential(i));
      all.pushes.push_back({i, contact.mu});
      all.pushes.push_back({i, -contact.mu});
    } else if (const double slides = slide_of(states[i]); slides != 0) {
      all.signs.push_back({problem.tangential(i), slides});
      all.pushes.push_back({i, -slides * contact.mu});
    } else {
      all.pushes.push_back({i, -contact.slip * contact.mu});
    }
  }
  return all;
}

VectorXd impulses(const FewContacts& problem, const std::vector<Push>& pushes, const VectorXd& x) {
  VectorXd r = VectorXd::Zero(problem.q.size());
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    const auto [contact, tangential] = pushes[k];
    r[problem.normal(contact)] += x[static_cast<Index>(k)];
    if (problem.rows > 1) r[problem.tangential(contact)] += tangential * x[static_cast<Index>(k)];
  }
  return r;
}

double scale_of(const FewContacts& problem) { return problem.w.diagonal().cwiseAbs().maxCoeff(); }

/// What a unit of each push adds to some rows of u. Rounding becomes 0, so that dependent rows are seen.
MatrixXd effects(const FewContacts& problem, const std::vector<Push>& pushes,
                 const std::vector<Index>& rows) {
  MatrixXd a(rows.size(), pushes.size());
  const double rounding = dependent * scale_of(problem);
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    const auto [contact, tangential] = pushes[k];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double effect = problem.w(rows[i], problem.normal(contact));
      if (tangential != 0) effect += problem.w(rows[i], problem.tangential(contact)) * tangential;
      a(static_cast<Index>(i), static_cast<Index>(k)) = std::abs(effect) <= rounding ? 0 : effect;
    }
  }
  return a;
}

/// Finds the first contact whose signs are wrong.
void judge(const FewContacts& problem, ComplementaryState& state) {
  const double least_u =
      -same * problem.q.cwiseAbs().maxCoeff() - 1e-13 * (scale_of(problem) * state.r.norm());
  const double least_r = -same * state.r.cwiseAbs().maxCoeff();
  const auto blame = [&](int contact, StateFault fault, double value, double least) {
    if (value >= least) return false;
    state.fault = fault;
    state.contact = contact;
    state.value = value;
    return true;
  };
  for (int i = 0; i < problem.size(); ++i) {
    const double normal = state.r[problem.normal(i)];
    if (state.states[i] == ContactMode::open) {
      if (blame(i, StateFault::penetrates, state.u[problem.normal(i)], least_u)) return;
      continue;
    }
    if (blame(i, StateFault::pulls, normal, least_r)) return;
    if (state.states[i] == ContactMode::sticks) {
      const double reserve = problem.contacts[i].mu * normal - std::abs(state.r[problem.tangential(i)]);
      if (blame(i, StateFault::exceeds, reserve, least_r)) return;
    }
    if (const double slides = slide_of(state.states[i]); slides != 0)
      if (blame(i, StateFault::along_slip, slides * state.u[problem.tangential(i)], least_u)) return;
  }
}

/// The signs of a state as equations A y = b of y >= 0: the pushes, then what signed rows of u exceed 0 by.
struct SignEquations {
  MatrixXd a;
  VectorXd b;
};

SignEquations sign_equations(const FewContacts& problem, const StateEquations& equations) {
  std::vector<Index> rows = equations.zero;
  for (const SignedRow& row : equations.signs) rows.push_back(row.row);
  const auto pushes = static_cast<Index>(equations.pushes.size());
  const auto zero = static_cast<Index>(equations.zero.size());
  const auto size = static_cast<Index>(rows.size());
  SignEquations all{MatrixXd::Zero(size, pushes + size - zero), -problem.q(rows)};
  all.a.leftCols(pushes) = effects(problem, equations.pushes, rows) / scale_of(problem);
  for (Index k = 0; k < size - zero; ++k)
    all.a(zero + k, pushes + k) = -equations.signs[static_cast<std::size_t>(k)].sign;
  return all;
}

bool solves(const MatrixXd& a, const VectorXd& y, const VectorXd& b) {
  return (a * y - b).norm() <= same * b.norm();
}

/// Whether A y = b has other solutions y >= 0: some y_j that is 0 may grow, while those above 0 go anywhere.
bool has_other_solution(const MatrixXd& a, const VectorXd& y) {
  const double least = same * y.cwiseAbs().maxCoeff();
  for (Index j = 0; j < y.size(); ++j) {
    if (y[j] > least) continue;
    MatrixXd ways(a.rows(), 0);
    const auto add = [&](const VectorXd& column) {
      ways.conservativeResize(Eigen::NoChange, ways.cols() + 1);
      ways.rightCols(1) = column;
    };
    for (Index k = 0; k < y.size(); ++k) {
      if (k == j) continue;
      add(a.col(k));
      if (y[k] > least) add(-a.col(k));
    }
    if (solves(ways, nonnegative_least_squares(ways, -a.col(j)), -a.col(j))) return true;
  }
  return false;
}

/// A state whose equations are dependent.
void solve_dependent_state(const FewContacts& problem, const StateEquations& equations,
                           ComplementaryState& state) {
  const SignEquations signs = sign_equations(problem, equations);
  const VectorXd y = nonnegative_least_squares(signs.a, signs.b);
  const auto pushes = static_cast<Index>(equations.pushes.size());
  if (solves(signs.a, y, signs.b)) {
    state.r = impulses(problem, equations.pushes, y.head(pushes)) / scale_of(problem);
    state.u = problem.q + problem.w * state.r;
    state.many = has_other_solution(signs.a, y);
    return;
  }
  const MatrixXd a = effects(problem, equations.pushes, equations.zero);
  const VectorXd b = -problem.q(equations.zero);
  const VectorXd x = a.completeOrthogonalDecomposition().solve(b);
  state.fault = StateFault::no_impulse;
  if (!solves(a, x, b)) return;
  state.r = impulses(problem, equations.pushes, x);
  state.u = problem.q + problem.w * state.r;
  judge(problem, state);
}

void solve_state(const FewContacts& problem, ComplementaryState& state) {
  const StateEquations equations = equations_of(problem, state.states);
  VectorXd x(0);
  if (!equations.pushes.empty()) {
    const Eigen::PartialPivLU<MatrixXd> lu(effects(problem, equations.pushes, equations.zero));
    const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
    if (pivots.minCoeff() <= dependent * scale_of(problem)) {
      solve_dependent_state(problem, equations, state);
      return;
    }
    x = lu.solve(-problem.q(equations.zero));
  }
  state.r = impulses(problem, equations.pushes, x);
  state.u = problem.q + problem.w * state.r;
  judge(problem, state);
}

/// The states that a contact may have, the likely ones first.
std::vector<ContactMode> states_of(const FewContacts::Contact& contact) {
  if (!contact.may_stick()) return {ContactMode::open, ContactMode::closed};
  return {ContactMode::open, ContactMode::sticks, ContactMode::slides_forward, ContactMode::slides_back};
}

/// The feasible states by their velocities.
std::vector<std::vector<std::size_t>> motions_of(const StateSurvey& survey, double speed) {
  std::vector<std::vector<std::size_t>> motions;
  for (std::size_t k = 0; k < survey.states.size(); ++k) {
    if (survey.states[k].fault != StateFault::none) continue;
    const auto is_like = [&](const std::vector<std::size_t>& motion) {
      const VectorXd difference = survey.states[motion.front()].u - survey.states[k].u;
      return difference.cwiseAbs().maxCoeff() <= 10 * same * speed;
    };
    const auto motion = std::find_if(motions.begin(), motions.end(), is_like);
    if (motion == motions.end())
      motions.push_back({k});
    else
      motion->push_back(k);
  }
  return motions;
}

}  // namespace

std::uint64_t number_of_states(const FewContacts& problem) {
  std::uint64_t count = 1;
  for (const FewContacts::Contact& contact : problem.contacts) count *= states_of(contact).size();
  return count;
}

StateSurvey survey_states(const FewContacts& problem, std::size_t most) {
  StateSurvey survey;
  survey.count = number_of_states(problem);
  const bool lists_all = survey.count <= most;
  for (std::uint64_t number = 0; number < survey.count; ++number) {
    ComplementaryState state;
    std::uint64_t rest = number;  // the last contact changes first
    state.states.resize(problem.contacts.size());
    for (int i = problem.size() - 1; i >= 0; --i) {
      const std::vector<ContactMode> choices = states_of(problem.contacts[i]);
      state.states[i] = choices[rest % choices.size()];
      rest /= choices.size();
    }
    solve_state(problem, state);
    ++survey.by_fault[static_cast<std::size_t>(state.fault)];
    if (lists_all || (state.fault == StateFault::none && survey.states.size() < most))
      survey.states.push_back(std::move(state));
  }
  survey.motions = motions_of(survey, problem.q.size() ? problem.q.cwiseAbs().maxCoeff() : 0);
  return survey;
}

}  // namespace flyrock
