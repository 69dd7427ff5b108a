#pragma once
// Measured places or distances (`observed`), with which a run is compared.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"

namespace flyrock {

enum class ObservedNumber {
  runout,   ///< from the start to the stop, horizontally
  place,    ///< where it stopped, in plan
  distance  ///< the greatest distance from the start
};

/// The name as the scenario writes it.
std::string_view name_of(ObservedNumber of);

/// What one line of the table describes.
enum class ObservedUnit {
  rock,
  blast,  ///< the farthest rock of a trial
  hole    ///< the farthest rock of a measured hole, as of a blast with holes that are all alike
};
std::string_view name_of(ObservedUnit unit);

/// A line of the table.
struct ObservedRow {
  std::string name, group;                                                ///< empty: none
  Vec3 place = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  ///< m; NaN: only a distance
  double distance = std::numeric_limits<double>::quiet_NaN();             ///< m; NaN: only a place
  /// The rock of each trial with which it is compared: its group (index into Scenario::rocks) and its line in
  /// the table of that group. -1: all rocks together.
  int rock_group = -1, rock_line = -1;
  int hole = -1;  ///< the measured hole with whose farthest rock it is compared; -1: none
};

struct ObservedPlan {
  std::string file;
  ObservedNumber of = ObservedNumber::runout;
  ObservedUnit per = ObservedUnit::rock;
  std::vector<ObservedRow> rows;
  std::vector<std::string> other_heads;  ///< of the table, which are no columns

  /// Whether each row has a rock or a hole of its own.
  bool is_paired() const { return !rows.empty() && (rows.front().rock_line >= 0 || rows.front().hole >= 0); }
};

}  // namespace flyrock
