// Times of impact with the ground in 3D: which facets to search, and the contacts that hold there.
#include <algorithm>

#include "collision/advance_3d.h"
#include "collision/ground/along_path.h"
#include "collision/held_3d.h"
#include "collision/rules.h"
#include "collision/smooth/piece_heights.h"

namespace flyrock {

namespace {

/// The first touch of a contactor that moves by `travel` at most, a small part of its size. Only the facets
/// in its box matter, and of these the ones whose planes it does not surely stay above.
template <class See>
std::optional<double> near_start(Workspace& work, const Ground3& ground, const Moving3& c, double travel,
                                 double end, const TouchSearch& search, const See& see) {
  const MovingState start(c, 0, end);
  Box3 box = core_box({c.shape, {start.x, start.turn.rotation}});
  const double grow = c.shape.radius + travel + 1e-6 * c.shape.bound;
  box.low.array() -= grow;
  box.high.array() += grow;
  std::vector<Facet>& facets = work.facets;
  facets.clear();
  ground.facets(box, facets);
  std::vector<PieceHeight>& pieces = work.heights_a;
  std::optional<double> first;
  for (const Facet& facet : facets) {
    const Heights heights(facet.normal, Vec3::Zero(), start, facet.corner[0], Vec3::Zero());
    const double bend = std::max(0.0, -facet.normal.dot(c.motion.a)) + start.bend(c.shape.bound);
    const double room = search.slack - c.shape.radius - 1e-9 * search.size;
    const auto& points = c.shape.points;
    const bool clear = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return stays_open(heights.of(p) + room, heights.rate(p), bend, first.value_or(end));
    });
    const double until = first.value_or(end);
    piece_heights(c.shape, heights, pieces);
    const bool circles_clear = std::all_of(pieces.begin() + points.size(), pieces.end(), [&](const auto& p) {
      return p.at(0) + room > 0 && p.at(until) + room - 0.5 * until * until * bend > 0;  // it is concave
    });
    if (facet.unbounded || !clear || !circles_clear) see(facet, {0, first.value_or(end)}, first);
  }
  return first;
}

/// The first of the times that touch_of_facet(facet, window) finds.
template <class TouchOfFacet>
std::optional<double> touch_of_facets(Workspace& work, const Moving3& c, const Ground3& ground, double t_max,
                                      const TouchSearch& search, const TouchOfFacet& touch_of_facet) {
  const auto see = [&](const Facet& facet, const TimeWindow& window, std::optional<double>& first) {
    const auto t = touch_of_facet(facet, window);
    if (t && (!first || *t < *first)) first = t;
  };
  const double reach = reach_on_path(c.shape.bound);
  if (const double travel = greatest_travel(c.motion, c.shape.bound, t_max); travel < 0.25 * reach)
    return near_start(work, ground, c, travel, t_max, search, see);
  return along_path(work, ground, c.motion, reach, t_max, see);
}

}  // namespace

template <CoreSearch by>
std::optional<double> core_touch_of_ground(Workspace& work, const Moving3& core, const Ground3& ground,
                                           double t_max, const TouchSearch& search) {
  const TouchSearch near = by == CoreSearch::pill ? without_distant(work, core, ground, search) : search;
  const auto held = held_on(work, ground, near.held);
  return touch_of_facets(work, core, ground, t_max, near, [&](const Facet& facet, const TimeWindow& window) {
    return core_touch_of_facet(work, core, facet, held, by, window, near);
  });
}
template FindTouchOfGround<3> core_touch_of_ground<CoreSearch::ball>;
template FindTouchOfGround<3> core_touch_of_ground<CoreSearch::pill>;
template FindTouchOfGround<3> core_touch_of_ground<CoreSearch::hull>;

std::optional<double> smooth_touch_of_ground(Workspace& work, const Moving3& shape, const Ground3& ground,
                                             double t_max, const TouchSearch& search) {
  return touch_of_facets(work, shape, ground, t_max, search,
                         [&](const Facet& facet, const TimeWindow& window) {
                           return smooth_touch_of_facet(work, shape, facet, window, search);
                         });
}

std::optional<double> cloud_touch_of_ground(Workspace& work, const Moving3& cloud, const Ground3& ground,
                                            double t_max, const TouchSearch& search) {
  return touch_of_facets(work, cloud, ground, t_max, search,
                         [&](const Facet& facet, const TimeWindow& window) {
                           return cloud_touch_of_facet(cloud, facet, window, search);
                         });
}

}  // namespace flyrock
