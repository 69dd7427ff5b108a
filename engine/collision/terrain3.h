#pragma once
// The ground of a 3D run, prepared for contact search.

#include "collision/contact.h"
#include "geometry/plane.h"
#include "geometry/terrain_names.h"

namespace flyrock {

class Terrain3 {
 public:
  explicit Terrain3(Plane plane) : plane_(std::move(plane)), names_(terrain_names(plane_.parts)) {}

  const Plane& plane() const { return plane_; }
  const std::vector<std::string>& parts() const { return plane_.parts; }
  /// The name of each part, as laws use it.
  const std::vector<std::string>& names() const { return names_; }
  /// The part that a contact's `against` names.
  int part(std::uint32_t against) const { return index_of(against); }
  double height(double x, double y) const { return plane_.height(x, y); }

 private:
  Plane plane_;
  std::vector<std::string> names_;
};

}  // namespace flyrock
