#include "results/compare/simulated_rows.h"

#include <algorithm>

namespace flyrock {

SimulatedTally::SimulatedTally(const Scenario& scenario)
    : plan_(*scenario.observed), dimension_(scenario.dimension), seen_(scenario.rocks.size(), 0) {
  for (const RockGroup& group : scenario.rocks)
    row_of_line_.emplace_back(group.table ? group.table->rocks.size() : 0, -1);
  for (std::size_t r = 0; r < plan_.rows.size() && plan_.rows[r].rock_line >= 0; ++r)
    row_of_line_[static_cast<std::size_t>(plan_.rows[r].rock_group)]
                [static_cast<std::size_t>(plan_.rows[r].rock_line)] = static_cast<int>(r);
  if (plan_.per == ObservedUnit::hole) row_of_hole_.assign(scenario.blast->pattern.measured.size(), -1);
  for (std::size_t r = 0; r < plan_.rows.size(); ++r)
    if (plan_.rows[r].hole >= 0)
      row_of_hole_[static_cast<std::size_t>(plan_.rows[r].hole)] = static_cast<int>(r);
  rows_.rows.resize(plan_.is_paired() ? plan_.rows.size() : 1);
  starts_.assign(rows_.rows.size(), 0);
  farthest_.resize(rows_.rows.size());
}

void SimulatedTally::end_trial() {
  if (!is_open_) return;
  is_open_ = false;
  ++rows_.trials;
  for (std::size_t r = 0; r < farthest_.size(); ++r) {
    if (!farthest_[r]) continue;
    rows_.rows[r].values.push_back(*farthest_[r]);
    farthest_[r].reset();
    ++values_;
  }
  std::fill(seen_.begin(), seen_.end(), std::size_t{0});
  is_full_ = values_ >= most_values;
}

SimulatedRow* SimulatedTally::row_of(const RockRecord& rock) {
  const std::size_t line = seen_[static_cast<std::size_t>(rock.group)]++;
  if (!plan_.is_paired()) return &rows_.rows.front();
  if (!row_of_hole_.empty()) {
    const int row = row_of_hole_[static_cast<std::size_t>(rock.hole)];
    return row < 0 ? nullptr : &rows_.rows[static_cast<std::size_t>(row)];
  }
  const std::vector<int>& of_line = row_of_line_[static_cast<std::size_t>(rock.group)];
  const int row = line < of_line.size() ? of_line[line] : -1;
  return row < 0 ? nullptr : &rows_.rows[static_cast<std::size_t>(row)];
}

Vec2 SimulatedTally::value_of(const RockRecord& rock) const {
  if (plan_.of == ObservedNumber::place) return in_plan(rock.stop_x, rock.stop_y);
  return {plan_.of == ObservedNumber::runout ? rock.runout : rock.max_distance, 0};
}

void SimulatedTally::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_open_ && rock.trial != trial_) end_trial();
    if (is_full_) return;
    is_open_ = true;
    trial_ = rock.trial;
    SimulatedRow* row = row_of(rock);
    if (!row) continue;
    if (is_fault(rock.reason)) {
      ++row->lost;
      continue;
    }
    row->start += in_plan(rock.start_x, rock.start_y);
    const auto index = static_cast<std::size_t>(row - rows_.rows.data());
    ++starts_[index];
    const SimulatedValue value{rock.trial, value_of(rock), rock.censored};
    if (plan_.per == ObservedUnit::rock) {
      row->values.push_back(value);
      ++values_;
    } else if (!farthest_[index] || farthest_[index]->value.x() < value.value.x()) {
      farthest_[index] = value;
    }
  }
}

SimulatedRows SimulatedTally::result() {
  end_trial();
  for (std::size_t r = 0; r < rows_.rows.size(); ++r)
    rows_.rows[r].start /= static_cast<double>(starts_[r]);  // NaN where none started
  return std::move(rows_);
}

}  // namespace flyrock
