#include "report/page/ground_data.h"

#include <nlohmann/json.hpp>

#include "geometry/ground.h"
#include "report/page/rounded.h"
#include "report/page/tracks.h"
#include "report/tables/json_object.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// The greatest distance between the thinned and the sampled profile, relative to its length.
constexpr double section_tolerance = 2e-4;

Json surface_data(const GroundPicture& picture) {
  const auto& [mesh, lattice] = picture.page;
  std::vector<double> x, y, z;
  for (const Vec3& vertex : mesh.vertices) {
    x.push_back(vertex.x());
    y.push_back(vertex.y());
    z.push_back(vertex.z());
  }
  Json triangles = Json::array();
  int before = 0;
  for (const auto& triangle : mesh.triangles)
    for (const int vertex : triangle) {
      triangles.push_back(vertex - before);
      before = vertex;
    }
  return json_object("x", differences(x), "y", differences(y), "z", differences(z), "triangles",
                     std::move(triangles), "part", runs_of(mesh.part), "parts", mesh.parts, "lattice",
                     lattice, "cell", picture.cell);
}

/// Thins a line of (distance, height).
Json line_data(const std::vector<Vec2>& line, double tolerance) {
  std::vector<Vec3> places;
  for (const Vec2& place : line) places.emplace_back(place.x(), place.y(), 0);
  std::vector<double> s, z;
  for (const std::size_t i : simplify(places, tolerance)) {
    s.push_back(line[i].x());
    z.push_back(line[i].y());
  }
  return json_object("s", differences(s), "z", differences(z));
}

}  // namespace

Json grounds_data(const GroundPictures& pictures) {
  Json list = Json::array();
  for (const GroundPicture& picture : pictures.grounds) list.push_back(surface_data(picture));
  return list;
}

Json stems_data(const PointResult& point, std::size_t most) {
  if (!point.forest) return nullptr;
  const std::vector<Stem>& stems = point.forest->stems();
  const Vec3& origin = point.terrain.origin;
  std::vector<double> x, y, foot, height, diameter;
  for (std::size_t i = 0; i < std::min(most, stems.size()); ++i) {
    const Vec2& place = stems[i].place;
    const auto ground = point.terrain.ground->ground().height(place.x(), place.y());
    if (!ground) continue;
    x.push_back(place.x() + origin.x());
    y.push_back(place.y() + origin.y());
    foot.push_back(*ground + origin.z());
    height.push_back(stems[i].height);
    diameter.push_back(2 * stems[i].radius);
  }
  return json_object("x", differences(x), "y", differences(y), "foot", differences(foot), "height",
                     differences(height), "diameter", differences(diameter), "count", stems.size());
}

Json section_data(const PointResult& point) {
  if (point.reach.empty()) return nullptr;
  const PlanReach::Line line = point.reach.mean_line();
  Json lines = Json::array();
  for (const std::vector<Vec2>& piece : ground_under(point, line))
    lines.push_back(line_data(piece, section_tolerance * (line.to - line.from)));
  return json_object("x", line.release.x(), "y", line.release.y(), "dx", line.direction.x(), "dy",
                     line.direction.y(), "from", line.from, "to", line.to, "lines", std::move(lines));
}

}  // namespace flyrock
