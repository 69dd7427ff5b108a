#include "report/exports/export_obj.h"

#include <fmt/format.h>

#include <map>

#include "files/safe_file.h"
#include "record/block_row.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

/// A face of a block: its block and its corners.
struct StoredFace {
  std::int64_t block = 0;
  std::vector<std::int64_t> vertices;
};

struct StoredBlocks {
  std::vector<Vec3> vertices;
  std::vector<StoredFace> faces;  ///< in the order of the blocks
};

StoredBlocks read_blocks(const SqliteReader& database, std::int64_t point) {
  StoredBlocks blocks;
  Query row(database,
            fmt::format("SELECT block, face, vertex, x_m, y_m, z_m FROM block_corners WHERE point = {} AND "
                        "trial = 0 ORDER BY rowid",
                        point));
  std::int64_t block = -1, face = -1;
  while (row.next()) {
    if (row.whole(0) != block || row.whole(1) != face) {
      block = row.whole(0);
      face = row.whole(1);
      blocks.faces.push_back({block, {}});
    }
    const auto vertex = static_cast<std::size_t>(row.whole(2));
    blocks.faces.back().vertices.push_back(row.whole(2));
    if (vertex >= blocks.vertices.size()) blocks.vertices.resize(vertex + 1);
    blocks.vertices[vertex] = Vec3(row.real(3), row.real(4), row.real(5));
  }
  return blocks;
}

/// The modes of the blocks of trial 0, by their number.
std::map<std::int64_t, std::string> modes_of(const SqliteReader& database, std::int64_t point) {
  std::map<std::int64_t, std::string> modes;
  Query row(database, fmt::format("SELECT block, mode FROM blocks WHERE point = {} AND trial = 0", point));
  while (row.next()) modes[row.whole(0)] = row.text(1);
  return modes;
}

std::string obj_of(const StoredBlocks& blocks, std::map<std::int64_t, std::string> modes) {
  std::string text = "# Blocks between joints, of trial 0; a group for each block.\n";
  for (const Vec3& p : blocks.vertices) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  std::int64_t block = -1;
  for (const StoredFace& face : blocks.faces) {
    if (face.block != block) text += fmt::format("g block_{} {}\n", face.block, modes[face.block]);
    block = face.block;
    text += 'f';
    for (const std::int64_t vertex : face.vertices) text += fmt::format(" {}", vertex + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

VtkPoints stored_blocks(const SqliteReader& database, std::int64_t point) {
  const StoredBlocks blocks = read_blocks(database, point);
  VtkPoints data;
  data.points = blocks.vertices;
  std::vector<VtkArray> arrays = {{"block", {}}, {"rock", {}},   {"removable", {}},
                                  {"mode", {}},  {"factor", {}}, {"volume_m3", {}}};
  std::map<std::int64_t, std::array<double, 6>> numbers;
  Query row(database,
            fmt::format("SELECT block, rock, removable, mode, factor, volume_m3 FROM blocks WHERE point = {} "
                        "AND trial = 0",
                        point));
  while (row.next()) {
    double mode = 0;
    while (mode < 4 && row.text(3) != name_of(static_cast<BlockMode>(static_cast<int>(mode)))) ++mode;
    numbers[row.whole(0)] = {
        row.real(0), row.real(1), row.real(2), mode, row.type(4) == SQLITE_NULL ? -1 : row.real(4),
        row.real(5)};
  }
  for (const StoredFace& face : blocks.faces) {
    data.corners.insert(data.corners.end(), face.vertices.begin(), face.vertices.end());
    data.polygon_ends.push_back(data.corners.size());
    for (std::size_t i = 0; i < arrays.size(); ++i) arrays[i].values.push_back(numbers[face.block][i]);
  }
  data.of_cells = std::move(arrays);
  return data;
}

std::vector<fs::path> export_obj(const fs::path& results, const fs::path& folder) {
  const SqliteReader database(results);
  std::vector<fs::path> files;
  Query points(database, "SELECT DISTINCT point FROM block_corners WHERE trial = 0 ORDER BY point");
  while (points.next()) {
    const std::int64_t point = points.whole(0);
    if (files.empty()) make_folder(folder);
    files.push_back(folder / fmt::format("blocks-p{}.obj", point));
    write_file(files.back(), obj_of(read_blocks(database, point), modes_of(database, point)));
  }
  return files;
}

}  // namespace flyrock
