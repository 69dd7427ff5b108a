#pragma once
// The ground of a 3D run, with the names of its parts as laws use them.

#include <memory>

#include "collision/contact.h"
#include "geometry/ground.h"
#include "geometry/terrain_names.h"

namespace flyrock {

/// Copies share the ground, which does not change.
class Terrain3 {
 public:
  explicit Terrain3(TerrainShape3 shape)
      : bytes_(bytes_of(shape)),
        faces_(faces_of(shape)),
        ground_(make_ground(std::move(shape))),
        names_(terrain_names(ground_->parts())) {}

  const Ground3& ground() const { return *ground_; }
  operator const Ground3&() const { return *ground_; }  ///< as Terrain2 is a Ground2
  const std::vector<std::string>& parts() const { return ground_->parts(); }
  /// The name of each part, as laws use it.
  const std::vector<std::string>& names() const { return names_; }
  /// The bench faces, the uppermost first.
  const std::vector<Mesh::Face>& faces() const { return faces_; }
  /// About how much memory it takes.
  std::size_t bytes() const { return bytes_; }
  /// The part that a contact's `against` names. An edge belongs to the facet that names it.
  int part(FeatureId against) const { return ground_->part(ground_->facet_of(against)); }

 private:
  static std::vector<Mesh::Face> faces_of(const TerrainShape3& shape) {
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    return mesh ? mesh->faces : std::vector<Mesh::Face>();
  }

  /// A mesh with its tree and its tables of neighbours takes some 300 bytes a triangle, a grid its heights.
  static std::size_t bytes_of(const TerrainShape3& shape) {
    if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return 300 * mesh->triangles.size();
    if (const HeightGrid* grid = std::get_if<HeightGrid>(&shape))
      return grid->heights.size() * sizeof(double) + grid->part.size();
    return sizeof(Plane);
  }

  std::size_t bytes_;
  std::vector<Mesh::Face> faces_;
  std::shared_ptr<const Ground3> ground_;
  std::vector<std::string> names_;
};

}  // namespace flyrock
