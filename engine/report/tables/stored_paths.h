#pragma once
// The stored trajectories of results.db, point by point of the sweep.

#include <cstdint>
#include <string>
#include <vector>

#include "math/space.h"
#include "report/tables/sqlite.h"

namespace flyrock {

/// A stored point of a path.
struct StoredMoment {
  double time, speed, energy, mode;  ///< s, m/s, J, index in travel_mode_names
  Vec3 place;                        ///< m, of the centre of mass
  double angle;                      ///< rad, 2D
  Eigen::Quaterniond turn;           ///< 3D, maps the body's frame to the world
};

/// The stored path of one rock.
struct StoredPath {
  std::int64_t point, trial, rock;
  std::string group;                  ///< of the rock; of a body, its name
  double runout, diameter;            ///< m; of the sphere of the rock's volume
  std::vector<StoredMoment> moments;  ///< at least one

  /// Linear between the stored moments, turns at a constant rate. The mode is the one in which the rock
  /// arrives at the later moment. Before and after the path, its first and last moment.
  StoredMoment at(double time) const;
};

/// Reads the paths of one sweep point after the other.
class StoredPaths {
 public:
  explicit StoredPaths(const SqliteReader& database);
  /// Empty after the last point.
  std::vector<StoredPath> next_point();

 private:
  Query rows_;
  bool more_;
};

}  // namespace flyrock
