// OBJ through tinyobjloader, which splits statements, resolves the forms of corners (v, v/vt, v//vn, v/vt/vn)
// and passes what it reads to callbacks. It neither counts lines nor refuses text that is no number (it reads
// 0), so each line passes a check on its way to it.

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <streambuf>

#include "geometry/mesh_edges.h"
#include "plugin/params.h"
#include "plugin/words.h"
#include "plugins/terrain/mesh/mesh_file.h"

namespace flyrock::plugins {

namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r";
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

/// Hands the lines of a file on, one at a time, each after a check. A line that ends with a backslash goes on
/// in the next.
class CheckedLines : public std::streambuf {
 public:
  CheckedLines(const std::string& plugin, const std::string& path)
      : plugin_(plugin), path_(path), file_(path) {
    if (!file_) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
  }

  /// The line that was handed on last, from 1.
  int line() const { return line_; }

  /// The place of the last line `v`. tinyobjloader rounds each digit, to some 1e-14 of a number.
  const Vec3& vertex() const { return vertex_; }
  const WrittenDigits& digits() const { return digits_; }

  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("plugin {}: {}:{}: {}", plugin_, path_, line_, text));
  }

  [[noreturn]] void fail_in_file(const std::string& text) const {
    throw PluginError(fmt::format("plugin {}: {}: {}", plugin_, path_, text));
  }

 protected:
  int_type underflow() override {
    if (!std::getline(file_, text_)) return traits_type::eof();
    ++lines_read_;
    line_ = lines_read_;
    if (line_ == 1 && is_utf16(text_)) fail(save_as_utf8);
    // The byte order mark begins the file, and each file that was joined to it.
    while (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
    std::string more;
    while (text_.ends_with('\\') || text_.ends_with("\\\r")) {
      text_.resize(text_.rfind('\\'));
      if (!std::getline(file_, more)) break;
      ++lines_read_;
      text_ += ' ' + more;
    }
    text_.resize(std::min(text_.find('#'), text_.size()));
    constexpr std::string_view ends("\0\x1A", 2);  // the second ends texts of DOS
    text_.resize(std::min(text_.find_first_of(ends), text_.size()));
    check();
    text_ += '\n';
    setg(text_.data(), text_.data(), text_.data() + text_.size());
    return traits_type::to_int_type(text_[0]);
  }

 private:
  void check() {
    const std::vector<std::string_view> words = words_of(text_);
    if (words.empty()) return;
    check_statement(words[0]);
    if (words[0] == "v") check_vertex(words);
    if (words[0] == "f") check_face(words);
  }

  /// A vertex that is not taken for one shifts all faces, so a word that looks like `v` must not be passed
  /// over.
  void check_statement(std::string_view word) const {
    for (const char c : word)
      if (c <= ' ' || c > '~')
        fail(
            fmt::format("the line begins with `{}`, in which a letter is none of ASCII: write `v`, `f` and "
                        "blanks",
                        word));
    if (word == "V" || word == "F")
      fail(fmt::format("`{}` is no statement of OBJ, expected `{}`", word, word == "V" ? "v" : "f"));
  }

  void check_vertex(const std::vector<std::string_view>& words) {
    if (words.size() < 4) fail(fmt::format("a vertex has {} numbers, expected x, y and z", words.size() - 1));
    double number = 0;
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (!to_number(words[i], number)) fail(fmt::format("`{}` is not a number", words[i]));
      if (i > 3) continue;
      vertex_[static_cast<int>(i) - 1] = number;
      digits_.add(static_cast<int>(i) - 1, words[i]);
    }
    ++vertices_;
  }

  void check_face(const std::vector<std::string_view>& words) {
    if (words.size() < 4)
      fail(fmt::format("a face has {} corners, expected at least three", words.size() - 1));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string_view index = words[i].substr(0, words[i].find('/'));
      int number = 0;
      const auto [stop, error] = std::from_chars(index.data(), index.data() + index.size(), number);
      if (error != std::errc() || stop != index.data() + index.size())
        fail(fmt::format("`{}` is not a corner, expected the number of a vertex", words[i]));
      if (number == 0 || std::abs(number) > vertices_)
        fail(fmt::format("the face names the vertex {}, there are {} above it", number, vertices_));
    }
  }

  std::string plugin_, path_, text_;
  std::ifstream file_;
  int lines_read_ = 0, line_ = 0;
  int vertices_ = 0;
  Vec3 vertex_ = Vec3::Zero();
  WrittenDigits digits_;
};

/// What the callbacks fill.
struct Reading {
  /// The names of one kind, and the name of each triangle.
  struct Names {
    std::string now = {};
    std::vector<std::string> all = {};
    std::vector<int> of_triangle = {};

    void add_triangles(int count) {
      const auto found = std::find(all.begin(), all.end(), now);
      const auto index = static_cast<int>(found - all.begin());
      if (found == all.end()) all.push_back(now);
      of_triangle.insert(of_triangle.end(), static_cast<std::size_t>(count), index);
    }
    bool has_any() const { return all.size() > 1 || (all.size() == 1 && !all[0].empty()); }
  };

  CheckedLines& text;
  MeshFile& file;
  Names groups = {}, materials = {};

  void take_parts(PartsOf parts) {
    if (parts == PartsOf::materials && !materials.has_any())
      text.fail_in_file("has no line `usemtl`, which `parts: materials` asks for");
    const bool by_material = parts == PartsOf::materials || (parts == PartsOf::either && !groups.has_any());
    if (!by_material && parts == PartsOf::either && groups.all.size() == 1 && materials.all.size() > 1)
      file.notes.push_back(fmt::format(
          "all faces are of the group `{}`; `parts: materials` makes parts of its {} materials ({})",
          groups.all[0], materials.all.size(), fmt::join(materials.all, ", ")));
    Names& names = by_material ? materials : groups;
    file.mesh.parts = std::move(names.all);
    file.mesh.part = std::move(names.of_triangle);
  }

  void add_face(const tinyobj::index_t* corners, int count) {
    const int vertices = static_cast<int>(file.mesh.vertices.size());
    std::vector<int> face;
    for (int i = 0; i < count; ++i) {
      const int index = corners[i].vertex_index;  // from 1; negative: from the last
      face.push_back(index > 0 ? index - 1 : vertices + index);
    }
    if (const std::string wrong = add_fan(file, face, text.line()); !wrong.empty()) text.fail(wrong);
    groups.add_triangles(count - 2);
    materials.add_triangles(count - 2);
  }
};

Reading& of(void* user) { return *static_cast<Reading*>(user); }

}  // namespace

MeshFile read_obj(const std::string& plugin, const std::string& path, PartsOf parts) {
  MeshFile file;
  CheckedLines text(plugin, path);
  Reading reading{text, file};
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = [](void* user, double, double, double, double) {
    of(user).file.mesh.vertices.push_back(of(user).text.vertex());
  };
  callbacks.index_cb = [](void* user, tinyobj::index_t* corners, int count) {
    of(user).add_face(corners, count);
  };
  callbacks.group_cb = [](void* user, const char** names, int count) {
    std::string name;  // programs write names with blanks: `g pit floor`
    for (int i = 0; i < count; ++i) name += fmt::format("{}{}", i == 0 ? "" : " ", names[i]);
    of(user).groups.now = part_name(name);
  };
  callbacks.object_cb = [](void* user, const char* name) {
    of(user).groups.now = part_name(name ? name : "");
  };
  callbacks.usemtl_cb = [](void* user, const char* name, int) {
    of(user).materials.now = part_name(name ? name : "");
  };
  std::istream stream(&text);
  stream.exceptions(std::ios::badbit);  // lets an error of a line through
  std::string error;
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &reading, nullptr, nullptr, &error) || !error.empty())
    text.fail(error.empty() ? "is no OBJ file" : error);
  if (file.mesh.triangles.empty()) text.fail_in_file("has no faces, expected lines that begin with `f`");
  judge_digits(plugin, path, text.digits(), file);
  reading.take_parts(parts);
  file.mesh = welded(std::move(file.mesh));
  return file;
}

}  // namespace flyrock::plugins
