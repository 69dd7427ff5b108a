#include "flight/decided.h"

#include <algorithm>
#include <cmath>

#include "flight/ground.h"

namespace flyrock {

namespace {

/// A stretch of a line within the domain.
struct Stretch {
  Vec2 start, along;
  double length;
};

/// A line across x ends where the domain does.
Stretch within(const PlanLine::Piece& piece, const Domain<3>& domain) {
  if (std::isfinite(piece.length)) return {piece.start, piece.along, piece.length};
  return {{piece.start.x(), domain.low[1]}, piece.along, domain.high[1] - domain.low[1]};
}

}  // namespace

std::optional<double> least_height(const PlanLine& line, const Terrain2& terrain) {
  return terrain.height(line.pieces().front().start.x());
}

std::optional<double> least_height(const PlanLine& line, const Terrain3& terrain) {
  const Box3& box = terrain.ground().extent();
  const double above = std::isfinite(box.high.z()) ? box.high.z() + 1 : 0;  // m, higher than all ground
  double least = infinite;
  for (const PlanLine::Piece& piece : line.pieces()) {
    const Stretch stretch = within(piece, domain_of(terrain));
    if (!std::isfinite(stretch.length)) return std::nullopt;
    Path<3> path{};  // along the stretch, at 1 m/s
    path.x = Vec3(stretch.start.x(), stretch.start.y(), above);
    path.v = Vec3(stretch.along.x(), stretch.along.y(), 0);
    visit_heights(terrain, path, stretch.length, [&](double from, double to, const auto& highest) {
      least = std::min(least, above - highest(from, to));
    });
  }
  return std::isfinite(least) ? std::optional(least) : std::nullopt;
}

template <int D>
bool DecidedLines<D>::is_decided(const PlanLine& line, const std::optional<double>& height,
                                 const Departure& departure) {
  if (line.side(departure.start) != line.side(departure.end)) return true;
  return height && departure.lift < *height;
}

template class DecidedLines<2>;
template class DecidedLines<3>;

}  // namespace flyrock
