#include "solver/distributing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flyrock {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Impulses P and y = E^(1/(n+1)) of all contacts.
struct State {
  VectorXd p, y;
};

/// The law over a parameter s that all contacts share: with k_j = K_j^(1/(n+1)),
///   dP_j/ds = k_j y_j^n,   dy_j/ds = -v_j k_j/(n+1), in expansion divided by e_j^2.
class Law {
 public:
  Law(const Eigen::MatrixXd& w, const VectorXd& v, const DistributingSprings& springs)
      : w_(w), v_(v), springs_(springs), k_(springs.stiffness.array().pow(1 / (springs.exponent + 1))) {}

  VectorXd velocity(const State& state) const { return v_ + w_ * state.p; }

  State rate(const State& state) const {
    const double n = springs_.exponent;
    const VectorXd v = velocity(state);
    State rate{VectorXd::Zero(v.size()), VectorXd::Zero(v.size())};
    for (Index j = 0; j < v.size(); ++j) {
      const double loss = v[j] > 0 ? 1 / (springs_.restitution[j] * springs_.restitution[j]) : 1;
      rate.y[j] = -v[j] * k_[j] * loss / (n + 1);
      if (state.y[j] > 0)
        rate.p[j] = k_[j] * std::pow(state.y[j], n);
      else
        rate.y[j] = std::max(0.0, rate.y[j]);  // open
    }
    return rate;
  }

  State advance(const State& state, double step) const {
    const auto along = [&](const State& rate, double by) {
      return State{state.p + by * rate.p, state.y + by * rate.y};
    };
    const State a = rate(state), b = rate(along(a, step / 2)), c = rate(along(b, step / 2)),
                d = rate(along(c, step));
    State next{state.p + step / 6 * (a.p + 2 * b.p + 2 * c.p + d.p),
               state.y + step / 6 * (a.y + 2 * b.y + 2 * c.y + d.y)};
    next.y = next.y.cwiseMax(0);
    return next;
  }

  /// How long the longest impact of one contact alone takes, about: 3 y/(dy/ds) with the greatest y.
  double duration() const {
    double longest = 0;
    for (Index j = 0; j < v_.size(); ++j) {
      const double speed = v_.cwiseAbs().maxCoeff(), n = springs_.exponent;
      const double greatest = std::pow(0.5 * speed * speed / w_(j, j), 1 / (n + 1));
      longest = std::max(longest, 3 * greatest * (n + 1) / (speed * k_[j]));
    }
    return longest;
  }

  DistributingPoint point(const State& state) const {
    DistributingPoint point{state.p, velocity(state), state.y.array().pow(springs_.exponent + 1)};
    point.energy.maxCoeff(&point.primary);
    return point;
  }

 private:
  const Eigen::MatrixXd& w_;
  const VectorXd& v_;
  const DistributingSprings& springs_;
  VectorXd k_;
};

}  // namespace

std::vector<DistributingPoint> distributing_path(const Eigen::MatrixXd& w, const VectorXd& v,
                                                 const DistributingSprings& springs, int steps) {
  constexpr int longest = 1000;  // times an impact of one contact
  const Law law(w, v, springs);
  State state{VectorXd::Zero(v.size()), VectorXd::Zero(v.size())};
  std::vector<DistributingPoint> path{law.point(state)};
  if (v.size() == 0 || v.minCoeff() >= 0) return path;
  const double step = law.duration() / steps;
  for (int k = 0; k < longest * steps; ++k) {
    state = law.advance(state, step);
    path.push_back(law.point(state));
    if (state.y.maxCoeff() == 0 && path.back().velocity.minCoeff() >= 0) return path;
  }
  throw std::runtime_error("the path of the impact does not end");
}

}  // namespace flyrock
