// Times of impact with the ground in 3D: which facets to search, and the contacts that hold there.
#include <algorithm>

#include "collision/advance_3d.h"
#include "collision/ground/along_path.h"
#include "collision/pair_search.h"
#include "collision/rules.h"
#include "collision/smooth/piece_heights.h"

namespace flyrock {

namespace {

// A contact of a pill that has opened by more than this share of the size is not held any more.
constexpr double opened_share = 1e-4;

/// The contacts that exist at the start, with the vertices of their features. Valid until the next call.
const std::vector<HeldOnGround>& held_on(Workspace& work, const Ground3& ground,
                                         std::span<const HeldContact> held) {
  std::vector<HeldOnGround>& found = work.held_on_ground;
  found.clear();
  for (const HeldContact& contact : held) {
    HeldOnGround on{contact.feature, contact.against, contact.opened, contact.yields, {}, 1};
    if (kind_of(contact.against) == FeatureKind::vertex) {
      on.vertex[0] = ground_index(contact.against);
      on.place = ground.vertex(on.vertex[0]);
    } else {
      const Facet facet = ground.facet(ground.facet_of(contact.against));
      const int rim = static_cast<int>(ground_index(contact.against) % 3);
      on.vertex = facet.vertex;
      on.vertices = 3;
      on.normal = facet.normal;
      on.place = facet.corner[0];
      if (kind_of(contact.against) == FeatureKind::edge) {
        on.vertex = {facet.vertex[rim], facet.vertex[Facet::next(rim)]};
        on.vertices = 2;
        on.place = facet.corner[rim];
        on.along = facet.along(rim);
      }
    }
    found.push_back(on);
  }
  return found;
}

/// A search without the contacts of a pill or a cylinder that have opened: it may leave an edge and come back
/// to it elsewhere, which is a new touch. Valid until the next call.
TouchSearch without_opened(Workspace& work, const Moving3& c, const Ground3& ground, FindGapToGround<3>* gap,
                           const TouchSearch& search) {
  work.still_held.clear();
  const Placed3 start{c.shape, {c.motion.x, c.motion.turn(0).rotation}};
  for (const HeldContact& h : search.held)
    if (contactor_of(h.feature) != c.index ||
        gap(work, start, h.feature, ground, h.against, h.normal) <= opened_share * search.size)
      work.still_held.push_back(h);
  TouchSearch closed = search;
  closed.held = work.still_held;
  return closed;
}

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

std::optional<double> touch_of_facets(Workspace& work, const Moving3& core, const Ground3& ground,
                                      double t_max, const TouchSearch& search, CoreSearch by) {
  const auto& held = held_on(work, ground, search.held);
  return touch_of_facets(work, core, ground, t_max, search,
                         [&](const Facet& facet, const TimeWindow& window) {
                           return core_touch_of_facet(work, core, facet, held, by, window, search);
                         });
}

}  // namespace

std::optional<double> ball_core_touch_of_ground(Workspace& work, const Moving3& ball, const Ground3& ground,
                                                double t_max, const TouchSearch& search) {
  return touch_of_facets(work, ball, ground, t_max, search, CoreSearch::ball);
}

std::optional<double> pill_touch_of_ground(Workspace& work, const Moving3& pill, const Ground3& ground,
                                           double t_max, const TouchSearch& search) {
  const TouchSearch closed = without_opened(work, pill, ground, core_gap_to_ground, search);
  return touch_of_facets(work, pill, ground, t_max, closed, CoreSearch::pill);
}

std::optional<double> hull_touch_of_ground(Workspace& work, const Moving3& hull, const Ground3& ground,
                                           double t_max, const TouchSearch& search) {
  return touch_of_facets(work, hull, ground, t_max, search, CoreSearch::hull);
}

std::optional<double> smooth_touch_of_ground(Workspace& work, const Moving3& shape, const Ground3& ground,
                                             double t_max, const TouchSearch& search) {
  const TouchSearch closed = without_opened(work, shape, ground, smooth_gap_to_ground, search);
  const auto& held = held_on(work, ground, closed.held);
  return touch_of_facets(work, shape, ground, t_max, closed,
                         [&](const Facet& facet, const TimeWindow& window) {
                           return smooth_touch_of_facet(work, shape, facet, held, window, closed);
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
