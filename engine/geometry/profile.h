#pragma once
// The terrain of a 2D run: a polyline with the ground below it.

#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A polyline from left to right. The ground lies on its right-hand side, that is below it. x never
/// decreases, and successive points differ.
struct Profile {
  std::vector<Vec2> points;
  std::vector<int> part;           ///< of each segment (points.size() - 1): index into `parts`
  std::vector<std::string> parts;  ///< names of the parts, as in `materials: { part: NAME }`
  struct Face {
    Vec2 toe;
    Vec2 crest;
    std::string name = {};  ///< empty: bench_1 for the first, and so on
  };
  std::vector<Face> faces;  ///< bench faces, the uppermost first: `release: { from: face, bench: 1 }`

  /// The name of a face: its own, or bench_1, bench_2, ...
  std::string face_name(std::size_t face) const;
  int segments() const { return static_cast<int>(points.size()) - 1; }
  double x_min() const { return points.front().x(); }
  double x_max() const { return points.back().x(); }
  /// The height of the ground at x [m], for x within [x_min, x_max]; the highest one if the profile is
  /// vertical there.
  double height(double x) const;
  /// What is wrong with the points, or an empty text.
  std::string fault() const;
};

}  // namespace flyrock
