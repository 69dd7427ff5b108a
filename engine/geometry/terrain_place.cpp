#include "geometry/terrain_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "geometry/place_text.h"

namespace flyrock {

namespace {

Vec3 place_of(const HeightGrid& grid, int column, int row) {
  return {grid.corner.x() + grid.cell * column, grid.corner.y() + grid.cell * row, grid.at(column, row)};
}

Box3 extent_of(const TerrainShape3& shape) {
  Box3 extent = Box3::empty();
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    for (const Vec3& vertex : mesh->vertices) extent.add(vertex);
  } else if (const HeightGrid* grid = std::get_if<HeightGrid>(&shape)) {
    for (const auto& [column, row] : {std::pair(0, 0), std::pair(grid->columns - 1, grid->rows - 1)}) {
      const Vec3 corner = place_of(*grid, column, row);
      extent.low.head<2>() = extent.low.head<2>().cwiseMin(corner.head<2>());
      extent.high.head<2>() = extent.high.head<2>().cwiseMax(corner.head<2>());
    }
    for (const double height : grid->heights) {
      if (std::isnan(height)) continue;
      extent.low.z() = std::min(extent.low.z(), height);
      extent.high.z() = std::max(extent.high.z(), height);
    }
  } else {
    extent.add(std::get<Plane>(shape).point);
  }
  return extent;
}

/// A piece of a section: two places (distance along the line, height), from left to right.
struct Piece {
  Vec2 from, to;
  int part;
};

class Cut {
 public:
  Cut(const Vec2& from, const Vec2& to)
      : from_(from), length_((to - from).norm()), along_((to - from) / length_) {}

  /// Adds what a triangle leaves on the line.
  void add(const Vec3& a, const Vec3& b, const Vec3& c, int part) {
    const std::array<Vec3, 3> corner{a, b, c};
    std::array<double, 3> beside;
    for (int k = 0; k < 3; ++k) beside[k] = cross(along_, Vec2(corner[k].head<2>() - from_));
    const auto [least, greatest] = std::minmax({beside[0], beside[1], beside[2]});
    // A triangle whose side lies on the line counts if it is on the left of it, so that one of two does.
    if (!(least <= 0 && greatest > 0)) return;
    std::vector<Vec2> ends;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (beside[k] == 0) ends.push_back(place(corner[k]));
      if (beside[k] * beside[next] < 0)
        ends.push_back(
            place(corner[k] + beside[k] / (beside[k] - beside[next]) * (corner[next] - corner[k])));
    }
    if (ends.size() != 2) return;  // the line touches a corner
    if (ends[1].x() < ends[0].x()) std::swap(ends[0], ends[1]);
    if (ends[1].x() <= 0 || ends[0].x() >= length_) return;
    const Vec3 normal = (b - a).cross(c - a);
    if (std::abs(normal.z()) <= 1e-9 * normal.norm()) {  // upright: its ends are one above the other
      walls_.push_back({ends[0].x(), part});
      return;
    }
    if (normal.z() < 0) hangs_over_ = std::min(hangs_over_, ends[0].x());
    clip(ends);
    pieces_.push_back({ends[0], ends[1], part});
  }

  Profile profile(const std::vector<std::string>& parts) {
    if (hangs_over_ < 1e300) fail("hangs over", hangs_over_);
    std::sort(pieces_.begin(), pieces_.end(),
              [](const Piece& p, const Piece& q) { return p.from.x() < q.from.x(); });
    Profile profile;
    profile.parts = parts;
    const double rounding = 1e-9 * std::max(1.0, length_);
    constexpr double step = 1e-6;  // m; a lower one is rounding
    double reached = 0;
    for (const Piece& piece : pieces_) {
      if (piece.to.x() - piece.from.x() < rounding) continue;
      if (piece.from.x() > reached + rounding) fail("has no ground", reached);
      if (piece.from.x() < reached - rounding) fail("hangs over", piece.from.x());
      if (profile.points.empty()) profile.points.push_back(piece.from);
      if (std::abs(piece.from.y() - profile.points.back().y()) > step) {
        profile.points.emplace_back(profile.points.back().x(), piece.from.y());
        profile.part.push_back(wall_at(piece.from.x(), piece.part));
      }
      profile.points.push_back(piece.to);
      profile.part.push_back(piece.part);
      reached = piece.to.x();
    }
    if (reached < length_ - rounding) fail("has no ground", reached);
    return profile;
  }

 private:
  Vec2 place(const Vec3& p) const { return {along_.dot(p.head<2>() - from_), p.z()}; }

  /// The part of the upright ground at a distance along the line.
  int wall_at(double distance, int otherwise) const {
    for (const Wall& wall : walls_)
      if (std::abs(wall.at - distance) < 1e-6) return wall.part;
    return otherwise;
  }

  void clip(std::vector<Vec2>& ends) const {
    const Vec2 whole = ends[1] - ends[0];
    if (ends[0].x() < 0) ends[0] = Vec2(0, ends[0].y() - ends[0].x() / whole.x() * whole.y());
    if (ends[1].x() > length_)
      ends[1] = Vec2(length_, ends[1].y() - (ends[1].x() - length_) / whole.x() * whole.y());
  }

  [[noreturn]] void fail(const char* what, double distance) const {
    const Vec2 at = from_ + distance * along_;
    throw SectionError(fmt::format("the terrain {} on the line of the section {:.6g} m from its begin, at {}",
                                   what, distance, place_text(at)));
  }

  Vec2 from_;
  double length_;
  Vec2 along_;
  std::vector<Piece> pieces_;
  struct Wall {
    double at;
    int part;
  };
  std::vector<Wall> walls_;
  double hangs_over_ = 1e300;
};

/// Drops points between two pieces of one part that lie on a line, as triangles leave them on even ground.
Profile without_flat_points(Profile profile) {
  Profile kept;
  kept.parts = std::move(profile.parts);
  kept.points.push_back(profile.points[0]);
  for (std::size_t i = 1; i < profile.points.size(); ++i) {
    const Vec2& point = profile.points[i];
    const std::size_t n = kept.points.size();
    if (n > 1 && kept.part.back() == profile.part[i - 1]) {
      const Vec2 before = kept.points[n - 1] - kept.points[n - 2], after = point - kept.points[n - 1];
      if (std::abs(cross(before, after)) <= 1e-12 * before.norm() * after.norm()) {
        kept.points.back() = point;
        continue;
      }
    }
    kept.points.push_back(point);
    kept.part.push_back(profile.part[i - 1]);
  }
  return kept;
}

}  // namespace

Vec3 automatic_origin(const TerrainShape3& shape) {
  constexpr double far = 1e4, round = 100;
  Vec3 origin = Vec3::Zero();
  if (std::holds_alternative<Plane>(shape)) return origin;
  const Box3 extent = extent_of(shape);
  for (int k = 0; k < 3; ++k)
    if (std::max(std::abs(extent.low[k]), std::abs(extent.high[k])) > far)
      origin[k] = std::floor(extent.low[k] / round) * round;
  return origin;
}

TerrainShape3 counted_from(TerrainShape3 shape, const Vec3& origin) {
  if (origin == Vec3::Zero()) return shape;
  if (Mesh* mesh = std::get_if<Mesh>(&shape)) {
    for (Vec3& vertex : mesh->vertices) vertex -= origin;
    for (Mesh::Face& face : mesh->faces)
      for (auto* line : {&face.toe, &face.crest})
        for (Vec3& point : *line) point -= origin;
  } else if (HeightGrid* grid = std::get_if<HeightGrid>(&shape)) {
    grid->corner -= origin.head<2>();
    if (origin.z() != 0)
      for (double& height : grid->heights) height -= origin.z();
  } else {
    std::get<Plane>(shape).point -= origin;
  }
  return shape;
}

std::string reach_fault(const TerrainShape3& shape, const Vec3& origin, double most) {
  const Box3 extent = extent_of(shape);
  for (const Vec3& corner : {extent.low, extent.high})
    if (corner.cwiseAbs().maxCoeff() > most)
      return fmt::format("reaches to {}, more than {:.6g} km from the origin {}",
                         place_text(Vec3(corner + origin)), most / 1000, place_text(origin));
  return {};
}

Profile section_of(const TerrainShape3& shape, const Vec2& from, const Vec2& to) {
  constexpr double shortest = 1e-3, longest = 1e5;  // m
  const double length = (to - from).norm();
  if (!(length >= shortest && length <= longest))
    throw SectionError(
        fmt::format("`from` and `to` of the section are {:.6g} m apart, expected 1 mm to 100 km", length));
  Cut cut(from, to);
  if (const Plane* plane = std::get_if<Plane>(&shape)) {
    Profile profile;
    profile.points = {{0, plane->height(from.x(), from.y())}, {length, plane->height(to.x(), to.y())}};
    profile.part = {0};
    profile.parts = plane->parts;
    return profile;
  }
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
      const auto& [a, b, c] = mesh->triangles[t];
      cut.add(mesh->vertices[a], mesh->vertices[b], mesh->vertices[c], mesh->part[t]);
    }
  } else {
    const HeightGrid& grid = std::get<HeightGrid>(shape);
    // Only the squares near the line.
    const Vec2 along = (to - from).normalized();
    for (int row = 0; row + 1 < grid.rows; ++row)
      for (int column = 0; column + 1 < grid.columns; ++column) {
        const Vec2 middle = grid.corner + grid.cell * Vec2(column + 0.5, row + 0.5);
        if (std::abs(cross(along, Vec2(middle - from))) > grid.cell) continue;
        const Vec3 a = place_of(grid, column, row), b = place_of(grid, column + 1, row),
                   c = place_of(grid, column + 1, row + 1), d = place_of(grid, column, row + 1);
        if (!std::isfinite(a.z() + b.z() + c.z() + d.z())) continue;
        cut.add(a, b, c, 0);
        cut.add(a, c, d, 0);
      }
  }
  return without_flat_points(cut.profile(parts_of(shape)));
}

}  // namespace flyrock
