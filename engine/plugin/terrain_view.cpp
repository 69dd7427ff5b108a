#include "plugin/terrain_view.h"

#include <algorithm>
#include <string_view>

#include "geometry/ground.h"
#include "geometry/profile.h"

namespace flyrock {

Vec2 TerrainView::low() const {
  if (profile_) return {profile_->x_min(), 0};
  return ground_->extent().low.head<2>() + origin_.head<2>();
}

Vec2 TerrainView::high() const {
  if (profile_) return {profile_->x_max(), 0};
  return ground_->extent().high.head<2>() + origin_.head<2>();
}

std::optional<double> TerrainView::height(double x, double y) const {
  if (!profile_) {
    const auto found = ground_->top(x - origin_.x(), y - origin_.y());
    return found ? std::optional(found->z + origin_.z()) : std::nullopt;
  }
  if (!(x >= profile_->x_min() && x <= profile_->x_max())) return std::nullopt;
  return profile_->height(x);
}

std::optional<Vec3> TerrainView::normal(double x, double y) const {
  if (!profile_) {
    const auto found = ground_->top(x - origin_.x(), y - origin_.y());
    return found ? std::optional(ground_->facet(found->facet).normal) : std::nullopt;
  }
  if (!(x >= profile_->x_min() && x <= profile_->x_max())) return std::nullopt;
  // The segment to the right of x, or the last one.
  const auto& points = profile_->points;
  auto right = std::upper_bound(points.begin(), points.end(), x,
                                [](double value, const Vec2& point) { return value < point.x(); });
  if (right == points.end()) --right;
  const Vec2 along = (*right - *(right - 1)).normalized();
  return Vec3(-along.y(), along.x(), 0);
}

namespace {

constexpr std::string_view notch_back = "notch_back", notch_base = "notch_base", notch_end = "notch_end";

/// In 2D the crest that was there lies above the toe as the back lies above its foot at the height of the
/// toe.
std::optional<TerrainView::Notch> notch_in(const Profile& profile) {
  const auto segment_of = [&](std::string_view name) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < profile.part.size(); ++i)
      if (profile.parts[static_cast<std::size_t>(profile.part[i])] == name) return i;
    return std::nullopt;
  };
  const auto back = segment_of(notch_back), base = segment_of(notch_base);
  if (!back || !base) return std::nullopt;
  const Vec2 &top = profile.points[*back], &low = profile.points[*back + 1], &toe = profile.points[*base + 1];
  const Vec2 foot = low + (toe.y() - low.y()) / (top.y() - low.y()) * (top - low);
  TerrainView::Notch notch;
  for (const Vec2& corner : {top, low, toe, Vec2(top + toe - foot)})
    notch.corners.emplace_back(corner.x(), corner.y(), 0);
  return notch;
}

std::optional<TerrainView::Notch> notch_in(const Ground3& ground, const Vec3& origin) {
  const std::vector<std::string>& parts = ground.parts();
  if (std::find(parts.begin(), parts.end(), notch_back) == parts.end()) return std::nullopt;
  std::vector<Facet> facets;
  ground.triangles(ground.extent(), facets);
  TerrainView::Notch notch;
  for (const Facet& facet : facets) {
    const std::string& part = parts[static_cast<std::size_t>(ground.part(facet.id))];
    if (part != notch_back && part != notch_base && part != notch_end) continue;
    for (const Vec3& corner : facet.corner) notch.corners.push_back(corner + origin);
    if (part == notch_back) notch.outward = Vec3(facet.normal.x(), facet.normal.y(), 0).normalized();
  }
  if (notch.corners.empty()) return std::nullopt;
  return notch;
}

}  // namespace

std::optional<TerrainView::Notch> TerrainView::notch() const {
  return profile_ ? notch_in(*profile_) : notch_in(*ground_, origin_);
}

std::vector<TerrainView::Face> TerrainView::faces() const {
  std::vector<Face> list;
  if (profile_) {
    const auto in_3d = [](const Vec2& p) { return std::vector<Vec3>{Vec3(p.x(), p.y(), 0)}; };
    for (std::size_t i = 0; i < profile_->faces.size(); ++i)
      list.push_back(
          {profile_->face_name(i), in_3d(profile_->faces[i].toe), in_3d(profile_->faces[i].crest)});
    return list;
  }
  for (const Mesh::Face& face : *faces_) {
    Face& shown = list.emplace_back(Face{face.name, face.toe, face.crest});
    for (auto* line : {&shown.toe, &shown.crest})
      for (Vec3& point : *line) point += origin_;
  }
  return list;
}

}  // namespace flyrock
