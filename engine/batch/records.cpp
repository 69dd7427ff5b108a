#include "batch/records.h"

#include <algorithm>
#include <iterator>

namespace flyrock {

namespace {

constexpr std::size_t most_notes = 20;

template <class Row>
void append_rows(std::vector<Row>& to, std::vector<Row>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

void append(TrialRecords& to, TrialRecords&& from) {
  append_rows(to.rocks, std::move(from.rocks));
  append_rows(to.inputs, std::move(from.inputs));
  append_rows(to.impacts, std::move(from.impacts));
  append_rows(to.trajectories, std::move(from.trajectories));
  append_rows(to.gates, std::move(from.gates));
  append_rows(to.barriers, std::move(from.barriers));
  to.materials.resize(std::max(to.materials.size(), from.materials.size()));
  for (std::size_t i = 0; i < from.materials.size(); ++i) to.materials[i].add(from.materials[i]);
  to.quality.add(from.quality);
  to.times.add(from.times);
  for (std::string& note : from.notes)
    if (to.notes.size() < most_notes && std::find(to.notes.begin(), to.notes.end(), note) == to.notes.end())
      to.notes.push_back(std::move(note));
  if (!from.bodies.empty()) to.bodies = std::move(from.bodies);
}

}  // namespace flyrock
