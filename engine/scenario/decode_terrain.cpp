// Materials, terrain and pairs.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "document/wording.h"
#include "geometry/terrain_place.h"
#include "scenario/decode_sections.h"
#include "scenario/ground_store.h"
#include "scenario/load_table.h"
#include "scenario/normalise.h"
#include "scenario/normalise_number.h"
#include "survey/surveyed_terrain.h"
#include "survey/vector_file.h"

namespace flyrock {

namespace {

std::optional<PluginUse> decode_law(DecodeContext& context, const Node& material, PluginKind kind) {
  const std::optional<Node> node = material.find(name_of(kind));
  return node ? decode_plugin(context, *node, kind) : std::nullopt;
}

/// What a terrain says of its file: one line, the coordinate system, and warnings.
void take_report(DecodeContext& context, const Node& node, const SurveyReport& report,
                 DecodedTerrain& terrain) {
  terrain.survey = report.size;
  terrain.crs_of_file = report.crs;
  terrain.is_converted = report.is_converted;
  for (const std::string& note : report.notes) context.diagnostics.warning(node.key_at, node.path, note);
}

/// What other sections need of the terrain of trial 0. Its shape in 3D goes to `shape` unless it may be
/// another in other trials.
DecodedTerrain outline_of(DecodeContext& context, const Node& node, const PluginUse& use,
                          const TerrainPlan& plan, std::uint64_t seed,
                          std::shared_ptr<TerrainShape3>& shape) {
  const std::optional<SectionPlan>& section = plan.section;
  const DrawKey key;
  std::vector<double> values;
  for (const Number& slot : use.slots) values.push_back(slot.value(context.draws, seed, key));
  RandomStream rng(seed, use.path, key);
  DecodedTerrain terrain;
  const auto model = make_instance<TerrainModel>(use, section ? 3 : context.dimension);
  if (section || context.dimension == 3)
    shape = std::make_shared<TerrainShape3>(model->build_3d(values, rng));
  if (const auto* surveyed = dynamic_cast<const SurveyedTerrain*>(model.get()))
    take_report(context, node, surveyed->report(), terrain);
  if (context.dimension == 3) {
    terrain.parts = parts_of(*shape);
    terrain.automatic_origin = automatic_origin(*shape);
    if (const Mesh* mesh = std::get_if<Mesh>(shape.get()))
      for (const Mesh::Face& face : terrain.bench_faces = mesh->faces) terrain.faces.push_back(face.name);
  } else {
    terrain.profile = section ? section_of(*shape, section->from, section->to) : model->build(values, rng);
    if (terrain.profile->fault().empty())
      terrain.profile = with_earthworks(std::move(*terrain.profile), plan.works);
    terrain.parts = terrain.profile->parts;
    for (std::size_t i = 0; i < terrain.profile->faces.size(); ++i)
      terrain.faces.push_back(terrain.profile->face_name(i));
  }
  const bool constant =
      std::all_of(use.slots.begin(), use.slots.end(), [](const Number& n) { return n.is_constant(); });
  if (!constant || rng.drawn()) shape.reset();
  return terrain;
}

/// Builds the terrain, or takes its outline from one who has built the same before. `text`: text_of_ground.
std::shared_ptr<TerrainShape3> try_to_build(DecodeContext& context, const Node& node, const PluginUse& use,
                                            std::uint64_t seed, const std::string& text,
                                            DecodedTerrain& terrain) {
  std::shared_ptr<TerrainShape3> shape;
  try {
    const auto outline = context.grounds->get(fmt::format("outline {} {}", seed, text), [&] {
      return GroundStore::Made{
          std::make_shared<const DecodedTerrain>(outline_of(context, node, use, terrain.plan, seed, shape))};
    });
    TerrainPlan plan = std::move(terrain.plan);
    terrain = *std::static_pointer_cast<const DecodedTerrain>(outline);
    terrain.plan = std::move(plan);
  } catch (const SectionError& error) {
    context.diagnostics.error(node.key_at, node.path, error.what());
  } catch (const EarthworksError& error) {
    context.diagnostics.error(node.key_at, node.path, error.what());
  } catch (const FileFaults& found) {
    for (const std::string& wrong : found.faults) context.diagnostics.error(node.key_at, node.path, wrong);
  } catch (const PluginError& error) {
    context.diagnostics.error(node.key_at, node.path, error.what());
  }
  return shape;
}

/// The line of a section in plan. A layer stays in its own system, because the terrain is not read yet.
SectionPlan decode_section_line(DecodeContext& context, const Node& node) {
  context.crs = own_system;
  const Section section = decode_section(context, node, "terrain: section");
  context.crs.clear();
  if (const std::optional<Node> line = node.find("line")) {
    if (node.find("from") || node.find("to"))
      line->error(context.diagnostics, "stands in place of `from` and `to`, expected one of both");
    const std::vector<Vec3>& ends = section.points("line");
    if (ends.size() == 2) return {ends[0].head<2>(), ends[1].head<2>()};
    if (!ends.empty())
      line->error(context.diagnostics,
                  fmt::format("has {} points, expected two: a section is straight", ends.size()));
    return {Vec2::Zero(), Vec2::Zero()};
  }
  const auto place = [&](const char* key) -> Vec2 {
    if (!node.find(key)) {
      context.diagnostics.error(node.key_at, node.path,
                                fmt::format("has no `{}`, expected `from` and `to`, or `line`", key));
      return Vec2::Zero();
    }
    const std::vector<Number>& numbers = section.vector(key);
    return numbers.size() == 2 ? Vec2(numbers[0].constant, numbers[1].constant) : Vec2(Vec2::Zero());
  };
  return {place("from"), place("to")};
}

/// { type: section, of: { type, ... }, from, to }: a profile out of a terrain in 3D.
std::optional<PluginUse> decode_section_terrain(DecodeContext& context, const Node& node, TerrainPlan& plan) {
  std::optional<PluginUse> use;
  if (const std::optional<Node> of = node.find("of")) {
    context.dimension = 3;
    use = decode_plugin(context, *of, PluginKind::terrain);
    context.dimension = 2;
  }
  plan.section = decode_section_line(context, node);
  return use;
}

/// The ditch and the bund on a profile whose plugin has none of its own.
Earthworks decode_earthworks(DecodeContext& context, const Node& node) {
  Earthworks works;
  for (const std::string& key : earthworks_of(context, node)) {
    const auto work = node.find(key);
    if (!work) continue;
    const Section section = decode_section(context, *work, "terrain." + key);
    if (key == "ditch") {
      works.ditch = {.x = section.constant("x"),
                     .width = section.constant("width"),
                     .depth = section.constant("depth"),
                     .slope = section.constant("slope")};
      continue;
    }
    if (section.given("x") && section.given("distance"))
      work->error(context.diagnostics, "begins at `x`, or by `distance` from a ditch, expected one of both");
    if (!section.given("x") && !works.ditch)
      work->error(context.diagnostics, "has no place, expected `x`, or a `ditch` beyond which it stands");
    works.bund = {.x = section.given("x") ? std::optional(section.constant("x")) : std::nullopt,
                  .distance = section.given("distance") ? section.constant("distance") : 0,
                  .height = section.constant("height"),
                  .top = section.constant("top"),
                  .slope = section.constant("slope")};
  }
  return works;
}

/// The text of what is built of a terrain: without its zones, faces, origin and materials.
std::string text_of_ground(const Node& node) {
  Map ground;
  for (const Entry& entry : *node.value->map()) {
    constexpr std::array<std::string_view, 6> others{"zones", "faces",    "origin",
                                                     "crs",   "material", "materials"};
    if (std::find(others.begin(), others.end(), entry.key) == others.end()) ground.push_back(entry);
  }
  return to_json(map_value(std::move(ground)));
}

/// `material` applies to every part and zone that `materials` does not name.
void decode_part_materials(DecodeContext& context, const Node& node, const std::vector<Material>& materials,
                           const std::vector<std::string>& parts, TerrainPlan& plan) {
  const std::optional<Node> rest = node.find("material");
  const std::optional<Node> named = node.find("materials");
  std::vector<std::string> names = parts;
  std::erase(names, "");  // a profile without parts: all of it except its zones
  if (rest) {
    const int index = find_material(context, *rest, materials);
    for (const std::string& part : parts) plan.material_of_part[part] = index;
  }
  if (named) {
    for (const Node& entry : named->entries()) {
      if (std::find(names.begin(), names.end(), entry.key) == names.end())
        context.diagnostics.error(
            entry.key_at, entry.path,
            fmt::format(
                "the terrain has no part or zone `{}`{}{}", entry.key,
                names.empty() ? "" : suggestion(entry.key, names),
                names.size() < parts.size() ? "; `material` applies to the parts without a name" : ""));
      plan.material_of_part[entry.key] = find_material(context, entry, materials);
    }
  }
  for (const std::string& part : parts)
    if (!plan.material_of_part.contains(part))
      context.diagnostics.error(node.key_at, node.path,
                                part.empty()
                                    ? fmt::format("`material` is missing, expected the name of a material{}",
                                                  names.empty() ? "" : " for what is not a zone")
                                    : fmt::format("`materials` gives none for the part `{}`", part));
}

/// The coefficient of friction of a law that answers with this parameter.
std::shared_ptr<const OverTime> decode_mu_over_time(DecodeContext& context, const Node& friction) {
  const std::optional<Node> mu = friction.find("mu");
  const auto table = decode_over_time(mu);
  const Value* type = friction.value->find("type");
  if (table && type && type->text() && *type->text() != "coulomb")
    mu->error(context.diagnostics, "changes over time only with the friction `coulomb`");
  return table;
}

}  // namespace

int find_material(DecodeContext& context, const Node& node, const std::vector<Material>& materials) {
  const std::string* name = node.value->text();
  if (!name) return -1;  // already reported
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (materials[i].name == *name) return static_cast<int>(i);
  node.error(context.diagnostics,
             fmt::format("there is no material `{}`{}", *name, suggestion(*name, names_of(materials))));
  return -1;
}

std::vector<Material> decode_materials(DecodeContext& context, const Node& node) {
  std::vector<Material> materials;
  for (const Node& entry : node.entries()) {
    materials.push_back({.name = entry.key,
                         .restitution = decode_law(context, entry, PluginKind::restitution),
                         .friction = decode_law(context, entry, PluginKind::friction),
                         .rolling = decode_law(context, entry, PluginKind::rolling),
                         .unilateral = decode_law(context, entry, PluginKind::unilateral),
                         .roughness = {},
                         .mu_over_time = {}});
    if (const auto friction = entry.find("friction"))
      materials.back().mu_over_time = decode_mu_over_time(context, *friction);
    const std::optional<Node> roughness = entry.find("roughness");
    if (!roughness) continue;
    const Number angle = decode_section(context, *roughness, "materials.roughness").number("angle");
    if (angle.is_constant() && !(std::abs(angle.constant) < 0.5 * pi))
      roughness->error(context.diagnostics, "tilts the ground by 90 degrees or more");
    materials.back().roughness = angle;
  }
  return materials;
}

DecodedTerrain decode_terrain(DecodeContext& context, const Node& node,
                              const std::vector<Material>& materials, bool needs_materials,
                              std::uint64_t seed) {
  DecodedTerrain terrain;
  if (node.value->is_null()) return terrain;  // already reported
  const std::size_t errors = context.diagnostics.errors_given();
  const std::string* type = node.find("type")->value->text();
  if (const auto crs = node.find("crs"); crs && crs->value->text()) context.crs = *crs->value->text();
  const auto use = context.dimension == 2 && type && *type == "section"
                       ? decode_section_terrain(context, node, terrain.plan)
                       : decode_plugin(context, node, PluginKind::terrain);
  std::shared_ptr<TerrainShape3> shape;
  if (use && context.is_sound(node.path) && context.diagnostics.errors_given() == errors) {
    terrain.plan.model = *use;
    terrain.plan.works = decode_earthworks(context, node);
    if (context.diagnostics.errors_given() == errors)
      shape = try_to_build(context, node, *use, seed, text_of_ground(node), terrain);
  }
  decode_places_of_terrain(context, node, terrain);
  const bool names_materials = node.find("material") || node.find("materials");
  if (!terrain.parts.empty()) {
    for (const Zone& zone : terrain.plan.zones) {
      // A group that takes the place of a part leaves nothing of it.
      if (!zone.group.empty()) std::erase(terrain.parts, zone.group);
      terrain.parts.push_back(zone.name);
    }
    if (needs_materials || names_materials)
      decode_part_materials(context, node, materials, terrain.parts, terrain.plan);
  }
  terrain.plan.text = to_json(*node.value);
  terrain.plan.grounds = context.grounds;
  if (shape) context.grounds->leave(terrain.plan.text, std::move(shape));
  return terrain;
}

std::vector<PairPlan> decode_pairs(DecodeContext& context, const Node& node,
                                   const std::vector<Material>& materials,
                                   const std::vector<std::string>& names) {
  std::vector<PairPlan> pairs;
  for (const Node& item : node.items()) {
    PairPlan pair;
    if (const auto material = item.find("material"))
      pair.material = find_material(context, *material, materials);
    const std::optional<Node> between = item.find("between");
    const std::vector<Node> ends = between ? between->items() : std::vector<Node>();
    for (const Node& end : ends) {
      const std::string* name = end.value->text();
      if (!name || std::find(names.begin(), names.end(), *name) == names.end())
        end.error(context.diagnostics,
                  fmt::format("{} is neither a body nor a group nor a part of the terrain{}",
                              shown(*end.value), name ? suggestion(*name, names) : ""));
      else
        (&end == &ends.front() ? pair.a : pair.b) = *name;
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace flyrock
