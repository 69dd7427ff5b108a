#include "batch/chunk_queue.h"

#include <fmt/format.h>

namespace flyrock {

namespace {

/// If so many rocks fail and none succeeds, it is no accident, and the run would only repeat the message.
constexpr std::uint64_t hopeless = 20;

}  // namespace

std::optional<std::size_t> ChunkQueue::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return hope_ || stopped_ || under_way_ == 0; });
  if (stopped_ || next_ >= std::min(chunks_, end_)) return std::nullopt;
  ++under_way_;
  return next_++;
}

bool ChunkQueue::judge(std::size_t chunk, const TrialRecords& records, std::size_t from) {
  const std::lock_guard lock(mutex_);
  const std::string why = reason(records, from);
  if (why.empty()) return true;
  if (chunk < end_) {
    end_ = chunk;
    why_ = why;
  }
  return false;
}

std::string ChunkQueue::reason(const TrialRecords& records, std::size_t from) {
  for (std::size_t i = from; i < records.rocks.size(); ++i) {
    const RockRecord& rock = records.rocks[i];
    const bool failed = is_fault(rock.reason);
    if (strict_ && failed)
      return fmt::format("trial {}, rock {}: {}: {}", rock.trial, rock.rock, name_of(rock.reason),
                         rock.fault);
    if (hope_) continue;
    if (!failed) {
      hope_ = true;
      changed_.notify_all();
    } else if (++failed_ == hopeless) {
      return fmt::format("the first {} rocks all failed, the last with: {}", hopeless, rock.fault);
    }
  }
  if (strict_ && records.totals.quality.not_converged > 0)
    return fmt::format("{} steps did not converge", records.totals.quality.not_converged);
  return {};
}

bool ChunkQueue::may_end() const {
  const std::lock_guard lock(mutex_);
  return strict_ || !hope_;
}

std::size_t ChunkQueue::end() const {
  const std::lock_guard lock(mutex_);
  return std::min(end_, chunks_);
}

bool ChunkQueue::wanted(std::size_t chunk) const {
  const std::lock_guard lock(mutex_);
  return !stopped_ && chunk <= end_;
}

void ChunkQueue::finish() {
  const std::lock_guard lock(mutex_);
  --under_way_;
  changed_.notify_all();
}

void ChunkQueue::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

}  // namespace flyrock
