// Finds the known keys that a run does not read.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "document/printable.h"
#include "scenario/blast_readers.h"
#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

bool any_is_placed_by_rows(const Scenario& scenario) {
  return std::any_of(scenario.rocks.begin(), scenario.rocks.end(), is_placed_by_rows);
}

/// Why nobody reads a field; names those that read the blast.
std::string reason(const Scenario& scenario) {
  std::set<std::string> readers;
  for (const RockGroup& group : scenario.rocks)
    for (const PluginUse* use : blast_readers(group)) readers.insert(use->plugin->spec.name);
  if (scenario.blast->face) readers.insert("blast.face");
  if (readers.empty()) return "nothing reads it";
  return fmt::format("{} {} not read it", fmt::join(readers, ", "), readers.size() == 1 ? "does" : "do");
}

bool is_read(const Scenario& scenario, BlastField field) {
  return std::any_of(scenario.rocks.begin(), scenario.rocks.end(),
                     [&](const RockGroup& group) { return reads_field(scenario, group, field); });
}

bool is_used(const Scenario& scenario, BlastField field, Giver giver) {
  const bool is_compared =
      field == BlastField::powder_factor && std::isfinite(scenario.blast->design.powder_factor);
  return is_compared ||
         std::any_of(scenario.rocks.begin(), scenario.rocks.end(),
                     [&](const RockGroup& group) { return depends_on(scenario, group, field, giver); });
}

/// Why a given field changes nothing: nobody reads it, or who does reads what follows from other fields.
std::string why_idle(const Scenario& scenario, BlastField field) {
  if (!is_read(scenario, field)) return reason(scenario);
  const BlastPlan& blast = *scenario.blast;
  if (field == BlastField::burden && blast.face) return "blast.face gives the burdens";
  std::vector<std::string_view> others;
  for (const BlastFieldInfo& info : blast_fields())
    if (info.field != field && follows(blast, field, info.field)) others.push_back(info.path);
  if (others.empty()) return "each of the holes has its own";
  return fmt::format("it follows from {}", fmt::join(others, ", "));
}

void find_blast_keys(const Node& blast, const Scenario& scenario, std::vector<std::string>& list) {
  const bool explosive_by_name = blast.value->find("explosive") && blast.value->find("explosive")->text();
  bool explosive_is_used = false;
  std::string why_explosive = reason(scenario);
  for (const BlastFieldInfo& info : blast_fields()) {
    const bool used = is_used(scenario, info.field, Giver::blast);
    const std::size_t dot = info.path.find('.');
    if (info.path.starts_with("explosive.")) {
      explosive_is_used = explosive_is_used || used;
      if (is_read(scenario, info.field)) why_explosive = why_idle(scenario, info.field);
    }
    const std::optional<Node> parent =
        dot == std::string_view::npos ? blast : blast.find(info.path.substr(0, dot));
    const std::string_view key = dot == std::string_view::npos ? info.path : info.path.substr(dot + 1);
    if (!used && parent && find_given(*parent, key))
      list.push_back(fmt::format("blast.{} ({})", info.path, why_idle(scenario, info.field)));
    if (scenario.blast->columns.contains(info.field) && !is_used(scenario, info.field, Giver::hole)) {
      const Value* holes = blast.value->find("holes");
      const bool is_bearing = info.field == BlastField::hole_azimuth && holes && holes->map() &&
                              !scenario.blast->has_mathematical_azimuths;
      list.push_back(fmt::format("blast.holes: the column `{}` ({})", is_bearing ? "bearing" : key,
                                 why_idle(scenario, info.field)));
    }
  }
  for (const std::string& head : scenario.blast->other_heads)
    list.push_back(
        fmt::format("blast.holes: the column `{}` (no column of holes has this name)", printable(head)));
  if (explosive_by_name && !explosive_is_used)
    list.push_back(fmt::format("blast.explosive ({})", why_explosive));
  const auto rows = blast.find("rows");
  if (rows && find_given(*rows, "distance") && !any_is_placed_by_rows(scenario))
    list.push_back("blast.rows.distance (no rock is released at a collar or on the bench top)");
  if (rows && scenario.rock_contacts)
    for (const char* key : {"delay_row", "delay_hole", "delay_in_hole"})
      if (find_given(*rows, key))
        list.push_back(fmt::format("blast.rows.{} (rocks that meet each other leave together)", key));
}

void find_heads_of_trees(const Scenario& scenario, std::vector<std::string>& list) {
  if (!scenario.forest) return;
  for (const std::string& head : scenario.forest->other_heads)
    list.push_back(
        fmt::format("forest.file: the column `{}` (no column of trees has this name)", printable(head)));
}

void find_materials(const Scenario& scenario, std::vector<std::string>& list) {
  if (scenario.method == Method::ballistic) {
    for (const Material& material : scenario.materials)
      list.push_back(fmt::format("materials.{} (the method ballistic has no contacts)", material.name));
    return;
  }
  for (const Material& material : scenario.materials) {
    if (scenario.method == Method::lumped_mass && material.unilateral)
      list.push_back(
          fmt::format("materials.{}.unilateral (a lumped mass rebounds without duration)", material.name));
    if (scenario.method != Method::lumped_mass && material.roughness)
      list.push_back(fmt::format("materials.{}.roughness (the method lumped_mass reads it)", material.name));
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

/// What says how bodies meet each other, where they do not: `why`.
void find_meetings_of_bodies(const Scenario& scenario, const char* why, std::vector<std::string>& list) {
  const auto is_body = [&](const std::string& name) {
    return std::any_of(scenario.bodies.begin(), scenario.bodies.end(),
                       [&](const BodyPlan& body) { return body.name == name; });
  };
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
    if (scenario.bodies[i].fixed || scenario.bodies[i].driven)
      list.push_back(fmt::format("bodies.{} ({})", i, why));
  for (std::size_t i = 0; i < scenario.pairs.size(); ++i)
    if (is_body(scenario.pairs[i].a) && is_body(scenario.pairs[i].b))
      list.push_back(fmt::format("pairs.{} ({})", i, why));
}

void find_body_contacts(const Node& root, const Scenario& scenario, std::vector<std::string>& list) {
  if (scenario.bodies.empty()) {
    if (find_given(root, "body_contacts")) list.emplace_back("body_contacts (the scenario has no bodies)");
  } else if (scenario.method == Method::nscd && !scenario.body_contacts) {
    find_meetings_of_bodies(scenario, "body_contacts is off", list);
  }
}

/// Heads of tables of rocks and of measured places that are no columns.
void find_other_heads(const Scenario& scenario, std::vector<std::string>& list) {
  struct Use {
    std::string where, file;
    const std::vector<std::string>& heads;
  };
  std::vector<Use> uses;
  for (const RockGroup& group : scenario.rocks)
    if (group.table)
      uses.push_back({"rocks." + group.name + ".table", group.table->file, group.table->other_heads});
  if (scenario.observed)
    uses.push_back({"observed", scenario.observed->file, scenario.observed->other_heads});
  for (const Use& use : uses)
    for (const std::string& head : use.heads) {
      // One file may hold rocks and where they stopped.
      const bool is_read = std::any_of(uses.begin(), uses.end(), [&](const Use& other) {
        return other.file == use.file &&
               std::find(other.heads.begin(), other.heads.end(), head) == other.heads.end();
      });
      if (!is_read)
        list.push_back(fmt::format("{}: the column `{}` (no column of the table has this name)", use.where,
                                   printable(head)));
    }
}

/// Keys about contacts between rocks, in a scenario where rocks do not meet each other.
void find_rock_contacts(const Node& root, const Scenario& scenario, std::vector<std::string>& list) {
  if (scenario.rocks.empty()) {
    if (find_given(root, "rock_contacts")) list.emplace_back("rock_contacts (the scenario has no rocks)");
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

/// Keys that a point without extent and spin has no use for.
void find_keys_of_bodies(const Node& root, const Scenario& scenario, std::vector<std::string>& list) {
  if (const auto solver = find_given(root, "solver"))
    for (const char* key : {"name", "time_step", "step_tolerance", "theta", "tolerance", "max_iterations",
                            "flight", "impacts", "bodies"})
      if (find_given(*solver, key))
        list.push_back(fmt::format("solver.{} (a lumped mass has no contact scheme)", key));
  const auto find_spin = [&](const std::optional<Node>& node) {
    if (node && find_given(*node, "spin")) list.push_back(node->path + ".spin (a lumped mass has none)");
  };
  if (const auto rocks = root.find("rocks"))
    for (const Node& item : rocks->items()) find_spin(item.find("launch"));
  if (const auto bodies = root.find("bodies"))
    for (const Node& item : bodies->items()) find_spin(item);
  find_meetings_of_bodies(scenario, "a lumped mass meets the terrain only", list);
}

}  // namespace

void refuse_charges_without_length(const Node& root, const Scenario& scenario, Diagnostics& diagnostics) {
  using enum BlastField;
  if (!scenario.blast) return;
  const BlastPlan& blast = *scenario.blast;
  const auto says = [](const PluginUse* use) {
    return says_it_reads(*use, hole_linear_charge) || says_it_reads(*use, explosive_density);
  };
  const auto reads_charge = [&](const RockGroup& group) {
    const std::vector<const PluginUse*> readers = blast_readers(group);
    return std::any_of(readers.begin(), readers.end(), says);
  };
  if (std::none_of(scenario.rocks.begin(), scenario.rocks.end(), reads_charge)) return;
  const auto is_without = [](const Blast& hole, const BlastSources& sources) {
    const auto is_given = [&](BlastField field) {
      return sources.follows(field, field, Giver::hole) || sources.follows(field, field, Giver::blast);
    };
    return is_given(hole_charge) && !is_given(hole_linear_charge) && std::isnan(hole[hole_charge_length]);
  };
  constexpr const char* expected =
      "the charge per length does not follow from it, and the rocks would be thrown by a hole full of "
      "explosive; expected two of `length`, `stemming` and `charge_length`, a `charge_length`, or a "
      "`linear_charge` in its place";
  const Node node = *root.find("blast");
  if (!blast.has_holes()) {
    if (is_without(blast.typical, blast.sources.front()))
      node.error(diagnostics, fmt::format("`hole.charge` is given without its length: {}", expected));
    return;
  }
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < blast.holes.size(); ++i)
    if (is_without(blast.holes[i], blast.sources[i])) holes.push_back(i);
  if (holes.empty()) return;
  const std::size_t first = holes.front();
  const std::string others = holes.size() == 1 ? "" : fmt::format(" (and {} more holes)", holes.size() - 1);
  diagnostics.error(
      blast.hole_places[first], "blast.holes",
      fmt::format("hole {}{}: its charge of {:.6g} kg is given without its length: {}",
                  blast.pattern.measured[first].name, others, blast.holes[first][hole_charge], expected));
}

std::vector<std::string> find_not_used(const Node& root, const Scenario& scenario) {
  std::vector<std::string> list;
  if (const auto blast = root.find("blast")) find_blast_keys(*blast, scenario, list);
  find_other_heads(scenario, list);
  find_heads_of_trees(scenario, list);
  find_materials(scenario, list);
  if (scenario.method == Method::ballistic && find_given(root, "solver"))
    list.emplace_back("solver (the method ballistic has no contacts)");
  const auto output = root.find("output");
  if (scenario.method != Method::nscd && output && find_given(*output, "series"))
    list.push_back(fmt::format("output.series (the method {} flies points)", name_of(scenario.method)));
  if (output && find_given(*output, "first") && scenario.output.rocks)
    list.emplace_back("output.first (every rock has its rows)");
  if (output && find_given(*output, "maps") && scenario.output.maps.wanted) {
    if (scenario.dimension == 2) list.emplace_back("output.maps (maps are made in 3D)");
    if (scenario.dimension == 3 && !scenario.bodies.empty())
      list.emplace_back("output.maps (maps are made of `rocks`)");
  }
  if (scenario.method == Method::lumped_mass) find_keys_of_bodies(root, scenario, list);
  find_rock_contacts(root, scenario, list);
  find_body_contacts(root, scenario, list);
  return list;
}

}  // namespace flyrock
