#pragma once
// Drawings as a DXF file: text, AutoCAD release 12 (AC1009), which every CAD program reads.

#include <span>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Points and polylines on named layers. Names of layers have capital letters, digits and `_` only.
class DxfFile {
 public:
  void add_point(const std::string& layer, const Vec3& place);
  /// A polyline in 3D; a closed one goes on from its last place to its first.
  void add_line(const std::string& layer, std::span<const Vec3> places, bool is_closed = false);

  bool empty() const { return layers_.empty(); }
  /// The file, whose layers have different colours in the order of their first use.
  std::string text() const;

 private:
  void begin(const char* entity, const std::string& layer);
  void add_place(const Vec3& place);

  std::vector<std::string> layers_;
  std::string entities_;
  Eigen::AlignedBox3d extent_;
};

}  // namespace flyrock
