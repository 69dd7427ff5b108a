#pragma once
// Which plugins and releases read the blast: launches, populations, and releases at the rows of holes.

#include <vector>

#include "scenario/scenario.h"

namespace flyrock {

/// Whether a plugin reads any field of the blast. Also true if it may read one because its manifest does not
/// say what it reads.
bool reads_blast(const PluginUse& use);

/// The plugins of a group that get the blast.
std::vector<const PluginUse*> blast_readers(const RockGroup& group);

/// Whether the release is at the collars or on the bench top: these find the rows by the burden and the
/// distance between rows.
bool is_placed_by_rows(const RockGroup& group);

/// Whether `field` is `result`, or is used to compute `result` because the scenario does not give it
/// (blast/design.h).
bool makes_up(const BlastPlan& blast, BlastField field, BlastField result);

/// Whether the rocks of a group depend on a field of the blast: a plugin reads the field, or reads a field
/// that is computed from it, or the release uses it.
bool depends_on(const BlastPlan& blast, const RockGroup& group, BlastField field);

}  // namespace flyrock
