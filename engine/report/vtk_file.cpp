#include "report/vtk_file.h"

#include <fmt/format.h>

#include "batch/safe_file.h"
#include "document/value.h"

namespace flyrock {

namespace {

class VtpWriter {
 public:
  explicit VtpWriter(const std::filesystem::path& path) : file_(path, Sync::no) {}

  void write(const VtkPoints& data) {
    const bool lines = !data.line_ends.empty();
    file_.write(
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\">\n<PolyData>\n"
                    "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                    data.points.size(), lines ? 0 : data.points.size(), data.line_ends.size()));
    arrays("PointData", data.of_points);
    arrays("CellData", data.of_cells);
    file_.write("<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n");
    for (const Vec3& p : data.points)
      file_.write(fmt::format("{} {} {}\n", shortest(p.x()), shortest(p.y()), shortest(p.z())));
    file_.write("</DataArray>\n</Points>\n");
    cells(lines ? "Lines" : "Verts", data);
    file_.write("</Piece>\n</PolyData>\n</VTKFile>\n");
    file_.commit();
  }

 private:
  void arrays(const char* section, const std::vector<VtkArray>& list) {
    file_.write(fmt::format("<{}>\n", section));
    for (const VtkArray& array : list) {
      file_.write(fmt::format("<DataArray type=\"Float64\" Name=\"{}\" format=\"ascii\">\n", array.name));
      for (const double value : array.values) file_.write(shortest(value) + '\n');
      file_.write("</DataArray>\n");
    }
    file_.write(fmt::format("</{}>\n", section));
  }

  void cells(const char* section, const VtkPoints& data) {
    file_.write(
        fmt::format("<{}>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n", section));
    for (std::size_t i = 0; i < data.points.size(); ++i) file_.write(fmt::format("{}\n", i));
    file_.write("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
    for (const std::size_t end : data.line_ends) file_.write(fmt::format("{}\n", end));
    for (std::size_t i = 0; data.line_ends.empty() && i < data.points.size(); ++i)
      file_.write(fmt::format("{}\n", i + 1));
    file_.write(fmt::format("</DataArray>\n</{}>\n", section));
  }

  FileWriter file_;
};

}  // namespace

void write_vtp(const std::filesystem::path& path, const VtkPoints& data) { VtpWriter(path).write(data); }

void write_pvd(const std::filesystem::path& path, const std::vector<VtkMoment>& series) {
  FileWriter file(path);
  file.write(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n");
  for (const auto& [time, name] : series)
    file.write(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", shortest(time), name));
  file.write("</Collection>\n</VTKFile>\n");
  file.commit();
}

}  // namespace flyrock
