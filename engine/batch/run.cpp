#include "batch/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "batch/chunk_queue.h"
#include "batch/record_check.h"
#include "files/safe_file.h"
#include "flight/run.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

std::uint64_t count_failed(const TrialRecords& records) {
  return static_cast<std::uint64_t>(
      std::count_if(records.rocks.begin(), records.rocks.end(),
                    [](const RockRecord& rock) { return is_fault(rock.reason); }));
}

class Run {
 public:
  Run(const std::vector<ChunkRange>& chunks, const RunOptions& options)
      : options_(options),
        chunks_(chunks),
        whole_(chunks.size(), 0),
        printed_(chunks.size()),
        queue_(chunks.size(), options.strict) {
    for (const ChunkRange& chunk : chunks) outcome_.progress.total += chunk.count;
  }

  RunOutcome run(const MakeWorker& make_worker) {
    const int threads = std::clamp(options_.threads, 1, std::max(1, static_cast<int>(chunks_.size())));
    {
      std::vector<std::jthread> others;
      for (int thread = 1; thread < threads; ++thread)
        others.emplace_back([&, thread] { work(make_worker, thread); });
      work(make_worker, 0);
    }  // threads are joined here
    if (error_) std::rethrow_exception(error_);
    return conclude();
  }

 private:
  void work(const MakeWorker& make_worker, int thread) {
    try {
      const RunTrial run_trial = make_worker(thread);
      while (const std::optional<std::size_t> chunk = queue_.take()) {
        if (!keep(*chunk)) run_chunk(*chunk, run_trial);
        queue_.finish();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      queue_.stop();
    }
  }

  /// Whether a chunk of an earlier run is kept. If a fault may end the run, a chunk with faults runs again,
  /// because it may have to end in the middle.
  bool keep(std::size_t index) {
    const ChunkRange& chunk = chunks_[index];
    const std::filesystem::path path = options_.folder / chunk.file_name();
    if (!options_.resume || !std::filesystem::exists(path)) return false;
    std::string why;
    const std::optional<TrialRecords> records =
        read_chunk(path, chunk, options_.scenario_hash, Part::whole, why);
    if (!records ||
        (options_.plan && !records_fault(*records, chunk, options_.plan->points[chunk.point]).empty()))
      return false;
    const std::uint64_t failed = count_failed(*records);
    if ((failed > 0 || records->totals.quality.not_converged > 0) && queue_.may_end()) return false;
    queue_.judge(index, *records, 0);
    {
      const std::lock_guard lock(mutex_);
      whole_[index] = 1;
      outcome_.progress.done += chunk.count;
      outcome_.progress.kept += chunk.count;
      outcome_.failed += failed;
      options_.report(outcome_.progress);
    }
    show(index, *records);
    return true;
  }

  void run_chunk(std::size_t index, const RunTrial& run_trial) {
    ChunkRange chunk = chunks_[index];
    TrialRecords records;
    PrintLog prints;
    for (std::uint64_t done = 0; done < chunk.count; ++done) {
      if (options_.interrupted()) {
        interrupted_ = true;
        queue_.stop();
      }
      if (!queue_.wanted(index)) return;
      const std::size_t before = records.rocks.size();
      try {
        prints.add(run_trial(chunk.point, chunk.first + done, records));
      } catch (const Interrupted&) {
        interrupted_ = true;
        return queue_.stop();
      }
      if (!queue_.judge(index, records, before)) chunk.count = done + 1;
      const std::lock_guard lock(mutex_);
      ++outcome_.progress.done;
      outcome_.progress.rocks += records.rocks.size() - before;
      options_.report(outcome_.progress);
    }
    const auto start = std::chrono::steady_clock::now();
    write_file(options_.folder / chunk.file_name(), encode_chunk(chunk, options_.scenario_hash, records),
               Sync::no);
    const std::chrono::nanoseconds store_time = std::chrono::steady_clock::now() - start;
    {
      const std::lock_guard lock(mutex_);
      outcome_.store_time += store_time.count();
      chunks_[index] = chunk;
      whole_[index] = 1;
      outcome_.failed += count_failed(records);
      outcome_.times.add(records.totals.times);
      printed_[index] = std::move(prints);
    }
    show(index, records);
  }

  /// Shows a chunk that has just been completed, if it is the next one, and later chunks that waited for it.
  /// Holds no lock meanwhile, so other threads go on. Chunks that waited are read back from disk, so none
  /// stays in memory.
  void show(std::size_t index, const TrialRecords& records) {
    std::unique_lock lock(mutex_);
    if (showing_ || index != shown_) return;
    showing_ = true;
    std::optional<TrialRecords> waited;
    while (shown_ < chunks_.size() && whole_[shown_] && shown_ <= queue_.end()) {
      const ChunkRange chunk = chunks_[shown_];
      lock.unlock();
      const auto start = std::chrono::steady_clock::now();
      if (shown_ != index) waited = read_back(chunk);
      options_.see(chunk.point, waited ? *waited : records);
      prints_.add(std::exchange(printed_[shown_], {}));
      if (!prints_.empty()) options_.print(prints_.take());
      lock.lock();
      outcome_.see_time += (std::chrono::steady_clock::now() - start).count();
      ++shown_;
    }
    showing_ = false;
  }

  TrialRecords read_back(const ChunkRange& chunk) const {
    const std::filesystem::path path = options_.folder / chunk.file_name();
    std::string why;
    std::optional<TrialRecords> records = read_chunk(path, chunk, options_.scenario_hash, Part::whole, why);
    if (!records) throw FileError(fmt::format("{}: {}", path.string(), why));
    return std::move(*records);
  }

  RunOutcome conclude() {
    const std::size_t end = queue_.end();
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      if (i <= end && whole_[i]) outcome_.chunks.push_back(chunks_[i]);
      if (i > end) std::filesystem::remove(options_.folder / chunks_[i].file_name());
    }
    if (interrupted_ && outcome_.chunks.size() < std::min(end + 1, chunks_.size())) {
      outcome_.ending = RunEnding::interrupted;
    } else if (end < chunks_.size()) {
      outcome_.ending = RunEnding::faults;
      outcome_.why = queue_.why();
    }
    return std::move(outcome_);
  }

  const RunOptions& options_;
  std::vector<ChunkRange> chunks_;  ///< the chunk in which the run ends becomes short
  std::vector<char> whole_;         ///< not bool, because threads write neighbouring elements
  std::vector<PrintLog> printed_;   ///< by the Lua code of each chunk not shown yet
  ChunkQueue queue_;
  std::mutex mutex_;       ///< guards the members below, and chunks_, whole_ and printed_
  std::size_t shown_ = 0;  ///< number of chunks, from the first
  bool showing_ = false;   ///< some thread shows chunks now and owns prints_
  PrintLog prints_;        ///< of the whole run
  RunOutcome outcome_;
  std::exception_ptr error_;
  std::atomic<bool> interrupted_ = false;
};

}  // namespace

RunOutcome run_chunks(const std::vector<ChunkRange>& chunks, const MakeWorker& make_worker,
                      const RunOptions& options) {
  return Run(chunks, options).run(make_worker);
}

}  // namespace flyrock
