#pragma once
// One function for each section of a normalised scenario (decode_context.h). It reports what is wrong. Its
// result is used only if nothing was wrong.

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/profile.h"
#include "scenario/decode_params.h"
#include "scenario/measure.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The materials, sorted by name.
std::vector<Material> decode_materials(DecodeContext& context, const Node& node);

/// The index of the material that a node names; -1 if there is none, which is reported.
int find_material(DecodeContext& context, const Node& node, const std::vector<Material>& materials);

/// The terrain, with the data that checks of other sections need: its parts and zones, the names of its
/// faces, and in 2D its profile, as built in trial 0. There are no parts if it could not be built.
struct DecodedTerrain {
  TerrainPlan plan;
  std::vector<std::string> parts;
  std::vector<std::string> faces;
  std::optional<Profile> profile;
  std::vector<Mesh::Face> bench_faces = {};  ///< 3D
  Vec3 automatic_origin = Vec3::Zero();      ///< 3D: the origin where the scenario gives none
  std::string survey = {};                   ///< what was read of its file, "525 cells of 5 m, 2 to 31 m"
  std::string crs_of_file = {};              ///< "EPSG:2056"
  bool is_converted = false;  ///< its file had other units in plan: no code is that of its metres
};
DecodedTerrain decode_terrain(DecodeContext& context, const Node& node,
                              const std::vector<Material>& materials, bool needs_materials,
                              std::uint64_t seed);

/// The zones, faces and the origin of a terrain that was built.
void decode_places_of_terrain(DecodeContext& context, const Node& node, DecodedTerrain& terrain);

/// The ESRI ASCII grid that the key `key` of a section names; nothing if it cannot be read, which is reported
/// at `node`.
std::shared_ptr<const HeightGrid> read_raster(DecodeContext& context, const Node& node,
                                              const Section& section, const char* key);

BlastPlan decode_blast(DecodeContext& context, const Node& node);

/// The measured holes of a blast, `holes` and `scatter`, into its plan.
void decode_holes(DecodeContext& context, const Node& blast, BlastPlan& plan);
/// Completes each of them with all medians and reports what is wrong with it.
void complete_holes(DecodeContext& context, const Node& blast, BlastPlan& plan);

/// The indices of the holes of a list of names, or of the rows with these numbers. Reports those that are not
/// there.
std::vector<int> holes_named(Diagnostics& diagnostics, const Node& list, const std::vector<Hole>& holes,
                             bool are_rows);

/// The median of a number.
double middle_of(const DecodeContext& context, const Number& number);
/// The sources of the fields that the blast of all holes gives: they follow from themselves, the Gurney
/// constant perhaps from D.
BlastSources given_fields(const BlastPlan& plan);

/// Checks that need both the blast and the terrain: the length of the hole against the height of the bench.
void check_hole(DecodeContext& context, const Node& blast, const BlastPlan& plan, const TerrainPlan& terrain);

std::vector<RockGroup> decode_rocks(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials, const DecodedTerrain& terrain);

/// The table of a group of rocks; never null. Also checks that it and the other keys of the group together
/// say all of a rock, each only once.
std::shared_ptr<const RockTable> decode_rock_table(DecodeContext& context, const Node& group,
                                                   const Section& section);

/// What is measured. `groups` are those of the scenario, whose tables may have the rocks of the rows.
ObservedPlan decode_observed(DecodeContext& context, const Node& node, const Scenario& scenario);

/// Where the rocks of a group start.
std::optional<Release> decode_release(DecodeContext& context, const Node& node,
                                      const DecodedTerrain& terrain);

std::vector<BodyPlan> decode_bodies(DecodeContext& context, const Node& node,
                                    const std::vector<Material>& materials);

/// `bodies` are those of the scenario.
std::vector<LinkPlan> decode_links(DecodeContext& context, const Node& node,
                                   const std::vector<BodyPlan>& bodies);

/// `names`: the bodies, the groups, `terrain` and `terrain.<part>`.
std::vector<PairPlan> decode_pairs(DecodeContext& context, const Node& node,
                                   const std::vector<Material>& materials,
                                   const std::vector<std::string>& names);

/// Also checks that gates and barriers stand within the profile.
std::vector<BarrierPlan> decode_barriers(DecodeContext& context, const Node& node,
                                         const std::optional<Profile>& profile);
std::vector<GatePlan> decode_gates(DecodeContext& context, const Node& node,
                                   const std::optional<Profile>& profile);

/// Nothing if it cannot be decoded, which is reported.
std::optional<ForestPlan> decode_forest(DecodeContext& context, const Node& node,
                                        const DecodedTerrain& terrain);

/// `groups`: the names of all groups of rocks.
std::vector<ClearancePlan> decode_clearances(DecodeContext& context, const Node& node,
                                             const std::vector<std::string>& groups);

/// Also checks that they lie within the profile.
std::vector<ExposurePlan> decode_exposures(DecodeContext& context, const Node& node,
                                           const std::optional<Profile>& profile);

AirPlan decode_air(DecodeContext& context, const Node& node);

SolverPlan decode_solver(DecodeContext& context, const Node& node);
StopPlan decode_stop(DecodeContext& context, const Node& node);
SettlePlan decode_settle(DecodeContext& context, const Node& node);
/// Gives bodies the states of another run.
void decode_start(DecodeContext& context, const Node& node, std::vector<BodyPlan>& bodies);
/// `names`: of the bodies or of the groups of rocks; none if they have errors.
OutputPlan decode_output(DecodeContext& context, const Node& node, const std::vector<std::string>& names);

std::vector<Expectation> decode_expect(const Node& node, const MeasureNames& names);
/// Nothing if it is wrong, which is reported.
std::optional<AnswerPlan> decode_answer(const Node& node, const MeasureNames& names);

/// Refuses charges without the length over which they lie, where a model reads the charge per length or the
/// density of the explosive: it would compute with another charge.
void refuse_charges_without_length(const Node& root, const Scenario& scenario, Diagnostics& diagnostics);

/// Keys that the document gives and this run does not read.
std::vector<std::string> find_not_used(const Node& root, const Scenario& scenario);

/// The elements of a list. decode(element) reads one.
template <class Item, class Decode>
std::vector<Item> decode_list(const Node& node, Decode&& decode) {
  std::vector<Item> items;
  for (const Node& item : node.items())
    if (!item.value->is_null()) items.push_back(decode(item));
  return items;
}

}  // namespace flyrock
