#include "results/say/fault_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "scenario/plan.h"

namespace flyrock {

namespace {

std::uint64_t count_of(const Results& results, StopReason reason) {
  std::uint64_t sum = 0;
  for (const PointResult& point : results.points)
    sum += point.groups.front().reasons[static_cast<std::size_t>(reason)];
  return sum;
}

/// Each text once, with the first rock that has it.
std::vector<std::string> distinct_faults(const Plan& plan, const Results& results) {
  constexpr std::size_t most_named = 3;
  std::vector<std::string> list;
  std::set<std::string> known;
  for (const Fault& fault : results.faults) {
    if (list.size() == most_named) break;
    if (!known.insert(fault.text).second) continue;
    const std::string point = plan.points.size() > 1 ? fmt::format("point {}, ", fault.point) : "";
    list.push_back(fmt::format("{} ({}trial {}, rock {})", fault.text, point, fault.trial, fault.rock));
  }
  return list;
}

}  // namespace

std::string fault_line(const Plan& plan, const Results& results) {
  if (results.fault_count == 0) return {};
  const std::uint64_t diverged = count_of(results, StopReason::diverged),
                      failed = results.fault_count - diverged;
  const char* what = plan.points.front().bodies.empty() ? "rocks" : "bodies";
  std::string text = fmt::format("{} of {} {} ", diverged > 0 ? diverged : failed, results.rocks(), what);
  text += diverged > 0 ? "diverged" : "failed";
  if (diverged > 0 && failed > 0) text += fmt::format(" and {} failed", failed);
  return text + fmt::format(": {}. They are in no number of this report: find the cause before you use it.",
                            fmt::join(distinct_faults(plan, results), "; "));
}

}  // namespace flyrock
