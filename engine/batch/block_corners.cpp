#include "batch/block_corners.h"

#include <array>
#include <cmath>
#include <map>

#include "batch/rock_surface.h"

namespace flyrock {

namespace {

/// Numbers places. Two places are one if they are closer than a micrometre along each axis; the corner of two
/// blocks differs by rounding only.
class Vertices {
 public:
  int at(const Vec3& place) {
    constexpr double cell = 1e-6;  // m
    const Vec3 scaled = place / cell;
    for (int side = 0; side < 8; ++side) {
      std::array<std::int64_t, 3> key{};
      for (int k = 0; k < 3; ++k)
        key[static_cast<std::size_t>(k)] =
            std::llround(side >> k & 1 ? std::ceil(scaled[k]) : std::floor(scaled[k]));
      if (const auto found = known_.find(key); found != known_.end()) return found->second;
    }
    const int next = static_cast<int>(known_.size());
    known_[{std::llround(scaled[0]), std::llround(scaled[1]), std::llround(scaled[2])}] = next;
    return next;
  }

 private:
  std::map<std::array<std::int64_t, 3>, int> known_;
};

}  // namespace

template <int D>
std::vector<BlockCorner> block_corners(const Trial<D>& trial) {
  std::vector<BlockCorner> corners;
  Vertices vertices;
  for (std::size_t i = 0; i < trial.block_bodies.size(); ++i) {
    const World<D>& world = trial.worlds.front();
    const Body<D>& body = world.bodies[static_cast<std::size_t>(trial.block_bodies[i])];
    for (const SurfaceCorner& corner : surface_of(body.contactors)) {
      BlockCorner& row = corners.emplace_back();
      row.block = static_cast<int>(i);
      row.face = corner.face;
      row.place.template head<D>() = body.pose() * Vec<D>(corner.place.template head<D>()) + world.origin;
      row.vertex = vertices.at(row.place);
    }
  }
  return corners;
}

template std::vector<BlockCorner> block_corners(const Trial<2>&);
template std::vector<BlockCorner> block_corners(const Trial<3>&);

}  // namespace flyrock
