#pragma once
// What a terrain plugin answers in 3D.

#include <variant>

#include "geometry/height_grid.h"
#include "geometry/mesh.h"
#include "geometry/plane.h"

namespace flyrock {

using TerrainShape3 = std::variant<Plane, Mesh, HeightGrid>;

/// The names of its parts.
inline const std::vector<std::string>& parts_of(const TerrainShape3& shape) {
  return std::visit([](const auto& s) -> const std::vector<std::string>& { return s.parts; }, shape);
}

}  // namespace flyrock
