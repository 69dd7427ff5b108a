#include "math/free_rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flyrock {

namespace {

// Moments that differ by less than this share count as equal. The energy of the symmetric top then has a
// relative error of this size.
constexpr double equal_moments = 1e-12;
// A spin that deviates from a principal axis by less than this share counts as lying on it.
constexpr double on_axis = 1e-15;
// The smallest m1: the period is infinite on the separatrix, and this is 1e-15 away from it.
constexpr double least_complement = 1e-30;

bool equal(double a, double b) { return std::abs(a - b) <= equal_moments * std::max(a, b); }

/// From the body's frame (a, b, c) to one whose z axis is the angular momentum, which is `momentum` in the
/// body.
Eigen::Matrix3d to_momentum_frame(const Vec3& momentum) {
  const double across = std::hypot(momentum.x(), momentum.y()), length = momentum.norm();
  const double sin_psi = momentum.x() / across, cos_psi = momentum.y() / across;
  const double sin_theta = across / length, cos_theta = momentum.z() / length;
  Eigen::Matrix3d s;
  s << cos_psi, -sin_psi, 0,                                 //
      cos_theta * sin_psi, cos_theta * cos_psi, -sin_theta,  //
      sin_theta * sin_psi, sin_theta * cos_psi, cos_theta;
  return s;
}

Eigen::Matrix3d about_z(double angle) {
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  r.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

}  // namespace

FreeRotation::FreeRotation(const Vec3& moments, const Rotation3& rotation, const Vec3& spin)
    : start_(rotation) {
  const Vec3 w = rotation.inverse(spin);
  int order[3] = {0, 1, 2};
  // Equal moments keep their order. std::stable_sort is not used, because it allocates and a motion is made
  // in every step.
  std::sort(order, order + 3,
            [&](int i, int j) { return std::pair(moments[i], i) < std::pair(moments[j], j); });
  const int low = order[0], middle = order[1], high = order[2];

  const bool low_pair = equal(moments[low], moments[middle]),
             high_pair = equal(moments[middle], moments[high]);
  for (int i = 0; i < 3; ++i) {
    const double across = std::hypot(w[(i + 1) % 3], w[(i + 2) % 3]);
    if ((low_pair && high_pair) || across <= on_axis * std::abs(w[i])) {
      precess(spin, Vec3::Zero());
      return;
    }
  }
  if (low_pair || high_pair) {
    const int axis = low_pair ? high : low;
    const double across = moments[middle];
    const Vec3 own = w[axis] * (1 - moments[axis] / across) * Vec3::Unit(axis);
    precess(rotation * Vec3(moments.cwiseProduct(w) / across), own);
    return;
  }

  // c is the axis that the spin circles, because the modulus is then below 1.
  const auto weight = [&](int i) {
    return moments[i] * std::abs(moments[middle] - moments[i]) * w[i] * w[i];
  };
  const int c = weight(high) >= weight(low) ? high : low, a = c == high ? low : high;
  // With this sign, the amplitude at t = 0 lies within a quarter turn
  to_body_.col(0) = std::copysign(1, w[a]) * Vec3::Unit(a);
  to_body_.col(2) = Vec3::Unit(c);
  to_body_.col(1) =
      to_body_.col(2).cross(to_body_.col(0));  // the middle axis, with the sign of a right-handed frame
  const Vec3 v = to_body_.transpose() * w;
  const double ia = moments[a], ib = moments[middle], ic = moments[c];
  moments_ = {ia, ib, ic};
  // From the conservation of energy and momentum. Each is a sum of positive terms.
  const double ratio = ib * (ib - ic) / (ia * (ia - ic));
  amplitude_.x() = std::sqrt(v.x() * v.x() + ratio * v.y() * v.y());
  amplitude_.y() = amplitude_.x() / std::sqrt(ratio);
  amplitude_.z() =
      std::copysign(std::sqrt(v.z() * v.z() + ib * (ib - ia) / (ic * (ic - ia)) * v.y() * v.y()), v.z());
  const double whole = std::abs(ib - ic) * ic * amplitude_.z() * amplitude_.z();
  Modulus modulus;
  modulus.m1 = std::max((weight(c) - weight(a)) / whole, least_complement);
  modulus.m = 1 - modulus.m1;
  lambda_ = (ic - ia) / ib * amplitude_.z() * amplitude_.x() / amplitude_.y();
  const double n = ic * (ib - ia) / (ia * (ib - ic));  // negative
  functions_ = EllipticFunctions(modulus, n);
  u0_ = first_kind(modulus, v.y() / amplitude_.y(), v.x() / amplitude_.x());
  third_kind_start_ = functions_.at(u0_).third_kind;
  precesses_ = false;
  const Vec3 momentum = moments_.cwiseProduct(v);
  momentum_ = momentum.norm();
  to_world_ = rotation.matrix() * to_body_ * to_momentum_frame(momentum).transpose();
  set_bounds(amplitude_.x(), amplitude_.y(), std::abs(amplitude_.z()));
}

void FreeRotation::precess(const Vec3& p, const Vec3& q) {
  p_ = p;
  q_ = q;
  const Vec3 own = start_ * q;
  greatest_spin_ = (p + own).norm();
  greatest_spin_rate_ = p.cross(own).norm();
}

/// Sets the bounds from the greatest values of the components.
void FreeRotation::set_bounds(double a, double b, double c) {
  const double ia = moments_.x(), ib = moments_.y(), ic = moments_.z();
  greatest_spin_ = std::hypot(std::max(a, b), c);
  greatest_spin_rate_ = Vec3((ib - ic) / ia * b * c, (ic - ia) / ib * c * a, (ia - ib) / ic * a * b).norm();
}

std::optional<double> FreeRotation::precession_of(const Vec3& axis) const {
  if (!precesses_ || !q_.cross(axis).isZero(1e-12 * q_.norm() * axis.norm())) return std::nullopt;
  return p_.norm();
}

FreeRotation FreeRotation::seen_from(const Rotation3& frame) const {
  FreeRotation seen = *this;
  seen.start_ = frame.inverse() * start_;
  seen.p_ = frame.inverse(p_);
  seen.to_world_ = frame.matrix().transpose() * to_world_;
  return seen;
}

Turn FreeRotation::at(double t) const {
  if (precesses_) {
    const Rotation3 r = Rotation3::from_vector(t * p_) * start_ * Rotation3::from_vector(t * q_);
    return {r, p_ + r * q_};
  }
  const EllipticFunctions::Values f = functions_.at(lambda_ * t + u0_);
  const Vec3 w = amplitude_.cwiseProduct(Vec3(f.cn, f.sn, f.dn));
  const double phi = momentum_ * (t / moments_.z() + (1 / moments_.x() - 1 / moments_.z()) *
                                                         (f.third_kind - third_kind_start_) / lambda_);
  const Eigen::Matrix3d from_axes = to_world_ * about_z(phi) * to_momentum_frame(moments_.cwiseProduct(w));
  return {Rotation3(Eigen::Matrix3d(from_axes * to_body_.transpose())), from_axes * w};
}

}  // namespace flyrock
