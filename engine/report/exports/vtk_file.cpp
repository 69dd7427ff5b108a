#include "report/exports/vtk_file.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "document/value.h"
#include "files/safe_file.h"
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

class VtkWriter {
 public:
  explicit VtkWriter(const std::filesystem::path& path) : file_(path, Sync::no) {}

  void write_poly_data(const VtkPoints& data, const std::string& crs) {
    const Cells cells = cells_of(data);
    begin("PolyData", crs);
    file_.write(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                    data.points.size(), cells.are("Verts"), cells.are("Lines"), cells.are("Polys")));
    write_points(data);
    write(cells.kind, cells);
    file_.write(fmt::format("</{}>\n", cells.kind));
    end("PolyData");
  }

  /// Cells of three or four points: triangles (type 5 of VTK) and tetrahedra (10).
  void write_grid(const VtkPoints& data, const std::string& crs) {
    const Cells cells = cells_of(data);
    begin("UnstructuredGrid", crs);
    file_.write(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", data.points.size(),
                            cells.ends.size()));
    write_points(data);
    write("Cells", cells);
    file_.write("<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n");
    std::int64_t start = 0;
    for (const std::int64_t end : cells.ends) {
      file_.write(end - start == 3 ? "5\n" : "10\n");
      start = end;
    }
    file_.write("</DataArray>\n</Cells>\n");
    end("UnstructuredGrid");
  }

 private:
  void begin(const char* kind, const std::string& crs) {
    file_.write(
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\">\n<{0}>\n{1}",
                    kind, field_data(crs)));
  }
  void end(const char* kind) {
    file_.write(fmt::format("</Piece>\n</{}>\n</VTKFile>\n", kind));
    file_.commit();
  }

  void write_points(const VtkPoints& data) {
    arrays("PointData", data.of_points);
    arrays("CellData", data.of_cells);
    file_.write("<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n");
    for (const Vec3& p : data.points)
      file_.write(fmt::format("{} {} {}\n", shortest(p.x()), shortest(p.y()), shortest(p.z())));
    file_.write("</DataArray>\n</Points>\n");
  }

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

  /// The arrays of an element `section`, which stays open.
  void write(std::string_view section, const Cells& cells) {
    file_.write(
        fmt::format("<{}>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n", section));
    for (const std::int64_t point : cells.connectivity) file_.write(fmt::format("{}\n", point));
    file_.write("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
    for (const std::int64_t end : cells.ends) file_.write(fmt::format("{}\n", end));
    file_.write("</DataArray>\n");
  }

  FileWriter file_;
};

}  // namespace

void write_vtp(const std::filesystem::path& path, const VtkPoints& data, const std::string& crs) {
  VtkWriter(path).write_poly_data(data, crs);
}

void write_vtu(const std::filesystem::path& path, const VtkPoints& data, const std::string& crs) {
  VtkWriter(path).write_grid(data, crs);
}

void write_pvd(const std::filesystem::path& index,
               const std::vector<std::pair<double, std::filesystem::path>>& files) {
  FileWriter file(index);
  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n");
  for (const auto& [time, name] : files)
    file.write(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", shortest(time),
                           (index.stem() / name).generic_string()));
  file.write("</Collection>\n</VTKFile>\n");
  file.commit();
}

void write_vtp_series(const std::filesystem::path& index, double end, double steps, const std::string& crs,
                      const std::function<VtkPoints(double time)>& frame) {
  const double step = round_step(end / steps);
  const auto last = static_cast<int>(std::ceil(end / step));
  const std::filesystem::path folder = index.parent_path() / index.stem();
  make_folder(folder);
  std::vector<std::pair<double, std::filesystem::path>> files;
  for (int i = 0; i <= last; ++i) {
    files.emplace_back(step * i, fmt::format("{:04}.vtp", i));
    write_vtp(folder / files.back().second, frame(step * i), crs);
  }
  write_pvd(index, files);
}

}  // namespace flyrock
