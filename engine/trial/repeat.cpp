#include "trial/repeat.h"

#include <algorithm>
#include <cmath>

#include "trial/build_trial.h"

namespace flyrock {

namespace {

/// The draws of materials: each rock gets them anew with its surfaces.
std::vector<bool> draws_of_materials(const Scenario& scenario) {
  std::vector<bool> marked(scenario.draws.size(), false);
  const auto mark = [&](const Number& number) {
    if (!number.is_constant()) marked[static_cast<std::size_t>(number.draw)] = true;
  };
  for (const Material& material : scenario.materials) {
    for (const auto* law :
         {&material.restitution, &material.friction, &material.rolling, &material.unilateral})
      if (*law) std::for_each((*law)->slots.begin(), (*law)->slots.end(), mark);
    if (material.roughness) mark(*material.roughness);
  }
  return marked;
}

/// Whether the place of a rock depends on its orientation.
bool needs_orientation(const std::optional<Release>& release) {
  if (!release || release->kind == ReleaseKind::position) return false;
  return release->kind != ReleaseKind::above_ground || release->on_ground;
}

bool is_lowered(const TableRock* line) { return line && line->on_ground; }

}  // namespace

bool is_native(const PluginUse& use) {
  if (use.plugin->spec.native.empty()) return false;
  for (const ParamValue& value : use.values)
    if (value.parts && !std::all_of(value.parts->begin(), value.parts->end(),
                                    [](const ShapePart& part) { return is_native(part.shape); }))
      return false;
  return true;
}

bool may_repeat(const Scenario& scenario) {
  if (scenario.method == Method::nscd || !scenario.bodies.empty() || scenario.rock_contacts ||
      !scenario.branches.empty())
    return false;
  for (const RockGroup& group : scenario.rocks)
    if (!is_native(group.population) || (group.launch && !is_native(*group.launch))) return false;
  const std::vector<bool> of_material = draws_of_materials(scenario);
  for (std::size_t i = 0; i < scenario.draws.size(); ++i)
    if ((scenario.draws[i].scope != Scope::run || scenario.outer > 1) && !of_material[i]) return false;
  return true;
}

template <int D>
bool TrialBuilder<D>::starts_alike(const Trial<D>& trial) const {
  if (!may_repeat_ || !kept_terrain_) return false;
  return std::all_of(trial.rocks.begin(), trial.rocks.end(), [&](const TrialRock& rock) {
    const bool turned = !std::isnan(rock.outcomes[Outcome::orientation]);
    return rock.world >= 0 && !rock.start_is_drawn &&
           !(turned && (needs_orientation(scenario_.rocks[rock.group].release) || is_lowered(line_of(rock))));
  });
}

/// Reuses the memory of a finished trial for the trial of another number.
template <int D>
void TrialBuilder<D>::begin_again(Trial<D>& trial, std::uint64_t number) {
  for (TrialRock& rock : trial.rocks) {
    rock.key.trial = number;
    rock.fault.clear();
    rock.reason = StopReason::not_started;
    World<D>& world = trial.worlds[rock.world];
    Body<D>& body = world.bodies[rock.body];
    world.quality() = {};
    body.x = trial.starts[rock.world];
    if (!std::isnan(rock.outcomes[Outcome::orientation])) {
      body.attitude = last_made(rock).body.attitude;
      turn_at_random(rock, body);
    }
    if (scenario_.method == Method::lumped_mass) trial.laws[rock.world].begin_rock(rock.key);
  }
}

template bool TrialBuilder<2>::starts_alike(const Trial<2>&) const;
template bool TrialBuilder<3>::starts_alike(const Trial<3>&) const;
template void TrialBuilder<2>::begin_again(Trial<2>&, std::uint64_t);
template void TrialBuilder<3>::begin_again(Trial<3>&, std::uint64_t);

}  // namespace flyrock
