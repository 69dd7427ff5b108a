#pragma once
// One function for each section of a scenario. Each appends what it read to `resolved`, in schema order, and
// reports what is wrong. Its result is used only if nothing was wrong.

#include <optional>
#include <string>
#include <vector>

#include "scenario/decode_params.h"
#include "scenario/measure.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The materials, sorted by name.
std::vector<Material> decode_materials(DecodeContext& context, const std::optional<Node>& node,
                                       Map& resolved);

/// The index of the material that a node names; -1 if there is none, which is reported.
int find_material(DecodeContext& context, const Node& node, const std::vector<Material>& materials);

/// The terrain, with the data that checks of other sections need: its parts and zones, the names of its
/// faces, and in 2D its profile, as built in trial 0. There are no parts if it could not be built.
struct DecodedTerrain {
  TerrainPlan plan;
  std::vector<std::string> parts;
  std::vector<std::string> faces;
  std::optional<Profile> profile;
  Vec3 automatic_origin = Vec3::Zero();  ///< 3D: the origin where the scenario gives none
};
DecodedTerrain decode_terrain(DecodeContext& context, const Node& node,
                              const std::vector<Material>& materials, bool needs_materials,
                              std::uint64_t seed, Map& resolved);

/// The zones, faces and the origin of a terrain that was built.
void decode_places_of_terrain(DecodeContext& context, const Node& node, DecodedTerrain& terrain,
                              Map& resolved);

/// The ESRI ASCII grid that the key `key` of a section names; nothing if it cannot be read, which is reported
/// at `node`.
std::shared_ptr<const HeightGrid> read_raster(DecodeContext& context, const Node& node,
                                              const Section& section, const char* key);

BlastPlan decode_blast(DecodeContext& context, const Node& node, Map& resolved);

/// Checks that need both the blast and the terrain: the length of the hole against the height of the bench.
void check_hole(DecodeContext& context, const Node& blast, const BlastPlan& plan, const TerrainPlan& terrain);

std::vector<RockGroup> decode_rocks(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, const DecodedTerrain& terrain,
                                    Map& resolved);

/// Where the rocks of a group start.
std::optional<Release> decode_release(DecodeContext& context, const Node& node, const DecodedTerrain& terrain,
                                      Map& resolved);

std::vector<BodyPlan> decode_bodies(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, Map& resolved);

/// `names`: the bodies, the groups, `terrain` and `terrain.<part>`.
std::vector<PairPlan> decode_pairs(DecodeContext& context, const Node& node,
                                   const std::vector<Material>& materials,
                                   const std::vector<std::string>& names, Map& resolved);

/// Also checks that gates and barriers stand within the profile.
std::vector<BarrierPlan> decode_barriers(DecodeContext& context, const Node& node,
                                         const std::optional<Profile>& profile, Map& resolved);
std::vector<GatePlan> decode_gates(DecodeContext& context, const Node& node,
                                   const std::optional<Profile>& profile, Map& resolved);

/// `groups`: the names of all groups of rocks.
std::vector<ClearancePlan> decode_clearances(DecodeContext& context, const Node& node,
                                             const std::vector<std::string>& groups, Map& resolved);

AirPlan decode_air(DecodeContext& context, const Node& node, Map& resolved);

SolverPlan decode_solver(DecodeContext& context, const std::optional<Node>& node, Map& resolved);
StopPlan decode_stop(DecodeContext& context, const std::optional<Node>& node, Map& resolved);
OutputPlan decode_output(DecodeContext& context, const std::optional<Node>& node, Map& resolved);

std::vector<Expectation> decode_expect(DecodeContext& context, const Node& node, const MeasureNames& names,
                                       Map& resolved);

/// Known keys of the scenario that this run does not read.
std::vector<std::string> find_not_used(const Node& root, const Scenario& scenario);

/// Reports an error at each element of a list whose `name` is already used by an earlier element; for names
/// of groups and bodies.
void refuse_duplicate_names(DecodeContext& context, const Node& list);

/// Decodes a list of elements with names. decode(element, map) reads one and appends what it read to `map`.
template <class Item, class Decode>
std::vector<Item> decode_list(DecodeContext& context, const Node& node, std::string_view key, Map& resolved,
                              Decode&& decode) {
  std::vector<Item> items;
  if (!node.expect_list(context.diagnostics)) return items;
  List list;
  for (const Node& item : node.items()) {
    if (!item.expect_map(context.diagnostics)) continue;
    Map map;
    if (const auto name = item.find("name")) check_name(context, *name);
    items.push_back(decode(item, map));
    list.push_back(map_value(std::move(map)));
  }
  refuse_duplicate_names(context, node);
  put(resolved, key, list_value(std::move(list)));
  return items;
}

}  // namespace flyrock
