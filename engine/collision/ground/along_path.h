#pragma once
// The facets of the ground that a moving body may meet, piece by piece along its path.

#include <algorithm>
#include <vector>

#include "collision/workspace.h"
#include "geometry/ground.h"

namespace flyrock {

/// How far a ball about a contactor reaches, and a little more: rounding must not exclude a facet that is
/// just touched.
inline double reach_on_path(double bound) { return bound * (1 + 1e-6); }

/// Calls see(facet, window, first) for the facets that a ball of radius r about the moving point may meet
/// within [0, end], the early ones first; see() keeps the first touch in `first`. The path is halved until
/// the box of a piece meets few facets or is as short as the ball is wide, and pieces in empty air are left
/// out at once. The search therefore costs nothing for air, however long and fast the flight is. A window is
/// the part of a piece in which the ball may meet the box of the facet.
template <class See>
std::optional<double> along_path(Workspace& work, const Ground3& ground, const Path<3>& path, double r,
                                 double end, See see) {
  constexpr int few = 8;
  std::vector<Facet>& facets = work.facets;
  std::vector<FacetMeeting>& meetings = work.meetings;
  std::optional<double> first;
  const auto search = [&](const auto& self, double from, double to) -> void {
    if (first && *first <= from) return;
    const Path<3> piece{path.position(from), path.velocity(from), path.a};
    const Box3 box = swept_box(piece, r, to - from);
    const double length = (box.high - box.low).maxCoeff();
    const bool divisible = length > 4 * r && to - from > 1e-9 * end;
    const int met = divisible ? ground.count(box, few + 1) : few;
    if (met == 0) return;
    if (met > few) {
      const double middle = 0.5 * (from + to);
      self(self, from, middle);
      self(self, middle, to);
      return;
    }
    facets.clear();
    ground.facets(box, facets);
    meetings.clear();
    for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
      TimeWindow window{from, first ? std::min(*first, to) : to};
      if (const Facet& facet = facets[i]; !facet.unbounded) {
        const Box3 corners{facet.corner[0].cwiseMin(facet.corner[1]).cwiseMin(facet.corner[2]),
                           facet.corner[0].cwiseMax(facet.corner[1]).cwiseMax(facet.corner[2])};
        const TimeWindow meeting = meeting_window(path, r, corners, window.b);
        window = {std::max(window.a, meeting.a), std::min(window.b, meeting.b)};
      }
      if (!window.empty()) meetings.push_back({window, i});
    }
    std::sort(meetings.begin(), meetings.end(), [](const FacetMeeting& a, const FacetMeeting& b) {
      return a.window.a != b.window.a ? a.window.a < b.window.a : a.facet < b.facet;
    });
    for (const FacetMeeting& meeting : meetings) {
      if (first && *first <= meeting.window.a) break;
      see(facets[meeting.facet],
          TimeWindow{meeting.window.a, first ? std::min(*first, meeting.window.b) : meeting.window.b}, first);
    }
  };
  search(search, 0.0, end);
  return first;
}

}  // namespace flyrock
