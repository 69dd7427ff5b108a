// Known keys that nothing in a run reads.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

bool reads(const PluginUse& use, const BlastFieldInfo& info) {
  const PluginSpec& spec = use.plugin->spec;
  return std::any_of(spec.reads.begin(), spec.reads.end(), [&](const FieldRead& read) {
    const bool named = read.field == fmt::format("blast.{}", info.path) || read.field == fmt::format("blast.{}", info.name);
    return named && holds(read, spec, use.values);
  });
}

/// A Lua plugin may read what it likes where its manifest does not say.
bool may_read(const PluginUse& use, const BlastFieldInfo& info) {
  return reads(use, info) || (!use.plugin->spec.declares_reads && use.plugin->spec.native.empty());
}

/// Whether a given field makes up one that does not stand in the scenario itself but follows (blast/design.h).
bool feeds(const BlastPlan& plan, BlastField field, BlastField result) {
  using enum BlastField;
  if (plan.fields.contains(result) || !plan.provides(result)) return false;
  const auto is_length = [](BlastField f) { return f == hole_length || f == hole_stemming || f == hole_charge_length; };
  if (is_length(result)) return is_length(field);
  return result == burden && (is_length(field) || field == hole_subdrilling || field == hole_deviation ||
                              field == burden_crest || field == burden_toe);
}

/// A release at the collars or on the bench top finds the rows by their burden and distance.
bool places_by_rows(const Scenario& scenario) {
  return std::any_of(scenario.rocks.begin(), scenario.rocks.end(), [](const RockGroup& group) {
    return group.release && (group.release->kind == ReleaseKind::collar || group.release->kind == ReleaseKind::bench_top);
  });
}

/// The uses of plugins that get the blast, of one name together.
using Readers = std::map<std::string, std::vector<const PluginUse*>>;
Readers blast_readers(const Scenario& scenario) {
  Readers readers;
  for (const RockGroup& group : scenario.rocks) {
    if (group.launch) readers[group.launch->plugin->spec.name].push_back(&*group.launch);
    if (group.population.plugin->spec.name != default_population)
      readers[group.population.plugin->spec.name].push_back(&group.population);
  }
  return readers;
}

std::string reason(const Readers& readers) {
  if (readers.empty()) return "nothing reads it";
  std::string names;
  for (const auto& [name, uses] : readers) names += (names.empty() ? "" : ", ") + name;
  return names + (readers.size() == 1 ? " does not read it" : " do not read it");
}

void find_blast_keys(const Node& blast, const Scenario& scenario, std::vector<std::string>& list) {
  const auto readers = blast_readers(scenario);
  const bool explosive_by_name = blast.value->find("explosive") && blast.value->find("explosive")->text();
  bool explosive_is_read = false;
  for (const BlastFieldInfo& info : blast_fields()) {
    const auto read_by_plugin = [&](const BlastFieldInfo& other) {
      return std::any_of(readers.begin(), readers.end(), [&](const auto& reader) {
        return std::any_of(reader.second.begin(), reader.second.end(), [&](const PluginUse* use) { return may_read(*use, other); });
      });
    };
    const bool holds_rows = info.field == BlastField::burden || info.field == BlastField::burden_crest;
    const bool is_read =
        read_by_plugin(info) || (holds_rows && places_by_rows(scenario)) ||
        (info.field == BlastField::powder_factor && std::isfinite(scenario.blast->design.powder_factor)) ||
        std::any_of(blast_fields().begin(), blast_fields().end(), [&](const BlastFieldInfo& other) {
          return feeds(*scenario.blast, info.field, other.field) && read_by_plugin(other);
        });
    const std::size_t dot = info.path.find('.');
    if (info.path.starts_with("explosive.")) explosive_is_read = explosive_is_read || is_read;
    const std::optional<Node> parent =
        dot == std::string_view::npos ? blast : blast.find(info.path.substr(0, dot));
    const std::string_view key = dot == std::string_view::npos ? info.path : info.path.substr(dot + 1);
    if (!is_read && parent && parent->find(key))
      list.push_back(fmt::format("blast.{} ({})", info.path, reason(readers)));
  }
  if (explosive_by_name && !explosive_is_read)
    list.push_back(fmt::format("blast.explosive ({})", reason(readers)));
  const auto rows = blast.find("rows");
  if (rows && rows->find("distance") && !places_by_rows(scenario))
    list.push_back("blast.rows.distance (no rock is released at a collar or on the bench top)");
  if (rows && scenario.rock_contacts)
    for (const char* key : {"delay_row", "delay_hole", "delay_in_hole"})
      if (rows->find(key)) list.push_back(fmt::format("blast.rows.{} (rocks that meet each other leave together)", key));
}

void find_materials(const Scenario& scenario, std::vector<std::string>& list) {
  if (scenario.method == Method::ballistic) {
    for (const Material& material : scenario.materials)
      list.push_back(fmt::format("materials.{} (the method ballistic has no contacts)", material.name));
    return;
  }
  std::set<int> used;
  for (const auto& [part, material] : scenario.terrain.material_of_part) used.insert(material);
  for (const PairPlan& pair : scenario.pairs) used.insert(pair.material);
  for (const RockGroup& group : scenario.rocks) used.insert(group.material);
  for (const BodyPlan& body : scenario.bodies) used.insert(body.material);
  for (std::size_t i = 0; i < scenario.materials.size(); ++i)
    if (!used.contains(static_cast<int>(i)))
      list.push_back(fmt::format("materials.{} (nothing is made of it)", scenario.materials[i].name));
}

/// What concerns rocks that meet each other, where they do not.
void find_rock_contacts(const Node& root, const Scenario& scenario, std::vector<std::string>& list) {
  if (scenario.rocks.empty()) {
    if (root.find("rock_contacts")) list.emplace_back("rock_contacts (the scenario has no rocks)");
    return;
  }
  if (scenario.rock_contacts) return;
  auto is_group = [&](const std::string& name) {
    return std::any_of(scenario.rocks.begin(), scenario.rocks.end(),
                       [&](const RockGroup& group) { return group.name == name; });
  };
  for (std::size_t i = 0; i < scenario.pairs.size(); ++i)
    if (is_group(scenario.pairs[i].a) && is_group(scenario.pairs[i].b))
      list.push_back(fmt::format("pairs.{} (rock_contacts is off)", i));
  for (std::size_t i = 0; i < scenario.rocks.size(); ++i)
    if (scenario.rocks[i].material >= 0)
      list.push_back(fmt::format("rocks.{}.material (rock_contacts is off)", i));
}

}  // namespace

std::vector<std::string> find_not_used(const Node& root, const Scenario& scenario) {
  std::vector<std::string> list;
  if (const auto blast = root.find("blast")) find_blast_keys(*blast, scenario, list);
  find_materials(scenario, list);
  if (scenario.method == Method::ballistic && root.find("solver"))
    list.emplace_back("solver (the method ballistic has no contacts)");
  find_rock_contacts(root, scenario, list);
  return list;
}

}  // namespace flyrock
