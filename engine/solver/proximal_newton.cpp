#include "solver/proximal_newton.h"

#include <algorithm>
#include <cmath>

#include "solver/residual.h"

namespace flyrock {

namespace {

/// max(0, x) with a rounded corner of width e, and its slope. No cancellation for x < 0.
struct Rounded {
  double value, slope;
  Rounded(double x, double e) {
    const double root = std::hypot(x, 2 * e);
    value = x > 0 || root == 0 ? 0.5 * (x + root) : 2 * e * e / (root - x);
    slope = root > 0 ? value / root : 0.5;
  }
};

/// The smoothed law r = p(y) of a contact. Rows that carry nothing have p = 0.
template <int D>
SmoothedLaw<D> smoothed_law(const typename ContactProblem<D>::Contact& contact,
                            const typename ContactProblem<D>::Row& diagonal,
                            const typename ContactProblem<D>::Row& y, double smoothing) {
  SmoothedLaw<D> law;
  law.value.setZero(), law.slope.setZero();
  if (contact.normal && diagonal[0] > 0) {
    const Rounded n(y[0], std::sqrt(smoothing / diagonal[0]));
    law.value[0] = n.value, law.slope(0, 0) = n.slope;
  }
  for (int g = 0; g < static_cast<int>(ContactProblem<D>::groups.size()); ++g) {
    const auto [first, count] = ContactProblem<D>::groups[g];
    const double radius = contact.radius(g, law.value[0]);
    if (radius <= 0 || diagonal[first] <= 0) continue;
    const double size = count == 1 ? std::abs(y[first]) : std::hypot(y[first], y[first + 1]);
    const Rounded beyond(size - radius, std::sqrt(smoothing / diagonal[first]));
    const double m = radius + beyond.value, share = radius / m;
    for (int i = first; i < first + count; ++i) {
      law.value[i] = share * y[i];
      law.slope(i, 0) = y[i] * (1 - share * (1 - beyond.slope)) / m * contact.bound(g) * law.slope(0, 0);
      law.slope(i, i) = share;
      if (size > 0)
        for (int j = first; j < first + count; ++j)
          law.slope(i, j) -= share * beyond.slope / m * y[i] * y[j] / size;
    }
  }
  return law;
}

/// Clips r exactly to its bounds, because a step may end slightly outside.
template <int D>
void clip(const ContactProblem<D>& problem, std::vector<typename ContactProblem<D>::Row>& r) {
  for (int a = 0; a < problem.size(); ++a) {
    r[a][0] = std::max(0.0, r[a][0]);
    for (int g = 0; g < static_cast<int>(ContactProblem<D>::groups.size()); ++g) {
      const auto [begin, count] = ContactProblem<D>::groups[g];
      const double radius = problem.contacts[a].radius(g, r[a][0]),
                   size = r[a].segment(begin, count).stableNorm();
      if (size > radius)
        for (int i = begin; i < begin + count; ++i) r[a][i] *= radius / size;
    }
  }
}

}  // namespace

template <int D>
void ProximalNewton<D>::begin(const Problem& problem) {
  problem_ = &problem;
  const int width = problem.width(), n = problem.size();
  diagonal_.assign(n, Row::Zero());
  scale_.resize(n * width);
  for (int a = 0; a < n; ++a) {
    const auto w = problem.contacts[a].w.diagonal();
    diagonal_[a].template head<D>().setConstant(w.template head<D>().maxCoeff());
    for (std::size_t g = 1; g < Problem::groups.size(); ++g) {
      const auto [first, count] = Problem::groups[g];
      diagonal_[a].segment(first, count).setConstant(w.segment(first, count).maxCoeff());
    }
    for (int i = 0; i < width; ++i)
      scale_[a * width + i] = diagonal_[a][i] > 0 ? std::sqrt(diagonal_[a][i]) : 1;
  }
  analysed_ = false;
}

/// Evaluates the laws at r into laws_, and the scaled F = r - p into error_. Returns |error_|.
template <int D>
double ProximalNewton<D>::find_error(const std::vector<Row>& r, double smoothing) {
  const int width = problem_->width();
  laws_.resize(r.size());
  error_.resize(scale_.size());
  for (int a = 0; a < problem_->size(); ++a) {
    const Row& d = diagonal_[a];
    const Row u = problem_->velocity(a, r) + alpha_ * d.cwiseProduct(r[a] - centre_[a]);
    Row y = r[a];
    for (int i = 0; i < width; ++i)
      if (d[i] > 0) y[i] -= u[i] / d[i];
    laws_[a] = smoothed_law<D>(problem_->contacts[a], d, y, smoothing);
    for (int i = 0; i < width; ++i)
      error_[a * width + i] = (r[a][i] - laws_[a].value[i]) * scale_[a * width + i];
  }
  return error_.norm();
}

/// Solves F' z = -F, from laws_ and error_, into direction_. False if there is no solution.
template <int D>
bool ProximalNewton<D>::find_direction() {
  const int width = problem_->width();
  entries_.clear();
  const auto enter = [&](int a, int b,
                         const Block& w) {  // the part of dp_a / dr_b that acts through u_a, with its sign
    const Block& slope = laws_[a].slope;
    const Row& d = diagonal_[a];
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < width; ++i) {
        double sum = a == b ? (i == j) - slope(i, j) : 0;
        for (int k = 0; k < width; ++k)
          if (slope(i, k) != 0) sum += slope(i, k) * w(k, j) / d[k];
        const int row = a * width + i, column = b * width + j;
        entries_.emplace_back(row, column, sum * scale_[row] / scale_[column]);
      }
  };
  for (int a = 0; a < problem_->size(); ++a) {
    Block w = problem_->contacts[a].w;
    w.diagonal() += alpha_ * diagonal_[a];
    enter(a, a, w);
    for (int k = problem_->first[a]; k < problem_->first[a + 1]; ++k)
      enter(a, problem_->other(k), problem_->full_block(k));
  }
  matrix_.resize(error_.size(), error_.size());
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  if (!analysed_) factors_.analyzePattern(matrix_), analysed_ = true;
  factors_.factorize(matrix_);
  if (factors_.info() != Eigen::Success) return false;
  z_ = factors_.solve(error_);
  if (!z_.allFinite()) return false;
  direction_.assign(laws_.size(), Row::Zero());
  for (int a = 0; a < problem_->size(); ++a)
    for (int i = 0; i < width; ++i) direction_[a][i] = -z_[a * width + i] / scale_[a * width + i];
  return true;
}

/// Checks r, clipped to its bounds, and the result of one sweep from it.
template <int D>
void ProximalNewton<D>::judge_step(Nlgs<D>& sweeper, const std::vector<Row>& r) {
  candidate_ = r;
  clip(*problem_, candidate_);
  for (const bool swept : {false, true}) {
    if (swept) sweeper.sweep_once(candidate_);
    SolveResult found;
    judge(*problem_, settings_, candidate_, found);
    if (found.residual < result_.residual || found.converged) result_ = found, best_ = candidate_;
    if (found.converged) return;
  }
}

/// Solves the shifted problem around r, and stores the next centre in r. False if its Newton steps stall.
template <int D>
bool ProximalNewton<D>::find_next_centre(Nlgs<D>& sweeper, int steps, std::vector<Row>& r) {
  constexpr double wanted = 0.05;      // share of the error at the centre
  constexpr double least_step = 1e-3;  // share of a Newton step
  constexpr double sufficient = 1e-4;  // required decrease, as a share of the step
  const int n = problem_->size();
  centre_ = r;
  const double target = wanted * find_error(r, 0);
  const auto smoothing_for = [n](double error) { return error * error / n; };
  double smoothing = smoothing_for(0.3 * target / wanted);
  for (int k = 0; k < steps; ++k) {
    ++taken_;
    const double before = find_error(r, smoothing);
    if (!find_direction()) return false;
    double share = 1, after = before;
    trial_ = r;
    for (; share > least_step; share *= 0.5) {
      for (int a = 0; a < n; ++a) trial_[a] = r[a] + share * direction_[a];
      after = find_error(trial_, smoothing);
      // Always take the first step in full: it moves far, and the next step corrects its curvature error.
      if ((k == 0 && std::isfinite(after)) || after <= (1 - sufficient * share) * before) break;
    }
    if (share <= least_step) return false;
    r.swap(trial_);
    judge_step(sweeper, r);
    if (result_.converged || find_error(r, 0) <= target) return true;
    if (after <= 0.5 * std::sqrt(smoothing * n))
      smoothing = std::max(smoothing_for(0.2 * target), smoothing * (share == 1 ? 0.1 : 0.5));
  }
  return false;
}

template <int D>
SolveResult ProximalNewton<D>::solve(const Problem& problem, const SolveSettings& settings, Nlgs<D>& sweeper,
                                     int steps, std::vector<Row>& r) {
  constexpr double first_alpha = 1e-3, least_alpha = 1e-12, greatest_alpha = 1;
  constexpr int few = 5, several = 10, many = 20;  // Newton steps between centres
  settings_ = settings;
  begin(problem);
  taken_ = 0;
  alpha_ = first_alpha;
  best_ = r;
  judge(problem, settings, r, result_);
  // Start from zero, because among many solutions the one with the smallest impulses is far from the bounds.
  r.assign(r.size(), Row::Zero());
  while (!result_.converged && taken_ < steps) {
    const int before = taken_;
    next_ = r;
    if (find_next_centre(sweeper, std::min(many, steps - taken_), next_)) {
      r.swap(next_);
      if (taken_ - before <= few)
        alpha_ /= 3;
      else if (taken_ - before <= several)
        alpha_ /= 1.5;
      alpha_ = std::max(alpha_, least_alpha);
    } else {
      alpha_ = std::min(4 * alpha_, greatest_alpha);
    }
  }
  r = best_;
  result_.iterations = taken_;
  result_.solver = SolverKind::proximal_newton;
  return result_;
}

template class ProximalNewton<2>;
template class ProximalNewton<3>;

}  // namespace flyrock
