#include "results/statistics/selection.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace flyrock {

namespace {

constexpr std::uint64_t most_kept = 4096;
constexpr int least_part_bits = 10, most_part_bits = 16;
constexpr std::uint64_t values_for_part = 512;  // of the first pass, on the mean over all parts
constexpr std::uint64_t sign = std::uint64_t{1} << 63;

/// Maps doubles to whole numbers in the same order. -0 and +0 have the same key.
std::uint64_t key_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
  return bits & sign ? ~bits : bits | sign;
}

double value_of(std::uint64_t key) { return std::bit_cast<double>(key & sign ? key & ~sign : ~key); }

}  // namespace

Selection::Selection(std::vector<double> ranks, std::uint64_t count, double weight, double least,
                     double greatest)
    : low_(key_of(least)), high_(key_of(greatest)), count_(count), weight_(weight) {
  look_for(std::move(ranks));
  look_within(low_, high_, 0, count_, {0, ranks_.size()});
  find_lows();
}

void Selection::look_for(std::vector<double> ranks) {
  ranks_ = std::move(ranks);
  std::sort(ranks_.begin(), ranks_.end());
  ranks_.erase(std::unique(ranks_.begin(), ranks_.end()), ranks_.end());
  values_.assign(ranks_.size(), 0);
  if (!ranks_.empty() && ranks_.back() >= weight_) throw std::out_of_range("a rank beyond the last number");
}

Selection Selection::search_again(std::vector<double> ranks) {
  if (first_.parts.empty()) return {std::move(ranks), count_, weight_, value_of(low_), value_of(high_)};
  Selection again;
  again.low_ = low_;
  again.high_ = high_;
  again.count_ = count_;
  again.weight_ = weight_;
  again.look_for(std::move(ranks));
  first_.wanted = {0, again.ranks_.size()};
  again.narrow(first_);
  again.find_lows();
  forget();
  return again;
}

void Selection::find_lows() {
  lows_.clear();
  for (const Stretch& stretch : open_) lows_.push_back(stretch.low);
}

void Selection::add(double value, double weight) {
  const std::uint64_t key = key_of(value);
  const auto above = std::upper_bound(lows_.begin(), lows_.end(), key);
  if (above == lows_.begin()) return;
  Stretch& stretch = open_[static_cast<std::size_t>(above - lows_.begin()) - 1];
  if (key > stretch.high) return;
  if (stretch.parts.empty()) {
    stretch.kept.push_back({value + 0.0, weight});
  } else {
    Heap& part = stretch.parts[(key - stretch.low) >> stretch.shift];
    ++part.count;
    part.weight += weight;
  }
}

void Selection::end_pass() {
  std::vector<Stretch> seen;
  seen.swap(open_);
  for (Stretch& stretch : seen) {
    if (stretch.parts.empty()) {
      settle(stretch);
      continue;
    }
    narrow(stretch);
    if (stretch.low == low_ && stretch.high == high_) first_ = std::move(stretch);
  }
  find_lows();
}

double Selection::at(double rank) const {
  const auto found = std::lower_bound(ranks_.begin(), ranks_.end(), rank);
  if (found == ranks_.end() || *found != rank)
    throw std::out_of_range("an order statistic that nobody looked for");
  return values_[static_cast<std::size_t>(found - ranks_.begin())];
}

void Selection::look_within(std::uint64_t low, std::uint64_t high, double before, std::uint64_t count,
                            Wanted wanted) {
  if (wanted.first == wanted.end) return;
  if (low == high) {
    std::fill(values_.begin() + static_cast<std::ptrdiff_t>(wanted.first),
              values_.begin() + static_cast<std::ptrdiff_t>(wanted.end), value_of(low));
    return;
  }
  const int part_bits =
      std::clamp(static_cast<int>(std::bit_width(count / values_for_part)), least_part_bits, most_part_bits);
  Stretch stretch{
      low, high, before, wanted, std::max(0, static_cast<int>(std::bit_width(high - low)) - part_bits),
      {},  {}};
  if (count > most_kept)
    stretch.parts.resize(((high - low) >> stretch.shift) + 1);
  else
    stretch.kept.reserve(count);
  open_.push_back(std::move(stretch));
}

/// The ranks below `end`, which leave `left`.
Selection::Wanted Selection::take(Wanted& left, double end) const {
  Wanted taken{left.first, left.first};
  while (taken.end < left.end && ranks_[taken.end] < end) ++taken.end;
  left.first = taken.end;
  return taken;
}

// Sums of weights are rounded: the last number, or the last part with numbers, has all ranks that are left.

void Selection::settle(Stretch& stretch) {
  std::stable_sort(stretch.kept.begin(), stretch.kept.end(),
                   [](const Kept& a, const Kept& b) { return a.value < b.value; });
  double before = stretch.before;
  Wanted left = stretch.wanted;
  for (const auto& [value, weight] : stretch.kept) {
    before += weight;
    const Wanted taken = take(left, before);
    for (std::size_t i = taken.first; i < taken.end; ++i) values_[i] = value;
  }
  for (std::size_t i = left.first; i < left.end && !stretch.kept.empty(); ++i)
    values_[i] = stretch.kept.back().value;
}

void Selection::narrow(const Stretch& stretch) {
  const auto is_filled = [](const Heap& part) { return part.count > 0; };
  const auto last = std::find_if(stretch.parts.rbegin(), stretch.parts.rend(), is_filled);
  double before = stretch.before;
  Wanted left = stretch.wanted;
  for (std::size_t part = 0; part < stretch.parts.size(); ++part) {
    const auto& [count, weight] = stretch.parts[part];
    if (count == 0) continue;
    const std::uint64_t low = stretch.low + (std::uint64_t{part} << stretch.shift);
    const std::uint64_t high = std::min(low + ((std::uint64_t{1} << stretch.shift) - 1), stretch.high);
    Wanted taken = take(left, before + weight);
    if (&stretch.parts[part] == &*last) taken.end = left.first = left.end;
    look_within(low, high, before, count, taken);
    before += weight;
  }
}

}  // namespace flyrock
