#include "plugin/terrain_view.h"

#include <algorithm>

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
