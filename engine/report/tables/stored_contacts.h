#pragma once
// The forces of contacts over time, from the series of results.db.

#include <cstdint>
#include <vector>

#include "math/space.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

/// The force of a contact during a step. If only some steps have rows (`output.series.every`), it stands
/// until the next row falls due.
struct StoredForce {
  double begin, end;  ///< s
  Vec3 place;         ///< m
  Vec3 normal;        ///< towards the first body of the pair
  Vec3 force;         ///< N, on the first body of the pair

  double along_normal() const { return force.dot(normal); }  ///< N
};

struct StoredContact {
  /// Of the two bodies; null: the terrain, a body that is fixed or driven, or without a stored path.
  const StoredPath *a = nullptr, *b = nullptr;
  std::vector<StoredForce> forces;  ///< in the order of time

  /// The force at a time; null if there was none.
  const StoredForce* at(double time) const;
  /// The line of the force network: from centre to centre through the place of the contact [m].
  std::vector<Vec3> line(const StoredForce& force, double time) const;
};

/// The contacts of a trial, by pair and number. The `paths` outlive them.
std::vector<StoredContact> stored_contacts(const SqliteReader& database, std::int64_t point,
                                           std::int64_t trial, const std::vector<StoredPath>& paths);

}  // namespace flyrock
