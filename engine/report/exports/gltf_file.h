#pragma once
// A scene with moving bodies as a binary glTF 2.0 file (.glb), which viewers of 3D models open. Source:
// Khronos Group, glTF 2.0 Specification (2021), sections 3.6 (buffers), 3.7 (geometry), 3.11
// (animations), 4.4 (GLB).

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A body's places and attitudes at rising times, linear between them (turns at a constant rate).
struct GltfMotion {
  std::vector<double> times;  ///< s
  std::vector<Vec3> places;   ///< m
  std::vector<Eigen::Quaterniond> turns;
};

/// Numbers of 32 bits, as glTF has them: places must be near 0.
class GltfFile {
 public:
  using Json = nlohmann::ordered_json;

  /// `up`: which axis of the places points up, 'y' as in glTF or 'z'; the node above all others turns it to
  /// y.
  explicit GltfFile(char up);

  /// A surface colour, red, green and blue from 0 to 1. Returns its number, as the functions below.
  int add_material(const std::string& name, const Vec3& colour);
  /// `corners`: three a triangle, counter-clockwise as seen from outside, or two a line.
  int add_triangles(const std::string& name, const std::vector<Vec3>& points,
                    const std::vector<std::uint32_t>& corners, int material);
  int add_lines(const std::string& name, const std::vector<Vec3>& points,
                const std::vector<std::uint32_t>& corners, int material);
  /// A mesh at the first place of a motion; with several moments it moves. `extras`: data of the user.
  void add_node(const std::string& name, int mesh, const GltfMotion& motion, Json extras);

  /// `extras`: of the whole file. Throws FileError.
  void write(const std::filesystem::path& path, Json extras) const;

 private:
  int add_mesh(const std::string& name, const std::vector<Vec3>& points,
               const std::vector<std::uint32_t>& corners, int material, int mode);
  enum class Use { places, corners, keys };

  int add_view(const void* bytes, std::size_t size, Use use);
  int add_floats(const std::vector<float>& numbers, const char* type, int components, Use use);
  void add_channel(int node, const char* path, int input, int output);

  Json json_;
  std::string bytes_;
};

}  // namespace flyrock
