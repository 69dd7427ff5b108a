#include "collision/ground/terrain_3d.h"

#include <utility>

#include "geometry/ground.h"
#include "geometry/terrain_names.h"

namespace flyrock {

namespace {

std::vector<Mesh::Face> faces_of(const TerrainShape3& shape) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  return mesh ? mesh->faces : std::vector<Mesh::Face>();
}

/// A mesh with its tree and its tables of neighbours takes some 300 bytes a triangle, a grid its heights.
std::size_t bytes_of(const TerrainShape3& shape) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return 300 * mesh->triangles.size();
  if (const HeightGrid* grid = std::get_if<HeightGrid>(&shape))
    return grid->heights.size() * sizeof(double) + grid->part.size();
  return sizeof(Plane);
}

}  // namespace

Terrain3::Terrain3(TerrainShape3 shape)
    : bytes_(bytes_of(shape)),
      faces_(faces_of(shape)),
      ground_(make_ground(std::move(shape))),
      names_(terrain_names(ground_->parts())) {}

const std::vector<std::string>& Terrain3::parts() const { return ground_->parts(); }

int Terrain3::part(FeatureId against) const { return ground_->part(ground_->facet_of(against)); }

}  // namespace flyrock
