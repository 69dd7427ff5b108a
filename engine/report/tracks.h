#pragma once
// Trajectories thinned to what a plot can show.

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "batch/records.h"

namespace flyrock {

/// The indices of `points` that a poly-line within `tolerance` [m] of all of them keeps, in the plane of x
/// and height (Ramer 1972, Douglas and Peucker 1973). First and last are always kept.
std::vector<std::size_t> simplify(const std::vector<Vec2>& points, double tolerance);

/// The paths of whole rocks, as many as fit into a budget of points: each thinned, with time, speed and mode
/// of travel. How much a path may be thinned rests on the extent of all of its group: it is thinned as far as
/// those before it tell, and again when all have been seen.
class Tracks {
 public:
  Tracks(std::size_t budget, int dimension) : budget_(budget), dimension_(dimension) {}

  /// The chunks in order.
  void see(const TrialRecords& chunk);

  /// { list: [{ trial, rock, group, reason, x, y, t, speed, modes }], cut }: x, y and t as differences of
  /// thousandths, speed in thousandths; modes is how many points follow each other in a mode, by turns with
  /// the mode's number.
  nlohmann::ordered_json data() const;

 private:
  /// What the page needs of a stored point.
  struct Point {
    Vec2 place;  ///< in the vertical plane of 2D; of space as seen from the side
    double time, speed;
    TravelMode mode;  ///< in which the rock arrived here
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
  static nlohmann::ordered_json data_of(const Track& track, const std::vector<Point>& points);
  double tolerance(int group) const;

  std::size_t budget_, kept_ = 0;
  int dimension_;
  bool full_ = false;                         ///< there were more
  std::map<int, Eigen::AlignedBox3d> boxes_;  ///< of the paths of each group, which a plot may show alone
  std::vector<Track> tracks_;
};

}  // namespace flyrock
