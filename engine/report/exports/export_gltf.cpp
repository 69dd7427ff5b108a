#include "report/exports/export_gltf.h"

#include <fmt/format.h>

#include <cmath>

#include "files/safe_file.h"
#include "report/exports/gltf_file.h"
#include "report/exports/rock_shape.h"
#include "report/exports/vtk_ground.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

constexpr double kilometre = 1000;
constexpr double most_turn =
    pi / 2;  // between moments in 2D: a turn of more than pi would take the short way

/// The corners of triangles that fill convex polygons, as fans.
std::vector<std::uint32_t> fans_of(const std::vector<std::vector<std::int64_t>>& polygons) {
  std::vector<std::uint32_t> triangles;
  for (const std::vector<std::int64_t>& corners : polygons)
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      for (const std::int64_t corner : {corners[0], corners[i], corners[i + 1]})
        triangles.push_back(static_cast<std::uint32_t>(corner));
  return triangles;
}

/// What one sweep point shows.
class MotionScene {
 public:
  MotionScene(bool in_space, const Vec3& first_place) : in_space_(in_space), file_(in_space ? 'z' : 'y') {
    for (int k = 0; k < (in_space ? 2 : 1); ++k)
      origin_[k] = kilometre * std::round(first_place[k] / kilometre);
    ground_ = file_.add_material("ground", Vec3(0.55, 0.52, 0.46));
    rock_ = file_.add_material("rock", Vec3(0.85, 0.42, 0.13));
  }

  void add_ground(const VtkPoints& ground) {
    if (ground.points.empty()) return;
    std::vector<Vec3> points;
    for (const Vec3& point : ground.points) points.push_back(point - origin_);
    int mesh = 0;
    if (ground.polygon_ends.empty()) {
      std::vector<std::uint32_t> ends(points.size());
      for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::uint32_t>(i);
      mesh = file_.add_lines("ground", points, ends, ground_);
    } else {
      const std::vector<std::uint32_t> corners(ground.corners.begin(), ground.corners.end());
      mesh = file_.add_triangles("ground", points, corners, ground_);
    }
    file_.add_node("ground", mesh, {{0}, {Vec3::Zero()}, {Eigen::Quaterniond::Identity()}}, {});
  }

  void add_rock(const StoredPath& path, const std::vector<SurfaceCorner>& corners) {
    add(fmt::format("{} {} of trial {}", path.group, path.rock, path.trial), path, corners, rock_,
        {{"trial", path.trial}, {"rock", path.rock}, {"group", path.group}, {"runout_m", path.runout}});
  }

  void add_fixture(const StoredFixture& fixture) {
    if (fixture_ < 0) fixture_ = file_.add_material("fixture", Vec3(0.35, 0.40, 0.48));
    add(fixture.path.group, fixture.path, fixture.corners, fixture_, {});
  }

  void write(const fs::path& file, const std::string& crs) const {
    GltfFile::Json extras = {{"origin_m", {origin_.x(), origin_.y(), origin_.z()}}};
    if (!crs.empty()) extras["crs"] = crs;
    file_.write(file, std::move(extras));
  }

 private:
  void add(const std::string& name, const StoredPath& path, const std::vector<SurfaceCorner>& corners,
           int material, GltfFile::Json extras) {
    const RockShape shape = shape_of(corners, in_space_);
    const std::vector<std::uint32_t> triangles = fans_of(shape.faces);
    if (triangles.empty()) return;
    const int mesh = file_.add_triangles(name, shape.vertices, triangles, material);
    file_.add_node(name, mesh, motion_of(path), std::move(extras));
  }

  GltfMotion motion_of(const StoredPath& path) const {
    GltfMotion motion;
    const auto put = [&](const StoredMoment& moment) {
      motion.times.push_back(moment.time);
      motion.places.push_back(moment.place - origin_);
      motion.turns.push_back(turn_of(moment, in_space_));
    };
    put(path.moments.front());
    for (std::size_t i = 1; i < path.moments.size(); ++i) {
      const StoredMoment &a = path.moments[i - 1], &b = path.moments[i];
      const double pieces = in_space_ ? 1 : std::ceil(std::abs(b.angle - a.angle) / most_turn);
      for (double k = 1; k < pieces; ++k) put(path.at(a.time + k / pieces * (b.time - a.time)));
      put(b);
    }
    return motion;
  }

  bool in_space_;
  Vec3 origin_ = Vec3::Zero();
  GltfFile file_;
  int ground_ = 0, rock_ = 0;  // materials
  int fixture_ = -1;           // without fixtures none
};

}  // namespace

std::vector<fs::path> export_gltf(const fs::path& results, const fs::path& folder) {
  const SqliteReader database(results);
  const bool in_space = is_stored_in_space(database);
  StoredPaths stored(database);
  std::vector<fs::path> files;
  for (auto paths = stored.next_point(); !paths.empty(); paths = stored.next_point()) {
    if (files.empty()) make_folder(folder);
    const std::int64_t point = paths.front().point;
    MotionScene scene(in_space, paths.front().moments.front().place);
    scene.add_ground(stored_ground_surface(database, point));
    for (const StoredPath& path : paths) scene.add_rock(path, stored_corners(database, path));
    for (const StoredFixture& fixture : stored_fixtures(database, paths)) scene.add_fixture(fixture);
    files.push_back(folder / fmt::format("motion-p{}.glb", point));
    scene.write(files.back(), stored_crs(database));
  }
  return files;
}

}  // namespace flyrock
