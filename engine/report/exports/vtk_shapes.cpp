#include "report/exports/vtk_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/exports/rock_shape.h"
#include "report/exports/vtk_file.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

constexpr double least_steps = 50;    // of a series; a round number of seconds makes fewer
constexpr double most_bytes = 100e6;  // of all steps together, about

/// In the file of a step, about: a vertex has three coordinates, a face its corners and its data.
double bytes_of(const RockShape& shape) {
  return 30 * static_cast<double>(shape.vertices.size()) + 80 * static_cast<double>(shape.faces.size());
}

/// All rocks and fixtures of a step as one set of polygons.
class StepPolygons {
 public:
  void add(const StoredPath& path, const RockShape& surface, const StoredMoment& now, bool in_space) {
    const Eigen::Matrix3d turn = turn_of(now, in_space).toRotationMatrix();
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
  const bool in_space = is_stored_in_space(database);
  std::vector<RockShape> surfaces;
  double bytes = 0, end = 0;
  for (const StoredPath& path : paths) {
    RockShape surface = shape_of(stored_corners(database, path), in_space);
    if (!surfaces.empty() && least_steps * (bytes + bytes_of(surface)) > most_bytes) break;
    bytes += bytes_of(surface);
    surfaces.push_back(std::move(surface));
    end = std::max(end, path.moments.back().time);
  }
  std::vector<StoredPath> shown(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(surfaces.size()));
  for (StoredFixture& fixture : stored_fixtures(database, shown)) {
    surfaces.push_back(shape_of(fixture.corners, in_space));
    bytes += bytes_of(surfaces.back());
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
