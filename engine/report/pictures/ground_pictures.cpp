#include "report/pictures/ground_pictures.h"

#include <map>

#include "geometry/ground.h"

namespace flyrock {

namespace {

constexpr int section_points = 1000;

Vec2 in_plan(const Vec3& place) { return place.head<2>(); }

GroundSurface surface_of(const TerrainPicture& terrain, const Eigen::AlignedBox2d& window, std::size_t most) {
  const Vec2 origin = in_plan(terrain.origin);
  GroundSurface surface =
      surface_within(terrain.ground->ground(), {window.min() - origin, window.max() - origin}, most);
  for (Vec3& vertex : surface.mesh.vertices) vertex += terrain.origin;
  return surface;
}

}  // namespace

GroundPictures ground_pictures(const std::vector<PointResult>& points) {
  struct Shared {
    const TerrainPicture* terrain;
    Eigen::AlignedBox2d window;
  };
  GroundPictures pictures;
  std::vector<Shared> list;
  std::map<const Terrain3*, int> known;
  for (const PointResult& point : points) {
    const Terrain3* ground = point.terrain.ground.get();
    if (!ground || point.reach.empty()) {
      pictures.of_point.push_back(-1);
      continue;
    }
    const auto [found, is_new] = known.try_emplace(ground, static_cast<int>(list.size()));
    if (is_new) list.push_back({&point.terrain, {}});
    list[static_cast<std::size_t>(found->second)].window.extend(point.reach.window());
    pictures.of_point.push_back(found->second);
  }
  for (const auto& [terrain, window] : list)
    pictures.grounds.push_back({surface_of(*terrain, window, most_stored_triangles / list.size()),
                                surface_of(*terrain, window, most_page_triangles / list.size()),
                                terrain->ground->ground().cell()});
  return pictures;
}

std::vector<std::vector<Vec2>> ground_under(const PointResult& point, const PlanReach::Line& line) {
  if (!point.terrain.ground) return {};
  const Vec3& origin = point.terrain.origin;
  const Vec2 release = line.release - in_plan(origin);
  std::vector<std::vector<Vec2>> lines =
      heights_along(point.terrain.ground->ground(), release + line.from * line.direction,
                    release + line.to * line.direction, section_points);
  for (std::vector<Vec2>& piece : lines)
    for (Vec2& place : piece) place += Vec2(line.from, origin.z());
  return lines;
}

}  // namespace flyrock
