#pragma once
// Curves as a self-contained SVG picture.

#include <string>
#include <vector>

namespace flyrock {

struct Curve {
  std::string name;
  std::vector<double> x, y;                 ///< same length, finite
  bool dashed = false;                      ///< a curve that coincides with it shows through the gaps
  std::vector<double> low = {}, high = {};  ///< of a pale band about it, or nothing; NaN where it has none
};

/// One pair of axes.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
};

/// The plots next to each other under a heading, with round ticks, and a legend if there are several curves.
std::string svg_of(const std::string& heading, const std::vector<Plot>& plots);

}  // namespace flyrock
