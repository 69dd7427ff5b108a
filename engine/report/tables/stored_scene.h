#pragma once
// What results.db says of the coordinates, of the ground of a sweep point, of the shapes of its rocks and of
// its fixtures.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/scenery.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

/// The coordinate system of all places, "EPSG:2056"; empty: not known.
std::string stored_crs(const SqliteReader& database);

/// The number of the ground of a point in `grounds`; none in 2D.
std::optional<std::int64_t> stored_ground(const SqliteReader& database, std::int64_t point);

/// The surface of a rock, in its own frame; empty if it is not stored.
std::vector<SurfaceCorner> stored_corners(const SqliteReader& database, const StoredPath& path);

/// A fixed or driven body (record/scenery.h).
struct StoredFixture {
  StoredPath path;  ///< one moment if the body does not move; the rock is -1, the group the body's name
  std::vector<SurfaceCorner> corners;
};

/// A link, and how its ends move.
struct StoredLink {
  struct End {
    const StoredPath* path = nullptr;  ///< of its body; null: it stays
    Vec3 place;                        ///< m, in the frame of the body, or of the world

    Vec3 at(double time) const;
  };
  std::string type;
  End a, b;
};

/// The links of the trial of these paths, between bodies of these paths and fixtures, which outlive them.
std::vector<StoredLink> stored_links(const SqliteReader& database, const std::vector<StoredPath>& paths,
                                     const std::vector<StoredFixture>& fixtures);

/// The fixtures of the trial of the first of these paths, moved until the paths end.
std::vector<StoredFixture> stored_fixtures(const SqliteReader& database,
                                           const std::vector<StoredPath>& paths);

}  // namespace flyrock
