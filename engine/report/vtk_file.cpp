#include "report/vtk_file.h"

#include <fmt/format.h>

#include <cmath>

#include "batch/safe_file.h"
#include "document/value.h"
#include "math/round_step.h"

namespace flyrock {

namespace {

/// The cells of a file, which are all of one kind.
struct Cells {
  std::string_view kind;                   ///< the element of the file: Verts, Lines, Polys
  std::vector<std::int64_t> connectivity;  ///< the points of all cells, one after the other
  std::vector<std::int64_t> ends;          ///< of each cell, the index after its last one

  std::size_t are(std::string_view asked) const { return asked == kind ? ends.size() : 0; }
};

Cells cells_of(const VtkPoints& data) {
  if (!data.polygon_ends.empty())
    return {"Polys", data.corners, {data.polygon_ends.begin(), data.polygon_ends.end()}};
  Cells cells{data.line_ends.empty() ? "Verts" : "Lines", {}, {data.line_ends.begin(), data.line_ends.end()}};
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    cells.connectivity.push_back(static_cast<std::int64_t>(i));
    if (data.line_ends.empty()) cells.ends.push_back(static_cast<std::int64_t>(i) + 1);
  }
  return cells;
}

class VtpWriter {
 public:
  explicit VtpWriter(const std::filesystem::path& path) : file_(path, Sync::no) {}

  void write(const VtkPoints& data, const std::string& crs) {
    const Cells cells = cells_of(data);
    file_.write(fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\">\n<PolyData>\n{}"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
        field_data(crs), data.points.size(), cells.are("Verts"), cells.are("Lines"), cells.are("Polys")));
    arrays("PointData", data.of_points);
    arrays("CellData", data.of_cells);
    file_.write("<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n");
    for (const Vec3& p : data.points)
      file_.write(fmt::format("{} {} {}\n", shortest(p.x()), shortest(p.y()), shortest(p.z())));
    file_.write("</DataArray>\n</Points>\n");
    write(cells);
    file_.write("</Piece>\n</PolyData>\n</VTKFile>\n");
    file_.commit();
  }

 private:
  /// Text of VTK: the codes of its characters, then 0.
  static std::string field_data(const std::string& crs) {
    if (crs.empty()) return "";
    std::string codes;
    for (const char c : crs) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    return fmt::format(
        "<FieldData>\n<Array type=\"String\" Name=\"crs\" NumberOfTuples=\"1\" format=\"ascii\">\n{}0\n"
        "</Array>\n</FieldData>\n",
        codes);
  }

  void arrays(const char* section, const std::vector<VtkArray>& list) {
    file_.write(fmt::format("<{}>\n", section));
    for (const VtkArray& array : list) {
      file_.write(
          fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                      array.name, array.components));
      for (const double value : array.values) file_.write(shortest(value) + '\n');
      file_.write("</DataArray>\n");
    }
    file_.write(fmt::format("</{}>\n", section));
  }

  void write(const Cells& cells) {
    file_.write(
        fmt::format("<{}>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n", cells.kind));
    for (const std::int64_t point : cells.connectivity) file_.write(fmt::format("{}\n", point));
    file_.write("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
    for (const std::int64_t end : cells.ends) file_.write(fmt::format("{}\n", end));
    file_.write(fmt::format("</DataArray>\n</{}>\n", cells.kind));
  }

  FileWriter file_;
};

}  // namespace

void write_vtp(const std::filesystem::path& path, const VtkPoints& data, const std::string& crs) {
  VtpWriter(path).write(data, crs);
}

void write_vtp_series(const std::filesystem::path& index, double end, double steps, const std::string& crs,
                      const std::function<VtkPoints(double time)>& frame) {
  const double step = round_step(end / steps);
  const auto last = static_cast<int>(std::ceil(end / step));
  const std::filesystem::path folder = index.parent_path() / index.stem();
  make_folder(folder);
  std::string series;
  for (int i = 0; i <= last; ++i) {
    const std::string name = fmt::format("{:04}.vtp", i);
    write_vtp(folder / name, frame(step * i), crs);
    series += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", shortest(step * i),
                          (index.stem() / name).generic_string());
  }
  FileWriter file(index);
  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n");
  file.write(series);
  file.write("</Collection>\n</VTKFile>\n");
  file.commit();
}

}  // namespace flyrock
