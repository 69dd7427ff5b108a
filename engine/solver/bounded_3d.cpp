// A contact in 3D with cohesion, rolling resistance or spinning resistance (local_3d.h).

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/local_3d.h"
#include "solver/residual.h"

namespace flyrock {

namespace {

using Contact = ContactProblem<3>::Contact;
using Row = ContactProblem<3>::Row;
using Block = ContactProblem<3>::Block;
constexpr auto& groups = ContactProblem<3>::groups;

/// The minimum of x.A x / 2 + c.x over |x| <= radius. A is symmetric positive semi-definite (its symmetric
/// part is taken). On the rim, (A + lambda) x = -c. Newton's method solves for lambda from 0 with 1 / |x|,
/// because this is nearly linear in lambda; it approaches the root monotonically.
Eigen::Vector2d minimum_in_disc(const Eigen::Matrix2d& a, const Eigen::Vector2d& c, double radius) {
  if (radius <= 0) return Eigen::Vector2d::Zero();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes;
  modes.computeDirect(0.5 * (a + a.transpose()));
  const Eigen::Array2d stiffness = modes.eigenvalues().array().max(0.0);
  const Eigen::Array2d load = (modes.eigenvectors().transpose() * -c).array();
  const double floor = 1e-15 * std::max(stiffness.maxCoeff(), load.matrix().norm() / radius);
  double lambda = 0;
  for (int step = 0; step < 60; ++step) {
    const Eigen::Array2d d = (stiffness + lambda).max(floor), x = load / d;
    const double size = x.matrix().norm();
    if (size <= radius * (1 + 1e-15)) return modes.eigenvectors() * x.matrix();
    const double next = lambda + (size / radius - 1) * size * size / (x * x / d).sum();
    if (next <= lambda * (1 + 1e-15)) break;
    lambda = next;
  }
  const Eigen::Vector2d x = modes.eigenvectors() * (load / (stiffness + lambda).max(floor)).matrix();
  return x * std::min(1.0, radius / x.norm());
}

/// For given r_n, the bounded rows minimise their energy, by coordinate descent over the groups.
void settle_bounded_rows(const Contact& contact, const Row& b, Row& r) {
  constexpr int most_rounds = 400;
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto [first, count] = groups[g];
      const double radius = contact.radius(static_cast<int>(g), r[0]);
      const Row before = r;
      const Row u = b + contact.w * r;
      if (count == 1) {
        const double w = contact.w(first, first);
        r[first] = w > 0 ? std::clamp(r[first] - u[first] / w, -radius, radius) : 0;
      } else {
        const Eigen::Matrix2d a = contact.w.block<2, 2>(first, first);
        r.segment<2>(first) = minimum_in_disc(a, u.segment<2>(first) - a * r.segment<2>(first), radius);
      }
      if (radius > 0) change = std::max(change, (r - before).norm() / radius);
    }
    if (change <= 1e-15) return;
  }
}

/// Solves by a bracket on r_n, because u_n(r_n) increases from a negative value at 0.
Row solve_by_bracket(const Contact& contact, const Row& b) {
  const auto normal_velocity = [&](Row& r) {
    settle_bounded_rows(contact, b, r);
    return b[0] + contact.w.row(0).dot(r);
  };
  Row low = Row::Zero();
  double low_velocity = normal_velocity(low), high_velocity = low_velocity;
  Row high = low;
  high[0] = -low_velocity / contact.w(0, 0);
  for (int k = 0; k < 200; ++k, high[0] *= 2) {
    high_velocity = normal_velocity(high);
    if (high_velocity >= 0) break;
    low = high, low_velocity = high_velocity;
  }
  if (high_velocity < 0) return high;
  // Regula falsi with the Illinois rule.
  double weight_low = low_velocity, weight_high = high_velocity;
  Row middle = high;
  for (int k = 0; k < 200 && high[0] - low[0] > 1e-15 * high[0]; ++k) {
    middle[0] = (low[0] * weight_high - high[0] * weight_low) / (weight_high - weight_low);
    if (!(middle[0] > low[0] && middle[0] < high[0])) middle[0] = 0.5 * (low[0] + high[0]);
    const double velocity = normal_velocity(middle);
    if (velocity == 0) return middle;
    if (velocity < 0) {
      low = middle, weight_low = velocity, weight_high *= 0.5;
    } else {
      high = middle, weight_high = velocity, weight_low *= 0.5;
    }
  }
  return middle;
}

/// Newton steps from r, until the error is at most `wanted`. Returns the error of the best impulse, which is
/// stored in r. Beyond `wanted` only rounding is left, which further steps do not lessen.
double sharpen(const Contact& contact, const Row& b, double wanted, Row& r) {
  constexpr int most_steps = 15;
  double least = std::numeric_limits<double>::infinity();
  Row best = r;
  for (int step = 0; step <= most_steps; ++step) {
    const Row u = b + contact.w * r;
    const double error = local_error<3>(contact, u, r);
    if (error < least) least = error, best = r;
    if (error <= wanted || step == most_steps) break;
    Block m = contact.w;
    Row rhs = -u;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto [first, count] = groups[g];
      const double coefficient = contact.bound(static_cast<int>(g));
      const double radius = contact.radius(static_cast<int>(g), std::max(0.0, r[0]));
      const double diagonal = contact.w.diagonal().segment(first, count).maxCoeff();
      if (radius <= 0 || diagonal <= 0) {  // the rows carry nothing
        for (int i = first; i < first + count; ++i) m.row(i).setZero(), m(i, i) = 1, rhs[i] = -r[i];
        continue;
      }
      if (count == 1) {
        const double y = r[first] - u[first] / diagonal;
        if (std::abs(y) <= radius) continue;
        const double sign = y > 0 ? 1 : -1;
        m.row(first).setZero();
        m(first, first) = 1, m(first, 0) = -sign * coefficient;
        rhs[first] = sign * radius - r[first];
      } else {
        const Eigen::Vector2d y = r.segment<2>(first) - u.segment<2>(first) / diagonal;
        const double size = y.norm();
        if (size <= radius) continue;
        const Eigen::Vector2d e = y / size;
        const Eigen::Matrix2d turn = radius / size * (Eigen::Matrix2d::Identity() - e * e.transpose());
        Eigen::Matrix<double, 2, 6> rows = turn / diagonal * contact.w.block<2, 6>(first, 0);
        rows.block<2, 2>(0, first) += Eigen::Matrix2d::Identity() - turn;
        rows.col(0) -= coefficient * e;
        m.block<2, 6>(first, 0) = rows;
        rhs.segment<2>(first) = radius * e - r.segment<2>(first);
      }
    }
    r += m.partialPivLu().solve(rhs);
    if (!r.allFinite() || r[0] < 0) break;
  }
  r = best;
  return least;
}

}  // namespace

Row solve_bounded(const Contact& contact, const Row& b, const Row& guess) {
  Row r = Row::Zero();
  if (contact.resists_open()) settle_bounded_rows(contact, b, r);
  if (!contact.normal || b[0] + contact.w.row(0).dot(r) >= 0 || contact.w(0, 0) <= 0) return r;
  const double rounding = std::numeric_limits<double>::epsilon() * b.head<3>().norm();
  const double wanted = 16 * rounding, allowed = 256 * rounding;
  r = guess;
  if (r[0] <= 0) r = Row::Zero(), r[0] = std::abs(b[0]) / contact.w(0, 0);
  const double error = sharpen(contact, b, wanted, r);
  if (error > allowed) {
    Row other = solve_by_bracket(contact, b);
    if (sharpen(contact, b, wanted, other) < error) r = other;
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {  // clip exactly to the bounds
    const auto [first, count] = groups[g];
    const double radius = contact.radius(static_cast<int>(g), r[0]);
    const double size = count == 1 ? std::abs(r[first]) : r.segment<2>(first).norm();
    if (size > radius)
      for (int i = first; i < first + count; ++i) r[i] *= radius / size;
  }
  return r;
}

}  // namespace flyrock
