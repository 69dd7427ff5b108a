#pragma once
// The grounds of a 3D run as triangles: all of them for exports, fewer for the page.

#include <vector>

#include "geometry/ground_surface.h"
#include "results/measured/measures.h"

namespace flyrock {

/// At most about so many triangles of all grounds of a run together: in the database, and in the page, where
/// one takes some 20 bytes.
inline constexpr std::size_t most_stored_triangles = 250'000, most_page_triangles = 30'000;

/// The ground of one point or of several that share it, over all places of their rocks, in the coordinates of
/// the scenario.
struct GroundPicture {
  GroundSurface stored, page;
  double cell = 0;  ///< see Ground3::cell
};

struct GroundPictures {
  std::vector<GroundPicture> grounds;
  std::vector<int> of_point;  ///< index into `grounds`; -1: in 2D, or if the point has no ground or no rock
};

GroundPictures ground_pictures(const std::vector<PointResult>& points);

/// The ground of a point under the mean line of its rocks (PlanReach): lines of (distance from the mean
/// release, height) [m].
std::vector<std::vector<Vec2>> ground_under(const PointResult& point, const PlanReach::Line& line);

}  // namespace flyrock
