// STL: text ("facet normal ... outer loop, vertex x y z three times, endloop endfacet") or binary (a header
// of 80 bytes, the number of triangles, 50 bytes each: normal and corners in single precision). The normals
// are not read, because the order of the corners says the same.

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "geometry/mesh_edges.h"
#include "plugin/params.h"
#include "plugin/words.h"
#include "plugins/terrain/mesh/mesh_file.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

constexpr std::size_t header = 80, record = 50;

static_assert(std::endian::native == std::endian::little);

/// Whether the start of a file is text that begins with `solid`, in any letters. A text has no byte 0; a
/// binary file of fewer than 16 million triangles has one in their number.
bool is_text(std::string_view start) {
  if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);  // byte order mark
  start.remove_prefix(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  return lower(start.substr(0, 5)) == "solid" && start.find('\0') == start.npos;
}

/// The number of triangles of a binary file; nothing if the file is text. What follows the last triangle is
/// not read, which a note says.
std::int64_t binary_triangles(const std::string& plugin, const std::string& path, MeshFile& mesh) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
  std::array<char, header + 4> start{};
  file.read(start.data(), start.size());
  const std::string_view read(start.data(), static_cast<std::size_t>(file.gcount()));
  std::uint32_t count = 0;
  std::memcpy(&count, start.data() + header, sizeof count);
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path));
  const std::int64_t expected = header + 4 + static_cast<std::int64_t>(record) * count;
  if (file && size == expected) return count;
  if (is_text(read)) return -1;
  if (file && size > expected && count > 0) {
    mesh.notes.push_back(fmt::format("{} bytes follow the {} triangles that the file announces: not read",
                                     size - expected, count));
    return count;
  }
  throw PluginError(
      fmt::format("plugin {}: {}: is neither STL as text (its first word is not `solid`) nor binary: {} "
                  "triangles need {} bytes, the file has {}",
                  plugin, path, count, expected, size));
}

void add_triangle(MeshFile& file, const std::array<Vec3, 3>& corners) {
  const int first = static_cast<int>(file.mesh.vertices.size());
  file.mesh.vertices.insert(file.mesh.vertices.end(), corners.begin(), corners.end());
  file.mesh.triangles.push_back({first, first + 1, first + 2});
  file.mesh.part.push_back(0);
}

void read_binary(const std::string& plugin, const std::string& path, std::int64_t count, MeshFile& mesh) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(header + 4);
  std::array<char, record> bytes{};
  for (std::int64_t i = 0; i < count; ++i) {
    if (!file.read(bytes.data(), bytes.size()))
      throw PluginError(fmt::format("plugin {}: {}: ends at triangle {} of {}", plugin, path, i + 1, count));
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), bytes.data(), sizeof numbers);
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = Vec3(numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]);
      if (!corners[k].allFinite())
        throw PluginError(fmt::format("plugin {}: {}: a corner of triangle {} of {} is not finite", plugin,
                                      path, i + 1, count));
    }
    add_triangle(mesh, corners);
  }
  note_single_precision(mesh);
}

void expect(Words& words, std::string_view expected) {
  const std::string found(words.next());
  if (lower(found) == expected) return;
  words.fail(found.empty() ? fmt::format("the file ends, expected `{}`", expected)
                           : fmt::format("expected `{}`, found `{}`", expected, found));
}

void read_facet(Words& words, WrittenDigits& digits, MeshFile& mesh) {
  mesh.lines.push_back(static_cast<int>(words.line()));
  expect(words, "normal");
  for (int i = 0; i < 3; ++i) words.next();  // some programs write `nan` for a facet without an area
  expect(words, "outer");
  expect(words, "loop");
  std::array<Vec3, 3> corners;
  for (Vec3& corner : corners) {
    expect(words, "vertex");
    for (int k = 0; k < 3; ++k) {
      digits.add(k, words.peek());
      corner[k] = words.number("a coordinate");
    }
  }
  expect(words, "endloop");
  expect(words, "endfacet");
  add_triangle(mesh, corners);
}

/// One or several solids; a name may follow `solid` and `endsolid`, on the same line.
void read_text(const std::string& plugin, const std::string& path, MeshFile& mesh) {
  Words words("plugin " + plugin, path);
  WrittenDigits digits;
  expect(words, "solid");
  const auto skip_name = [&words] {
    const std::int64_t line = words.line();
    while (!words.peek().empty() && words.line() == line) words.next();
  };
  skip_name();
  while (true) {
    const std::string word = lower(words.next());
    if (word == "facet") {
      read_facet(words, digits, mesh);
    } else if (word == "endsolid") {
      skip_name();
      if (words.peek().empty()) return judge_digits(plugin, path, digits, mesh);
      expect(words, "solid");
      skip_name();
    } else {
      words.fail(word.empty() ? "the file ends, expected `endsolid`"
                              : fmt::format("expected `facet` or `endsolid`, found `{}`", word));
    }
  }
}

}  // namespace

MeshFile read_stl(const std::string& plugin, const std::string& path) {
  MeshFile file;
  file.mesh.parts = {""};
  const std::int64_t triangles = binary_triangles(plugin, path, file);
  if (triangles >= 0)
    read_binary(plugin, path, triangles, file);
  else
    read_text(plugin, path, file);
  if (file.mesh.triangles.empty())
    throw PluginError(fmt::format("plugin {}: {}: has no triangles", plugin, path));
  file.mesh = welded(std::move(file.mesh));
  return file;
}

}  // namespace flyrock::plugins
