#include "solver/impact_path.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
namespace odeint = boost::numeric::odeint;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double eps = std::numeric_limits<double>::epsilon();

/// The normal motion along the path, and the current phase of the impact.
class NormalMotion {
 public:
  NormalMotion(double v, ImpactEnd end, double e) : speed(v), target_(-e * v), end_(end), e_(e) {}

  double speed;        ///< v_n
  double impulse = 0;  ///< P
  double work = 0;     ///< integral of v_n dP

  bool ended() const { return ended_; }

  /// A function that is negative before the next event (end of compression, end of impact) and positive after
  /// it.
  double beyond_event() const {
    if (!restitution_) return speed;
    switch (end_) {
      case ImpactEnd::newton:
        return speed - target_;
      case ImpactEnd::poisson:
        return impulse - turn_impulse_ - e_ * compression_impulse_;
      case ImpactEnd::energy:
        break;
    }
    return work - turn_work_ - e_ * e_ * compression_work_;
  }
  /// During restitution the contact may be compressed again, if slip turns into a jam.
  bool compressed_again() const { return restitution_ && speed < 0; }
  void compress_again() {
    restitution_ = false;
    start_impulse_ = impulse;
    start_work_ = work;
  }
  void pass_event() {
    if (restitution_) {
      ended_ = true;
      return;
    }
    restitution_ = true;
    speed = 0;
    turn_impulse_ = impulse;
    turn_work_ = work;
    compression_impulse_ = impulse - start_impulse_;
    compression_work_ = start_work_ - work;
    ended_ = e_ == 0;
  }

  /// Follows a leg with dv_n/dP = b for at most `length` of P. Returns the length it covered.
  double along(double b, double length) {
    // In exact arithmetic b > 0 on a leg without a limit, so that v_n rises until the impact ends. Rounding
    // must not change that.
    if (length == infinity) b = std::max(b, eps);
    double gone = 0;
    while (!ended_) {
      const double rest = length - gone, to_event = distance_to_event(b);
      const double step = std::min(rest, to_event);
      work += step * (speed + 0.5 * b * step);
      speed += b * step;
      impulse += step;
      gone += step;
      if (rest < to_event) break;
      pass_event();
    }
    return gone;
  }

 private:
  double distance_to_event(double b) const {
    if (!restitution_) return b > 0 ? -speed / b : infinity;
    const double missing = -beyond_event();
    if (missing <= 0) return 0;
    switch (end_) {
      case ImpactEnd::newton:
        return missing / b;
      case ImpactEnd::poisson:
        return missing;
      case ImpactEnd::energy:
        break;
    }
    return 2 * missing / (speed + std::sqrt(std::max(0.0, speed * speed + 2 * b * missing)));
  }

  double target_;
  ImpactEnd end_;
  double e_;
  bool restitution_ = false, ended_ = false;
  double start_impulse_ = 0, start_work_ = 0;  // at the start of compression
  double turn_impulse_ = 0, turn_work_ = 0;    // at the start of restitution
  double compression_impulse_ = 0, compression_work_ = 0;
};

/// The path in scaled numbers of order 1: velocities divided by |v|, impulses times trace(W) / |v|.
class Path {
 public:
  Path(const Eigen::Matrix3d& w, const Eigen::Vector3d& v, double mu, ImpactEnd end, double e)
      : w_nn_(w(0, 0)),
        w_tn_(w.block<2, 1>(1, 0)),
        w_tt_(w.block<2, 2>(1, 1)),
        mu_(mu),
        slip_(v.tail<2>()),
        normal_(v[0], end, e) {}

  Eigen::Vector3d follow() {
    if (mu_ == 0) return {normal_.along(w_nn_, infinity), 0, 0};
    const Vector2d start = slip_;
    if (slip_.norm() > no_slip) slip_until_stick();
    if (!normal_.ended()) go_on_from_rest();
    const Vector2d tangential = w_tt_.ldlt().solve(slip_ - start - w_tn_ * normal_.impulse);
    return {normal_.impulse, tangential[0], tangential[1]};
  }

 private:
  static constexpr double no_slip = 1e-14;

  Vector2d slip_rate(const Vector2d& e) const { return w_tn_ - mu_ * w_tt_ * e; }
  double normal_rate(const Vector2d& e) const { return w_nn_ - mu_ * e.dot(w_tn_); }

  void slip_until_stick() {
    const Vector2d e = slip_.normalized(), rate = slip_rate(e);
    const double along = e.dot(rate), across = e.x() * rate.y() - e.y() * rate.x();
    if (std::abs(across) > 4 * eps) return follow_turning_slip();
    const double length = along < 0 ? slip_.norm() / -along : infinity;
    const double gone = normal_.along(normal_rate(e), length);
    slip_ = gone < length ? Vector2d(slip_ + gone * along * e) : Vector2d::Zero();
  }

  /// Continues from v_t = 0: stick, or slip along the unit vector e with W_tn - mu W_tt e = lambda e, lambda
  /// > 0. This vector is unique, because |(mu W_tt + lambda I)^-1 w_tn| decreases with lambda.
  void go_on_from_rest() {
    slip_.setZero();
    const auto direction = [&](double lambda) -> Vector2d {
      return (mu_ * w_tt_ + lambda * Matrix2d::Identity()).ldlt().solve(w_tn_);
    };
    const Vector2d held = w_tt_.ldlt().solve(w_tn_);
    if (held.norm() <= mu_) {
      normal_.along(w_nn_ - w_tn_.dot(held), infinity);
      return;
    }
    const auto excess = [&](double lambda) { return direction(lambda).norm() - 1; };
    double lambda = w_tn_.norm();  // |direction| <= 1 at this lambda
    if (excess(lambda) < 0) {
      std::uintmax_t iterations = 200;
      const auto bracket = boost::math::tools::toms748_solve(
          excess, 0.0, lambda, boost::math::tools::eps_tolerance<double>(), iterations);
      lambda = 0.5 * (bracket.first + bracket.second);
    }
    const Vector2d e = direction(lambda).normalized();
    const double gone = normal_.along(normal_rate(e), infinity);
    slip_ = gone * slip_rate(e);
  }

  /// With the slip rho (cos phi, sin phi) and the variable sigma, dP = rho dsigma, the equations remain
  /// smooth when slip ends:
  ///   phi' = across, (ln rho)' = along, P' = rho, v_n' = rho (w_nn - mu e.w_tn), work' = rho v_n.
  void follow_turning_slip() {
    enum { phi, log_rho, impulse, speed, work };
    using State = std::array<double, 5>;
    const auto equations = [&](const State& x, State& rate, double) {
      const Vector2d e(std::cos(x[phi]), std::sin(x[phi])), slip = slip_rate(e);
      const double rho = std::exp(x[log_rho]);
      rate = {e.x() * slip.y() - e.y() * slip.x(), e.dot(slip), rho, rho * normal_rate(e), rho * x[speed]};
    };
    const auto take = [&](const State& x) {
      normal_.impulse = x[impulse];
      normal_.speed = x[speed];
      normal_.work = x[work];
    };
    static const odeint::runge_kutta_fehlberg78<State>
        blank{};  // static, because GCC warns about copies of an uninitialised work space
    auto plain = blank;
    auto stepper = odeint::make_controlled(1e-13, 1e-13, plain);
    State x = {std::atan2(slip_.y(), slip_.x()), std::log(slip_.norm()), normal_.impulse, normal_.speed,
               normal_.work};
    const double log_no_slip = std::log(no_slip);
    double t = 0, dt = 0.1;
    while (!normal_.ended() && x[log_rho] > log_no_slip) {
      const State from = x;
      const double begin = t;
      while (stepper.try_step(equations, x, t, dt) == odeint::fail) {
      }
      take(x);
      const bool again = normal_.compressed_again();
      if (!again && normal_.beyond_event() < 0) continue;
      // The event lies within this step. Find its time as a root.
      const double length = t - begin;
      const auto at = [&](double h) {
        x = from;
        plain.do_step(equations, x, begin, h);
        take(x);
        return again ? -normal_.speed : normal_.beyond_event();
      };
      const double before = at(0);
      if (before < 0) {
        std::uintmax_t iterations = 100;
        const auto bracket = boost::math::tools::toms748_solve(
            at, 0.0, length, boost::math::tools::eps_tolerance<double>(), iterations);
        at(bracket.second);
      }
      t = begin;
      again ? normal_.compress_again() : normal_.pass_event();
      x[speed] = normal_.speed;
    }
    slip_ = x[log_rho] > log_no_slip
                ? Vector2d(std::exp(x[log_rho]) * Vector2d(std::cos(x[phi]), std::sin(x[phi])))
                : Vector2d::Zero();
  }

  double w_nn_;
  Vector2d w_tn_;
  Matrix2d w_tt_;
  double mu_;
  Vector2d slip_;
  NormalMotion normal_;
};

}  // namespace

Eigen::Vector3d impact_path(const Eigen::Matrix3d& w, const Eigen::Vector3d& v, double mu, ImpactEnd end,
                            double e) {
  if (v[0] >= 0) return Eigen::Vector3d::Zero();
  const double speed = v.norm(), mobility = w.trace();
  return speed / mobility * Path(w / mobility, v / speed, mu, end, e).follow();
}

Eigen::Vector2d impact_path(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, double mu, ImpactEnd end,
                            double e) {
  Eigen::Matrix3d space =
      Eigen::Matrix3d::Identity() * w(1, 1);  // the third direction is at rest and uncoupled
  space.topLeftCorner<2, 2>() = w;
  return impact_path(space, {v[0], v[1], 0}, mu, end, e).head<2>();
}

}  // namespace flyrock
