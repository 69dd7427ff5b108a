#pragma once
// The motion of rocks as an animated picture.

#include <optional>
#include <string>
#include <vector>

#include "report/stored_paths.h"

namespace flyrock {

/// The stored `paths` of one sweep point as a self-contained SVG picture, animated without scripts (SMIL), so
/// that it also moves in a page of documentation. It repeats, lasts 4 to 12 seconds, and its axis shows the
/// true time. Forces of contacts are arrows where the results have series of contacts: in 2D normal and
/// tangential force together, in 3D the normal force. Rocks that hide each other in 3D are drawn in the order
/// of the first moment. Empty if there are none.
std::string animation_of(const SqliteReader& database, const std::vector<StoredPath>& paths,
                         const std::string& title);

/// The same pictures one by one, for programs that do not animate SVG: those of all frames, or of one time
/// [s] (before the motion: its first moment).
struct Frames {
  std::vector<std::string> pictures;
  double rate = 0;  ///< frames a second with which they last as long as the animation
};
Frames frames_of(const SqliteReader& database, const std::vector<StoredPath>& paths, const std::string& title,
                 std::optional<double> time);

}  // namespace flyrock
