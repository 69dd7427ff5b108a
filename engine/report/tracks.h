#pragma once
// Trajectories thinned to what a plot can show.

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "batch/records.h"

namespace flyrock {

/// The indices of `points` that a poly-line within `tolerance` [m] of all of them keeps, in the plane of x and
/// height (Ramer 1972, Douglas and Peucker 1973). First and last are always kept.
std::vector<std::size_t> simplify(const std::vector<Vec2>& points, double tolerance);

/// The rows of one rock's path within the records of a point.
struct Track {
  std::uint64_t trial = 0;
  int rock = 0;
  std::size_t begin = 0, end = 0;
};

/// Rows that follow each other and belong to the same rock.
std::vector<Track> tracks_of(const std::vector<TrajectoryRecord>& rows);

/// The paths of whole rocks, as many as fit into a budget of points: each thinned, with time, speed and mode of travel.
/// All chunks are measured first, then seen.
class Tracks {
 public:
  Tracks(std::size_t budget, int dimension) : budget_(budget), dimension_(dimension) {}

  void measure(const TrialRecords& chunk);
  void see(const TrialRecords& chunk);

  /// { list: [{ trial, rock, group, x, y, t, speed, modes, reason }], cut }: x, y and t as differences of thousandths,
  /// speed in thousandths; modes is how many points follow each other in a mode, by turns with the mode's number.
  nlohmann::ordered_json data() const { return {{"list", list_}, {"cut", cut_}}; }

 private:
  void add(const Track& track, const TrialRecords& chunk);

  std::size_t budget_, points_ = 0;
  int dimension_;
  bool cut_ = false;
  std::map<int, Eigen::AlignedBox3d> boxes_;  ///< of the paths of each group, which a plot may show alone
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
};

}  // namespace flyrock
