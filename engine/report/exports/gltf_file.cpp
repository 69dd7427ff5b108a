#include "report/exports/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "files/safe_file.h"

namespace flyrock {

namespace {

// Numbers of the specification.
constexpr int component_float = 5126, component_uint32 = 5125;
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int mode_lines = 1, mode_triangles = 4;
constexpr std::uint32_t gltf_magic = 0x46546C67, gltf_version = 2;  // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

std::vector<float> floats_of(const std::vector<Vec3>& places) {
  std::vector<float> numbers;
  numbers.reserve(3 * places.size());
  for (const Vec3& place : places)
    for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(place[k]));
  return numbers;
}

/// x, y, z, w. Of q and -q, which are the same turn, that which is nearer to the one before it.
std::vector<float> floats_of(const std::vector<Eigen::Quaterniond>& turns) {
  std::vector<float> numbers;
  Eigen::Vector4d before = turns.front().coeffs();
  for (const Eigen::Quaterniond& turn : turns) {
    Eigen::Vector4d now = turn.normalized().coeffs();
    if (now.dot(before) < 0) now = -now;
    for (int k = 0; k < 4; ++k) numbers.push_back(static_cast<float>(now[k]));
    before = now;
  }
  return numbers;
}

/// The moments whose times still rise as numbers of 32 bits; of several with one time the last.
GltfMotion with_rising_times(const GltfMotion& motion) {
  GltfMotion rising;
  for (std::size_t i = 0; i < motion.times.size(); ++i) {
    const bool is_last = i + 1 == motion.times.size();
    if (!is_last && static_cast<float>(motion.times[i + 1]) <= static_cast<float>(motion.times[i])) continue;
    rising.times.push_back(motion.times[i]);
    rising.places.push_back(motion.places[i]);
    rising.turns.push_back(motion.turns[i]);
  }
  return rising;
}

void append(std::string& text, std::uint32_t number) {
  for (int k = 0; k < 4; ++k) text += static_cast<char>(number >> (8 * k) & 0xFF);
}

/// A chunk: its length, its kind and its bytes, filled up to a multiple of four.
void append_chunk(std::string& file, std::uint32_t kind, std::string bytes, char filler) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filler);
  append(file, static_cast<std::uint32_t>(bytes.size()));
  append(file, kind);
  file += bytes;
}

}  // namespace

GltfFile::GltfFile(char up)
    : json_({{"asset", {{"version", "2.0"}, {"generator", "flyrock"}}},
             {"scene", 0},
             {"scenes", Json::array({{{"nodes", {0}}}})}}) {
  Json root = {{"name", "scene"}};
  const double half = std::sqrt(0.5);
  if (up == 'z') root["rotation"] = {-half, 0, 0, half};  // a quarter turn about x: (x, y, z) to (x, z, -y)
  json_["nodes"] = Json::array({root});
}

int GltfFile::add_material(const std::string& name, const Vec3& colour) {
  Json& materials = json_["materials"];
  materials.push_back({{"name", name},
                       {"pbrMetallicRoughness",
                        {{"baseColorFactor", {colour.x(), colour.y(), colour.z(), 1}},
                         {"metallicFactor", 0},
                         {"roughnessFactor", 1}}},
                       {"doubleSided", true}});
  return static_cast<int>(materials.size()) - 1;
}

int GltfFile::add_triangles(const std::string& name, const std::vector<Vec3>& points,
                            const std::vector<std::uint32_t>& corners, int material) {
  return add_mesh(name, points, corners, material, mode_triangles);
}

int GltfFile::add_lines(const std::string& name, const std::vector<Vec3>& points,
                        const std::vector<std::uint32_t>& corners, int material) {
  return add_mesh(name, points, corners, material, mode_lines);
}

int GltfFile::add_mesh(const std::string& name, const std::vector<Vec3>& points,
                       const std::vector<std::uint32_t>& corners, int material, int mode) {
  const int places = add_floats(floats_of(points), "VEC3", 3, Use::places);
  const int view = add_view(corners.data(), corners.size() * sizeof(std::uint32_t), Use::corners);
  json_["accessors"].push_back({{"bufferView", view},
                                {"componentType", component_uint32},
                                {"count", corners.size()},
                                {"type", "SCALAR"}});
  Json& meshes = json_["meshes"];
  meshes.push_back({{"name", name},
                    {"primitives", Json::array({{{"attributes", {{"POSITION", places}}},
                                                 {"indices", places + 1},
                                                 {"material", material},
                                                 {"mode", mode}}})}});
  return static_cast<int>(meshes.size()) - 1;
}

void GltfFile::add_node(const std::string& name, int mesh, const GltfMotion& motion, Json extras) {
  Json& nodes = json_["nodes"];
  const auto node = static_cast<int>(nodes.size());
  const std::vector<float> place = floats_of({motion.places.front()}),
                           turn = floats_of({motion.turns.front()});
  nodes.push_back({{"name", name}, {"mesh", mesh}, {"translation", place}, {"rotation", turn}});
  if (!extras.empty()) nodes.back()["extras"] = std::move(extras);
  nodes[0]["children"].push_back(node);
  const GltfMotion keys = with_rising_times(motion);
  if (keys.times.size() < 2) return;
  const int input = add_floats({keys.times.begin(), keys.times.end()}, "SCALAR", 1, Use::keys);
  add_channel(node, "translation", input, add_floats(floats_of(keys.places), "VEC3", 3, Use::keys));
  add_channel(node, "rotation", input, add_floats(floats_of(keys.turns), "VEC4", 4, Use::keys));
}

void GltfFile::write(const std::filesystem::path& path, Json extras) const {
  Json json = json_;
  json["extras"] = std::move(extras);
  json["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  std::string chunks, file;
  append_chunk(chunks, json_chunk, json.dump(), ' ');
  append_chunk(chunks, binary_chunk, bytes_, '\0');
  append(file, gltf_magic);
  append(file, gltf_version);
  append(file, static_cast<std::uint32_t>(12 + chunks.size()));
  write_file(path, file + chunks);
}

int GltfFile::add_view(const void* bytes, std::size_t size, Use use) {
  Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
  if (use != Use::keys) view["target"] = use == Use::places ? array_buffer : element_array_buffer;
  bytes_.append(static_cast<const char*>(bytes), size);
  Json& views = json_["bufferViews"];
  views.push_back(std::move(view));
  return static_cast<int>(views.size()) - 1;
}

/// With the least and the greatest number of each component, which places of meshes and times must have.
int GltfFile::add_floats(const std::vector<float>& numbers, const char* type, int components, Use use) {
  std::vector<float> least(numbers.begin(), numbers.begin() + components), greatest = least;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t k = i % static_cast<std::size_t>(components);
    least[k] = std::min(least[k], numbers[i]);
    greatest[k] = std::max(greatest[k], numbers[i]);
  }
  const int view = add_view(numbers.data(), numbers.size() * sizeof(float), use);
  Json& accessors = json_["accessors"];
  accessors.push_back({{"bufferView", view},
                       {"componentType", component_float},
                       {"count", numbers.size() / static_cast<std::size_t>(components)},
                       {"type", type},
                       {"min", least},
                       {"max", greatest}});
  return static_cast<int>(accessors.size()) - 1;
}

void GltfFile::add_channel(int node, const char* path, int input, int output) {
  if (!json_.contains("animations"))
    json_["animations"] =
        Json::array({{{"name", "motion"}, {"channels", Json::array()}, {"samplers", Json::array()}}});
  Json& motion = json_["animations"][0];
  motion["channels"].push_back(
      {{"sampler", motion["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  motion["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
}

}  // namespace flyrock
