#pragma once
// The motion of rocks as an animated picture.

#include <optional>
#include <string>
#include <vector>

#include "report/pictures/stage.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

/// How forces of contacts are drawn.
enum class ForceStyle {
  arrows,  ///< at the contacts, as long as the force
  network  ///< lines from centre to centre through the contacts, as wide as the normal force
};

/// The stored `paths` of one sweep point as a self-contained SVG picture, animated without scripts (SMIL), so
/// that it also moves in a page of documentation. It repeats, lasts 4 to 12 seconds, and its axis shows the
/// true time. Forces of contacts are drawn where the results have series of contacts. Rocks that hide each
/// other in 3D are drawn in the order of the first moment. Up to a dozen bodies have their names, where these
/// differ, and lines along which their centres move, so that also the first frame, which is all that a
/// printed page shows, says what happens. Empty if there are no paths; throws InputError if none comes to the
/// region.
std::string animation_of(const SqliteReader& database, const std::vector<StoredPath>& paths,
                         const std::string& title, const std::optional<Region>& region = std::nullopt,
                         ForceStyle style = ForceStyle::arrows);

/// The same pictures one by one, for programs that do not animate SVG: those of all frames, or of one time
/// [s] (before the motion: its first moment).
struct Frames {
  std::vector<std::string> pictures;
  double rate = 0;  ///< frames a second with which they last as long as the animation
};
Frames frames_of(const SqliteReader& database, const std::vector<StoredPath>& paths, const std::string& title,
                 std::optional<double> time, const std::optional<Region>& region = std::nullopt,
                 ForceStyle style = ForceStyle::arrows);

}  // namespace flyrock
