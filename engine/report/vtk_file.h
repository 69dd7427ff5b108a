#pragma once
// Polylines, polygons and points as an XML file of VTK (.vtp), which ParaView opens. Source: VTK File
// Formats, "PolyData" (Kitware, VTK User's Guide).

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Numbers for the points or cells, one each.
struct VtkArray {
  std::string name;
  std::vector<double> values;
};

struct VtkPoints {
  std::vector<Vec3> points;  ///< m
  /// For each polyline, the index after its last point. If empty, there are no lines and every point is a
  /// cell.
  std::vector<std::size_t> line_ends;
  /// Polygons, in place of lines: the points of all, one polygon after the other, and for each the index
  /// after its last one.
  std::vector<std::int64_t> corners;
  std::vector<std::size_t> polygon_ends;
  std::vector<VtkArray> of_points, of_cells;
};

/// Throws FileError.
void write_vtp(const std::filesystem::path& path, const VtkPoints& data);

/// One file of a time series, as listed in the index file (.pvd).
struct VtkMoment {
  double time;  ///< s
  std::string file;
};
/// Throws FileError.
void write_pvd(const std::filesystem::path& path, const std::vector<VtkMoment>& series);

}  // namespace flyrock
