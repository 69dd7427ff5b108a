#include "results/compare/simulate.h"

#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

#include "batch/trial.h"
#include "files/safe_file.h"
#include "files/sha256.h"
#include "flight/run.h"

namespace flyrock {

namespace {

/// What is recorded beside the rocks costs time and is not read.
void record_rocks_only(Scenario& scenario) {
  scenario.output.trajectories_first = 0;
  scenario.output.impacts = false;
  scenario.output.envelopes = false;
  scenario.output.maps.wanted = false;
  scenario.output.series.reset();
  scenario.output.hard_problems = false;
}

/// The trials from `first` to `end` by one thread.
TrialRecords run_trials(TrialRunner& runner, std::uint64_t first, std::uint64_t end) {
  TrialRecords kept;
  for (std::uint64_t trial = first; trial < end; ++trial) {
    TrialRecords records;
    runner.run(trial, records);
    kept.rocks.insert(kept.rocks.end(), records.rocks.begin(), records.rocks.end());
  }
  return kept;
}

}  // namespace

SimulatedRows simulate(const SimulatedScenario& scenario, const LoadedScenario& loaded, int threads,
                       bool (*interrupted)()) {
  const std::uint64_t trials = loaded.plan.points.front().trials;
  const auto parts = static_cast<std::uint64_t>(
      std::clamp<std::uint64_t>(static_cast<std::uint64_t>(threads), 1, std::max<std::uint64_t>(1, trials)));
  std::vector<TrialRecords> records(parts);
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&](std::uint64_t part) {
    try {
      // Each thread reads the scenario for itself, because a Lua state serves one thread at a time.
      Diagnostics diagnostics;
      std::optional<LoadedScenario> own =
          load_scenario(scenario.path, scenario.overrides, diagnostics, Prints::collected, &loaded);
      if (!own) throw FileError(diagnostics.to_text());
      Scenario& point = own->plan.points.front();
      record_rocks_only(point);
      TrialRunner runner(point);
      runner.stop_when(interrupted);
      records[part] = run_trials(runner, part * trials / parts, (part + 1) * trials / parts);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::uint64_t part = 1; part < parts; ++part) others.emplace_back(work, part);
    work(0);
  }
  if (error) std::rethrow_exception(error);
  SimulatedTally tally(loaded.plan.points.front());
  for (const TrialRecords& part : records) tally.add(part);
  return tally.result();
}

namespace {

constexpr std::string_view format_of_rows = "flyrock rows 1\n";

void put(std::string& bytes, const auto& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Reads numbers from bytes; false at their end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  bool take(T& number) {
    if (bytes_.size() < sizeof number) return false;
    std::memcpy(&number, bytes_.data(), sizeof number);
    bytes_.remove_prefix(sizeof number);
    return true;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

constexpr std::size_t bytes_of_value = sizeof(std::uint64_t) + 2 * sizeof(double) + 1;

}  // namespace

std::string stored(const SimulatedRows& rows, const std::string& key) {
  std::string body = key + '\n';
  put(body, rows.trials);
  put(body, static_cast<std::uint64_t>(rows.rows.size()));
  for (const SimulatedRow& row : rows.rows) {
    put(body, row.start.x());
    put(body, row.start.y());
    put(body, row.lost);
    put(body, static_cast<std::uint64_t>(row.values.size()));
    for (const SimulatedValue& value : row.values) {
      put(body, value.trial);
      put(body, value.value.x());
      put(body, value.value.y());
      body += value.censored ? '\1' : '\0';
    }
  }
  return std::string(format_of_rows) + sha256(body) + '\n' + body;
}

std::optional<SimulatedRows> restored(const std::string& bytes, const std::string& key) {
  constexpr std::size_t digest = 64;
  const std::size_t head = format_of_rows.size() + digest + 1;
  if (!bytes.starts_with(format_of_rows) || bytes.size() < head + key.size() + 1) return std::nullopt;
  const std::string body = bytes.substr(head);
  if (bytes.compare(format_of_rows.size(), digest, sha256(body)) != 0 || !body.starts_with(key + '\n'))
    return std::nullopt;
  ByteReader reader(std::string_view(body).substr(key.size() + 1));
  SimulatedRows rows;
  std::uint64_t count = 0;
  if (!reader.take(rows.trials) || !reader.take(count) || count > reader.left()) return std::nullopt;
  rows.rows.resize(count);
  for (SimulatedRow& row : rows.rows) {
    std::uint64_t values = 0;
    if (!reader.take(row.start.x()) || !reader.take(row.start.y()) || !reader.take(row.lost) ||
        !reader.take(values) || values > reader.left() / bytes_of_value)
      return std::nullopt;
    row.values.resize(values);
    for (SimulatedValue& value : row.values) {
      char censored = 0;
      reader.take(value.trial);
      reader.take(value.value.x());
      reader.take(value.value.y());
      reader.take(censored);
      value.censored = censored != 0;
    }
  }
  return rows;
}

}  // namespace flyrock
