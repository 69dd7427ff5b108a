// Surfaces of triangles as survey and modelling programs export them, as OBJ, PLY and STL.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus.h"
#include "terrain_file.h"

namespace flyrock::fuzz {

namespace {

/// A surface as an exporter has it: faces of three or four corners.
struct MadeMesh {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> faces;

  /// A place inside of a face, by shares of its first three corners.
  Vec3 place(std::size_t face, double u, double v) const {
    const auto& f = faces[face];
    const Vec3 &a = vertices[f[0]], &b = vertices[f[1]], &c = vertices[f[2]];
    return a + u * (b - a) + v * (c - a);
  }
};

class MeshMaker {
 public:
  explicit MeshMaker(Dice& dice) : dice_(dice) {}

  TerrainFile make() {
    is_stl_ = dice_.one_in(3);
    hill_ = make_hill(dice_, !is_stl_ && dice_.one_in(2));
    hill_.base = std::abs(hill_.base);
    if (is_stl_) hill_.base = std::min(hill_.base, 500.0);
    columns_ = 5 + static_cast<int>(dice_.below(6));
    rows_ = 5 + static_cast<int>(dice_.below(6));
    cell_ = rounded_draw(dice_, 0.8, 8, 1);
    make_sheet();
    const std::size_t sheet_faces = mesh_.faces.size();
    add_probes(sheet_faces);
    make_fault();
    if (file_.fault.empty()) add_quirks();
    file_.start = hill_.corner + cell_ * Vec2(0.5 * columns_ + 0.21, 0.5 * rows_ + 0.13);
    if (is_stl_)
      write_stl();
    else
      dice_.one_in(3) ? write_ply() : write_obj();
    return file_;
  }

 private:
  Vec3 vertex(int column, int row) const {
    const Vec2 place = hill_.corner + cell_ * Vec2(column, row);
    return {place.x(), place.y(), std::stod(fmt::format("{:.4f}", hill_.height(place)))};
  }

  /// Cells of two triangles, cut either way, or, in OBJ, of one face of four corners.
  void make_sheet() {
    has_quads_ = !is_stl_ && dice_.one_in(4);
    for (int row = 0; row <= rows_; ++row)
      for (int column = 0; column <= columns_; ++column) mesh_.vertices.push_back(vertex(column, row));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const int a = row * (columns_ + 1) + column, b = a + 1, c = b + columns_ + 1, d = a + columns_ + 1;
        if (has_quads_)
          mesh_.faces.push_back({a, b, c, d});
        else if (dice_.one_in(2))
          mesh_.faces.insert(mesh_.faces.end(), {{a, b, c}, {a, c, d}});
        else
          mesh_.faces.insert(mesh_.faces.end(), {{a, b, d}, {b, c, d}});
      }
  }

  void add_probes(std::size_t faces) {
    for (int i = 0; i < 40; ++i) {
      const double u = draw(dice_, 0.02, 0.95), v = draw(dice_, 0.02, 0.97 - u);
      const std::size_t face = dice_.below(faces);
      const Vec3 place = mesh_.place(face, u, v);
      file_.probes.push_back({place.head<2>(), place.z()});
    }
    file_.tolerance = is_stl_ ? 1e-3 : 5e-4;  // the digits of vertices, on slopes of up to 1
  }

  /// A face inside of the sheet, not at the place where the rock starts.
  std::size_t inner_face() {
    const int per_cell = has_quads_ ? 1 : 2;
    const int column = 1 + static_cast<int>(dice_.below(static_cast<std::size_t>(columns_ / 2 - 1)));
    const int row = 1 + static_cast<int>(dice_.below(static_cast<std::size_t>(rows_ - 2)));
    return static_cast<std::size_t>(per_cell * (row * columns_ + column));
  }

  /// What no reader can settle alone.
  void make_fault() {
    switch (dice_.below(18)) {
      case 0:
        return turn_one();
      case 1:
        return open_hole();
      case 2:
        return part_tiles();
      case 3:
        return add_second_surface();
      case 4:
        return swap_axes();
      default:
        return;
    }
  }

  void turn_one() {
    auto& face = mesh_.faces[inner_face()];
    std::reverse(face.begin(), face.end());
    file_.fault = "face opposite ways";
  }

  void open_hole() {
    const std::size_t gone = inner_face();
    mesh_.faces.erase(mesh_.faces.begin() + static_cast<std::ptrdiff_t>(gone));
    file_.fault = "the mesh has a hole of";
    file_.cure = "repair: { fill_holes: ";
  }

  /// The sheet as two tiles whose borders miss each other by some millimetres.
  void part_tiles() {
    const double gap = is_stl_ ? 0.01 : rounded_draw(dice_, 0.0004, 0.012, 4);
    split_into_tiles(gap);
    file_.fault = "miss each other by";
    file_.cure = "repair: { weld: ";
    file_.tolerance += 2 * gap;
  }

  /// The faces right of a column get vertices of their own, moved to the right.
  void split_into_tiles(double gap) {
    const int cut = 1 + columns_ / 2;
    std::vector<int> twin(mesh_.vertices.size(), -1);
    const int known = static_cast<int>(mesh_.vertices.size());
    for (auto& face : mesh_.faces) {
      const bool is_right = std::all_of(face.begin(), face.end(),
                                        [&](int v) { return v < known && v % (columns_ + 1) >= cut; });
      if (!is_right) continue;
      for (int& v : face) {
        if (twin[v] < 0) {
          twin[v] = static_cast<int>(mesh_.vertices.size());
          mesh_.vertices.push_back(mesh_.vertices[v] + Vec3(gap, 0, 0));
        }
        v = twin[v];
      }
    }
  }

  /// The pit below the topography in one file.
  void add_second_surface() {
    const int known = static_cast<int>(mesh_.vertices.size());
    for (int row = 1; row < rows_; ++row)
      for (int column = 1; column < columns_; ++column)
        mesh_.vertices.push_back(vertex(column, row) - Vec3(0, 0, 3));
    const int wide = columns_ - 1;
    for (int row = 0; row + 2 < rows_; ++row)
      for (int column = 0; column + 2 < columns_; ++column) {
        const int a = known + row * wide + column, b = a + 1, c = b + wide, d = a + wide;
        mesh_.faces.insert(mesh_.faces.end(), {{a, b, c}, {a, c, d}});
      }
    file_.fault = "two surfaces lie over each other";
    file_.cure = "repair: { keep: largest }";
  }

  /// y points up in the file, and the scenario does not say so. In coordinates of a country the heights tell.
  void swap_axes() {
    if (hill_.corner.x() < 1e6) return;
    y_is_up_ = true;
    file_.fault = file_.cure = "up: y";
  }

  /// What readers settle alone.
  void add_quirks() {
    if (dice_.one_in(3)) split_into_tiles(0);
    if (dice_.one_in(4)) add_flat_faces();
    if (dice_.one_in(5)) mesh_.faces.push_back(mesh_.faces[dice_.below(mesh_.faces.size())]);
    if (dice_.one_in(4))
      for (auto& face : mesh_.faces) std::reverse(face.begin(), face.end());
    if (dice_.one_in(5)) {
      y_is_up_ = true;
      file_.terrain = ", up: y";
    }
    if (dice_.one_in(5)) {
      scale_ = one_of(dice_, {"0.3048", "0.001", "1000"});
      file_.terrain += ", scale: " + scale_;
    }
  }

  /// Faces of which two corners are one.
  void add_flat_faces() {
    for (std::size_t n = 1 + dice_.below(4); n > 0; --n) {
      const auto face = mesh_.faces[dice_.below(mesh_.faces.size())];
      mesh_.faces.push_back({face[0], face[1], face[0]});
    }
  }

  /// As the file has it: with its axes and in its unit.
  Vec3 written(const Vec3& place) const {
    const Vec3 turned = y_is_up_ ? Vec3(place.x(), place.z(), -place.y()) : place;
    return scale_.empty() ? turned : Vec3(turned / std::stod(scale_));
  }
  std::string text_of(const Vec3& place) const {
    const Vec3 p = written(place);
    const int digits = scale_ == "1000" ? 7 : 4;
    return fmt::format("{:.{}f} {:.{}f} {:.{}f}", p.x(), digits, p.y(), digits, p.z(), digits);
  }

  void write_obj() {
    const std::string end = one_of(dice_, {"\n", "\n", "\r\n"});
    const std::size_t form = dice_.below(4);  // of corners: v, v/vt, v//vn, v/vt/vn
    const bool is_negative = dice_.one_in(5), is_soup = !is_negative && dice_.one_in(6),
               has_colours = dice_.one_in(5);
    std::string text = one_of(dice_, {"", "", "\xEF\xBB\xBF"});
    text += one_of(dice_, {"", "# exported"}) + end + "mtllib ground.mtl" + end;
    std::vector<Vec3> vertices = mesh_.vertices;
    std::vector<std::vector<int>> faces = mesh_.faces;
    if (is_soup) {
      vertices.clear();
      for (auto& face : faces)
        for (int& v : face) {
          vertices.push_back(mesh_.vertices[v]);
          v = static_cast<int>(vertices.size()) - 1;
        }
    }
    if (dice_.one_in(5)) vertices.emplace_back(0, 0, 0);  // used by no face
    for (const Vec3& v : vertices) text += "v " + text_of(v) + (has_colours ? " 0.5 0.4 0.3" : "") + end;
    if (form != 0) text += "vt 0 0" + end + "vn 0 0 1" + end;
    if (dice_.one_in(5)) text += "l 1 2 3" + end + "p 1" + end;
    const std::string named = one_of(dice_, {"", "g pit floor", "o Terrain.001", "usemtl rock face"});
    if (!named.empty()) text += named + end;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!named.empty() && f == faces.size() / 2) text += named + " 2" + end;
      text += "f";
      for (const int v : faces[f]) {
        const int index = is_negative ? v - static_cast<int>(vertices.size()) : v + 1;
        static constexpr std::array ends = {"", "/1", "//1", "/1/1"};
        text += fmt::format(" {}{}", index, ends[form]);
        if (dice_.one_in(200)) text += " \\" + end;  // goes on in the next line
      }
      text += end;
    }
    write_here("ground.obj", with_last_line(dice_, std::move(text)));
    file_.terrain = "type: mesh, file: ground.obj" + file_.terrain;
  }

  void write_stl() {
    const std::string name = one_of(dice_, {"ground.stl", "GROUND.STL"});
    write_here(name, dice_.one_in(2) ? stl_text() : stl_bytes());
    file_.terrain = fmt::format("type: mesh, file: {}{}", name, file_.terrain);
  }

  /// Text, or doubles in either order of bytes.
  void write_ply() {
    const std::string format = one_of(dice_, {"ascii", "binary_little_endian", "binary_big_endian"});
    const std::string end = one_of(dice_, {"\n", "\n", "\r\n"});
    const bool has_colours = dice_.one_in(3);
    std::string bytes = "ply" + end + "format " + format + " 1.0" + end + "comment exported" + end;
    bytes += fmt::format("element vertex {}{}", mesh_.vertices.size(), end);
    for (const char axis : {'x', 'y', 'z'}) bytes += fmt::format("property double {}{}", axis, end);
    if (has_colours) bytes += "property uchar red" + end;
    bytes += fmt::format("element face {}{}property list uchar int vertex_indices{}end_header{}",
                         mesh_.faces.size(), end, end, end);
    const auto put = [&](auto number) {
      if (format == "ascii") {
        bytes += fmt::format("{} ", number);
        return;
      }
      const auto* raw = reinterpret_cast<const char*>(&number);
      std::string one(raw, sizeof number);
      if (format == "binary_big_endian") std::reverse(one.begin(), one.end());
      bytes += one;
    };
    const auto end_row = [&] {
      if (format == "ascii") bytes += end;
    };
    for (const Vec3& vertex : mesh_.vertices) {
      for (int k = 0; k < 3; ++k) put(written(vertex)[k]);
      if (has_colours) put(static_cast<std::uint8_t>(dice_.below(256)));
      end_row();
    }
    for (const auto& face : mesh_.faces) {
      put(static_cast<std::uint8_t>(face.size()));
      for (const int v : face) put(static_cast<std::int32_t>(v));
      end_row();
    }
    const std::string name = one_of(dice_, {"ground.ply", "GROUND.PLY"});
    write_here(name, bytes);
    file_.terrain = fmt::format("type: mesh, file: {}{}", name, file_.terrain);
  }

  std::string stl_text() {
    const bool is_capital = dice_.one_in(3);
    std::string text = "solid ground\n";
    for (const auto& face : mesh_.faces) {
      text += " facet normal 0 0 0\n  outer loop\n";
      for (const int v : face) text += "   vertex " + text_of(mesh_.vertices[v]) + "\n";
      text += "  endloop\n endfacet\n";
    }
    text += "endsolid ground\n";
    if (is_capital)
      for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return with_last_line(dice_, std::move(text));
  }

  std::string stl_bytes() {
    std::string bytes = one_of(dice_, {"solid ground", "exported by a scanner", ""});
    bytes.resize(80, ' ');
    const auto put = [&](auto number) {
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    };
    put(static_cast<std::uint32_t>(mesh_.faces.size()));
    const bool has_attributes = dice_.one_in(3);
    for (const auto& face : mesh_.faces) {
      for (int k = 0; k < 3; ++k) put(0.0f);
      for (const int v : face)
        for (int k = 0; k < 3; ++k) put(static_cast<float>(written(mesh_.vertices[v])[k]));
      put(static_cast<std::uint16_t>(has_attributes ? 0x7fff : 0));
    }
    if (dice_.one_in(4)) bytes.append(1 + dice_.below(60), '\0');
    return bytes;
  }

  Dice& dice_;
  Hill hill_;
  int columns_ = 0, rows_ = 0;
  double cell_ = 1;
  bool is_stl_ = false, has_quads_ = false, y_is_up_ = false;
  std::string scale_;
  MadeMesh mesh_;
  TerrainFile file_;
};

}  // namespace

TerrainFile make_mesh_file(Dice& dice) { return MeshMaker(dice).make(); }

}  // namespace flyrock::fuzz
