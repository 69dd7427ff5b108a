#include "cli/conclude.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <ctime>

#include "cli/terminal.h"

namespace flyrock::cli {

void print_faults(const Results& results, const char* early_end) {
  for (const Fault& fault : results.faults)
    tell("error: point {}, trial {}, rock {}: {}: {}\n", fault.point, fault.trial, fault.rock,
         name_of(fault.reason), fault.text);
  if (results.fault_count > results.faults.size())
    tell("error: and {} more rocks that failed\n", results.fault_count - results.faults.size());
  if (!results.ended_early.empty()) tell("{}: {}\n", early_end, results.ended_early);
}

int exit_code(const Results& results) {
  if (!results.ended_early.empty() || results.fault_count > 0) return faults;
  return results.count(Judgement::failed) > 0 ? expectation_failed : done;
}

RunLog start_log() {
  RunLog log;
  log.started = fmt::format("{:%Y-%m-%dT%H:%M:%S%z}", fmt::localtime(std::time(nullptr)));
  char name[256] = {};
  log.host = ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
  return log;
}

std::uint64_t trials_in(const std::vector<ChunkRange>& chunks) {
  std::uint64_t trials = 0;
  for (const ChunkRange& chunk : chunks) trials += chunk.count;
  return trials;
}

std::vector<std::uint64_t> trials_of(const std::vector<ChunkRange>& chunks, std::size_t points) {
  std::vector<std::uint64_t> trials(points, 0);
  for (const ChunkRange& chunk : chunks) trials[static_cast<std::size_t>(chunk.point)] += chunk.count;
  return trials;
}

}  // namespace flyrock::cli
