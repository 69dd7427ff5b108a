#include "report/runout_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "math/round_step.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr double bins_wanted = 40;
constexpr std::uint64_t curve_points = 400, tail = 100;

/// The ranks of the curve's points among `count` runouts.
std::vector<std::uint64_t> curve_ranks(std::uint64_t count) {
  std::vector<std::uint64_t> ranks;
  const std::uint64_t stride = std::max<std::uint64_t>(1, count / curve_points);
  // The last 100 rocks are never thinned, because readers use the curve for its tail.
  for (std::uint64_t i = 0; i < count; i += i + tail >= count ? 1 : std::min(stride, count - tail - i))
    ranks.push_back(i);
  return ranks;
}

}  // namespace

RunoutData::RunoutData(std::uint64_t count, double least, double greatest)
    : count_(count), step_(round_step(count > 0 ? greatest / bins_wanted : 0)), ranks_(curve_ranks(count)) {
  const std::size_t bins = count > 0 ? static_cast<std::size_t>(greatest / step_) + 1 : 1;
  known_.assign(bins, 0);
  censored_.assign(bins, 0);
  if (count > 0) curve_ = Selection(ranks_, count, least, greatest);
}

void RunoutData::add(const Bounded& runout) {
  curve_.add(runout.value);
  if (binned_) return;
  ++(runout.censored ? censored_ : known_).at(static_cast<std::size_t>(runout.value / step_));
  if (runout.censored) least_censored_ = std::min(least_censored_, runout.value);
}

bool RunoutData::needs_another_pass() {
  binned_ = true;
  curve_.end_pass();
  return curve_.open();
}

Json RunoutData::data() const {
  // The share of rocks beyond x: at the value of rank i (from 0), the n - 1 - i rocks after it.
  Json x = Json::array(), share = Json::array();
  for (const std::uint64_t rank : ranks_) {
    x.push_back(std::llround(1000 * curve_.at(rank)));
    share.push_back(static_cast<double>(count_ - 1 - rank) / static_cast<double>(count_));
  }
  return {
      {"step", step_},
      {"known", known_},
      {"censored", censored_},
      {"x", x},
      {"share", share},
      {"known_to", std::isinf(least_censored_) ? Json(nullptr) : Json(std::llround(1000 * least_censored_))}};
}

}  // namespace flyrock
