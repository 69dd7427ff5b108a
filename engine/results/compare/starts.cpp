#include "results/compare/starts.h"

#include <algorithm>

#include "trial/blast_at.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

template <int D>
RockRecord at_start(const Trial<D>& trial, const TrialRock& rock, const Vec3& origin) {
  RockRecord record;
  record.group = rock.group;
  record.hole = hole_of(rock.key);
  record.reason = rock.world < 0 ? rock.reason : StopReason::stopped;
  if (rock.world < 0) return record;
  const World<D>& world = trial.worlds[static_cast<std::size_t>(rock.world)];
  const Vec<D>& place = world.bodies[static_cast<std::size_t>(rock.body)].x;
  record.start_x = place.x() + origin.x();
  record.start_y = place.y() + origin.y();
  return record;
}

template <int D>
SimulatedRows starts_in(const Scenario& scenario, std::uint64_t trials) {
  SimulatedTally tally(scenario);
  TrialBuilder<D> builder(scenario);
  for (std::uint64_t t = 0; t < std::min(trials, scenario.trials); ++t) {
    const Trial<D> trial = builder.build(t);
    TrialRecords records;
    for (const TrialRock& rock : trial.rocks) {
      records.rocks.push_back(at_start<D>(trial, rock, scenario.terrain.origin));
      records.rocks.back().trial = t;
    }
    tally.add(records);
  }
  return tally.result();
}

}  // namespace

SimulatedRows starts_of(const Scenario& scenario, std::uint64_t trials) {
  return scenario.dimension == 2 ? starts_in<2>(scenario, trials) : starts_in<3>(scenario, trials);
}

}  // namespace flyrock
