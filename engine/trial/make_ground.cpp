#include "trial/make_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/place_text.h"
#include "geometry/plan_zone.h"
#include "geometry/terrain_fault.h"
#include "geometry/terrain_place.h"
#include "trial/scenario_error.h"
#include "trial/start_checks.h"

namespace flyrock {

namespace {

Profile with_faces(Profile profile, const std::vector<FacePlan>& faces) {
  for (const FacePlan& plan : faces) {
    const Vec2 from(plan.from, profile.height(plan.from)), to(plan.to, profile.height(plan.to));
    const bool falls = from.y() > to.y();
    profile.faces.push_back({.toe = falls ? to : from, .crest = falls ? from : to, .name = plan.name});
  }
  return profile;
}

/// The terrain with the part `from` under the name `to`.
TerrainShape3 renamed(TerrainShape3 shape, const std::string& from, const std::string& to) {
  std::visit(
      [&](auto& terrain) {
        for (std::string& part : terrain.parts)
          if (part == from) part = to;
      },
      shape);
  return shape;
}

/// Where a zone of polygons is, and whether the numbers of a file are those of longitudes and latitudes.
std::string hint_of_place(const Zone& zone) {
  std::vector<Vec2> corners = zone.polygon;
  for (const PlanPolygon& polygon : zone.polygons)
    corners.insert(corners.end(), polygon.outline.begin(), polygon.outline.end());
  if (corners.empty()) return "";
  Vec2 low = corners.front(), high = low;
  for (const Vec2& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const bool is_on_earth =
      zone.polygon.empty() && low.x() >= -180 && high.x() <= 180 && low.y() >= -90 && high.y() <= 90;
  return fmt::format(
      "; it spans x {:.10g} to {:.10g} and y {:.10g} to {:.10g}{}", low.x(), high.x(), low.y(), high.y(),
      is_on_earth ? ", which may be degrees, expected metres of the system of the terrain" : "");
}

/// Refuses a zone that has no part of a terrain after it was cut out of it.
void refuse_if_empty(const std::vector<Zone>& zones, const Zone& zone, bool has_part) {
  if (has_part) return;
  throw ScenarioError(fmt::format("terrain.zones.{}", &zone - zones.data()),
                      fmt::format("the zone `{}` covers nothing of the terrain: expected a region on it that "
                                  "holds the middle of a segment, triangle or cell{}",
                                  zone.name, hint_of_place(zone)));
}

bool has_part(const Plane& plane, const std::string& name) { return plane.parts.front() == name; }
template <class Shape>
bool has_part(const Shape& shape, const std::string& name) {
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    if (shape.parts[part] == name &&
        std::find(shape.part.begin(), shape.part.end(), static_cast<int>(part)) != shape.part.end())
      return true;
  return shape.part.empty() && shape.parts.front() == name;
}

}  // namespace

Terrain2 profile_ground(Profile profile, const TerrainPlan& plan) {
  const std::string& name = plan.model.plugin->spec.name;
  if (const std::string fault = profile.fault(); !fault.empty())
    throw PluginError(
        fmt::format("plugin {}: build() returned a poly-line that is not a profile: {}", name, fault));
  for (const Vec2& point : profile.points)
    if (point.cwiseAbs().maxCoeff() > farthest_place)
      throw PluginError(
          fmt::format("plugin {}: the point {} of a profile is more than 100 km from the origin", name,
                      place_text(point)));
  try {
    profile = with_earthworks(std::move(profile), plan.works);
  } catch (const EarthworksError& error) {
    throw PluginError(fmt::format("plugin {}: {}", name, error.what()));
  }
  return Terrain2(with_faces(with_zones(std::move(profile), plan.zones), plan.faces));
}

Terrain3 shaped_ground(TerrainShape3 shape, const TerrainPlan& plan) {
  const std::string& name = plan.model.plugin->spec.name;
  if (const std::string wrong = fault(shape); !wrong.empty())
    throw PluginError(fmt::format("plugin {}: build_3d() returned no ground: {}", name, wrong));
  for (const Zone& zone : plan.zones) {
    if (!zone.polygon.empty())
      shape = with_zone(std::move(shape), zone.name, zone.polygon);
    else if (!zone.polygons.empty())
      shape = with_zone(std::move(shape), zone.name, zone.polygons);
    else if (zone.raster)
      shape =
          with_zone(std::move(shape), zone.name, [&zone](const Vec2& place) { return covers(zone, place); });
    else
      shape = renamed(std::move(shape), zone.group, zone.name);
    refuse_if_empty(plan.zones, zone,
                    std::visit([&](const auto& terrain) { return has_part(terrain, zone.name); }, shape));
  }
  shape = counted_from(std::move(shape), plan.origin);
  if (const std::string far = reach_fault(shape, plan.origin, farthest_place); !far.empty())
    throw PluginError(fmt::format("plugin {}: the terrain {}; `origin` of the terrain sets it", name, far));
  return Terrain3(std::move(shape));
}

Profile with_zones(Profile profile, const std::vector<Zone>& zones) {
  for (const Zone& zone : zones) {
    const int part = static_cast<int>(profile.parts.size());
    profile.parts.push_back(zone.name);
    for (const double x : {zone.from, zone.to}) {
      for (int i = 0; i < profile.segments(); ++i) {
        const Vec2 a = profile.points[i], b = profile.points[i + 1];
        if (x <= a.x() || x >= b.x()) continue;
        profile.points.insert(profile.points.begin() + i + 1, a + (x - a.x()) / (b.x() - a.x()) * (b - a));
        profile.part.insert(profile.part.begin() + i, profile.part[i]);
        break;
      }
    }
    for (int i = 0; i < profile.segments(); ++i) {
      const double middle = 0.5 * (profile.points[i].x() + profile.points[i + 1].x());
      if (middle > zone.from && middle < zone.to) profile.part[i] = part;
    }
    refuse_if_empty(zones, zone, has_part(profile, zone.name));
  }
  return profile;
}

bool covers(const Zone& zone, const Vec2& place) {
  if (!zone.polygon.empty()) return is_inside(zone.polygon, place);
  if (!zone.polygons.empty()) return is_inside(zone.polygons, place);
  return zone.raster && value_at(*zone.raster, place) == zone.value;
}

std::optional<double> value_at(const HeightGrid& grid, const Vec2& place) {
  const Vec2 cell = (place - grid.corner) / grid.cell + Vec2(0.5, 0.5);
  if (!(cell.x() >= 0 && cell.x() < grid.columns && cell.y() >= 0 && cell.y() < grid.rows))
    return std::nullopt;
  const double value = grid.at(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

}  // namespace flyrock
