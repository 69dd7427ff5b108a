#pragma once
// The ground of a 3D run, with the names of its parts as laws use them.

#include <memory>
#include <string>
#include <vector>

#include "geometry/facet.h"
#include "geometry/terrain_shape.h"

namespace flyrock {

class Ground3;

/// Copies share the ground, which does not change.
class Terrain3 {
 public:
  explicit Terrain3(TerrainShape3 shape);

  const Ground3& ground() const { return *ground_; }
  operator const Ground3&() const { return *ground_; }  ///< as Terrain2 is a Ground2
  const std::vector<std::string>& parts() const;
  /// The name of each part, as laws use it.
  const std::vector<std::string>& names() const { return names_; }
  /// The bench faces, the uppermost first.
  const std::vector<Mesh::Face>& faces() const { return faces_; }
  /// About how much memory it takes.
  std::size_t bytes() const { return bytes_; }
  /// The part that a contact's `against` names. An edge belongs to the facet that names it.
  int part(FeatureId against) const;

 private:
  std::size_t bytes_;
  std::vector<Mesh::Face> faces_;
  std::shared_ptr<const Ground3> ground_;
  std::vector<std::string> names_;
};

}  // namespace flyrock
