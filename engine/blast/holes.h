#pragma once
// The holes of a blast as they were drilled and charged.

#include <string>

#include "blast/sources.h"

namespace flyrock {

/// One hole of a table. Lengths in m, in the coordinates of the scenario; NaN: the table does not say.
struct Hole {
  std::string name;
  int row = 1;
  double x = std::numeric_limits<double>::quiet_NaN(), y = x, z = x;  ///< of the collar
  double time = 0;                                                    ///< s, when it goes off
  Blast own;  ///< what the table gives; the rest comes from the blast of all holes

  bool is_placed(int dimension) const { return !std::isnan(x) && (dimension == 2 || !std::isnan(y)); }
};

/// Puts a number that takes the place of what a completed blast has, and takes out what would follow from it
/// in another way; complete() then fills that in again. A stemming keeps the length of the hole, and a change
/// of lengths the charge per length.
void force(BlastField field, double value, Blast& blast, BlastSources* sources = nullptr);

/// Puts what a hole gives into the blast of all holes, before that is completed (design.h). Fields that say
/// the same in another way are taken out, because the hole knows better: of the lengths all, if it gives two;
/// a burden, if it gives those at crest and toe; the charge, if it gives a charge.
void put_own(const Hole& hole, Blast& blast, BlastSources* sources = nullptr);

}  // namespace flyrock
