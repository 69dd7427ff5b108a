// The air, and how a run is computed, ended and stored: solver, stop, output.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"

namespace flyrock {

AirPlan decode_air(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "air");
  return {section.number("density"), section.number("cd"), section.vector("wind")};
}

SolverPlan decode_solver(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "solver");
  const bool chosen = section.text("time_step") == "auto";
  const bool stepped = section.text("flight") == "stepped";
  if (stepped && chosen)
    node.find("flight")->error(context.diagnostics,
                               "`stepped` asks for steps of one length, expected a number for `time_step`");
  const bool one_by_one = section.text("impacts") == "one_by_one";
  if (stepped && one_by_one)
    node.find("impacts")->error(context.diagnostics,
                                "`one_by_one` needs the exact instant of each impact: `flight: exact`");
  DensePlan dense{.bodies = section.text("bodies")};
  if (dense.bodies == "dense" && (stepped || one_by_one))
    node.find("bodies")->error(context.diagnostics,
                               "dense steps need `flight: exact` and `impacts: together`");
  if (stepped) dense.bodies = "exact";
  if (!chosen) dense.time_step = section.constant("time_step");
  if (find_given(node, "tolerance")) dense.tolerance = section.constant("tolerance");
  if (find_given(node, "max_iterations")) dense.max_iterations = section.integer("max_iterations");
  return {.name = section.text("name"),
          .time_step = chosen ? std::nullopt : std::optional(section.constant("time_step")),
          .step_tolerance = section.constant("step_tolerance"),
          .theta = section.constant("theta"),
          .tolerance = section.constant("tolerance"),
          .max_iterations = section.integer("max_iterations"),
          .flight = stepped ? FlightMode::stepped : FlightMode::exact,
          .one_by_one = one_by_one,
          .rest_speed = section.constant("rest_speed"),
          .dense = dense};
}

StopPlan decode_stop(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "stop");
  return {section.constant("time"), section.constant("speed")};
}

SettlePlan decode_settle(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "settle");
  return {.until = section.constant("until"), .at_most = section.constant("at_most")};
}

RegionBox decode_region(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "output.series.regions");
  const std::vector<Vec3> corners = section.points("corners");
  RegionBox region{.name = section.text("name")};
  bool is_box = corners.size() == 2;
  for (int k = 0; k < context.dimension && is_box; ++k) is_box = corners[0][k] != corners[1][k];
  if (is_box) {
    region.low = corners[0].cwiseMin(corners[1]);
    region.high = corners[0].cwiseMax(corners[1]);
  } else if (const auto given = node.find("corners")) {
    given->error(context.diagnostics, "expected two opposite corners of a box");
  }
  return region;
}

SeriesPlan decode_series(DecodeContext& context, const Node& node, const std::vector<std::string>& names) {
  const Section section = decode_section(context, node, "output.series");
  SeriesPlan plan;
  if (const std::optional<Node> bodies = node.find("bodies"))
    for (const Node& item : bodies->items()) {
      const std::string* name = item.value->text();
      if (!name || name->empty()) continue;  // already reported
      if (!names.empty() && std::find(names.begin(), names.end(), *name) == names.end())
        item.error(context.diagnostics,
                   fmt::format("there is no body or group `{}`{}", *name, suggestion(*name, names)));
      plan.bodies.push_back(*name);
    }
  if (const std::optional<Node> regions = node.find("regions"))
    plan.regions =
        decode_list<RegionBox>(*regions, [&](const Node& item) { return decode_region(context, item); });
  plan.contacts = section.constant("contacts") != 0;
  plan.meshes = section.constant("meshes") != 0;
  plan.every = section.text("every") == "step" ? 0 : section.constant("every");
  plan.first = section.integer("first");
  return plan;
}

MapsPlan decode_maps(DecodeContext& context, const Node& node) {
  MapsPlan plan;
  if (const bool* wanted = node.value->boolean()) {
    plan.wanted = *wanted;
    return plan;
  }
  const Section section = decode_section(context, node, "output.maps");
  if (section.given("cell")) plan.cell = section.constant("cell");
  for (const Vec3& corner : section.points("region")) plan.region.emplace_back(corner.x(), corner.y());
  if (!section.given("region")) return plan;
  const bool corners = plan.region.size() == 2 && plan.region[0].x() != plan.region[1].x() &&
                       plan.region[0].y() != plan.region[1].y();
  if (!corners) {
    node.find("region")->error(context.diagnostics, "expected two opposite corners of a rectangle");
    plan.region.clear();
  }
  return plan;
}

OutputPlan decode_output(DecodeContext& context, const Node& node, const std::vector<std::string>& names) {
  const std::optional<Node> points = node.find("trajectories");
  if (!points) return {};  // already reported
  const Section section = decode_section(context, node, "output");
  const Section trajectories = decode_section(context, *points, "output.trajectories");
  OutputPlan plan{.trajectories_first = trajectories.integer("first"),
                  .trajectories_every = trajectories.constant("every"),
                  .impacts = section.constant("impacts") != 0,
                  .hard_problems = section.constant("hard_problems") != 0,
                  .rocks = section.constant("rocks") != 0,
                  .first = section.integer("first"),
                  .envelopes = section.constant("envelopes") != 0,
                  .rank_outcomes = section.constant("rank_outcomes") != 0,
                  .series = {},
                  .maps = {}};
  if (const std::optional<Node> series = node.find("series"))
    plan.series = decode_series(context, *series, names);
  if (const std::optional<Node> maps = node.find("maps")) plan.maps = decode_maps(context, *maps);
  return plan;
}

}  // namespace flyrock
