#include "report/page/convergence.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/page/rounded.h"

namespace flyrock {

namespace {

constexpr int most_counts = 24;
constexpr double fewest = 20;
constexpr std::array<std::pair<const char*, double>, 3> percentiles = {
    {{"p50", 0.5}, {"p95", 0.95}, {"p99", 0.99}}};

Questions questions() {
  Questions q;
  for (const auto& [name, p] : percentiles) {
    q.quantiles.push_back(p);
    q.intervals.push_back({p, stated_confidence});
  }
  return q;
}

}  // namespace

Convergence::Convergence(std::uint64_t count) {
  const double ratio = std::pow(static_cast<double>(count) / fewest, 1.0 / (most_counts - 1));
  for (int i = 0; i < most_counts; ++i) {
    const auto n =
        i + 1 == most_counts ? count : static_cast<std::uint64_t>(std::lround(fewest * std::pow(ratio, i)));
    if (n > count || n == 0 || (!starts_.empty() && n <= starts_.back().count)) continue;
    starts_.push_back({n, Sample(questions())});
  }
}

void Convergence::add(const Bounded& runout, std::uint64_t trial, double weight) {
  for (Start& start : starts_)
    if (seen_ < start.count) start.sample.add(runout, trial, weight);
  ++seen_;
}

bool Convergence::needs_another_pass() {
  seen_ = 0;
  bool more = false;
  for (Start& start : starts_) more |= start.sample.needs_another_pass();
  return more;
}

nlohmann::ordered_json Convergence::data() const {
  nlohmann::ordered_json n = nlohmann::ordered_json::array();
  for (const Start& start : starts_) n.push_back(start.count);
  nlohmann::ordered_json data = {{"n", n}};
  for (const auto& [name, p] : percentiles) {
    nlohmann::ordered_json value = nlohmann::ordered_json::array(), lower = value, upper = value,
                           censored = value;
    for (const Start& start : starts_) {
      const Bounded quantile = start.sample.quantile(p);
      const Interval interval = start.sample.quantile_interval(p, stated_confidence);
      value.push_back(rounded(quantile.value));
      lower.push_back(rounded(interval.lower));
      upper.push_back(rounded(interval.upper));
      censored.push_back(quantile.censored);
    }
    data[name] = {{"value", value}, {"lower", lower}, {"upper", upper}, {"censored", censored}};
  }
  return data;
}

}  // namespace flyrock
