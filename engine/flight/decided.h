#pragma once
// Lines that a rock which left the domain can no longer arrive at.
//
// A rock that left the domain without having arrived at the line of a gate or barrier might come back on
// ground that the terrain does not have. It does not if it left on the far side of the line, seen from its
// start, or if its energy does not lift it to the line: E + m g z < m g h, with its kinetic energy E and
// height z where it left, and the least height h of the ground along the line. Then the rock is decided for
// the line: it never arrives.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "collision/geometry.h"
#include "geometry/plan_line.h"

namespace flyrock {

/// How a rock left the domain, in the coordinates of the engine.
struct Departure {
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< m, in plan: its start, and where it left
  double lift =
      0;  ///< m: the height that it reaches with all its energy, z + E / (m g); infinite without gravity
};

/// The least height of the ground along a line [m]. Nothing if there is no ground below it or no end to it.
std::optional<double> least_height(const PlanLine& line, const Terrain2& terrain);
std::optional<double> least_height(const PlanLine& line, const Terrain3& terrain);

/// The lines of gates or barriers over the ground of a trial.
template <int D>
class DecidedLines {
 public:
  using Terrain = typename Geometry<D>::Terrain;
  static constexpr std::size_t most = 64;  ///< lines; a rock is decided for none of those after them

  /// One bit for each line, from the lowest: 1 if a rock that has not arrived there is decided. `lines` are
  /// the same in every call.
  template <class Place>
  std::uint64_t of(const std::vector<Place>& places, const std::shared_ptr<const Terrain>& terrain,
                   const Departure& departure) {
    if (terrain != terrain_) measure(places, terrain);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < heights_.size(); ++i)
      if (is_decided(places[i].line, heights_[i], departure)) bits |= std::uint64_t{1} << i;
    return bits;
  }

 private:
  template <class Place>
  void measure(const std::vector<Place>& places, const std::shared_ptr<const Terrain>& terrain) {
    terrain_ = terrain;
    heights_.clear();
    for (const Place& place : places)
      if (heights_.size() < most) heights_.push_back(least_height(place.line, *terrain));
  }
  static bool is_decided(const PlanLine& line, const std::optional<double>& height,
                         const Departure& departure);

  std::shared_ptr<const Terrain> terrain_;  ///< of which the heights are
  std::vector<std::optional<double>> heights_;
};

}  // namespace flyrock
