#pragma once
// Small programs of a deformable block that falls flat on a wall without friction.

#include <Eigen/Dense>
#include <cmath>

#include "elastic/elastic_step.h"

namespace flyrock::test {

/// What a block does that falls flat on a wall without friction, by the theta scheme with the velocity
/// condition: a node touches when its gap in the middle of the step is not positive.
struct Bounce {
  double rebound = 0, energy = 0;  ///< of the impact speed and energy
  std::vector<double> forces;      ///< of each step [N]
  double drift = 0;    ///< greatest error of the energy less the work of contacts, of the impact energy
  double gain = 0;     ///< greatest sum of that work so far
  double impulse = 0;  ///< N s
};

/// r >= 0 and W r + q >= 0, one of them 0 in each row: by pivots on the first row that fails (Murty). Sweeps
/// would not do: of a stiff block all rows of W are nearly the same.
inline Eigen::VectorXd pushes(const Eigen::MatrixXd& w, const Eigen::VectorXd& q) {
  const Eigen::Index n = q.size();
  std::vector<char> active(static_cast<std::size_t>(n), 1);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(n);
  for (int pivots = 0; pivots < 10000 && n > 0; ++pivots) {
    std::vector<Eigen::Index> rows;
    for (Eigen::Index a = 0; a < n; ++a)
      if (active[static_cast<std::size_t>(a)]) rows.push_back(a);
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd own(count, count);
    Eigen::VectorXd right(count);
    for (Eigen::Index a = 0; a < count; ++a) {
      right[a] = -q[rows[static_cast<std::size_t>(a)]];
      for (Eigen::Index b = 0; b < count; ++b)
        own(a, b) = w(rows[static_cast<std::size_t>(a)], rows[static_cast<std::size_t>(b)]);
    }
    const Eigen::VectorXd solved = own.ldlt().solve(right);
    r.setZero();
    for (Eigen::Index a = 0; a < count; ++a) r[rows[static_cast<std::size_t>(a)]] = solved[a];
    const Eigen::VectorXd after = w * r + q;
    const double none = 1e-13 * (q.cwiseAbs().maxCoeff() + (w * r).cwiseAbs().maxCoeff());
    Eigen::Index wrong = 0;
    while (wrong < n && (active[static_cast<std::size_t>(wrong)] ? r[wrong] * w(wrong, wrong) >= -none
                                                                 : after[wrong] >= -none))
      ++wrong;
    if (wrong == n) break;
    active[static_cast<std::size_t>(wrong)] ^= 1;
  }
  return r;
}

/// The block of the engine: rigid motion and deformation apart.
template <int D>
Bounce bounce(const ElasticModel<D>& model, double h, double speed, double start, int steps = 4000) {
  constexpr double theta = 0.5;
  constexpr int up = D - 1;
  const ElasticStep<D> step(model, h, theta);
  std::vector<int> base;
  double lowest = 0;
  for (const Vec<D>& node : model.mesh().nodes) lowest = std::min(lowest, node[up]);
  for (std::size_t i = 0; i < model.mesh().nodes.size(); ++i)
    if (model.mesh().nodes[i][up] < lowest + 1e-12) base.push_back(static_cast<int>(i));
  Eigen::VectorXd u = Eigen::VectorXd::Zero(model.size()), rate = u, change = u;
  double y = start - lowest, v = -speed;
  const double all = 0.5 * model.mass() * speed * speed;
  Bounce result;
  double touch = 0;
  int idle = 0;
  for (int n = 0; n < steps && idle < 40; ++n) {
    u += (1 - theta) * h * rate;
    y += (1 - theta) * h * v;
    std::vector<int> touching;
    for (const int node : base)
      if (y + model.mesh().nodes[node][up] + u[D * node + up] <= 0) touching.push_back(node);
    u -= (1 - theta) * h * rate;
    step.free_change(u, rate, change);
    u += (1 - theta) * h * rate;
    const auto count = static_cast<Eigen::Index>(touching.size());
    Eigen::MatrixXd w(count, count);
    Eigen::VectorXd q(count), before(count);
    rate += change;
    for (Eigen::Index a = 0; a < count; ++a) {
      before[a] = v + rate[D * touching[a] + up] - change[D * touching[a] + up];
      q[a] = v + rate[D * touching[a] + up];
      for (Eigen::Index b = 0; b < count; ++b)
        w(a, b) = 1 / model.mass() + step.mobility(touching[a], touching[b])(up, up);
    }
    const Eigen::VectorXd r = pushes(w, q);
    for (Eigen::Index a = 0; a < count; ++a) rate += r[a] * step.column(touching[a]).col(up);
    v += r.sum() / model.mass();
    u += theta * h * rate;
    y += theta * h * v;
    result.impulse += r.sum();
    idle = r.sum() == 0 && v > 0 ? idle + 1 : 0;
    result.forces.push_back(r.sum() / h);
    for (Eigen::Index a = 0; a < count; ++a)
      touch += 0.5 * r[a] * (before[a] + v + rate[D * touching[static_cast<std::size_t>(a)] + up]);
    const double deformed = model.strain_energy(u) + model.kinetic_energy(rate);
    result.energy = (0.5 * model.mass() * v * v + deformed) / all;
    result.drift = std::max(result.drift, std::abs(result.energy - 1 - touch / all));
    result.gain = std::max(result.gain, touch / all);
  }
  result.rebound = v / speed;
  return result;
}

/// The same by one dense matrix, rigid motion and all.
template <int D>
Bounce bounce_of_all(const ElasticModel<D>& model, double h, double speed) {
  constexpr double theta = 0.5;
  constexpr int up = D - 1;
  const Eigen::MatrixXd k = model.stiffness();
  Eigen::MatrixXd implicit = theta * theta * h * h * k;
  implicit.diagonal() += model.masses();
  const Eigen::MatrixXd inverse = implicit.inverse();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.size()), v = q;
  std::vector<Eigen::Index> base;
  double lowest = 0;
  for (const Vec<D>& node : model.mesh().nodes) lowest = std::min(lowest, node[up]);
  for (std::size_t i = 0; i < model.mesh().nodes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(D * i + up);
    v[row] = -speed;
    if (model.mesh().nodes[i][up] < lowest + 1e-12) base.push_back(row);
  }
  Bounce result;
  int idle = 0;
  for (int n = 0; n < 4000 && idle < 40; ++n) {
    Eigen::VectorXd next = v - inverse * (h * (k * (q + theta * h * v)));
    std::vector<Eigen::Index> touching;
    for (const Eigen::Index row : base)
      if (q[row] + (1 - theta) * h * v[row] <= 0) touching.push_back(row);
    const auto count = static_cast<Eigen::Index>(touching.size());
    Eigen::MatrixXd w(count, count);
    Eigen::VectorXd free(count);
    for (Eigen::Index a = 0; a < count; ++a) {
      free[a] = next[touching[a]];
      for (Eigen::Index b = 0; b < count; ++b) w(a, b) = inverse(touching[a], touching[b]);
    }
    const Eigen::VectorXd r = pushes(w, free);
    for (Eigen::Index a = 0; a < count; ++a) next += r[a] * inverse.col(touching[a]);
    q += h * ((1 - theta) * v + theta * next);
    v = next;
    double momentum = 0;
    for (Eigen::Index i = up; i < v.size(); i += D) momentum += model.masses()[i] * v[i];
    result.rebound = momentum / model.mass() / speed;
    idle = r.sum() == 0 && momentum > 0 ? idle + 1 : 0;
  }
  result.energy = (model.strain_energy(q) + model.kinetic_energy(v)) / (0.5 * model.mass() * speed * speed);
  return result;
}

}  // namespace flyrock::test
