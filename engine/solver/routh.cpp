#include "solver/routh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/impact_path.h"

namespace flyrock {

namespace {

/// The part of the line (v + W P)[row] = 0 that lies in the box |P_t| <= height, 0 <= P_n <= width.
std::vector<Eigen::Vector2d> line_in_box(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, int row,
                                         double width, double height) {
  const Eigen::Vector2d normal = w.row(row), along(-normal[1], normal[0]);
  const Eigen::Vector2d start = -v[row] / normal.squaredNorm() * normal;
  const Eigen::Vector2d low(0, -height), high(width, height);
  double first = -std::numeric_limits<double>::infinity(), last = -first;  // of start + s along
  for (int k = 0; k < 2; ++k) {
    if (along[k] == 0) {
      if (start[k] < low[k] || start[k] > high[k]) return {};
      continue;
    }
    const double a = (low[k] - start[k]) / along[k], b = (high[k] - start[k]) / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first >= last) return {};
  return {start + first * along, start + last * along};
}

}  // namespace

RouthDiagram routh_diagram(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, double mu, double e) {
  constexpr double beyond = 1.1;  // the path is drawn a little farther than its last end
  RouthDiagram diagram;
  const auto at = [&](const Eigen::Vector2d& impulse) { return RouthPoint{impulse, v + w * impulse}; };
  diagram.newton = at(impact_path(w, v, mu, ImpactEnd::newton, e));
  diagram.poisson = at(impact_path(w, v, mu, ImpactEnd::poisson, e));
  diagram.energy = at(impact_path(w, v, mu, ImpactEnd::energy, e));
  diagram.compression_end = at(impact_path(w, v, mu, ImpactEnd::poisson, 0));
  const double last =
      beyond * std::max({diagram.newton.impulse[0], diagram.poisson.impulse[0], diagram.energy.impulse[0]});

  diagram.path.push_back(at(Eigen::Vector2d::Zero()));
  double slope = 0;  // dP_t / dP_n
  double slip_end = 0;
  if (v[1] != 0) {
    slope = v[1] > 0 ? -mu : mu;
    const double rate = w(0, 1) + slope * w(1, 1);  // dv_t / dP_n
    slip_end = rate * v[1] < 0 ? -v[1] / rate : std::numeric_limits<double>::infinity();
  }
  if (slip_end < last) {
    const Eigen::Vector2d corner(slip_end, slope * slip_end);
    if (slip_end > 0) diagram.path.push_back(at(corner));
    diagram.slip_end = at(corner);
    const double sticking = -w(0, 1) / w(1, 1);
    slope = std::abs(sticking) <= mu ? sticking : w(0, 1) > 0 ? -mu : mu;
    diagram.path.push_back(at(corner + (last - slip_end) * Eigen::Vector2d(1, slope)));
  } else {
    diagram.path.push_back(at(last * Eigen::Vector2d(1, slope)));
    diagram.slip_end = diagram.path.back();
  }
  for (const Eigen::Vector2d& end : line_in_box(w, v, 1, last, mu * last))
    diagram.sticking.push_back(at(end));
  for (const Eigen::Vector2d& end : line_in_box(w, v, 0, last, mu * last))
    diagram.greatest_compression.push_back(at(end));
  return diagram;
}

}  // namespace flyrock
