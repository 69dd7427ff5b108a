// The air, and how a run is computed, ended and stored: solver, stop, output.

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
  return {.name = section.text("name"),
          .time_step = chosen ? std::nullopt : std::optional(section.constant("time_step")),
          .step_tolerance = section.constant("step_tolerance"),
          .theta = section.constant("theta"),
          .tolerance = section.constant("tolerance"),
          .max_iterations = section.integer("max_iterations"),
          .flight = stepped ? FlightMode::stepped : FlightMode::exact,
          .rest_speed = section.constant("rest_speed")};
}

StopPlan decode_stop(DecodeContext& context, const Node& node) {
  const Section section = decode_section(context, node, "stop");
  return {section.constant("time"), section.constant("speed")};
}

OutputPlan decode_output(DecodeContext& context, const Node& node) {
  const std::optional<Node> points = node.find("trajectories");
  if (!points) return {};  // already reported
  const Section section = decode_section(context, node, "output");
  const Section trajectories = decode_section(context, *points, "output.trajectories");
  return {trajectories.integer("first"), trajectories.constant("every"), section.constant("impacts") != 0,
          section.constant("hard_problems") != 0, section.constant("rank_outcomes") != 0};
}

}  // namespace flyrock
