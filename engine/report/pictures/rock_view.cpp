#include "report/pictures/rock_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace flyrock {

namespace {

Vec3 middle_of(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

}  // namespace

PictureView view_of(int dimension) {
  if (dimension == 2) return {};
  const double azimuth = -55 * pi / 180, elevation = 25 * pi / 180;  // of the eye
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  return {{-s, c, 0}, {-se * c, -se * s, ce}, {ce * c, ce * s, se}};
}

Vec3 area_of(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    sum += (places[i] - places[0]).cross(places[i + 1] - places[0]);
  return sum;
}

std::vector<Piece> pieces_of(const std::vector<SurfaceCorner>& corners, const PictureView& view) {
  std::map<std::pair<int, int>, std::vector<Vec3>> faces;
  std::map<std::pair<int, int>, double> radius;
  std::map<int, std::vector<Vec3>> contactors;
  for (const SurfaceCorner& corner : corners) {
    faces[{corner.contactor, corner.face}].push_back(corner.place);
    radius[{corner.contactor, corner.face}] = corner.radius;
    contactors[corner.contactor].push_back(corner.place);
  }
  std::vector<Piece> pieces;
  for (const auto& [key, places] : faces) {
    const Vec3 area = area_of(places);
    Piece piece;
    piece.radius = radius[key];
    if (piece.radius <= 0 && area.dot(view.near) <= 0) continue;
    for (const Vec3& place : places) piece.outline.push_back(view(place));
    piece.part_depth = view.near.dot(middle_of(contactors[key.first]));
    piece.light = piece.radius > 0 ? light_of(Vec3::Zero()) : light_of(area);
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.part_depth < b.part_depth; });
  return pieces;
}

double light_of(const Vec3& area) { return area.isZero() ? 0.7 : 0.5 + 0.5 * area.normalized().z(); }

std::string colour_of(double light) {
  const auto mix = [&](int dark, int bright) {
    return static_cast<int>(std::lround(dark + light * (bright - dark)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0x8a, 0xf2), mix(0x80, 0xee), mix(0x70, 0xe4));
}

}  // namespace flyrock
