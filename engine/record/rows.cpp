#include "record/rows.h"

#include <memory>

#include "record/tables.h"

namespace flyrock {

namespace {

/// The rows of some trials.
TrialRecords rows_within(TrialRecords records, const TrialRange& trials) {
  visit_tables(records, [&](const Table&, auto& rows, auto) {
    std::erase_if(rows, [&](const auto& row) { return !trials.meets(row.trial, 1); });
  });
  return records;
}

}  // namespace

Rows rows_of(TrialRecords records) {
  return Rows([kept = std::make_shared<const TrialRecords>(std::move(records))](
                  Part, const TrialRange& trials, const SeeRows& see) {
    const bool all = kept->rocks.empty() ||
                     (trials.first <= kept->rocks.front().trial && trials.end > kept->rocks.back().trial);
    all ? see(*kept) : see(rows_within(*kept, trials));
  });
}

}  // namespace flyrock
