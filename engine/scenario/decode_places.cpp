// Places and distances at which the rocks are evaluated: barriers, gates, clearances. None of their values
// may vary within a run.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/off_terrain.h"
#include "scenario/decode_sections.h"

namespace flyrock {

namespace {

/// Reads where a gate or barrier stands into its plan. Checks that `x` lies on the terrain of the first
/// trial. (In 3D that is checked when trials are tried out.)
template <class Place>
void read_place(DecodeContext& context, const Node& item, const Section& section,
                const std::optional<Profile>& profile, Place& plan) {
  if (context.dimension == 3) {
    if (section.given("x") == section.given("line"))
      return item.error(context.diagnostics, section.given("x")
                                                 ? "has both `x` and `line`, expected one of them"
                                                 : "expected `x` or `line`, which say where it stands");
    for (const Vec3& point : section.points("line")) plan.line.emplace_back(point.x(), point.y());
    if (section.given("x")) plan.x = section.constant("x");
    return;
  }
  plan.x = section.constant("x");
  const auto x = item.find("x");
  if (!x || !section.given("x") || !profile) return;
  const double at = section.constant("x");
  if (at > profile->x_min() && at < profile->x_max()) return;
  x->error(context.diagnostics, off_terrain(at, profile->x_min(), profile->x_max()));
}

/// The group of rocks of a clearance; -1 for all groups.
int decode_group(DecodeContext& context, const Node& item, const Section& section,
                 const std::vector<std::string>& groups) {
  if (!section.given("group")) return -1;
  const std::string& name = section.text("group");
  const auto found = std::find(groups.begin(), groups.end(), name);
  if (found != groups.end()) return static_cast<int>(found - groups.begin());
  item.find("group")->error(context.diagnostics,
                            fmt::format("`{}` is not a group of `rocks`{}", name, suggestion(name, groups)));
  return -1;
}

/// The sectors of a clearance by azimuth, about all release places or about a point.
void decode_sectors(DecodeContext& context, const Node& item, const Section& section, ClearancePlan& plan) {
  const auto error_at = [&](const char* key, const char* text) {
    item.find(key)->error(context.diagnostics, text);
  };
  if (section.given("x") || section.given("y"))
    plan.about =
        Vec2(section.given("x") ? section.constant("x") : 0, section.given("y") ? section.constant("y") : 0);
  for (const char* key : {"x", "y"})
    if (section.given(key) && !section.given("sectors"))
      error_at(key, "is the centre of the sectors, but `sectors` is missing");
  if (!section.given("sectors")) return;
  plan.sectors = section.integer("sectors");
  if (context.dimension != 3) error_at("sectors", "divide the azimuth, which needs dimension 3");
  if (plan.of_max_distance) error_at("of", "max_distance has no direction: `sectors` go with runout");
}

void decode_least_area(DecodeContext& context, const Node& item, const Section& section,
                       ClearancePlan& plan) {
  if (section.given("radius")) plan.radius = section.constant("radius");
  plan.least_area = section.given("area");
  if (section.given("radius") && !plan.least_area)
    item.find("radius")->error(context.diagnostics,
                               "is that of the kernel of `area: least`, but `area` is missing");
  if (!plan.least_area) return;
  if (context.dimension != 3)
    item.find("area")->error(context.diagnostics, "lies in plan, which needs dimension 3");
  if (plan.of_max_distance)
    item.find("of")->error(context.diagnostics, "max_distance has no place: `area` goes with runout");
}

/// The part of the time in which someone is there, of the traffic if that is given.
double decode_occupied(DecodeContext& context, const Node& item, const Section& section) {
  const bool of_traffic = section.given("vehicles_per_hour");
  if (of_traffic != section.given("speed") || (of_traffic && !section.given("length"))) {
    item.error(context.diagnostics, "expected `vehicles_per_hour`, `length` and `speed` together");
    return 1;
  }
  if (!of_traffic) return section.given("occupied") ? section.constant("occupied") : 1;
  if (section.given("occupied"))
    item.find("occupied")
        ->error(context.diagnostics, "follows from `vehicles_per_hour`, expected one of them");
  const double occupied =
      section.constant("vehicles_per_hour") / 3600 * section.constant("length") / section.constant("speed");
  if (occupied > 1)
    item.find("vehicles_per_hour")
        ->error(context.diagnostics, fmt::format("fill {:.3g} times the road at this speed", occupied));
  return occupied;
}

/// Reads where someone is exposed into its plan.
void read_exposed_place(DecodeContext& context, const Node& item, const Section& section,
                        const std::optional<Profile>& profile, ExposurePlan& plan) {
  if (context.dimension == 2) {
    plan.at = {section.constant("at"), 0};
    plan.spread = section.constant("spread");
    if (profile && section.given("at") && !(plan.at.x() > profile->x_min() && plan.at.x() < profile->x_max()))
      item.find("at")->error(context.diagnostics,
                             off_terrain(plan.at.x(), profile->x_min(), profile->x_max()));
    return;
  }
  if (section.given("at") == section.given("line"))
    return item.error(context.diagnostics, section.given("at")
                                               ? "has both `at` and `line`, expected one of them"
                                               : "expected `at` or `line`, which say where it is");
  for (const Vec3& point : section.points("line")) plan.line.emplace_back(point.x(), point.y());
  if (const std::vector<Number>& at = section.vector("at"); section.given("at") && at.size() == 2)
    plan.at = {at[0].constant, at[1].constant};
  if (!section.given("radius")) return;
  plan.radius = section.constant("radius");
  if (const double least = plan.least_radius(); plan.radius < least)
    item.find("radius")->error(
        context.diagnostics,
        fmt::format("is too small for an area of {:.4g} m2, expected at least {:.3g} m", plan.area, least));
}

}  // namespace

std::vector<BarrierPlan> decode_barriers(DecodeContext& context, const Node& node,
                                         const std::optional<Profile>& profile) {
  return decode_list<BarrierPlan>(node, [&](const Node& item) {
    const Section section = decode_section(context, item, place_section("barriers", context.dimension));
    BarrierPlan plan{.name = section.text("name"),
                     .height = section.constant("height"),
                     .capacity = section.constant("capacity"),
                     .inclination = section.constant("inclination"),
                     .freeboard = section.constant("freeboard"),
                     .service_level = section.text("level") == "sel",
                     .energy_factor = section.constant("energy_factor"),
                     .height_factor = section.constant("height_factor")};
    read_place(context, item, section, profile, plan);
    if (section.given("height") && plan.height > 0 && plan.held_height() <= 0)
      item.error(context.diagnostics,
                 fmt::format("holds no rock: height x cos(inclination) is {:.4g} m, expected more than the "
                             "freeboard of {:.4g} m",
                             plan.held_height() + plan.freeboard, plan.freeboard));
    return plan;
  });
}

std::vector<GatePlan> decode_gates(DecodeContext& context, const Node& node,
                                   const std::optional<Profile>& profile) {
  return decode_list<GatePlan>(node, [&](const Node& item) {
    const Section section = decode_section(context, item, place_section("gates", context.dimension));
    GatePlan plan{.name = section.text("name")};
    read_place(context, item, section, profile, plan);
    return plan;
  });
}

std::vector<ClearancePlan> decode_clearances(DecodeContext& context, const Node& node,
                                             const std::vector<std::string>& groups) {
  return decode_list<ClearancePlan>(node, [&](const Node& item) {
    const Section section = decode_section(context, item, "clearance");
    ClearancePlan plan{.name = section.text("name"),
                       .group = decode_group(context, item, section, groups),
                       .probability = section.constant("probability"),
                       .confidence = section.constant("confidence")};
    if (section.given("factor")) plan.factor = section.constant("factor");
    if (section.given("customary")) plan.customary = section.constant("customary");
    if (section.given("known_throw")) plan.known_throw = section.constant("known_throw");
    if (section.given("blasts_per_year")) plan.blasts_per_year = section.constant("blasts_per_year");
    plan.per_blast = section.text("per") == "blast";
    plan.of_max_distance = section.text("of") == "max_distance";
    decode_sectors(context, item, section, plan);
    decode_least_area(context, item, section, plan);
    return plan;
  });
}

std::vector<ExposurePlan> decode_exposures(DecodeContext& context, const Node& node,
                                           const std::optional<Profile>& profile) {
  return decode_list<ExposurePlan>(node, [&](const Node& item) {
    const int dimension = std::exchange(context.dimension, 2);  // places in plan have two coordinates
    const Section section = decode_section(context, item, place_section("exposure", dimension));
    context.dimension = dimension;
    ExposurePlan plan;
    plan.name = section.text("name");
    plan.area = section.constant("area");
    if (section.given("length")) plan.length = section.constant("length");
    plan.blasts_per_year = section.constant("blasts_per_year");
    if (section.given("limit_per_blast")) plan.limit_per_blast = section.constant("limit_per_blast");
    if (section.given("limit_per_year")) plan.limit_per_year = section.constant("limit_per_year");
    plan.energy = section.constant("energy");
    plan.occupied = decode_occupied(context, item, section);
    plan.is_stream = section.given("vehicles_per_hour");
    read_exposed_place(context, item, section, profile, plan);
    return plan;
  });
}

}  // namespace flyrock
