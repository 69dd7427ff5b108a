#include "solver/residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

template <int D>
using Row = typename ContactProblem<D>::Row;

/// |x - P(x - step u)| with the projection P onto the ball of radius `bound`: of two rows, and of one.
double ball_error(const Eigen::Vector2d& x, const Eigen::Vector2d& u, double step, double bound) {
  Eigen::Vector2d y = x - step * u;
  const double size = y.norm();
  if (size > bound) y *= bound / size;
  return (x - y).norm();
}
double ball_error(double x, double u, double step, double bound) {
  const double y = x - step * u, size = std::abs(y);
  return std::abs(x - (size > bound ? y * (bound / size) : y));
}

template <int D>
double group_error(typename ContactProblem<D>::Group group, const Row<D>& u, const Row<D>& r, double step,
                   double bound) {
  if (group.count == 1) return ball_error(r[group.first], u[group.first], step, bound);
  return ball_error(r.template segment<2>(group.first), u.template segment<2>(group.first), step, bound);
}

template <int D>
double de_saxce_error(double mu, const Eigen::Matrix<double, D, 1>& u, const Eigen::Matrix<double, D, 1>& r) {
  constexpr int tangents = D - 1;
  Eigen::Matrix<double, D, 1> x = r - u;
  x[0] -= mu * u.template tail<tangents>().norm();
  const double n = x[0], t = x.template tail<tangents>().norm();
  if (mu * t <= -n) return r.squaredNorm();
  if (t <= mu * n) return (r - x).squaredNorm();
  const double p = (mu * t + n) / (1 + mu * mu);
  x[0] = p;
  x.template tail<tangents>() *= mu * p / t;
  return (r - x).squaredNorm();
}

/// The part of |F|^2 of a contact that has more than Coulomb friction.
template <int D>
double separate_error(const typename ContactProblem<D>::Contact& contact, const Row<D>& u, const Row<D>& r) {
  double square = contact.normal ? std::pow(r[0] - std::max(0.0, r[0] - u[0]), 2) : r[0] * r[0];
  for (int g = 0; g < static_cast<int>(ContactProblem<D>::groups.size()); ++g)
    if (g == 0 || contact.resists(g))
      square += std::pow(group_error<D>(ContactProblem<D>::groups[g], u, r, 1, contact.radius(g, r[0])), 2);
  return square;
}

}  // namespace

template <int D>
double local_error(const typename ContactProblem<D>::Contact& contact, const Row<D>& u, const Row<D>& r) {
  const double w = contact.w.diagonal().template head<D>().maxCoeff();
  double error = contact.normal ? std::abs(r[0] - std::max(0.0, r[0] - u[0] / w)) * w : std::abs(r[0]) * w;
  for (std::size_t g = 0; g < ContactProblem<D>::groups.size(); ++g) {
    const auto group = ContactProblem<D>::groups[g];
    const double radius = contact.radius(static_cast<int>(g), r[0]);
    if (g == 0) {
      error = std::max(error, group_error<D>(group, u, r, 1 / w, radius) * w);
    } else if (contact.resists(static_cast<int>(g))) {
      const double diagonal = contact.w.diagonal().segment(group.first, group.count).maxCoeff();
      error = std::max(
          error, group_error<D>(group, u, r, 1 / diagonal, radius) * std::sqrt(contact.w(0, 0) * diagonal));
    }
  }
  return error;
}

template <int D>
double rounding_error(const ContactProblem<D>& problem, int a, const std::vector<Row<D>>& r) {
  const auto& contact = problem.contacts[a];
  double size = contact.q.template head<D>().norm() + contact.w.template topRows<D>().norm() * r[a].norm();
  for (int k = problem.first[a]; k < problem.first[a + 1]; ++k) {
    const double w = problem.width() == D
                         ? problem.template block<D>(k).norm()
                         : problem.template block<ContactProblem<D>::rows>(k).template topRows<D>().norm();
    size += w * r[problem.other(k)].norm();
  }
  return 32 * std::numeric_limits<double>::epsilon() * size;
}

template <int D>
double natural_map_squared(const typename ContactProblem<D>::Contact& contact, const Row<D>& u,
                           const Row<D>& r) {
  if (!contact.is_plain()) return separate_error<D>(contact, u, r);
  return de_saxce_error<D>(contact.mu, u.template head<D>(), r.template head<D>());
}

double Merit::fclib() const { return natural_map / (1 + std::sqrt(q)); }

template <int D>
Merit merit(const ContactProblem<D>& problem, const std::vector<Row<D>>& r) {
  Merit result;
  double squares = 0, q = 0, worst = -1;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    const Row<D> u = problem.velocity(a, r);
    const double square = natural_map_squared<D>(contact, u, r[a]);
    q += contact.q.template head<D>().squaredNorm();
    for (std::size_t g = 1; g < ContactProblem<D>::groups.size(); ++g)
      if (contact.resists(static_cast<int>(g)))
        q += contact.q.segment(ContactProblem<D>::groups[g].first, ContactProblem<D>::groups[g].count)
                 .squaredNorm();
    squares += square;
    if (square > worst) worst = square, result.worst_contact = a;
  }
  result.natural_map = std::sqrt(squares);
  result.q = std::sqrt(q);
  return result;
}

template <int D>
void judge(const ContactProblem<D>& problem, const SolveSettings& settings, const std::vector<Row<D>>& r,
           SolveResult& result, const std::vector<BodyMotion<D>>* motions) {
  if (settings.measure == ErrorMeasure::merit) {
    const Merit found = merit(problem, r);
    result.residual = found.relative();
    result.worst_contact = found.worst_contact;
    result.converged = result.residual <= settings.tolerance;
    return;
  }
  result.converged = true;
  result.residual = 0;
  result.worst_contact = -1;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    const Row<D> u = !motions               ? problem.velocity(a, r)
                     : problem.width() == D ? velocity_by<D>(problem, a, *motions)
                                            : velocity_by<ContactProblem<D>::rows>(problem, a, *motions);
    const double error = local_error<D>(contact, u, r[a]);
    if (result.worst_contact < 0 || !(error <= result.residual))
      result.residual = error, result.worst_contact = a;
    const double allowed = settings.tolerance * contact.speed_scale;
    result.converged =
        result.converged && (error <= allowed || error <= allowed + rounding_error(problem, a, r));
  }
}

#define FLYROCK_INSTANTIATE(D)                                                                             \
  template double local_error<D>(const ContactProblem<D>::Contact&, const Row<D>&, const Row<D>&);         \
  template double rounding_error<D>(const ContactProblem<D>&, int, const std::vector<Row<D>>&);            \
  template double natural_map_squared<D>(const ContactProblem<D>::Contact&, const Row<D>&, const Row<D>&); \
  template Merit merit<D>(const ContactProblem<D>&, const std::vector<Row<D>>&);                           \
  template void judge<D>(const ContactProblem<D>&, const SolveSettings&, const std::vector<Row<D>>&,       \
                         SolveResult&, const std::vector<BodyMotion<D>>*);
FLYROCK_INSTANTIATE(2)
FLYROCK_INSTANTIATE(3)
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
