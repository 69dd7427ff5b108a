#pragma once
// The series (`output.series`) of a trial: what is asked of its worlds, and their rows as records.

#include "flight/series_recorder.h"
#include "record/records.h"
#include "trial/build_trial.h"

namespace flyrock {

/// Whether a trial has series.
bool has_series(const Scenario& scenario, std::uint64_t trial);

/// What a world of a trial records into `rows`. Instantiated for D = 2, 3.
template <int D>
SeriesRequest series_of(const Scenario& scenario, const Trial<D>& trial, int world, Series& rows);

void add_series(std::uint64_t trial, Series rows, TrialRecords& out);

}  // namespace flyrock
