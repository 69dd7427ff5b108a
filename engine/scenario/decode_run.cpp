// The air, and how a run is computed, ended and stored: solver, stop, output. The last three may not vary
// within a run.

#include "scenario/decode_sections.h"

namespace flyrock {

AirPlan decode_air(DecodeContext& context, const Node& node, Map& resolved) {
  constexpr NumberRules rules{.varies = true, .scope = Scope::trial, .finest = Scope::rock};
  Map map;
  const Section section = decode_section(context, node, "air", rules, map);
  put(resolved, "air", map_value(std::move(map)));
  return {section.number("density"), section.number("cd"), section.vector("wind")};
}

SolverPlan decode_solver(DecodeContext& context, const std::optional<Node>& node, Map& resolved) {
  Map map;
  const Section section = decode_section(context, node, "solver", {}, map);
  put(resolved, "solver", map_value(std::move(map)));
  const bool chosen = section.text("time_step") == "auto";
  const bool stepped = section.text("flight") == "stepped";
  if (stepped && chosen)
    node->find("flight")->error(context.diagnostics,
                                "`stepped` asks for steps of one length, expected a number for `time_step`");
  return {.name = section.text("name"),
          .time_step = chosen ? std::nullopt : std::optional(section.constant("time_step")),
          .step_tolerance = section.constant("step_tolerance"),
          .theta = section.constant("theta"),
          .tolerance = section.constant("tolerance"),
          .max_iterations = section.integer("max_iterations"),
          .flight = stepped ? FlightMode::stepped : FlightMode::exact,
          .rest_speed = section.constant("rest_speed")};
}

StopPlan decode_stop(DecodeContext& context, const std::optional<Node>& node, Map& resolved) {
  Map map;
  const Section section = decode_section(context, node, "stop", {}, map);
  put(resolved, "stop", map_value(std::move(map)));
  return {section.constant("time"), section.constant("speed")};
}

OutputPlan decode_output(DecodeContext& context, const std::optional<Node>& node, Map& resolved) {
  Map map, trajectories_map;
  const Section section = decode_section(context, node, "output", {}, map);
  const Section trajectories = decode_section(context, node ? node->find("trajectories") : std::nullopt,
                                              "output.trajectories", {}, trajectories_map);
  put(map, "trajectories", map_value(std::move(trajectories_map)));
  put(resolved, "output", map_value(std::move(map)));
  return {trajectories.integer("first"), trajectories.constant("every"), section.constant("impacts") != 0,
          section.constant("hard_problems") != 0};
}

}  // namespace flyrock
