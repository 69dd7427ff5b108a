#include "plugins/terrain/mesh/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "plugin/params.h"
#include "survey/file_form.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

/// All triangles of the fan of a convex face look to the same side.
bool is_convex_face(const std::vector<Vec3>& vertices, const std::vector<int>& face) {
  const int count = static_cast<int>(face.size());
  const auto corner = [&](int i) -> const Vec3& { return vertices[face[i % count]]; };
  Vec3 mean = Vec3::Zero();
  for (int i = 1; i + 1 < count; ++i) mean += (corner(i) - corner(0)).cross(corner(i + 1) - corner(0));
  const double least = -1e-9 * mean.squaredNorm();  // corners on one line are fine, with their rounding
  for (int i = 0; i < count; ++i)
    if ((corner(i + 1) - corner(i)).cross(corner(i + 2) - corner(i + 1)).dot(mean) < least) return false;
  return true;
}

/// What to do with a file of another format.
std::string way_to_obj(const std::string& path) {
  if (ending_of(path) == ".dxf")
    return "is a drawing of CAD: export its 3D faces as OBJ, with three decimals or more; only a terrain "
           "reads "
           "them as DXF";
  const std::string other = other_form(path, "mesh");
  return other.empty()
             ? "expected a file whose name ends in .obj, .ply or .stl; of a terrain also .xml (LandXML) "
               "or .dxf"
             : other;
}

}  // namespace

std::string part_name(std::string name) {
  name.resize(name.find_last_not_of(" \t\r") + 1);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  return name;
}

std::string add_fan(MeshFile& file, const std::vector<int>& face, int line) {
  const std::size_t count = face.size();
  if (count < 3) return fmt::format("the face has {} corners, expected three or more", count);
  if (count > 3 && !is_convex_face(file.mesh.vertices, face))
    return fmt::format("the face of {} corners is not convex, expected triangles", count);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    file.mesh.triangles.push_back({face[0], face[i], face[i + 1]});
    if (line > 0) file.lines.push_back(line);
  }
  return {};
}

void note_single_precision(MeshFile& file) {
  constexpr double of_surveys = 0.01;  // a survey is not coarser than 1 cm
  double farthest = 0;
  for (const Vec3& vertex : file.mesh.vertices) farthest = std::max(farthest, vertex.cwiseAbs().maxCoeff());
  const auto near = static_cast<float>(farthest);
  const double step = std::nextafter(near, std::numeric_limits<float>::infinity()) - near;
  if (step < of_surveys) return;
  file.notes.push_back(fmt::format(
      "its coordinates are numbers of single precision, {:g} apart near {:.7g}: export PLY with doubles, "
      "OBJ with three decimals, or local coordinates",
      step, near));
}

void judge_digits(const std::string& plugin, const std::string& path, const WrittenDigits& digits,
                  MeshFile& file) {
  if (const std::string wrong = digits.fault(); !wrong.empty())
    throw PluginError(fmt::format("plugin {}: {}: {}", plugin, path, wrong));
  if (std::string note = digits.note(); !note.empty()) file.notes.push_back(std::move(note));
}

MeshFile read_mesh(const std::string& plugin, const std::string& path, PartsOf parts) {
  const std::string ending = ending_of(path);
  if (ending == ".obj") return read_obj(plugin, path, parts);
  if (ending == ".ply") return read_ply(plugin, path);
  if (ending == ".stl") return read_stl(plugin, path);
  throw PluginError(fmt::format("plugin {}: {}: {}", plugin, path, way_to_obj(path)));
}

}  // namespace flyrock::plugins
