#include "geometry/forest.h"

#include <cmath>

#include "geometry/box.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

/// |p_xy(t) - c|^2 - reach^2.
std::array<double, 11> squared_gap(const PlanPath& path, const Vec2& c, double reach) {
  std::array<double, 6> x = path.x, y = path.y;
  x[0] -= c.x();
  y[0] -= c.y();
  std::array<double, 11> gap{};
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < x.size(); ++k) gap[i + k] += x[i] * x[k] + y[i] * y[k];
  gap[0] -= reach * reach;
  return gap;
}

/// The greatest length of the derivative of this order over [0, end], or more.
double greatest_derivative(const PlanPath& path, int order, double end) {
  double most = 0, power = 1;
  for (int k = order; k < 6; ++k, power *= end) {
    double factor = 1;
    for (int i = 0; i < order; ++i) factor *= k - i;
    const auto n = static_cast<std::size_t>(k);
    most += factor * std::sqrt(path.x[n] * path.x[n] + path.y[n] * path.y[n]) * power;
  }
  return most;
}

}  // namespace

std::optional<double> first_touch(const SpacePath& path, double end, double radius, const Stem& stem,
                                  double top) {
  const std::array<double, 11> gap = squared_gap(path.plan, stem.place, stem.radius + radius);
  std::array<double, 6> above = path.z;
  above[0] -= top;
  constexpr int most_turns = 16;  // more than two polynomials of these degrees can fall
  double at = 0;
  bool is_above = above[0] > 0;
  for (int turn = 0; turn < most_turns; ++turn) {
    const std::optional<double> fall = is_above ? first_fall(above, at, end) : first_fall(gap, at, end);
    if (!fall) return std::nullopt;
    at = *fall;
    if (evaluate(is_above ? std::span<const double>(gap) : std::span<const double>(above), at) <= 0)
      return at;
    is_above = !is_above;
  }
  return std::nullopt;
}

Forest::Forest(std::vector<Stem> stems) : stems_(std::move(stems)) {
  if (stems_.empty()) return;
  Box2 box = Box2::empty();
  for (const Stem& stem : stems_) {
    box.add(stem.place);
    greatest_radius_ = std::max(greatest_radius_, stem.radius);
  }
  const Vec2 size = box.size();
  const double count = static_cast<double>(stems_.size());
  // About two stems a cell; along a line of stems, as many cells as stems.
  cell_ = std::max({std::sqrt(2 * size.x() * size.y() / count), size.maxCoeff() / count, 1.0});
  corner_ = box.low;
  columns_ = 1 + static_cast<int>(size.x() / cell_);
  rows_ = 1 + static_cast<int>(size.y() / cell_);
  const auto cell_of = [&](const Stem& stem) {
    const Vec2 at = (stem.place - corner_) / cell_;
    return static_cast<std::size_t>(std::min(static_cast<int>(at.y()), rows_ - 1)) *
               static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(std::min(static_cast<int>(at.x()), columns_ - 1));
  };
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Stem& stem : stems_) ++begin_[cell_of(stem) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  sorted_.resize(stems_.size());
  for (std::size_t i = 0; i < stems_.size(); ++i)
    sorted_[static_cast<std::size_t>(next[cell_of(stems_[i])]++)] = static_cast<int>(i);
}

int Forest::pieces_of(const PlanPath& path, double end, double& sag) const {
  constexpr double most_pieces = 1e6;
  const double length = greatest_derivative(path, 1, end) * end;
  const double pieces = std::clamp(std::ceil(length / (2 * cell_)), 1.0, most_pieces);
  const double dt = end / pieces;
  sag = greatest_derivative(path, 2, end) * dt * dt / 8;
  return static_cast<int>(pieces);
}

}  // namespace flyrock
