#pragma once
// Poly-lines and points as an XML file of VTK (.vtp), which ParaView opens.
// Source: VTK File Formats, "PolyData" (Kitware, VTK User's Guide).

#include <filesystem>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A number of each point or cell.
struct VtkArray {
  std::string name;
  std::vector<double> values;
};

struct VtkPoints {
  std::vector<Vec3> points;  ///< m
  /// Behind the last point of each poly-line; no lines where it is empty: every point is then a cell of its
  /// own.
  std::vector<std::size_t> line_ends;
  std::vector<VtkArray> of_points, of_cells;
};

/// Throws FileError.
void write_vtp(const std::filesystem::path& path, const VtkPoints& data);

/// A file of a series over time, as the index (.pvd) names it.
struct VtkMoment {
  double time;  ///< s
  std::string file;
};
/// Throws FileError.
void write_pvd(const std::filesystem::path& path, const std::vector<VtkMoment>& series);

}  // namespace flyrock
