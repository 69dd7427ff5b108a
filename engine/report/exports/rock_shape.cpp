#include "report/exports/rock_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace flyrock {

namespace {

/// Vertices of a surface, each once.
class Vertices {
 public:
  explicit Vertices(RockShape& surface) : surface_(surface) {}
  std::int64_t number_of(const Vec3& place) {
    const auto [known, is_new] =
        numbers_.try_emplace({place.x(), place.y(), place.z()}, surface_.vertices.size());
    if (is_new) surface_.vertices.push_back(place);
    return static_cast<std::int64_t>(known->second);
  }

 private:
  RockShape& surface_;
  std::map<std::array<double, 3>, std::size_t> numbers_;
};

/// The place of the hull of `points`, grown by a radius, that is farthest along a unit vector.
Vec3 farthest(const std::vector<Vec3>& points, double radius, const Vec3& direction) {
  Vec3 best = points.front();
  for (const Vec3& point : points)
    if (direction.dot(point - best) > 0) best = point;
  return best + radius * direction;
}

/// A grown hull: the faces of an octahedron with each edge cut into pieces, moved out to the surface.
void add_grown(RockShape& surface, const std::vector<Vec3>& points, double radius) {
  constexpr int pieces = 4;  // of an edge
  Vertices vertices(surface);
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0})
      for (const double sz : {1.0, -1.0}) {
        const auto vertex = [&](int i, int k) {
          const Vec3 direction = Vec3(sx * i, sy * k, sz * (pieces - i - k)).normalized();
          return vertices.number_of(farthest(points, radius, direction));
        };
        const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
          if (sx * sy * sz > 0)
            surface.faces.push_back({a, b, c});
          else
            surface.faces.push_back({a, c, b});  // seen from outside
        };
        for (int i = 0; i < pieces; ++i)
          for (int k = 0; i + k < pieces; ++k) {
            add(vertex(i, k), vertex(i + 1, k), vertex(i, k + 1));
            if (i + k + 2 <= pieces) add(vertex(i + 1, k), vertex(i + 1, k + 1), vertex(i, k + 1));
          }
      }
}

/// The same in 2D: one polygon.
void add_grown_outline(RockShape& surface, const std::vector<Vec3>& points, double radius) {
  const int corners = std::max(48, 8 * static_cast<int>(points.size()));
  std::vector<std::int64_t> face;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    face.push_back(static_cast<std::int64_t>(surface.vertices.size()));
    surface.vertices.push_back(farthest(points, radius, Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  surface.faces.push_back(std::move(face));
}

}  // namespace

RockShape shape_of(const std::vector<SurfaceCorner>& corners, bool in_space) {
  RockShape surface;
  Vertices vertices(surface);
  int contactor = -1, face = -1;
  std::vector<Vec3> points;  // of a contactor that is grown by a radius
  double radius = 0;
  const auto add_points = [&] {
    if (!points.empty()) (in_space ? add_grown : add_grown_outline)(surface, points, radius);
    points.clear();
  };
  for (const SurfaceCorner& corner : corners) {
    const bool is_new = corner.contactor != contactor || corner.face != face;
    if (is_new) add_points();
    radius = corner.radius;
    if (is_new && !(radius > 0)) surface.faces.emplace_back();
    contactor = corner.contactor;
    face = corner.face;
    if (radius > 0)
      points.push_back(corner.place);
    else
      surface.faces.back().push_back(vertices.number_of(corner.place));
  }
  add_points();
  return surface;
}

bool is_stored_in_space(const SqliteReader& database) {
  Query dimension(database, "SELECT count(*) FROM pragma_table_info('trajectory_rows') WHERE name = 'z_m'");
  return dimension.next() && dimension.whole(0) > 0;
}

Eigen::Quaterniond turn_of(const StoredMoment& moment, bool in_space) {
  return in_space ? moment.turn : Eigen::Quaterniond(Eigen::AngleAxisd(moment.angle, Vec3::UnitZ()));
}

}  // namespace flyrock
