#include "load/rocks_of_trial.h"

#include <algorithm>

#include "trial/build_trial.h"

namespace flyrock {

void RocksOfTrial::add(const RocksOfTrial& other) {
  count += other.count;
  real += other.real;
  greatest = std::max(greatest, other.greatest);
}

std::vector<RocksOfTrial> rocks_of_a_trial(const Scenario& scenario) {
  std::vector<RocksOfTrial> groups(scenario.rocks.size());
  const auto count = [&](const auto& trial) {
    for (const TrialRock& rock : trial.rocks)
      groups.at(static_cast<std::size_t>(rock.group)).add({1, rock.weight, rock.weight});
  };
  if (scenario.dimension == 2)
    count(TrialBuilder<2>(scenario).build(0));
  else
    count(TrialBuilder<3>(scenario).build(0));
  return groups;
}

}  // namespace flyrock
