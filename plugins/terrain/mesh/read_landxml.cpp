// LandXML: <Surfaces> of one or more <Surface>, each with a <Definition surfType="TIN"> of points
// <P id="1">northing easting height</P> and faces <F>1 2 3</F> of three ids. A face with i="1" is hidden: the
// program that wrote it cut it away.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <unordered_map>

#include "document/printable.h"
#include "geometry/mesh_edges.h"
#include "plugin/params.h"
#include "plugin/words.h"
#include "plugins/terrain/mesh/mesh_file.h"

namespace flyrock::plugins {

namespace {

struct LandXmlUnit {
  std::string_view name;
  double metres;
};
constexpr LandXmlUnit landxml_units[] = {
    {"millimeter", 0.001}, {"centimeter", 0.01},           {"meter", 1},     {"kilometer", 1000},
    {"foot", 0.3048},      {"USSurveyFoot", 1200. / 3937}, {"inch", 0.0254}, {"mile", 1609.344},
};

class LandXmlFile {
 public:
  LandXmlFile(const std::string& plugin, const std::string& path) : plugin_(plugin), path_(path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (is_utf16(bytes_)) fail(save_as_utf8);
    const pugi::xml_parse_result result = document_.load_buffer(bytes_.data(), bytes_.size());
    if (!result)
      fail_at(result.offset,
              "is no complete XML: the file was cut or edited, expected `<LandXML>` ... `</LandXML>`");
    for (std::size_t at = bytes_.find('\n'); at != bytes_.npos; at = bytes_.find('\n', at + 1))
      line_ends_.push_back(static_cast<std::ptrdiff_t>(at));
  }

  MeshFile read(const std::string& surface) {
    const pugi::xml_node root = document_.document_element();
    if (std::string_view(root.name()) != "LandXML")
      fail_at(root, fmt::format("the first element is {}, expected `LandXML`", quoted(root.name())));
    read_unit(root);
    if (const std::string code = root.child("CoordinateSystem").attribute("epsgCode").value();
        !code.empty() && code.size() <= 6 && code.find_first_not_of("0123456789") == code.npos)
      file_.crs = "EPSG:" + code;
    read_surface(chosen(root, surface));
    file_.mesh.parts = {""};
    file_.mesh.part.assign(file_.mesh.triangles.size(), 0);
    file_.mesh = welded(std::move(file_.mesh));
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("plugin {}: {}: {}", plugin_, path_, text));
  }
  [[noreturn]] void fail_at(std::ptrdiff_t offset, const std::string& text) const {
    const std::ptrdiff_t end =
        std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(bytes_.size()));
    const auto line = 1 + std::count(bytes_.begin(), bytes_.begin() + end, '\n');
    throw PluginError(fmt::format("plugin {}: {}:{}: {}", plugin_, path_, line, text));
  }
  [[noreturn]] void fail_at(pugi::xml_node node, const std::string& text) const {
    fail_at(node.offset_debug(), text);
  }
  static std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    return fmt::format("`{}`", printable(text, longest));
  }

  int line_of(pugi::xml_node node) const {
    const auto after = std::upper_bound(line_ends_.begin(), line_ends_.end(), node.offset_debug());
    return 1 + static_cast<int>(after - line_ends_.begin());
  }

  void read_unit(pugi::xml_node root) {
    const pugi::xml_node units = root.child("Units");
    if (!units) return;
    const pugi::xml_node system = units.child("Metric") ? units.child("Metric") : units.child("Imperial");
    const std::string_view name = system.attribute("linearUnit").value();
    for (const LandXmlUnit& unit : landxml_units)
      if (name == unit.name) file_.unit = unit.metres;
    if (file_.unit == 0)
      fail_at(units,
              fmt::format("linearUnit is {}, expected meter, foot, USSurveyFoot or another unit of LandXML",
                          quoted(name)));
    if (file_.unit != 1)
      file_.notes.push_back(fmt::format(
          "its coordinates are in {} ({:.10g} m) and were made metres, so the places of the scenario are in "
          "metres too",
          name, file_.unit));
  }

  /// The surface of a name; without a name the only one.
  pugi::xml_node chosen(pugi::xml_node root, const std::string& name) const {
    std::vector<pugi::xml_node> all;
    std::string names;
    for (const pugi::xml_node surfaces : root.children("Surfaces"))
      for (const pugi::xml_node surface : surfaces.children("Surface")) {
        constexpr std::size_t most = 10;
        if (all.size() < most)
          names += fmt::format("{}{}", all.empty() ? "" : ", ", quoted(surface.attribute("name").value()));
        all.push_back(surface);
      }
    if (all.empty()) fail("has no `Surface`, expected a TIN in `Surfaces`");
    if (name.empty() && all.size() == 1) return all[0];
    if (name.empty())
      fail(fmt::format("has {} surfaces, {}: write `surface: {}` for the one that is the ground", all.size(),
                       names, printable(all[0].attribute("name").value(), 60)));
    pugi::xml_node found;
    for (const pugi::xml_node surface : all) {
      if (name != surface.attribute("name").value()) continue;
      if (found) fail_at(surface, fmt::format("is the second surface of the name {}", quoted(name)));
      found = surface;
    }
    if (!found) fail(fmt::format("has no surface {}, it has {}", quoted(name), names));
    return found;
  }

  void read_surface(pugi::xml_node surface) {
    const pugi::xml_node definition = surface.child("Definition");
    const std::string_view type = definition.attribute("surfType").value();
    if (type != "TIN")
      fail_at(surface, fmt::format("the surface is of the type {}, expected `TIN`: triangles with points",
                                   quoted(type)));
    for (const pugi::xml_node points : definition.children("Pnts"))
      for (const pugi::xml_node point : points.children("P")) read_point(point);
    for (const pugi::xml_node faces : definition.children("Faces"))
      for (const pugi::xml_node face : faces.children("F"))
        if (std::string_view(face.attribute("i").value()) != "1") read_face(face);
    if (file_.mesh.triangles.empty()) fail_at(surface, "the surface has no faces");
  }

  /// The three words of an element.
  std::array<std::string_view, 3> three_words(pugi::xml_node node, const char* expected) const {
    std::array<std::string_view, 3> words;
    const std::string_view text = node.child_value();
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t count = 0;
    for (std::size_t begin = text.find_first_not_of(blanks); begin != text.npos; ++count) {
      const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
      if (count < 3) words[count] = text.substr(begin, end - begin);
      begin = text.find_first_not_of(blanks, end);
    }
    if (count != 3)
      fail_at(node, fmt::format("`{}` has {} numbers, expected three: {}", node.name(), count, expected));
    return words;
  }

  void read_point(pugi::xml_node node) {
    const auto words = three_words(node, "northing, easting, height");
    Vec3 place;
    for (int k = 0; k < 3; ++k)
      if (!to_number(words[k], place[k])) fail_at(node, fmt::format("{} is not a number", quoted(words[k])));
    const std::string id = node.attribute("id").value();
    if (!vertex_of_.emplace(id, static_cast<int>(file_.mesh.vertices.size())).second)
      fail_at(node, fmt::format("is the second point with the id {}", quoted(id)));
    const double unit = file_.unit == 0 ? 1 : file_.unit;
    file_.mesh.vertices.push_back(unit * Vec3(place[1], place[0], place[2]));
  }

  /// A TIN has one height at a place, so its triangles look up, whatever the order of their corners.
  void read_face(pugi::xml_node node) {
    std::array<int, 3> corners;
    const auto words = three_words(node, "the ids of its points");
    for (int k = 0; k < 3; ++k) {
      const auto found = vertex_of_.find(std::string(words[k]));
      if (found == vertex_of_.end())
        fail_at(node, fmt::format("the surface has no point {}", quoted(words[k])));
      corners[k] = found->second;
    }
    const auto& vertices = file_.mesh.vertices;
    const Vec3 a = vertices[corners[0]], b = vertices[corners[1]], c = vertices[corners[2]];
    if ((b - a).cross(c - a).z() < 0) std::swap(corners[1], corners[2]);
    file_.mesh.triangles.push_back(corners);
    file_.lines.push_back(line_of(node));
  }

  std::string plugin_, path_, bytes_;
  pugi::xml_document document_;
  std::vector<std::ptrdiff_t> line_ends_;
  std::unordered_map<std::string, int> vertex_of_;  ///< by id
  MeshFile file_;
};

}  // namespace

MeshFile read_landxml(const std::string& plugin, const std::string& path, const std::string& surface) {
  return LandXmlFile(plugin, path).read(surface);
}

}  // namespace flyrock::plugins
