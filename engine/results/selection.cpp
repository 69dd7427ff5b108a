#include "results/selection.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace flyrock {

namespace {

constexpr std::uint64_t most_kept = 1024;
constexpr int part_bits = 10;
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
    : ranks_(std::move(ranks)) {
  std::sort(ranks_.begin(), ranks_.end());
  ranks_.erase(std::unique(ranks_.begin(), ranks_.end()), ranks_.end());
  values_.resize(ranks_.size());
  if (!ranks_.empty() && ranks_.back() >= weight) throw std::out_of_range("a rank beyond the last number");
  look_within(key_of(least), key_of(greatest), 0, count, {0, ranks_.size()});
}

void Selection::add(double value, double weight) {
  const std::uint64_t key = key_of(value);
  const auto above =
      std::upper_bound(open_.begin(), open_.end(), key,
                       [](std::uint64_t k, const Stretch& stretch) { return k < stretch.low; });
  if (above == open_.begin()) return;
  Stretch& stretch = *std::prev(above);
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
    if (stretch.parts.empty())
      settle(stretch);
    else
      narrow(stretch);
  }
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
