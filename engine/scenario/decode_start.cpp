// Bodies that start where those of another run ended.

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode_sections.h"
#include "scenario/last_states.h"

namespace flyrock {

namespace {

/// The bodies of `start.bodies`, or all that are neither fixed nor driven.
std::vector<BodyPlan*> starting_bodies(DecodeContext& context, const Node& node,
                                       std::vector<BodyPlan>& bodies) {
  std::vector<BodyPlan*> starting;
  const std::optional<Node> list = node.find("bodies");
  if (!list) {
    for (BodyPlan& body : bodies)
      if (body.is_moved()) starting.push_back(&body);
    return starting;
  }
  std::vector<std::string> names;
  for (const BodyPlan& body : bodies)
    if (body.is_moved()) names.push_back(body.name);
  for (const Node& item : list->items()) {
    const std::string* name = item.value->text();
    if (!name) continue;  // already reported
    const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const BodyPlan& body) {
      return body.name == *name && body.is_moved();
    });
    if (found == bodies.end())
      item.error(context.diagnostics,
                 fmt::format("there is no body `{}` that is neither `fixed` nor `driven`{}", *name,
                             suggestion(*name, names)));
    else
      starting.push_back(&*found);
  }
  return starting;
}

}  // namespace

void decode_start(DecodeContext& context, const Node& node, std::vector<BodyPlan>& bodies) {
  const std::size_t errors = context.diagnostics.errors_given();
  const Section section = decode_section(context, node, "start");
  const std::vector<BodyPlan*> starting = starting_bodies(context, node, bodies);
  if (context.diagnostics.errors_given() > errors || section.text("from").empty()) return;
  const auto states = read_last_states(context, node, section.text("from"), section.integer("point"),
                                       section.integer("trial"));
  if (states.empty()) return;  // reported
  std::vector<std::string> missing;
  for (BodyPlan* body : starting) {
    const auto found = states.find(body->name);
    if (found == states.end())
      missing.push_back(body->name);
    else
      body->start = found->second;
  }
  if (missing.empty()) return;
  const std::string more = missing.size() > 1 ? fmt::format(" and {} more", missing.size() - 1) : "";
  node.find("from")->error(context.diagnostics,
                           fmt::format("the run has no body `{}`{}; `bodies` names those that start there",
                                       missing.front(), more));
}

}  // namespace flyrock
