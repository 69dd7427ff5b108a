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

Selection::Selection(std::vector<std::uint64_t> ranks, std::uint64_t count, double least, double greatest)
    : ranks_(std::move(ranks)) {
  std::sort(ranks_.begin(), ranks_.end());
  ranks_.erase(std::unique(ranks_.begin(), ranks_.end()), ranks_.end());
  values_.resize(ranks_.size());
  if (!ranks_.empty() && ranks_.back() >= count) throw std::out_of_range("a rank beyond the last number");
  look_within(key_of(least), key_of(greatest), 0, count);
}

void Selection::add(double value) {
  const std::uint64_t key = key_of(value);
  const auto above =
      std::upper_bound(open_.begin(), open_.end(), key,
                       [](std::uint64_t k, const Stretch& stretch) { return k < stretch.low; });
  if (above == open_.begin()) return;
  Stretch& stretch = *std::prev(above);
  if (key > stretch.high) return;
  if (stretch.parts.empty())
    stretch.kept.push_back(value + 0.0);
  else
    ++stretch.parts[(key - stretch.low) >> stretch.shift];
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

double Selection::at(std::uint64_t rank) const {
  const auto found = std::lower_bound(ranks_.begin(), ranks_.end(), rank);
  if (found == ranks_.end() || *found != rank)
    throw std::out_of_range("an order statistic that nobody looked for");
  return values_[static_cast<std::size_t>(found - ranks_.begin())];
}

bool Selection::wants(std::uint64_t before, std::uint64_t count) const {
  const auto next = std::lower_bound(ranks_.begin(), ranks_.end(), before);
  return next != ranks_.end() && *next < before + count;
}

void Selection::look_within(std::uint64_t low, std::uint64_t high, std::uint64_t before,
                            std::uint64_t count) {
  if (!wants(before, count)) return;
  if (low == high) {
    const double value = value_of(low);
    return answer(before, count, &value, 0);
  }
  Stretch stretch{
      low, high, before, count, std::max(0, static_cast<int>(std::bit_width(high - low)) - part_bits),
      {},  {}};
  if (count > most_kept)
    stretch.parts.assign(((high - low) >> stretch.shift) + 1, 0);
  else
    stretch.kept.reserve(count);
  open_.push_back(std::move(stretch));
}

void Selection::settle(Stretch& stretch) {
  std::sort(stretch.kept.begin(), stretch.kept.end());
  answer(stretch.before, stretch.kept.size(), stretch.kept.data(), 1);
}

void Selection::narrow(const Stretch& stretch) {
  std::uint64_t before = stretch.before;
  for (std::size_t part = 0; part < stretch.parts.size(); ++part) {
    const std::uint64_t low = stretch.low + (std::uint64_t{part} << stretch.shift);
    const std::uint64_t last = low + ((std::uint64_t{1} << stretch.shift) - 1);
    look_within(low, std::min(last, stretch.high), before, stretch.parts[part]);
    before += stretch.parts[part];
  }
}

/// Answers the wanted ranks from `before` on, at most `count` of them.
void Selection::answer(std::uint64_t before, std::uint64_t count, const double* sorted, std::size_t stride) {
  auto rank = std::lower_bound(ranks_.begin(), ranks_.end(), before);
  for (; rank != ranks_.end() && *rank < before + count; ++rank)
    values_[static_cast<std::size_t>(rank - ranks_.begin())] = sorted[(*rank - before) * stride];
}

}  // namespace flyrock
