#include "solver/nlgs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/local_2d.h"
#include "solver/residual.h"

namespace flyrock {

/// So that a later solve, which may be the first that is accelerated, does not allocate.
template <int D>
void Nlgs<D>::reserve() {
  const std::size_t rows = few_contacts * Problem::rows;
  for (auto* buffer : {&scale_, &from_, &to_}) buffer->reserve(rows);
  anderson_.begin(std::vector<double>(rows, 1.0));
}

template <int D>
void Nlgs<D>::begin(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r) {
  if (!problem_) reserve();
  problem_ = &problem;
  settings_ = settings;
  result_ = {};
  wanted_ = settings.tolerance;
  if (settings.measure == ErrorMeasure::merit) wanted_ *= merit(problem, r).q;
  expected_ratio_ = 1;
  next_judgement_ = 1;
  best_ = r;  // the answer if no residual is a number
  best_residual_ = std::numeric_limits<double>::infinity();
  if constexpr (D == 3) {
    friction_.clear();
    for (const auto& contact : problem.contacts)
      friction_.emplace_back(contact.w.template topLeftCorner<3, 3>(), contact.mu);
  }
  accelerated_ = problem.size() > few_contacts;
  if (accelerated_) begin_acceleration();
}

template <int D>
void Nlgs<D>::begin_accelerated(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r) {
  begin(problem, settings, r);
  if (accelerated_) return;
  accelerated_ = true;
  begin_acceleration();
}

template <int D>
void Nlgs<D>::begin_acceleration() {
  const Problem& problem = *problem_;
  const int width = problem.width();
  scale_.clear();
  for (const auto& contact : problem.contacts)
    for (int row = 0; row < width; ++row) scale_.push_back(std::sqrt(std::max(0.0, contact.w(row, row))));
  from_.resize(scale_.size());
  to_.resize(scale_.size());
  anderson_.begin(scale_);
}

/// Solves a contact that has the velocity u = b + W_aa r, b by all others. Returns the error of r before, by
/// the measure of the settings: for a step relative to its speed_scale, for the merit squared; 0 if it is not
/// accelerated.
template <int D>
double Nlgs<D>::solve_contact(int a, const Row& b, const Row& u, Row& r) const {
  const auto& contact = problem_->contacts[a];
  double error = 0;
  if (accelerated_)
    error = settings_.measure == ErrorMeasure::merit ? natural_map_squared<D>(contact, u, r)
                                                     : local_error<D>(contact, u, r) / contact.speed_scale;
  if constexpr (D == 2) {
    r = solve_local(contact, b);
  } else if (contact.is_plain()) {
    r.template head<3>() = friction_[a].solve(b.template head<3>(), r.template head<3>());
    r.template tail<3>().setZero();
  } else {
    r = solve_bounded(contact, b, r);
  }
  return error;
}

/// One sweep over the leading N rows. In problems of more than a few contacts, it returns the error seen
/// during the sweep: the error of each contact just before it is solved, by the measure of the settings. For
/// a step this is the greatest error relative to its speed_scale; for the merit it is |F|.
template <int D>
template <int N>
double Nlgs<D>::sweep_rows(std::vector<Row>& r) {
  double greatest = 0, sum = 0;
  for (int a = 0; a < problem_->size(); ++a) {
    Row b = problem_->contacts[a].q;
    problem_->template add_couplings<N>(a, r, b);
    Row u = b;
    if (accelerated_) u.template head<N>().noalias() += own<N>(a) * r[a].template head<N>();
    const double error = solve_contact(a, b, u, r[a]);
    greatest = std::max(greatest, error);
    sum += error;
  }
  return settings_.measure == ErrorMeasure::merit ? std::sqrt(sum) : greatest;
}

/// The same with the velocities that the impulses give to the bodies, v = sum of M^-1 H_b r_b:
///   u_a = q_a + H_a^T v,   b_a = u_a - W_aa r_a.
template <int D>
template <int N>
double Nlgs<D>::sweep_bodies(std::vector<Row>& r) {
  const Problem& problem = *problem_;
  find_motions<N>(problem, r, motions_);
  double greatest = 0, sum = 0;
  for (int a = 0; a < problem.size(); ++a) {
    const Row u = velocity_by<N>(problem, a, motions_);
    Row b = u;
    b.template head<N>().noalias() -= own<N>(a) * r[a].template head<N>();
    const Row before = r[a];
    const double error = solve_contact(a, b, u, r[a]);
    push_bodies<N, D>(problem, a, r[a] - before, motions_);
    greatest = std::max(greatest, error);
    sum += error;
  }
  return settings_.measure == ErrorMeasure::merit ? std::sqrt(sum) : greatest;
}

template <int D>
double Nlgs<D>::sweep(std::vector<Row>& r) {
  const bool is_plain = problem_->width() == D;
  if (!problem_->sides.empty()) return is_plain ? sweep_bodies<D>(r) : sweep_bodies<Problem::rows>(r);
  return is_plain ? sweep_rows<D>(r) : sweep_rows<Problem::rows>(r);
}

/// Replaces r, the result of a sweep from from_, by the next start.
template <int D>
void Nlgs<D>::accelerate(std::vector<Row>& r) {
  const int width = problem_->width();
  for (int a = 0, k = 0; a < problem_->size(); ++a)
    for (int row = 0; row < width; ++row) to_[k++] = r[a][row];
  anderson_.mix(from_.data(), to_.data());
  for (int a = 0, k = 0; a < problem_->size(); ++a)
    for (int row = 0; row < width; ++row) r[a][row] = to_[k++];
}

/// Checks r; the velocities of the bodies make it as cheap as a sweep.
template <int D>
void Nlgs<D>::check(const std::vector<Row>& r) {
  if (problem_->sides.empty()) return judge(*problem_, settings_, r, result_);
  if (problem_->width() == D)
    find_motions<D>(*problem_, r, motions_);
  else
    find_motions<Problem::rows>(*problem_, r, motions_);
  judge(*problem_, settings_, r, result_, &motions_);
}

template <int D>
const SolveResult& Nlgs<D>::run(int sweeps, std::vector<Row>& r) {
  constexpr int longest_wait = 32;
  const Problem& problem = *problem_;
  const int end = std::min(settings_.max_iterations, result_.iterations + sweeps);
  while (result_.iterations < end) {
    if (accelerated_)
      for (int a = 0, k = 0; a < problem.size(); ++a)
        for (int row = 0; row < problem.width(); ++row) from_[k++] = r[a][row];
    const double met = sweep(r);
    const int k = ++result_.iterations;
    if (!accelerated_ || k >= next_judgement_ || met * expected_ratio_ <= wanted_ || k == end) {
      check(r);
      if (result_.converged) return result_;
      const double scale = settings_.measure == ErrorMeasure::merit
                               ? settings_.tolerance / wanted_
                               : problem.contacts[result_.worst_contact].speed_scale;
      if (met > 0 && scale > 0) expected_ratio_ = std::min(1.0, result_.residual / (met * scale));
      next_judgement_ = k + std::min(k, longest_wait);
      if (result_.residual < best_residual_) best_ = r, best_residual_ = result_.residual;
    }
    if (accelerated_) accelerate(r);
  }
  r = best_;
  check(r);
  return result_;
}

template <int D>
SolveResult Nlgs<D>::solve(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r) {
  begin(problem, settings, r);
  return run(settings.max_iterations, r);
}

template class Nlgs<2>;
template class Nlgs<3>;

}  // namespace flyrock
