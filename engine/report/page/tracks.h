#pragma once
// Trajectories, thinned to what a plot can show.

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "record/records.h"

namespace flyrock {

/// The indices of the `points` that remain in a polyline within `tolerance` [m] of all points (Ramer 1972,
/// Douglas and Peucker 1973). The first and the last point always remain.
std::vector<std::size_t> simplify(const std::vector<Vec3>& points, double tolerance);

/// The complete paths of as many rocks as fit into a budget of points. Each path is thinned and has time,
/// speed and mode of motion. The tolerance of thinning depends on the extent of all paths of the group. A
/// path is therefore thinned first by the extent known so far, and again after all paths have been seen.
class Tracks {
 public:
  Tracks(std::size_t budget, int dimension) : budget_(budget), dimension_(dimension) {}

  /// Takes the chunks in order.
  void add(const TrialRecords& chunk);

  /// { list: [{ trial, rock, group, reason, x, y, across, t, speed, modes }], cut }. y is the height, across
  /// the other horizontal coordinate (3D only). x, y, across and t are differences in thousandths, speed is
  /// in thousandths. modes alternates between a number of consecutive points and the number of their mode.
  nlohmann::ordered_json data() const;

 private:
  /// The data of a stored point that the page needs.
  struct Point {
    Vec3 place;  ///< x, height, and in 3D the other horizontal coordinate
    double time, speed;
    TravelMode mode;  ///< mode in which the rock arrived here
  };
  struct Track {
    std::uint64_t trial;
    int rock, group;
    StopReason reason;
    std::vector<Point> points;
  };

  /// The rows of one rock in a chunk.
  struct Stretch {
    const RockRecord& rock;
    std::size_t begin, end;
  };
  static std::vector<Stretch> stretches_of(const TrialRecords& chunk);
  static std::vector<Point> thinned(const std::vector<Point>& path, double tolerance);
  nlohmann::ordered_json data_of(const Track& track, const std::vector<Point>& points) const;
  double tolerance(int group) const;

  std::size_t budget_, kept_ = 0;
  int dimension_;
  bool full_ = false;  ///< some paths did not fit
  std::map<int, Eigen::AlignedBox3d>
      boxes_;  ///< of the paths of each group, because a plot may show one group alone
  std::vector<Track> tracks_;
};

}  // namespace flyrock
