#include "batch/series_rows.h"

#include <algorithm>

#include "batch/body_names.h"

namespace flyrock {

bool has_series(const Scenario& scenario, std::uint64_t trial) {
  return scenario.output.series && trial < static_cast<std::uint64_t>(scenario.output.series->first);
}

template <int D>
SeriesRequest series_of(const Scenario& scenario, const Trial<D>& trial, int world, Series& rows) {
  const SeriesPlan& plan = *scenario.output.series;
  SeriesRequest request;
  request.names = names_of(scenario, trial, world);
  request.wanted.resize(request.names.bodies.size());
  request.contacts = plan.contacts;
  request.regions = plan.regions;
  request.meshes = plan.meshes;
  request.every = plan.every;
  request.rows = &rows;
  const auto wanted = [&](const std::string& name) {
    return plan.bodies.empty() ||
           std::find(plan.bodies.begin(), plan.bodies.end(), name) != plan.bodies.end();
  };
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
    request.wanted[i] = wanted(scenario.bodies[i].name);
  for (const TrialRock& rock : trial.rocks)
    if (scenario.bodies.empty() && rock.world == world)
      request.wanted[static_cast<std::size_t>(rock.body)] =
          wanted(scenario.rocks[static_cast<std::size_t>(rock.group)].name);
  return request;
}

void add_series(std::uint64_t trial, Series rows, TrialRecords& out) {
  for (SeriesBody& row : rows.bodies) out.series_bodies.push_back({trial, std::move(row)});
  for (SeriesContact& row : rows.contacts) out.series_contacts.push_back({trial, std::move(row)});
  for (SeriesLink& row : rows.links) out.series_links.push_back({trial, std::move(row)});
  for (SeriesRegion& row : rows.regions) out.series_regions.push_back({trial, std::move(row)});
  for (const SeriesSolve& row : rows.solves) out.series_solves.push_back({trial, row});
  for (SeriesStress& row : rows.stresses) out.series_stress.push_back({trial, std::move(row)});
  for (SeriesNode& row : rows.nodes) out.series_nodes.push_back({trial, std::move(row)});
  for (SeriesCell& row : rows.cells) out.series_cells.push_back({trial, std::move(row)});
}

template SeriesRequest series_of(const Scenario&, const Trial<2>&, int, Series&);
template SeriesRequest series_of(const Scenario&, const Trial<3>&, int, Series&);

}  // namespace flyrock
