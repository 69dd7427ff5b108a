#pragma once
// The terrain of a 2D run: a poly-line with the ground below it.

#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A poly-line from left to right; rock lies to its right hand side, that is below it. x never decreases
/// and two successive points differ.
struct Profile {
  std::vector<Vec2> points;
  std::vector<int> part;           ///< of each segment (points.size() - 1): index into `parts`
  std::vector<std::string> parts;  ///< names of the parts, as in `materials: { part: NAME }`
  struct Face {
    Vec2 toe;
    Vec2 crest;
  };
  std::vector<Face> faces;  ///< bench faces, the uppermost first: `release: { from: face, bench: 1 }`

  int segments() const { return static_cast<int>(points.size()) - 1; }
  double x_min() const { return points.front().x(); }
  double x_max() const { return points.back().x(); }
  /// The height of the ground at x, the highest where the profile is vertical. x within [x_min, x_max].
  double height(double x) const;
  /// What is wrong with the points, or an empty text.
  std::string fault() const;
};

}  // namespace flyrock
