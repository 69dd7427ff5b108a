#include "geometry/plan_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/plan_hull.h"

namespace flyrock {

namespace {

constexpr double far_away = 1e30;  // m2, of nodes from which no distance counts

/// Squared distances along one line of nodes, in cells: the lower envelope of the parabolas f(q) + (p - q)^2.
/// Source: Felzenszwalb and Huttenlocher 2012, Distance transforms of sampled functions.
void transform(std::vector<double>& line, std::vector<double>& from, std::vector<int>& apex,
               std::vector<double>& begin) {
  const int n = static_cast<int>(line.size());
  from = line;
  apex.assign(line.size(), 0);
  begin.assign(line.size() + 1, 0);
  int last = 0;
  begin[0] = -far_away;
  begin[1] = far_away;
  const auto meet = [&](int q, int r) {
    const auto f = [&](int k) { return from[static_cast<std::size_t>(k)] + static_cast<double>(k) * k; };
    return (f(q) - f(r)) / (2.0 * (q - r));
  };
  for (int q = 1; q < n; ++q) {
    double at = meet(q, apex[static_cast<std::size_t>(last)]);
    while (last > 0 && at <= begin[static_cast<std::size_t>(last)]) {
      --last;
      at = meet(q, apex[static_cast<std::size_t>(last)]);
    }
    ++last;
    apex[static_cast<std::size_t>(last)] = q;
    begin[static_cast<std::size_t>(last)] = at;
    begin[static_cast<std::size_t>(last) + 1] = far_away;
  }
  int k = 0;
  for (int p = 0; p < n; ++p) {
    while (begin[static_cast<std::size_t>(k) + 1] < p) ++k;
    const int q = apex[static_cast<std::size_t>(k)];
    line[static_cast<std::size_t>(p)] =
        from[static_cast<std::size_t>(q)] + static_cast<double>(p - q) * (p - q);
  }
}

}  // namespace

PlanField::PlanField(const Vec2& low, const Vec2& high, double cell) : cell_(cell) {
  const Vec2 size = high - low;
  const auto nodes = [&] { return (size.x() / cell_ + 4) * (size.y() / cell_ + 4); };
  while (nodes() > most_nodes) cell_ *= 1.1;
  corner_ = low - Vec2(cell_, cell_);
  nx_ = static_cast<int>(std::ceil(size.x() / cell_)) + 3;
  ny_ = static_cast<int>(std::ceil(size.y() / cell_)) + 3;
  values_.assign(index(0, ny_), 0);
}

double PlanField::at(const Vec2& place) const {
  const Vec2 from = (place - corner_) / cell_;
  const double u = std::clamp(from.x(), 0.0, nx_ - 1.0), v = std::clamp(from.y(), 0.0, ny_ - 1.0);
  const int i = std::min(static_cast<int>(u), nx_ - 2), j = std::min(static_cast<int>(v), ny_ - 2);
  const double a = u - i, b = v - j;
  const auto value = [&](int di, int dj) { return static_cast<double>(values_[index(i + di, j + dj)]); };
  return (1 - b) * ((1 - a) * value(0, 0) + a * value(1, 0)) + b * ((1 - a) * value(0, 1) + a * value(1, 1));
}

void PlanField::add_kernel(const Vec2& place, double radius, double weight) {
  const Vec2 from = (place - corner_) / cell_;
  const double reach = radius / cell_;
  const int low_i = std::max(0, static_cast<int>(std::ceil(from.x() - reach))),
            high_i = std::min(nx_ - 1, static_cast<int>(std::floor(from.x() + reach))),
            low_j = std::max(0, static_cast<int>(std::ceil(from.y() - reach))),
            high_j = std::min(ny_ - 1, static_cast<int>(std::floor(from.y() + reach)));
  for (int j = low_j; j <= high_j; ++j)
    for (int i = low_i; i <= high_i; ++i) {
      const double s = (Vec2(i, j) - from).squaredNorm() / (reach * reach);
      if (s < 1) values_[index(i, j)] += static_cast<float>(weight * (1 - s));
    }
}

void PlanField::add(const PlanField& other) {
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] += other.values_[k];
}

PlanField PlanField::with_distances(double margin) const {
  const int beyond = static_cast<int>(std::ceil(margin / cell_));
  PlanField wider;
  wider.cell_ = cell_;
  wider.corner_ = corner_ - beyond * Vec2(cell_, cell_);
  wider.nx_ = nx_ + 2 * beyond;
  wider.ny_ = ny_ + 2 * beyond;
  wider.values_.assign(wider.index(0, wider.ny_), 0);
  for (int j = 0; j < ny_; ++j)
    for (int i = 0; i < nx_; ++i) wider.values_[wider.index(i + beyond, j + beyond)] = values_[index(i, j)];
  std::vector<double> squares(wider.values_.size());
  for (std::size_t k = 0; k < squares.size(); ++k) squares[k] = wider.values_[k] > 0 ? 0 : far_away;
  std::vector<double> line, from, begin;
  std::vector<int> apex;
  for (int i = 0; i < wider.nx_; ++i) {
    line.clear();
    for (int j = 0; j < wider.ny_; ++j) line.push_back(squares[wider.index(i, j)]);
    transform(line, from, apex, begin);
    for (int j = 0; j < wider.ny_; ++j) squares[wider.index(i, j)] = line[static_cast<std::size_t>(j)];
  }
  for (int j = 0; j < wider.ny_; ++j) {
    line.assign(squares.begin() + static_cast<std::ptrdiff_t>(wider.index(0, j)),
                squares.begin() + static_cast<std::ptrdiff_t>(wider.index(0, j + 1)));
    transform(line, from, apex, begin);
    for (int i = 0; i < wider.nx_; ++i)
      if (float& value = wider.values_[wider.index(i, j)]; !(value > 0))
        value = static_cast<float>(-cell_ * std::sqrt(line[static_cast<std::size_t>(i)]));
  }
  return wider;
}

void PlanField::lift(const std::vector<Vec2>& hull) {
  if (hull.empty()) return;
  const float highest = 1 + std::max(0.0F, *std::max_element(values_.begin(), values_.end()));
  Vec2 low = hull.front(), high = hull.front();
  for (const Vec2& corner : hull) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double across = std::sqrt(2) * cell_;  // from any place of a cell to any of its nodes at most
  const Vec2 from = (low - corner_) / cell_, to = (high - corner_) / cell_;
  for (int j = std::max(0, static_cast<int>(from.y()) - 2);
       j <= std::min(ny_ - 1, static_cast<int>(to.y()) + 2); ++j)
    for (int i = std::max(0, static_cast<int>(from.x()) - 2);
         i <= std::min(nx_ - 1, static_cast<int>(to.x()) + 2); ++i)
      if (distance_from(hull, place_of(i, j)) <= across) values_[index(i, j)] = highest;
}

/// Whether each node is below the level and joined to the border by such nodes.
std::vector<char> PlanField::outside_of(double level) const {
  std::vector<char> outside(values_.size(), 0);
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= nx_ || j >= ny_) return;
    const std::size_t k = index(i, j);
    if (outside[k] || values_[k] >= level) return;
    outside[k] = 1;
    open.emplace_back(i, j);
  };
  for (int i = 0; i < nx_; ++i)
    for (const int j : {0, ny_ - 1}) visit(i, j);
  for (int j = 0; j < ny_; ++j)
    for (const int i : {0, nx_ - 1}) visit(i, j);
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    visit(i + 1, j);
    visit(i - 1, j);
    visit(i, j + 1);
    visit(i, j - 1);
  }
  return outside;
}

std::vector<PlanRing> PlanField::region_above(double level) const {
  // A frame of nodes outside closes what reaches the border.
  std::vector<char> outside = outside_of(level);
  for (int i = 0; i < nx_; ++i)
    for (const int j : {0, ny_ - 1}) outside[index(i, j)] = 1;
  for (int j = 0; j < ny_; ++j)
    for (const int i : {0, nx_ - 1}) outside[index(i, j)] = 1;
  // Edges between nodes, each by its lower left node: 2 k to the right, 2 k + 1 upwards. Each edge that the
  // outline crosses has one next edge, so that the region is to the left.
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> next(2 * values_.size(), none);
  for (int j = 0; j + 1 < ny_; ++j)
    for (int i = 0; i + 1 < nx_; ++i) {
      const std::size_t nodes[] = {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)};
      const std::size_t edges[] = {2 * nodes[0], 2 * nodes[1] + 1, 2 * nodes[3], 2 * nodes[0] + 1};
      // Edge e joins corner e with corner e + 1, counter-clockwise. From an edge that leads out of the region
      // the outline goes to the next one that leads back into it, about the corners outside: of two corners
      // outside that face each other it goes about each, so that the inside is joined.
      for (int e = 0; e < 4; ++e) {
        if (!(outside[nodes[e]] == 0 && outside[nodes[(e + 1) % 4]] == 1)) continue;
        int out = (e + 1) % 4;
        while (!(outside[nodes[out]] == 1 && outside[nodes[(out + 1) % 4]] == 0)) out = (out + 1) % 4;
        next[edges[e]] = edges[out];
      }
    }
  const auto crossing = [&](std::size_t edge) {
    const std::size_t k = edge / 2, to = k + (edge % 2 == 0 ? 1 : static_cast<std::size_t>(nx_));
    const auto place = [&](std::size_t node) {
      return place_of(static_cast<int>(node % static_cast<std::size_t>(nx_)),
                      static_cast<int>(node / static_cast<std::size_t>(nx_)));
    };
    const double a = values_[k], b = values_[to];
    const double share = a == b ? 0.5 : std::clamp((level - a) / (b - a), 0.0, 1.0);
    return Vec2(place(k) + share * (place(to) - place(k)));
  };
  std::vector<PlanRing> rings;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (next[start] == none) continue;
    PlanRing& ring = rings.emplace_back();
    for (std::size_t edge = start; next[edge] != none;) {
      ring.push_back(crossing(edge));
      edge = std::exchange(next[edge], none);
    }
  }
  return rings;
}

double area_of(const std::vector<PlanRing>& rings) {
  double twice = 0;
  for (const PlanRing& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      twice += cross(Vec2(ring[i] - ring[0]), Vec2(ring[(i + 1) % ring.size()] - ring[0]));
  return twice / 2;
}

}  // namespace flyrock
