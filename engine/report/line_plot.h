#pragma once
// Curves as a picture in SVG that needs nothing else.

#include <string>
#include <vector>

namespace flyrock {

struct Curve {
  std::string name;
  std::vector<double> x, y;  ///< equally many, finite
};

/// One pair of axes.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
};

/// The plots side by side, with a heading; round ticks, a legend where there are several curves.
std::string svg_of(const std::string& heading, const std::vector<Plot>& plots);

}  // namespace flyrock
