#pragma once
// The result of decoding a scenario file: one typed scenario for each point of its sweep.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "document/value.h"
#include "scenario/scenario.h"

namespace flyrock {

/// One axis of a sweep: numbers, or choices with their texts.
struct SweepAxis {
  std::string path;
  std::vector<double> values;            ///< in SI; for a choice its index
  std::string name = {};                 ///< the path with names: "barriers.fence.height"
  std::string unit = {};                 ///< SI: "m", "rad", "1"; of choices empty
  std::vector<std::string> labels = {};  ///< of choices: the text, or the `type` of a section; unique
  bool is_named = false;                 ///< of a row with a label, which names the point in its place

  bool is_choice() const { return !labels.empty(); }
  /// The text of a choice.
  const std::string& label(double value) const { return labels[static_cast<std::size_t>(value)]; }
};

/// The path of the axis whose values are the labels of the rows of a sweep.
inline constexpr const char* label_axis = "sweep.label";

/// The result of decoding a scenario file.
struct Plan {
  std::vector<SweepAxis> axes;               ///< sorted by path; the last varies fastest
  std::vector<Scenario> points;              ///< one point if nothing is swept
  std::vector<std::vector<double>> at;       ///< the values of the axes at each point
  Value resolved;                            ///< in schema order, with defaults, in SI units, sweeps kept
  std::vector<std::string> not_used;         ///< "blast.spacing (bench_fit does not read it)"
  std::vector<std::string> plugin_files;     ///< `plugins:` as written
  std::map<std::string, std::string> files;  ///< that parameters name: name as written -> full path

  /// The methods of the points, each once.
  std::vector<Method> methods() const {
    std::vector<Method> list;
    for (const Scenario& point : points)
      if (std::find(list.begin(), list.end(), point.method) == list.end()) list.push_back(point.method);
    return list;
  }
  /// Whether all paths end at their first landing. Texts then speak of this landing where they otherwise say
  /// runout; keys of files and measures keep their names.
  bool all_end_at_landing() const { return methods() == std::vector{Method::ballistic}; }
};

}  // namespace flyrock
