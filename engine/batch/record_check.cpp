#include "batch/record_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "batch/inputs.h"
#include "record/tables.h"

namespace flyrock {

namespace {

bool is_index(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

template <class Enum>
bool is_value(Enum value, Enum last) {
  return value >= Enum{} && value <= last;
}

/// The known numbers of a rock without fault must be finite, because samples are sorted by them. (Shares of
/// time and path may be unknown.)
bool has_finite_numbers(const RockRecord& rock) {
  bool finite = true;
  visit_rocks([&](const Column& column, auto get) {
    const auto& value = member_of(rock, get);
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>)
      finite = finite && (!column.name || !column.in_csv || std::isfinite(value));
  });
  return finite;
}

std::string rock_fault(const RockRecord& rock, const ChunkRange& range, std::size_t groups, std::size_t holes,
                       std::size_t branches) {
  if (rock.trial < range.first || rock.trial - range.first >= range.count)
    return fmt::format("a rock of trial {}, expected trials {} to {}", rock.trial, range.first,
                       range.first + range.count - 1);
  if (!is_index(rock.group, groups))
    return fmt::format("a rock of group {}, the scenario has {}", rock.group, groups);
  if (!is_index(rock.hole, holes))
    return fmt::format("a rock of hole {}, the scenario has {}", rock.hole, holes);
  if (!is_index(rock.branch, branches))
    return fmt::format("a rock of branch {}, the scenario has {}", rock.branch, branches);
  if (!(rock.weight > 0 && std::isfinite(rock.weight)))
    return fmt::format("rock {} of trial {} has no weight above 0", rock.rock, rock.trial);
  if (!is_value(rock.reason, StopReason::not_started)) return "a rock that stopped for no known reason";
  if (!is_fault(rock.reason) && !has_finite_numbers(rock))
    return fmt::format("rock {} of trial {} has numbers that are not finite", rock.rock, rock.trial);
  return {};
}

/// Whether each row belongs to a rock. Rows are sorted in the order of the rocks.
template <class Row>
bool of_rocks(const std::vector<Row>& rows, const std::vector<RockRecord>& rocks) {
  auto rock = rocks.begin();
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    rock = std::find_if(rock, rocks.end(),
                        [&](const RockRecord& r) { return r.trial == row.trial && r.rock == row.rock; });
    return rock != rocks.end();
  });
}

/// Whether this is a valid arrival of a rock at a gate or barrier, of which there are `count`.
bool is_arrival(const Arrival& arrival, int place, std::size_t count) {
  return is_index(place, count) && std::isfinite(arrival.time) && std::isfinite(arrival.speed) &&
         std::isfinite(arrival.kinetic_energy) && std::isfinite(arrival.height) &&
         std::isfinite(arrival.along);
}

bool are_arrivals(const TrialRecords& records, const Scenario& scenario) {
  const auto passes = [&](const GateRecord& row) {
    return is_arrival(row.passage, row.passage.gate, scenario.gates.size());
  };
  const auto hits = [&](const BarrierRecord& row) {
    return is_arrival(row.hit, row.hit.barrier, scenario.barriers.size()) &&
           is_value(row.hit.outcome, BarrierOutcome::over_energy);
  };
  return std::all_of(records.gates.begin(), records.gates.end(), passes) &&
         std::all_of(records.barriers.begin(), records.barriers.end(), hits);
}

bool are_tree_hits(const std::vector<TreeRecord>& rows, const Scenario& scenario) {
  return std::all_of(rows.begin(), rows.end(), [&](const TreeRecord& row) {
    const TreeHit& hit = row.hit;
    return scenario.forest && hit.tree >= 0 && std::isfinite(hit.time) && std::isfinite(hit.height) &&
           hit.energy_after >= 0 && hit.energy_after <= hit.energy_before && std::isfinite(hit.energy_before);
  });
}

/// Whether the rocks are sorted by trial and number, each once. Rows are looked up by this order.
bool in_order(const std::vector<RockRecord>& rocks) {
  const auto not_later = [](const RockRecord& a, const RockRecord& b) {
    return std::pair(a.trial, a.rock) >= std::pair(b.trial, b.rock);
  };
  return std::adjacent_find(rocks.begin(), rocks.end(), not_later) == rocks.end();
}

/// Whether a rock arrives twice at one gate or barrier. A gate or barrier acts once on each rock, so that
/// shares count rocks.
template <class Row, class Place>
bool arrives_twice(const std::vector<Row>& rows, Place&& place) {
  std::set<std::tuple<std::uint64_t, int, int>> seen;
  return !std::all_of(rows.begin(), rows.end(),
                      [&](const Row& row) { return seen.emplace(row.trial, row.rock, place(row)).second; });
}

}  // namespace

std::string records_fault(const TrialRecords& records, const ChunkRange& range, const Scenario& scenario) {
  const std::size_t groups = group_names(scenario).size();
  const std::size_t holes = scenario.blast ? static_cast<std::size_t>(scenario.blast->pattern.holes()) : 1;
  const std::size_t branches = scenario.branches.size() + 1;
  for (const RockRecord& rock : records.rocks)
    if (std::string fault = rock_fault(rock, range, groups, holes, branches); !fault.empty()) return fault;
  const auto& rocks = records.rocks;
  if (!in_order(rocks)) return "rocks out of order";
  bool all_of_rocks = true;
  visit_tables(records, [&](const Table& table, const auto& rows, auto) {
    if constexpr (requires { rows[0].rock; })
      if (table.owner == RowOwner::rock) all_of_rocks = all_of_rocks && of_rocks(rows, rocks);
  });
  if (!all_of_rocks) return "rows of a rock that it does not have";
  if (!are_arrivals(records, scenario))
    return "an arrival at a gate or barrier that the scenario does not have, or with numbers that are not "
           "finite";
  if (arrives_twice(records.gates, [](const GateRecord& row) { return row.passage.gate; }) ||
      arrives_twice(records.barriers, [](const BarrierRecord& row) { return row.hit.barrier; }))
    return "a rock that arrives twice at one gate or barrier";
  if (!are_tree_hits(records.trees, scenario))
    return "a hit of a tree in a scenario without a forest, or with numbers that cannot be";
  if (arrives_twice(records.trees, [](const TreeRecord& row) { return row.hit.tree; }))
    return "a rock that hits one tree twice";
  const std::size_t inputs = inputs_of(scenario).size();
  for (const InputRecord& input : records.inputs)
    if (!is_index(input.input, inputs))
      return fmt::format("input {}, the scenario has {}", input.input, inputs);
  for (const TrajectoryRecord& row : records.trajectories)
    if (!is_value(row.point.mode, TravelMode::roll))
      return "a point of a trajectory of no known mode of travel";
  for (const TrialRow<BlockRow>& block : records.blocks)
    if (!is_value(block.row.mode, BlockMode::locked)) return "a block with no known mode";
  for (const TrialRow<DrawnLink>& link : records.links)
    if (!is_value(link.row.type, LinkType::rope)) return "a link of no known type";
  for (const TrialRow<SeriesContact>& contact : records.series_contacts)
    if (!is_value(contact.row.state, SeriesState::after_impact))
      return "a contact of a series in no known state";
  for (const BodyHistory& body : records.totals.bodies)
    if (!is_value(body.reason, StopReason::not_started)) return "a body that stopped for no known reason";
  return {};
}

}  // namespace flyrock
