#include "record/records.h"

#include <algorithm>

namespace flyrock {

namespace {

constexpr std::size_t most_notes = 20;

}  // namespace

void TrialTotals::add(const TrialTotals& later) {
  materials.resize(std::max(materials.size(), later.materials.size()));
  for (std::size_t i = 0; i < later.materials.size(); ++i) materials[i].add(later.materials[i]);
  envelopes.add(later.envelopes);
  maps.add(later.maps);
  quality.add(later.quality);
  times.add(later.times);
  for (const std::string& note : later.notes) add_note(note);
  if (!later.bodies.empty()) bodies = later.bodies;
}

void TrialTotals::add_note(const std::string& note) {
  if (notes.size() < most_notes && std::find(notes.begin(), notes.end(), note) == notes.end())
    notes.push_back(note);
}

bool is_fault(StopReason reason) {
  return reason == StopReason::diverged || reason == StopReason::plugin_error ||
         reason == StopReason::not_started;
}

}  // namespace flyrock
