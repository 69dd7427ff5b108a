// PLY: a head of text that names elements, their number and their properties (numbers of a type, or lists of
// numbers), then the rows of the elements in that order, as text with a row a line, or binary.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "document/printable.h"
#include "geometry/mesh_edges.h"
#include "plugin/params.h"
#include "plugin/words.h"
#include "plugins/terrain/mesh/mesh_file.h"

namespace flyrock::plugins {

namespace {

struct PlyType {
  std::string_view name, other_name;
  int size;  ///< bytes
  double (*decode)(const char*);
};

template <class Number>
double decode_ply_number(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

constexpr std::array<PlyType, 8> ply_types = {{
    {"char", "int8", 1, decode_ply_number<std::int8_t>},
    {"uchar", "uint8", 1, decode_ply_number<std::uint8_t>},
    {"short", "int16", 2, decode_ply_number<std::int16_t>},
    {"ushort", "uint16", 2, decode_ply_number<std::uint16_t>},
    {"int", "int32", 4, decode_ply_number<std::int32_t>},
    {"uint", "uint32", 4, decode_ply_number<std::uint32_t>},
    {"float", "float32", 4, decode_ply_number<float>},
    {"double", "float64", 8, decode_ply_number<double>},
}};

struct PlyProperty {
  std::string name;
  const PlyType* type = nullptr;
  const PlyType* count_type = nullptr;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties = {};
};

static_assert(std::endian::native == std::endian::little);

/// The head and the rows of one file, from its first byte to its last.
class PlyFile {
 public:
  PlyFile(const std::string& plugin, const std::string& path) : plugin_(plugin), path_(path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (is_utf16(bytes_)) fail(save_as_utf8);
    if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
  }

  MeshFile read() {
    read_head();
    read_vertices_and_faces();
    refuse_rest();
    if (is_single_precision_) note_single_precision(file_);
    judge_digits(plugin_, path_, digits_, file_);
    file_.mesh.parts = {""};
    file_.mesh.part.assign(file_.mesh.triangles.size(), 0);
    file_.mesh = welded(std::move(file_.mesh));
    return std::move(file_);
  }

 private:
  enum class Format { text, little_endian, big_endian };

  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("plugin {}: {}: {}", plugin_, path_, text));
  }
  /// An error at the line of the head or of a text that was read last.
  [[noreturn]] void fail_at_line(const std::string& text) const {
    throw PluginError(fmt::format("plugin {}: {}:{}: {}", plugin_, path_, line_, text));
  }
  /// An error in the present row.
  [[noreturn]] void fail_in_row(const std::string& text) const {
    if (format_ == Format::text && row_ > 0) fail_at_line(text);
    fail(fmt::format("{} {} of {}: {}", quoted(element_->name), row_, element_->count, text));
  }
  static std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    return fmt::format("`{}`", printable(std::string(word.substr(0, longest))));
  }

  bool is_at_end() const { return at_ >= bytes_.size(); }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Reads the words of the next line.
  void next_line() {
    const std::string_view rest = std::string_view(bytes_).substr(at_);
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    ++line_;
    at_ += std::min(end + 1, rest.size());
    words_.clear();
    next_word_ = 0;
    constexpr std::string_view blanks = " \t\r";
    const std::string_view line = rest.substr(0, end);
    for (std::size_t begin = line.find_first_not_of(blanks); begin != line.npos;) {
      const std::size_t stop = std::min(line.find_first_of(blanks, begin), line.size());
      words_.push_back(line.substr(begin, stop - begin));
      begin = line.find_first_not_of(blanks, stop);
    }
  }

  // Head.

  void read_head() {
    next_line();
    if (words_.size() != 1 || words_[0] != "ply") fail("is no PLY file: its first line is not `ply`");
    bool has_format = false;
    while (true) {
      if (is_at_end()) fail_at_line("the head ends here without `end_header`");
      next_line();
      if (words_.empty()) continue;
      const std::string_view key = words_[0];
      if (key == "comment" || key == "obj_info") continue;
      if (key == "end_header") break;
      if (key == "format") {
        read_format();
        has_format = true;
      } else if (key == "element") {
        read_element();
      } else if (key == "property") {
        read_property();
      } else {
        fail_at_line(fmt::format(
            "{} is no line of a head of PLY, expected format, element, property, comment or end_header",
            quoted(key)));
      }
    }
    if (!has_format) fail("its head has no line `format`");
  }

  void read_format() {
    const std::string_view name = words_.size() == 3 ? words_[1] : "";
    if (name == "ascii")
      format_ = Format::text;
    else if (name == "binary_little_endian")
      format_ = Format::little_endian;
    else if (name == "binary_big_endian")
      format_ = Format::big_endian;
    else
      fail_at_line("expected `format ascii 1.0`, binary_little_endian or binary_big_endian");
  }

  void read_element() {
    std::int64_t count = -1;
    if (words_.size() == 3) {
      const std::string_view text = words_[2];
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
      if (error != std::errc() || end != text.data() + text.size()) count = -1;
    }
    if (count < 0) fail_at_line("expected `element NAME COUNT` with a whole number of at least 0");
    elements_.push_back({std::string(words_[1]), count});
  }

  const PlyType& type_of(std::string_view name) const {
    for (const PlyType& type : ply_types)
      if (name == type.name || name == type.other_name) return type;
    fail_at_line(
        fmt::format("{} is no type of PLY, expected char, uchar, short, ushort, int, uint, float or double",
                    quoted(name)));
  }

  void read_property() {
    if (elements_.empty()) fail_at_line("a property before the first element");
    const bool is_list = words_.size() > 1 && words_[1] == "list";
    if (words_.size() != (is_list ? 5u : 3u))
      fail_at_line("expected `property TYPE NAME` or `property list TYPE TYPE NAME`");
    PlyProperty property{.name = std::string(words_.back()), .type = &type_of(words_[words_.size() - 2])};
    if (is_list) property.count_type = &type_of(words_[2]);
    elements_.back().properties.push_back(std::move(property));
  }

  // Rows.

  /// A count that the file cannot hold is refused before memory is asked for.
  void require_room(const PlyElement& element) const {
    if (element.count == 0) return;
    if (element.properties.empty()) fail(fmt::format("the element {} has no property", quoted(element.name)));
    std::size_t least = 0;  // bytes of a row; of text a digit and a blank for each number
    for (const PlyProperty& property : element.properties)
      least +=
          format_ == Format::text ? 2 : (property.count_type ? property.count_type : property.type)->size;
    const std::size_t most =
        (bytes_left() + (format_ == Format::text)) / least;  // the last line may have no end
    if (static_cast<std::size_t>(element.count) > most)
      fail(fmt::format("its head announces {} times {}, the {} bytes that follow hold at most {}",
                       element.count, quoted(element.name), bytes_left(), most));
    if (element.count > std::numeric_limits<int>::max())
      fail(fmt::format("{} times {} are too many", element.count, quoted(element.name)));
  }

  void begin_row() {
    ++row_;
    if (format_ != Format::text) return;
    do {
      if (is_at_end())
        fail_at_line(fmt::format("the file ends, expected {} {} of {}", quoted(element_->name), row_,
                                 element_->count));
      next_line();
    } while (words_.empty());
  }

  void end_row() const {
    if (format_ == Format::text && next_word_ < words_.size())
      fail_in_row(fmt::format("{} numbers, expected {}: the properties of {}", words_.size(), next_word_,
                              quoted(element_->name)));
  }

  std::string_view next_word() {
    if (next_word_ == words_.size())
      fail_in_row(
          fmt::format("the line has {} numbers, {} needs more", words_.size(), quoted(element_->name)));
    return words_[next_word_++];
  }

  double number(const PlyType& type) {
    if (format_ == Format::text) {
      const std::string_view word = next_word();
      double value = 0;
      if (!to_number(word, value)) fail_in_row(fmt::format("{} is not a number", quoted(word)));
      return value;
    }
    std::array<char, 8> bytes{};
    const auto size = static_cast<std::size_t>(type.size);
    if (bytes_left() < size) fail_in_row("the file ends here");
    std::memcpy(bytes.data(), bytes_.data() + at_, size);
    if (format_ == Format::big_endian) std::reverse(bytes.begin(), bytes.begin() + size);
    at_ += size;
    return type.decode(bytes.data());
  }

  double coordinate(int axis, const PlyType& type) {
    const double value = number(type);
    if (format_ == Format::text) digits_.add(axis, words_[next_word_ - 1]);
    return value;
  }

  /// A whole number from 0 to below `end`.
  std::int64_t index(const PlyType& type, double end, const char* what) {
    const double value = number(type);
    if (value >= 0 && value < end && value == std::floor(value)) return static_cast<std::int64_t>(value);
    fail_in_row(
        fmt::format("{} is {:.10g}, expected a whole number from 0 to {:.10g}", what, value, end - 1));
  }

  /// The number of entries of a list, which the rest of the file can hold.
  std::int64_t list_length(const PlyProperty& property) {
    const double end = static_cast<double>(bytes_.size()) + 1;
    const std::int64_t length = index(*property.count_type, end, "the length of a list");
    if (format_ != Format::text && static_cast<std::size_t>(length) > bytes_left() / property.type->size)
      fail_in_row(fmt::format("a list of {} numbers, the file ends before", length));
    return length;
  }

  /// Numbers that nobody reads may be NaN.
  void pass_over(const PlyProperty& property) {
    const std::int64_t length = property.count_type ? list_length(property) : 1;
    if (format_ == Format::text)
      for (std::int64_t i = 0; i < length; ++i) next_word();
    else if (bytes_left() < static_cast<std::size_t>(length * property.type->size))
      fail_in_row("the file ends here");
    else
      at_ += static_cast<std::size_t>(length * property.type->size);
  }

  void read_vertices_and_faces() {
    bool has_vertices = false, has_faces = false;
    for (const PlyElement& element : elements_) {
      element_ = &element;
      row_ = 0;
      require_room(element);
      if (element.name == "vertex" && !has_vertices) {
        read_vertices();
        has_vertices = true;
      } else if (element.name == "face" && !has_faces) {
        if (!has_vertices) fail("the element `face` comes before `vertex`: MeshLab writes them in order");
        read_faces();
        has_faces = true;
      } else {
        for (std::int64_t i = 0; i < element.count; ++i) {
          begin_row();
          for (const PlyProperty& property : element.properties) pass_over(property);
          end_row();
        }
      }
    }
    if (!has_vertices) fail("its head has no element `vertex`");
    if (!file_.mesh.triangles.empty()) return;
    const bool has_strips = std::any_of(elements_.begin(), elements_.end(), [](const PlyElement& element) {
      return element.name == "tristrips";
    });
    fail(has_strips ? "has strips of triangles, expected the element `face`: open it in MeshLab and save it"
                    : "has points and no faces: triangulate them (CloudCompare: Edit, Mesh, Delaunay 2.5D), "
                      "or make a "
                      "grid for the terrain `raster` of them");
  }

  void read_vertices() {
    constexpr std::string_view axes = "xyz";
    std::vector<int> axis_of;  // of each property; -1: passed over
    int found = 0;
    for (const PlyProperty& property : element_->properties) {
      const bool is_axis = property.name.size() == 1 && axes.find(property.name[0]) != axes.npos;
      axis_of.push_back(is_axis && !property.count_type ? static_cast<int>(axes.find(property.name[0])) : -1);
      if (axis_of.back() < 0) continue;
      found |= 1 << axis_of.back();
      if (property.type->name == "float" && format_ != Format::text) is_single_precision_ = true;
    }
    if (found != 7) fail("the element `vertex` lacks one of the properties x, y, z");
    file_.mesh.vertices.resize(static_cast<std::size_t>(element_->count));
    for (Vec3& vertex : file_.mesh.vertices) {
      begin_row();
      for (std::size_t i = 0; i < axis_of.size(); ++i)
        if (axis_of[i] < 0)
          pass_over(element_->properties[i]);
        else
          vertex[axis_of[i]] = coordinate(axis_of[i], *element_->properties[i].type);
      end_row();
      if (!vertex.allFinite()) fail_in_row("a coordinate is not finite");
    }
  }

  void read_faces() {
    const auto is_corners = [](const PlyProperty& property) {
      return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    const auto corners = std::find_if(element_->properties.begin(), element_->properties.end(), is_corners);
    if (element_->count > 0 && corners == element_->properties.end())
      fail("the element `face` has no list `vertex_indices`");
    const auto vertices = static_cast<double>(file_.mesh.vertices.size());
    std::vector<int> face;
    for (std::int64_t i = 0; i < element_->count; ++i) {
      begin_row();
      for (auto property = element_->properties.begin(); property != element_->properties.end(); ++property) {
        if (property != corners) {
          pass_over(*property);
          continue;
        }
        face.clear();
        for (std::int64_t left = list_length(*property); left > 0; --left)
          face.push_back(static_cast<int>(index(*property->type, vertices, "a corner")));
      }
      end_row();
      const std::string wrong = add_fan(file_, face, format_ == Format::text ? line_ : 0);
      if (!wrong.empty()) fail_in_row(wrong);
    }
  }

  /// A count that is too small would cut the surface.
  void refuse_rest() {
    const std::size_t more = bytes_.find_first_not_of(std::string_view(" \t\r\n\0\x1A", 6), at_);
    if (more == bytes_.npos) return;
    line_ += 1 + static_cast<int>(std::count(bytes_.begin() + at_, bytes_.begin() + more, '\n'));
    const std::string text = "the file goes on after all that its head announces";
    if (format_ == Format::text) fail_at_line(text);
    fail(fmt::format("{}, by {} bytes", text, bytes_left()));
  }

  std::string plugin_, path_, bytes_;
  std::size_t at_ = 0;
  int line_ = 0;
  Format format_ = Format::text;
  std::vector<PlyElement> elements_;
  std::vector<std::string_view> words_;  ///< of the present line
  std::size_t next_word_ = 0;
  const PlyElement* element_ = nullptr;
  std::int64_t row_ = 0;  ///< of the element, from 1
  bool is_single_precision_ = false;
  WrittenDigits digits_;
  MeshFile file_;
};

}  // namespace

MeshFile read_ply(const std::string& plugin, const std::string& path) { return PlyFile(plugin, path).read(); }

}  // namespace flyrock::plugins
