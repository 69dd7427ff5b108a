#include "results/statistics/input_response.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "batch/inputs.h"
#include "random/stream.h"

namespace flyrock {

namespace {

constexpr std::size_t least_known = 30;
constexpr std::size_t most_bins = 10;

struct Pair {
  double x, f;
};

std::vector<Pair> sorted_pairs(const std::vector<double>& x, const std::vector<double>& f) {
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < std::min(x.size(), f.size()); ++t)
    if (std::isfinite(x[t]) && std::isfinite(f[t])) pairs.push_back({x[t], f[t]});
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.x < b.x; });
  return pairs;
}

std::size_t place(const std::vector<Pair>& pairs, double share) {
  return static_cast<std::size_t>(std::lround(share * static_cast<double>(pairs.size())));
}

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(at), high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (at - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

ResponseBin bin_of(const std::vector<Pair>& pairs, std::size_t begin, std::size_t end) {
  constexpr double c = stated_confidence;
  Sample sample({.quantiles = {0.5, 0.95, 0.99}, .intervals = {{0.5, c}, {0.95, c}, {0.99, c}}});
  do {
    for (std::size_t i = begin; i < end; ++i) sample.add({pairs[i].f}, i);
  } while (sample.needs_another_pass());
  return {.x = 0.5 * (pairs[(begin + end - 1) / 2].x + pairs[(begin + end) / 2].x),
          .mean = sample.moments().mean,
          .mean_interval = sample.mean_interval(c),
          .p50 = sample.quantile(0.5).value,
          .p95 = sample.quantile(0.95).value,
          .p99 = sample.quantile(0.99).value,
          .p50_interval = sample.quantile_interval(0.5, c),
          .p95_interval = sample.quantile_interval(0.95, c),
          .p99_interval = sample.quantile_interval(0.99, c),
          .trials = end - begin};
}

/// The correlation ratio over the bins, which follow each other in the pairs.
double explained_by(const std::vector<Pair>& pairs, const std::vector<ResponseBin>& bins) {
  double mean = 0, all = 0, within = 0;
  for (const Pair& pair : pairs) mean += pair.f / static_cast<double>(pairs.size());
  std::size_t i = 0;
  for (const ResponseBin& bin : bins)
    for (const std::size_t end = i + bin.trials; i < end; ++i) {
      all += (pairs[i].f - mean) * (pairs[i].f - mean);
      within += (pairs[i].f - bin.mean) * (pairs[i].f - bin.mean);
    }
  const auto n = static_cast<double>(pairs.size()), k = static_cast<double>(bins.size());
  return all > 0 && n > k ? 1 - within / (n - k) / (all / (n - 1)) : unknown;
}

/// One level of an isotonic fit: from a value of the input on.
struct Level {
  double from, to, sum, count;
  double mean() const { return sum / count; }
};

/// The rising fit of f over x, both sorted by x, each with a count.
std::vector<Level> isotonic(const std::vector<Pair>& pairs, const std::vector<double>& counts, double sign) {
  std::vector<Level> levels;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (counts[i] == 0) continue;
    levels.push_back({pairs[i].x, pairs[i].x, counts[i] * sign * pairs[i].f, counts[i]});
    while (levels.size() > 1 && levels[levels.size() - 2].mean() >= levels.back().mean()) {
      Level& before = levels[levels.size() - 2];
      const Level& last = levels.back();
      before = {before.from, last.to, before.sum + last.sum, before.count + last.count};
      levels.pop_back();
    }
  }
  return levels;
}

/// Where a rising fit passes the line: the middle between the last level below and the first above.
double crossing(const std::vector<Level>& levels, double line) {
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (levels[i - 1].mean() < line && levels[i].mean() >= line)
      return 0.5 * (levels[i - 1].to + levels[i].from);
  return unknown;
}

}  // namespace

InputValues::InputValues(const Scenario& scenario, int group, std::uint64_t trials)
    : group_(group), trials_(trials) {
  for (const Input& input : inputs_of(scenario)) {
    paths_.push_back(input.path);
    units_.push_back(input.unit);
  }
}

void InputValues::add(int base, const TrialRecords& chunk) {
  auto rock = chunk.rocks.begin();
  for (const InputRecord& input : chunk.inputs) {
    while (rock != chunk.rocks.end() && (rock->trial != input.trial || rock->rock != input.rock)) ++rock;
    if (rock == chunk.rocks.end()) return;
    if (group_ >= 0 && rock->group != group_) continue;
    Column& column = columns_[input.input];
    if (column.values.empty()) column.values.assign(2 * trials_, unknown);
    double& value = column.values.at(static_cast<std::size_t>(base) * trials_ + input.trial);
    if (input.impact > 0 || (!std::isnan(value) && value != input.value)) column.has_one = false;
    value = input.value;
  }
}

const std::vector<double>* InputValues::of(const std::string& path) const {
  for (const auto& [index, column] : columns_)
    if (paths_[static_cast<std::size_t>(index)] == path && column.has_one) return &column.values;
  return nullptr;
}

const std::string& InputValues::unit_of(const std::string& path) const {
  const auto found = std::find(paths_.begin(), paths_.end(), path);
  static const std::string none;
  return found == paths_.end() ? none : units_[static_cast<std::size_t>(found - paths_.begin())];
}

std::optional<InputResponse> response_of(const std::vector<double>& x, const std::vector<double>& f) {
  const std::vector<Pair> pairs = sorted_pairs(x, f);
  if (pairs.size() < least_known || pairs.front().x == pairs.back().x) return std::nullopt;
  InputResponse response;
  const auto about = [&](double share, double& at, double& mean, Interval& interval) {
    const ResponseBin bin = bin_of(pairs, place(pairs, share - 0.05), place(pairs, share + 0.05));
    at = bin.x;
    mean = bin.mean;
    interval = bin.mean_interval;
  };
  about(0.1, response.p10, response.f_p10, response.f_p10_interval);
  about(0.9, response.p90, response.f_p90, response.f_p90_interval);
  const std::size_t bins = std::clamp(pairs.size() / least_known, std::size_t{1}, most_bins);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const std::size_t begin = pairs.size() * bin / bins, end = pairs.size() * (bin + 1) / bins;
    response.curve.push_back(bin_of(pairs, begin, end));
  }
  response.explained = explained_by(pairs, response.curve);
  return response;
}

std::optional<ResponseMap> map_of(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<double>& f) {
  constexpr std::size_t least_for_map = 300, cells = 6, least_in_cell = 5;
  std::vector<std::size_t> known;
  for (std::size_t t = 0; t < f.size(); ++t)
    if (std::isfinite(x[t]) && std::isfinite(y[t]) && std::isfinite(f[t])) known.push_back(t);
  if (known.size() < least_for_map) return std::nullopt;
  // The cell of each trial along an axis, and the medians of the cells.
  const auto cells_along = [&](const std::vector<double>& values, std::vector<double>& medians) {
    std::vector<std::size_t> order = known, cell(f.size(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) cell[order[i]] = i * cells / order.size();
    for (std::size_t c = 0; c < cells; ++c)
      medians.push_back(values[order[(2 * c + 1) * order.size() / (2 * cells)]]);
    return cell;
  };
  ResponseMap map;
  const std::vector<std::size_t> column = cells_along(x, map.x), row = cells_along(y, map.y);
  std::vector<std::vector<double>> sums(cells, std::vector<double>(cells, 0)), counts = sums;
  for (const std::size_t t : known) {
    sums[row[t]][column[t]] += f[t];
    counts[row[t]][column[t]] += 1;
  }
  map.mean = sums;
  for (std::size_t r = 0; r < cells; ++r)
    for (std::size_t c = 0; c < cells; ++c)
      map.mean[r][c] = counts[r][c] < least_in_cell ? unknown : sums[r][c] / counts[r][c];
  return map;
}

std::optional<LineCrossing> crossing_of(const std::vector<double>& x, const std::vector<double>& f,
                                        double line, std::uint64_t seed, int bootstraps) {
  const std::vector<Pair> pairs = sorted_pairs(x, f);
  if (pairs.size() < least_known) return std::nullopt;
  const auto n = static_cast<double>(pairs.size());
  double mean_x = 0, mean_f = 0, product = 0;
  for (const Pair& pair : pairs) {
    mean_x += pair.x / n;
    mean_f += pair.f / n;
  }
  for (const Pair& pair : pairs) product += (pair.x - mean_x) * (pair.f - mean_f);
  const double sign = product < 0 ? -1 : 1;
  std::vector<double> counts(pairs.size(), 1.0);
  LineCrossing found;
  found.is_rising = sign > 0;
  found.at = crossing(isotonic(pairs, counts, sign), sign * line);
  if (std::isnan(found.at)) return std::nullopt;
  std::vector<double> places;
  RandomStream rng(seed, "crossing.bootstrap", {});
  for (int k = 0; k < bootstraps; ++k) {
    std::fill(counts.begin(), counts.end(), 0.0);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      counts[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(pairs.size()) - 1))] += 1;
    if (const double at = crossing(isotonic(pairs, counts, sign), sign * line); !std::isnan(at))
      places.push_back(at);
  }
  if (static_cast<double>(places.size()) < 0.975 * bootstraps) return std::nullopt;
  std::sort(places.begin(), places.end());
  found.interval = {quantile(places, 0.025), quantile(places, 0.975)};
  return found;
}

}  // namespace flyrock
