#include "solver/local_3d.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/dependent_rows.h"

namespace flyrock {

namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double eps = std::numeric_limits<double>::epsilon();

Matrix2d adjugate(const Matrix2d& m) {
  Matrix2d a;
  a << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
  return a;
}

/// The greatest root of a x^2 + b x + c, with a > 0 and at least one root, without cancellation.
double greatest_root(double a, double b, double c) {
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  return b <= 0 ? (-b + root) / (2 * a) : -2 * c / (b + root);
}

}  // namespace

FrictionContact3::FrictionContact3(const Matrix3d& w, double mu) : w_(w), mu_(mu) {
  double determinant;
  bool invertible;
  w.computeInverseAndDetWithCheck(inverse_, determinant, invertible, 0);
  const double scale = w.row(0).norm() * w.row(1).norm() * w.row(2).norm();
  singular_ = !invertible || std::abs(determinant) <= 1e-14 * scale || !inverse_.allFinite();
  if (singular_) inverse_ = solve_dependent(w, Matrix3d::Identity());
  if (!inverse_.allFinite()) inverse_.setZero();
}

Vector3d FrictionContact3::solve(const Vector3d& b, const Vector3d& guess) const {
  Vector3d r = Vector3d::Zero();
  if (b[0] >= 0 || w_(0, 0) <= 0) return r;
  if (stick(b, r)) return r;
  if (mu_ <= 0) return {-b[0] / w_(0, 0), 0, 0};
  if (guess[0] > 0) {
    const double size = guess.tail<2>().norm();
    if (size > 0.5 * mu_ * guess[0] && slide_from(guess.tail<2>() / size, b, r)) return r;
  }
  slide_from(bracketed_direction(b), b, r);
  return r;
}

bool FrictionContact3::stick(const Vector3d& b, Vector3d& r) const {
  const Vector3d impulse = inverse_ * -b;
  if (!(impulse[0] > 0) || impulse.tail<2>().squaredNorm() > mu_ * mu_ * impulse[0] * impulse[0])
    return false;
  if (singular_ && (b + w_ * impulse).norm() > 1e3 * eps * (b.norm() + w_.norm() * impulse.norm()))
    return false;
  r = impulse;
  return true;
}

/// Newton's method on the angle of r_t. `r` returns the impulse reached. True if it solves the contact to
/// rounding.
bool FrictionContact3::slide_from(const Vector2d& direction, const Vector3d& b, Vector3d& r) const {
  constexpr int most_steps = 12;
  constexpr double longest_turn = 0.5;
  const Vector2d w_nt = w_.block<1, 2>(0, 1).transpose(), w_tn = w_.block<2, 1>(1, 0), b_t = b.tail<2>();
  const Matrix2d w_tt = w_.block<2, 2>(1, 1);
  Vector2d d = direction;
  for (int step = 0;; ++step) {
    const double stiffness = w_(0, 0) + mu_ * w_nt.dot(d);
    if (!(stiffness > 0)) return false;  // sliding in this direction jams
    const double n = -b[0] / stiffness;
    r << n, mu_ * n * d;
    const Vector2d pushed = w_tn + mu_ * (w_tt * d);
    const Vector2d slip = b_t + n * pushed, normal(-d.y(), d.x());
    const double g = normal.dot(slip), speed = -d.dot(slip);
    const double rounding = 4 * eps * (b_t.norm() + n * pushed.norm());
    if (std::abs(g) <= rounding) return speed >= -rounding;
    const double change_of_n = -n * mu_ * w_nt.dot(normal) / stiffness;
    const double slope = speed + normal.dot(change_of_n * pushed + (n * mu_) * (w_tt * normal));
    if (step == most_steps || slope == 0) return false;
    d = (d + std::clamp(-g / slope, -longest_turn, longest_turn) * normal).normalized();
  }
}

/// The direction of r_t at a root of the quartic in lambda.
Vector2d FrictionContact3::bracketed_direction(const Vector3d& b) const {
  const double w_nn = w_(0, 0), b_n = b[0];
  const Vector2d w_nt = w_.block<1, 2>(0, 1).transpose(), w_tn = w_.block<2, 1>(1, 0), b_t = b.tail<2>();
  const Matrix2d w_tt = w_.block<2, 2>(1, 1), adjugate_tt = adjugate(w_tt);
  const double n_0 = -b_n * w_tt.determinant() + w_nt.dot(adjugate_tt * b_t);
  const double n_1 = -b_n * w_tt.trace() + w_nt.dot(b_t);
  const Vector2d p_0 = b_n * (adjugate_tt * w_tn) - adjugate(w_nn * w_tt - w_tn * w_nt.transpose()) * b_t;
  const Vector2d p_1 = b_n * w_tn - w_nn * b_t;
  const auto tangent = [&](double lambda) { return Vector2d(p_0 + lambda * p_1); };
  const auto excess = [&](double lambda) {
    return tangent(lambda).norm() - mu_ * (n_0 + lambda * (n_1 - b_n * lambda));
  };

  // Above `high` the lambda^2 term dominates all others.
  double low = n_0 > 0 ? 0 : std::max(0.0, greatest_root(-b_n, n_1, n_0));
  double high =
      greatest_root(-mu_ * b_n, -(mu_ * std::abs(n_1) + p_1.norm()), -(mu_ * std::abs(n_0) + p_0.norm()));
  double lambda = high;
  for (int step = 0; step < 200 && high - low > 1e-9 * high; ++step) {
    const double f = excess(lambda);
    (f > 0 ? low : high) = lambda;
    const Vector2d t = tangent(lambda);
    const double size = t.norm();
    const double slope = (size > 0 ? t.dot(p_1) / size : 0) - mu_ * (n_1 - 2 * b_n * lambda);
    const double newton = lambda - f / slope;
    if (std::abs(newton - lambda) <= 1e-12 * lambda) break;
    // Bisect in the logarithm, because the root may be many decades below `high`.
    const double middle = low > 0 ? std::sqrt(low * high) : 1e-3 * high;
    lambda = newton > low && newton < high ? newton : middle;
  }
  const Vector2d t = tangent(lambda);
  const double size = t.norm();
  return size > 0 && std::isfinite(size) ? Vector2d(t / size) : Vector2d(1, 0);
}

ContactProblem<3>::Row solve_local(const ContactProblem<3>::Contact& contact, const ContactProblem<3>::Row& b,
                                   const ContactProblem<3>::Row& guess) {
  if (!contact.is_plain()) return solve_bounded(contact, b, guess);
  ContactProblem<3>::Row r = ContactProblem<3>::Row::Zero();
  r.head<3>() =
      FrictionContact3(contact.w.topLeftCorner<3, 3>(), contact.mu).solve(b.head<3>(), guess.head<3>());
  return r;
}

}  // namespace flyrock
