#pragma once
// Polylines, polygons and points as an XML file of VTK (.vtp), which ParaView opens. Source: VTK File
// Formats, "PolyData" (Kitware, VTK User's Guide).

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Numbers for the points or cells, one each, or three each of vectors.
struct VtkArray {
  std::string name;
  std::vector<double> values;
  int components = 1;
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

/// The coordinate system `crs` ("EPSG:2056"; empty: not known) becomes field data of that name. Throws
/// FileError.
void write_vtp(const std::filesystem::path& path, const VtkPoints& data, const std::string& crs);

/// Triangles and tetrahedra as an unstructured grid (.vtu): the polygons of `data` are cells of three or four
/// points. Throws FileError.
void write_vtu(const std::filesystem::path& path, const VtkPoints& data, const std::string& crs);

/// An index (.pvd) of files at given times [s], each named from its folder. Throws FileError.
void write_pvd(const std::filesystem::path& index,
               const std::vector<std::pair<double, std::filesystem::path>>& files);

inline constexpr double most_vtk_steps = 500;  ///< of a time series

/// A time series: an index (.pvd) and, in a folder of its name beside it, one file for each step of a round
/// number of seconds from 0 to `end` [s], about `steps` of them. frame(time) gives the data of a step. Throws
/// FileError.
void write_vtp_series(const std::filesystem::path& index, double end, double steps, const std::string& crs,
                      const std::function<VtkPoints(double time)>& frame);

}  // namespace flyrock
