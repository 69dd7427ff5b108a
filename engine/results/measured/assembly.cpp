#include "results/measured/assembly.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace flyrock {

namespace {

/// The parts of a state of which an assembly has a least, a greatest and a mean.
template <class Use>
void each_part(BodyState& to, const BodyState& from, Use use) {
  for (int k = 0; k < 3; ++k) use(to.position[k], from.position[k]);
  for (int k = 0; k < 3; ++k) use(to.velocity[k], from.velocity[k]);
  use(to.kinetic_energy, from.kinetic_energy);
}

}  // namespace

std::vector<bool> moving_bodies(const Scenario& scenario) {
  std::vector<bool> moving;
  for (const BodyPlan& body : scenario.bodies) moving.push_back(body.is_moved());
  return moving;
}

Assembly assembly_of(const std::vector<bool>& moving, const std::vector<BodyHistory>& bodies) {
  Assembly assembly;
  for (std::size_t i = 0; i < std::min(bodies.size(), moving.size()); ++i) {
    if (!moving[i]) continue;
    const BodyHistory& body = bodies[i];
    if (assembly.bodies++ == 0) {
      assembly.low = assembly.high = assembly.mean = body.last;
    } else {
      each_part(assembly.low, body.last, [](double& to, double from) { to = std::min(to, from); });
      each_part(assembly.high, body.last, [](double& to, double from) { to = std::max(to, from); });
      each_part(assembly.mean, body.last, [](double& to, double from) { to += from; });
    }
    if (body.reason != StopReason::stopped) continue;
    ++assembly.at_rest;
    assembly.settled = std::max(assembly.settled, body.stop_time);
  }
  if (assembly.bodies > 0) each_part(assembly.mean, {}, [&](double& to, double) { to /= assembly.bodies; });
  return assembly;
}

std::string assembly_text(const Assembly& assembly, std::size_t moved, int dimension) {
  std::string text = fmt::format("{} of {} bodies moved; ", moved, assembly.bodies);
  if (assembly.at_rest == 0)
    text += "none is at rest.";
  else
    text += fmt::format("{} {} at rest, the last one since {:.4g} s.",
                        assembly.at_rest == assembly.bodies ? "all" : std::to_string(assembly.at_rest),
                        assembly.at_rest == 1 ? "is" : "are", assembly.settled);
  std::vector<std::string> extents;
  for (int k = 0; k < dimension; ++k)
    extents.push_back(fmt::format("from {} = {:.4g} to {:.4g} m", "xyz"[k], assembly.low.position[k],
                                  assembly.high.position[k]));
  return text + fmt::format(" The centres of all lie {}.", fmt::join(extents, ", "));
}

}  // namespace flyrock
