#pragma once
// The forces of contacts over time, from the series of results.db.

#include <cstdint>
#include <vector>

#include "math/space.h"
#include "report/tables/sqlite.h"

namespace flyrock {

/// The force of a contact during a step.
struct StoredForce {
  double begin, end;  ///< s, of the step
  Vec3 place;         ///< m
  Vec3 force;         ///< N, on the first body of the pair; in 3D without its tangential part
};

struct StoredContact {
  std::vector<StoredForce> forces;  ///< in the order of time

  /// The force in the step that contains the time; null if there was none.
  const StoredForce* at(double time) const;
};

/// The contacts of a trial, by pair and number.
std::vector<StoredContact> stored_contacts(const SqliteReader& database, std::int64_t point,
                                           std::int64_t trial);

}  // namespace flyrock
