#include "trial/part_overlap.h"

#include "collision/broad_phase.h"
#include "collision/pairs.h"

namespace flyrock {

namespace {

constexpr double least_share = 1e-6;

}  // namespace

template <int D>
std::optional<PartOverlap> deepest_overlap_of_parts(const Body<D>& body) {
  if (body.contactors.size() < 2) return std::nullopt;
  const typename Geometry<D>::Pose own_frame;
  std::vector<Box<D>> boxes;
  for (const auto& contactor : body.contactors)
    boxes.push_back(core_box(Placed<D>{contactor, own_frame}).grown(contactor.radius));
  Contacts<D> points;
  Workspace work;
  PartOverlap deepest;
  SortAndSweep sweep;
  for (const auto& [a, b] : sweep.pairs<D>(boxes)) {
    points.clear();
    body_contacts(work, Placed<D>{body.contactors[a], own_frame, a},
                  Placed<D>{body.contactors[b], own_frame, b}, 0, points);
    for (const ContactPoint<D>& point : points)
      if (-point.gap > deepest.depth)
        deepest = {static_cast<std::size_t>(a), static_cast<std::size_t>(b), -point.gap};
  }
  if (deepest.depth <= least_share * body.size) return std::nullopt;
  return deepest;
}

template std::optional<PartOverlap> deepest_overlap_of_parts(const Body<2>&);
template std::optional<PartOverlap> deepest_overlap_of_parts(const Body<3>&);

}  // namespace flyrock
