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

bool makes_up(const BlastPlan& blast, BlastField field, BlastField result) {
  using enum BlastField;
  if (field == result) return true;
  // The charge as loaded decides what the explosive fills, or how densely.
  if (result == explosive_density || result == hole_diameter || result == hole_linear_charge)
    if (field == hole_linear_charge || field == hole_charge) return true;
  if (result == gurney_constant) return blast.gurney_follows && field == detonation_velocity;
  if (blast.gives(result) || !blast.provides(result)) return false;
  const auto is_length = [](BlastField f) {
    return f == hole_length || f == hole_stemming || f == hole_charge_length;
  };
  if (is_length(result)) return is_length(field);
  return result == burden && (is_length(field) || field == hole_subdrilling || field == hole_deviation ||
                              field == burden_crest || field == burden_toe);
}

bool depends_on(const BlastPlan& blast, const RockGroup& group, BlastField field) {
  const bool holds_rows =
      !blast.has_holes() && (field == BlastField::burden || field == BlastField::burden_crest);
  if (holds_rows && is_placed_by_rows(group)) return true;
  const bool is_before_its_hole =
      blast.has_holes() && group.release && group.release->kind == ReleaseKind::face;
  if (is_before_its_hole && field == BlastField::spacing) return true;
  const std::vector<const PluginUse*> readers = blast_readers(group);
  return std::any_of(blast_fields().begin(), blast_fields().end(), [&](const BlastFieldInfo& other) {
    return makes_up(blast, field, other.field) &&
           std::any_of(readers.begin(), readers.end(),
                       [&](const PluginUse* use) { return may_read(*use, other); });
  });
}

}  // namespace flyrock
