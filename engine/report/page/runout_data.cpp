#include "report/page/runout_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "math/round_step.h"
#include "report/page/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr double bins_wanted = 40;
constexpr std::uint64_t curve_points = 400, tail = 100;

/// The ranks of the curve's points among `count` runouts.
std::vector<double> curve_ranks(std::uint64_t count) {
  std::vector<double> ranks;
  const std::uint64_t stride = std::max<std::uint64_t>(1, count / curve_points);
  // The last 100 rocks are never thinned, because readers use the curve for its tail.
  for (std::uint64_t i = 0; i < count; i += i + tail >= count ? 1 : std::min(stride, count - tail - i))
    ranks.push_back(static_cast<double>(i));
  return ranks;
}

/// The same where weights differ: the parts of all of their sum that lie below the points, denser at the end.
std::vector<double> weighted_ranks(double weight) {
  std::vector<double> ranks;
  for (std::uint64_t i = 0; i < curve_points; ++i)
    ranks.push_back(weight * static_cast<double>(i) / curve_points);
  double beyond = 1.0 / curve_points;  // each of the last points has 9 tenths of what the one before left
  for (std::uint64_t i = 0; i < tail; ++i) ranks.push_back(weight * (1 - (beyond *= 0.9)));
  return ranks;
}

/// Counts are whole numbers, sums of weights are not.
Json heights_data(const std::vector<double>& bins, bool are_counts) {
  Json data = Json::array();
  for (const double bin : bins)
    data.push_back(are_counts ? Json(static_cast<std::uint64_t>(bin)) : rounded(bin));
  return data;
}

}  // namespace

RunoutData::RunoutData(const RunoutExtent& extent)
    : count_(extent.count),
      is_weighted_(extent.is_weighted),
      weight_(is_weighted_ ? extent.weight : static_cast<double>(count_)),
      step_(round_step(count_ > 0 ? extent.greatest / bins_wanted : 0)),
      ranks_(is_weighted_ ? weighted_ranks(weight_) : curve_ranks(count_)) {
  const std::size_t bins = count_ > 0 ? static_cast<std::size_t>(extent.greatest / step_) + 1 : 1;
  known_.assign(bins, 0);
  censored_.assign(bins, 0);
  if (count_ == 0) ranks_.clear();
  if (count_ > 0) curve_ = Selection(ranks_, count_, weight_, extent.least, extent.greatest);
}

void RunoutData::add(const Bounded& runout, double weight) {
  if (!is_weighted_) weight = 1;
  curve_.add(runout.value, weight);
  if (binned_) return;
  (runout.censored ? censored_ : known_).at(static_cast<std::size_t>(runout.value / step_)) += weight;
  if (runout.censored) least_censored_ = std::min(least_censored_, runout.value);
}

bool RunoutData::needs_another_pass() {
  binned_ = true;
  curve_.end_pass();
  if (!curve_.open()) curve_.forget();
  return curve_.open();
}

Json RunoutData::data() const {
  // The share of rocks beyond x: at the value of rank i (from 0), the n - 1 - i rocks after it. A rank of
  // weights is the weight up to x.
  const double after = is_weighted_ ? weight_ : weight_ - 1;
  Json x = Json::array(), share = Json::array();
  for (const double rank : ranks_) {
    x.push_back(std::llround(1000 * curve_.at(rank)));
    share.push_back((after - rank) / weight_);
  }
  return {
      {"step", step_},
      {"known", heights_data(known_, !is_weighted_)},
      {"censored", heights_data(censored_, !is_weighted_)},
      {"x", x},
      {"share", share},
      {"known_to", std::isinf(least_censored_) ? Json(nullptr) : Json(std::llround(1000 * least_censored_))}};
}

}  // namespace flyrock
