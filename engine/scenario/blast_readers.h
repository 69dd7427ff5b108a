#pragma once
// Which plugins and releases read the blast: launches, populations, and releases at the rows of holes.

#include <vector>

#include "scenario/scenario.h"

namespace flyrock {

/// Whether a plugin reads any field of the blast. Also true if it may read one because its manifest does not
/// say what it reads.
bool reads_blast(const PluginUse& use);

/// Whether a plugin says that it reads a field.
bool says_it_reads(const PluginUse& use, BlastField field);

/// The plugins of a group that get the blast.
std::vector<const PluginUse*> blast_readers(const RockGroup& group);

/// Whether the release is at the collars or on the bench top: these find the rows by the burden and the
/// distance between rows.
bool is_placed_by_rows(const RockGroup& group);

/// Whether the rocks of a group read this field itself: a plugin does, or the release.
bool reads_field(const Scenario& scenario, const RockGroup& group, BlastField field);

/// Whether a field follows from a given one (BlastSources), at any hole.
bool follows(const BlastPlan& blast, BlastField field, BlastField from, Giver giver);
bool follows(const BlastPlan& blast, BlastField field, BlastField from);

/// Whether the rocks of a group depend on a given field: they read a field that follows from it.
bool depends_on(const Scenario& scenario, const RockGroup& group, BlastField given, Giver giver);
bool depends_on(const Scenario& scenario, const RockGroup& group, BlastField given);

}  // namespace flyrock
