#include "trial/load_tables.h"

#include <algorithm>

namespace flyrock {

LoadTables load_tables_of(const Scenario& scenario) {
  LoadTables loads;
  const auto take = [&](const std::shared_ptr<const OverTime>& table) {
    if (table) loads.last_change = std::max(loads.last_change, table->last_change());
    return table.get();
  };
  loads.gravity = take(scenario.gravity_over_time);
  for (const BodyPlan& body : scenario.bodies) loads.of_body.push_back(take(body.over_time));
  for (const Material& material : scenario.materials) take(material.mu_over_time);
  return loads;
}

}  // namespace flyrock
