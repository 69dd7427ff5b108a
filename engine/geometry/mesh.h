#pragma once
// A terrain in 3D given as triangles.

#include <array>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A surface of triangles. The ground lies behind it: seen from outside, the corners of a triangle follow
/// each other counter-clockwise. Overhangs and vertical faces are allowed.
struct Mesh {
  std::vector<Vec3> vertices;                 ///< m
  std::vector<std::array<int, 3>> triangles;  ///< indices into `vertices`
  std::vector<int> part;                      ///< of each triangle: index into `parts`
  std::vector<std::string> parts;             ///< names of the parts, as in `materials: { part: NAME }`
  /// A bench face: its toe and its crest as lines with equally many points, in the order of the crest.
  struct Face {
    std::string name;
    std::vector<Vec3> toe, crest;
  };
  std::vector<Face> faces;  ///< the uppermost first: `release: { from: face, bench: 1 }`
};

}  // namespace flyrock
