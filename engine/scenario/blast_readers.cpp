#include "scenario/blast_readers.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/schema.h"

namespace flyrock {

namespace {

bool reads(const PluginUse& use, const BlastFieldInfo& info) {
  const PluginSpec& spec = use.plugin->spec;
  return std::any_of(spec.reads.begin(), spec.reads.end(), [&](const FieldRead& read) {
    const bool named =
        read.field == fmt::format("blast.{}", info.path) || read.field == fmt::format("blast.{}", info.name);
    return named && holds(read, spec, use.values);
  });
}

/// A Lua plugin may read any field if its manifest does not say what it reads.
bool may_read(const PluginUse& use, const BlastFieldInfo& info) {
  return reads(use, info) || (!use.plugin->spec.declares_reads && use.plugin->spec.native.empty());
}

}  // namespace

bool says_it_reads(const PluginUse& use, BlastField field) {
  return reads(use, blast_fields()[static_cast<std::size_t>(field)]);
}

bool reads_blast(const PluginUse& use) {
  return std::any_of(blast_fields().begin(), blast_fields().end(),
                     [&](const BlastFieldInfo& info) { return may_read(use, info); });
}

std::vector<const PluginUse*> blast_readers(const RockGroup& group) {
  std::vector<const PluginUse*> readers;
  if (group.launch) readers.push_back(&*group.launch);
  if (group.population.plugin->spec.name != default_population) readers.push_back(&group.population);
  return readers;
}

bool is_placed_by_rows(const RockGroup& group) {
  return group.release &&
         (group.release->kind == ReleaseKind::collar || group.release->kind == ReleaseKind::bench_top);
}

bool reads_field(const Scenario& scenario, const RockGroup& group, BlastField field) {
  const BlastPlan& blast = *scenario.blast;
  if (!blast.has_holes() && is_placed_by_rows(group)) {
    if (field == BlastField::burden || field == BlastField::burden_crest) return true;
    const bool is_beside_others = scenario.dimension == 3 && blast.pattern.holes_per_row > 1;
    if (field == BlastField::spacing && is_beside_others && group.release->kind == ReleaseKind::collar)
      return true;
  }
  const bool is_before_its_hole =
      blast.has_holes() && group.release && group.release->kind == ReleaseKind::face;
  if (is_before_its_hole && field == BlastField::spacing) return true;
  const std::vector<const PluginUse*> readers = blast_readers(group);
  const BlastFieldInfo& info = blast_fields()[static_cast<std::size_t>(field)];
  return std::any_of(readers.begin(), readers.end(),
                     [&](const PluginUse* use) { return may_read(*use, info); });
}

bool follows(const BlastPlan& blast, BlastField field, BlastField from, Giver giver) {
  return std::any_of(blast.sources.begin(), blast.sources.end(),
                     [&](const BlastSources& of_hole) { return of_hole.follows(field, from, giver); });
}

bool follows(const BlastPlan& blast, BlastField field, BlastField from) {
  return follows(blast, field, from, Giver::blast) || follows(blast, field, from, Giver::hole);
}

bool depends_on(const Scenario& scenario, const RockGroup& group, BlastField given, Giver giver) {
  return std::any_of(blast_fields().begin(), blast_fields().end(), [&](const BlastFieldInfo& info) {
    return follows(*scenario.blast, info.field, given, giver) && reads_field(scenario, group, info.field);
  });
}

bool depends_on(const Scenario& scenario, const RockGroup& group, BlastField given) {
  return depends_on(scenario, group, given, Giver::blast) || depends_on(scenario, group, given, Giver::hole);
}

}  // namespace flyrock
