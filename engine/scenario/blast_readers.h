#pragma once
// Who reads the blast: launches, populations, and releases at the rows of holes.

#include <vector>

#include "scenario/scenario.h"

namespace flyrock {

/// Whether a plugin reads any field of the blast, or may, because its manifest does not say.
bool reads_blast(const PluginUse& use);

/// The plugins of a group that get the blast.
std::vector<const PluginUse*> blast_readers(const RockGroup& group);

/// A release at the collars or on the bench top finds the rows by their burden and distance.
bool is_placed_by_rows(const RockGroup& group);

/// Whether `field` is `result`, or makes it up where the scenario leaves it open (blast/design.h).
bool makes_up(const BlastPlan& blast, BlastField field, BlastField result);

/// Whether the rocks of a group depend on a field of the blast: a plugin reads it or what it makes up, or it
/// places them.
bool depends_on(const BlastPlan& blast, const RockGroup& group, BlastField field);

}  // namespace flyrock
