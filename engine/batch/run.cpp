#include "batch/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "batch/safe_file.h"
#include "batch/statistics.h"

namespace flyrock {

namespace {

/// So many rocks that fail, and none that does not, are no accident: the run would only repeat the message.
constexpr std::uint64_t hopeless = 20;

/// Watches the records for a fault that ends the run.
class FaultWatch {
 public:
  explicit FaultWatch(bool strict) : strict_(strict) {}

  /// Why the run ends after a trial, whose rocks start at `from`; or an empty text.
  std::string after_trial(const TrialRecords& records, std::size_t from) {
    for (std::size_t i = from; i < records.rocks.size(); ++i) {
      const RockRecord& rock = records.rocks[i];
      ++rocks_;
      failed_ += is_fault(rock.reason);
      if (strict_ && is_fault(rock.reason))
        return fmt::format("trial {}, rock {}: {}: {}", rock.trial, rock.rock, name_of(rock.reason), rock.fault);
      if (rocks_ == hopeless && failed_ == hopeless)
        return fmt::format("the first {} rocks all failed, the last with: {}", hopeless, rock.fault);
    }
    if (strict_ && records.quality.not_converged > 0)
      return fmt::format("{} steps did not converge", records.quality.not_converged);
    return {};
  }

 private:
  bool strict_;
  std::uint64_t rocks_ = 0, failed_ = 0;
};

}  // namespace

RunOutcome run_chunks(const std::vector<ChunkRange>& chunks, const RunTrial& run_trial, const RunOptions& options) {
  RunOutcome outcome;
  for (const ChunkRange& chunk : chunks) outcome.progress.total += chunk.count;
  FaultWatch watch(options.strict);
  for (ChunkRange chunk : chunks) {
    TrialRecords records;
    for (std::uint64_t done = 0; done < chunk.count && outcome.why.empty(); ++done) {
      if (options.interrupted()) {
        outcome.ending = RunEnding::interrupted;
        return outcome;
      }
      const std::size_t before = records.rocks.size();
      run_trial(chunk.point, chunk.first + done, records);
      outcome.why = watch.after_trial(records, before);
      if (!outcome.why.empty()) chunk.count = done + 1;
      ++outcome.progress.done;
      outcome.progress.rocks += records.rocks.size() - before;
      options.report(outcome.progress);
    }
    outcome.times.add(records.times);
    write_file(options.folder / chunk.file_name(), encode_chunk(chunk, options.scenario_hash, records));
    outcome.chunks.push_back(chunk);
    if (!outcome.why.empty()) {
      outcome.ending = RunEnding::faults;
      return outcome;
    }
  }
  return outcome;
}

std::vector<TrialRecords> merge_chunks(const std::vector<ChunkRange>& chunks, int points,
                                       const std::filesystem::path& folder, const std::string& scenario_hash) {
  std::vector<TrialRecords> merged(points);
  for (const ChunkRange& chunk : chunks) {
    const std::filesystem::path path = folder / chunk.file_name();
    std::string why;
    std::optional<TrialRecords> records = decode_chunk(read_file(path), chunk, scenario_hash, why);
    if (!records) throw FileError(fmt::format("{}: {}", path.string(), why));
    append(merged.at(static_cast<std::size_t>(chunk.point)), std::move(*records));
  }
  return merged;
}

void remove_chunks(const std::vector<ChunkRange>& chunks, const std::filesystem::path& folder) {
  std::error_code code;
  for (const ChunkRange& chunk : chunks) {
    std::filesystem::remove(folder / chunk.file_name(), code);
    if (code) throw FileError(fmt::format("cannot remove {}: {}", chunk.file_name(), code.message()));
  }
  std::filesystem::remove(folder, code);  // refused where somebody else's files are in it: they stay
}

}  // namespace flyrock
