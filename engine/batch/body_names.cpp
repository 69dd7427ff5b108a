#include "batch/body_names.h"

#include <fmt/format.h>

namespace flyrock {

template <int D>
WorldNames names_of(const Scenario& scenario, const Trial<D>& trial, int world) {
  WorldNames names;
  names.parts = parts_of(*trial.terrain);
  names.bodies.resize(trial.worlds[static_cast<std::size_t>(world)].bodies.size());
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i) names.bodies[i] = scenario.bodies[i].name;
  for (std::size_t i = 0; scenario.bodies.empty() && i < trial.rocks.size(); ++i) {
    const TrialRock& rock = trial.rocks[i];
    if (rock.world != world) continue;
    names.bodies[static_cast<std::size_t>(rock.body)] =
        fmt::format("{} {}", scenario.rocks[static_cast<std::size_t>(rock.group)].name, i);
  }
  return names;
}

template WorldNames names_of(const Scenario&, const Trial<2>&, int);
template WorldNames names_of(const Scenario&, const Trial<3>&, int);

}  // namespace flyrock
