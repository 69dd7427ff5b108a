#include "report/exports/vtk_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/exports/vtk_file.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

constexpr double least_steps = 50;    // of a series; a round number of seconds makes fewer
constexpr double most_bytes = 100e6;  // of all steps together, about

/// A surface in the body's frame.
struct RockShape {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::int64_t>> faces;

  /// In the file of a step, about: a vertex has three coordinates, a face its corners and its data.
  double bytes() const {
    return 30 * static_cast<double>(vertices.size()) + 80 * static_cast<double>(faces.size());
  }
};

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

/// The surface with these corners.
RockShape surface_with(const std::vector<SurfaceCorner>& corners, bool in_space) {
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

/// All rocks and fixtures of a step as one set of polygons.
class StepPolygons {
 public:
  void add(const StoredPath& path, const RockShape& surface, const StoredMoment& now, bool in_space) {
    const Eigen::Matrix3d turn = in_space ? now.turn.toRotationMatrix()
                                          : Eigen::AngleAxisd(now.angle, Vec3::UnitZ()).toRotationMatrix();
    const auto first = static_cast<std::int64_t>(data_.points.size());
    for (const Vec3& vertex : surface.vertices) data_.points.push_back(rounded(now.place + turn * vertex));
    for (const std::vector<std::int64_t>& face : surface.faces) {
      for (const std::int64_t corner : face) data_.corners.push_back(first + corner);
      data_.polygon_ends.push_back(data_.corners.size());
      const double values[] = {static_cast<double>(path.trial),
                               static_cast<double>(path.rock),
                               path.runout,
                               now.speed,
                               now.energy,
                               now.mode};
      for (std::size_t i = 0; i < of_faces_.size(); ++i) of_faces_[i].values.push_back(values[i]);
    }
  }
  VtkPoints done() && {
    data_.of_cells = std::move(of_faces_);
    return std::move(data_);
  }

 private:
  static Vec3 rounded(const Vec3& place) { return (place * 1e4).array().round().matrix() / 1e4; }

  VtkPoints data_;
  std::vector<VtkArray> of_faces_ = {{"trial", {}},     {"rock", {}},     {"runout_m", {}},
                                     {"speed_m_s", {}}, {"energy_J", {}}, {"mode", {}}};
};

}  // namespace

void write_shapes(const fs::path& index, const SqliteReader& database, const std::vector<StoredPath>& paths) {
  const bool in_space = [&] {
    Query dimension(database, "SELECT count(*) FROM pragma_table_info('trajectory_rows') WHERE name = 'z_m'");
    return dimension.next() && dimension.whole(0) > 0;
  }();
  std::vector<RockShape> surfaces;
  double bytes = 0, end = 0;
  for (const StoredPath& path : paths) {
    RockShape surface = surface_with(stored_corners(database, path), in_space);
    if (!surfaces.empty() && least_steps * (bytes + surface.bytes()) > most_bytes) break;
    bytes += surface.bytes();
    surfaces.push_back(std::move(surface));
    end = std::max(end, path.moments.back().time);
  }
  std::vector<StoredPath> shown(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(surfaces.size()));
  for (StoredFixture& fixture : stored_fixtures(database, shown)) {
    surfaces.push_back(surface_with(fixture.corners, in_space));
    bytes += surfaces.back().bytes();
    shown.push_back(std::move(fixture.path));
  }
  const double steps = std::clamp(most_bytes / std::max(bytes, 1.0), least_steps, most_vtk_steps);
  write_vtp_series(index, end, steps, stored_crs(database), [&](double time) {
    StepPolygons polygons;
    for (std::size_t k = 0; k < surfaces.size(); ++k)
      polygons.add(shown[k], surfaces[k], shown[k].at(time), in_space);
    return std::move(polygons).done();
  });
}

}  // namespace flyrock
