#include "record/envelope.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "math/round_step.h"
#include "record/whole_numbers.h"

namespace flyrock {

namespace {

const CodeScale one_percent{1.02};
// A terrain has about 400 bins. Bytes that flyrock did not write may name any.
constexpr std::int64_t most_bins = 1'000'000, farthest_bin = std::int64_t{1} << 60;

/// Maps ..., -1, 0, 1, ... to whole numbers from 0, small ones to small ones.
std::uint64_t folded(std::int64_t n) {
  return static_cast<std::uint64_t>(n) << 1 ^ static_cast<std::uint64_t>(n >> 63);
}
std::int64_t unfolded(std::uint64_t n) {
  return static_cast<std::int64_t>(n >> 1) ^ -static_cast<std::int64_t>(n & 1);
}

}  // namespace

double envelope_width(double length) { return round_step(length / 400); }

double EnvelopeBin::quantile(EnvelopeQuantity quantity, double p) const {
  return one_percent.value(quantile_code(counts[static_cast<std::size_t>(quantity)], rocks(), p));
}

double EnvelopeBin::rocks() const { return rocks_in(counts[0]); }

void EnvelopeBin::add(const EnvelopeBin& other) {
  for (std::size_t q = 0; q < counts.size(); ++q) merge_counts(counts[q], other.counts[q]);
}

std::size_t EnvelopeBins::visited() const {
  return static_cast<std::size_t>(
      std::count_if(bins_.begin(), bins_.end(), [](const EnvelopeBin& bin) { return !bin.empty(); }));
}

void EnvelopeBins::cover(std::int64_t first, std::size_t count) {
  if (bins_.empty()) first_ = first;
  if (first < first_) {
    bins_.insert(bins_.begin(), static_cast<std::size_t>(first_ - first), EnvelopeBin());
    first_ = first;
  }
  bins_.resize(std::max(bins_.size(), static_cast<std::size_t>(first - first_) + count));
}

void EnvelopeBins::add(const EnvelopeBins& more) {
  if (more.empty()) return;
  cover(more.first_, more.bins_.size());
  more.visit([&](std::int64_t number, const EnvelopeBin& bin) { at(number).add(bin); });
}

void Envelopes::add(int group, const PathBins& path, double weight) {
  if (path.bins().empty()) return;
  EnvelopeBins& bins = groups_[group];
  bins.cover(path.first(), path.bins().size());
  for (std::size_t i = 0; i < path.bins().size(); ++i) {
    const PathBin& seen = path.bins()[i];
    auto& counts = bins.at(path.first() + static_cast<std::int64_t>(i)).counts;
    add_code(counts[0], one_percent.code(seen.height), weight);
    add_code(counts[1], one_percent.code(seen.speed), weight);
    add_code(counts[2], one_percent.code(seen.energy), weight);
  }
}

void Envelopes::add(const Envelopes& later) {
  for (const auto& [group, bins] : later.groups_) groups_[group].add(bins);
}

const EnvelopeBins& Envelopes::of_group(int group) const {
  static const EnvelopeBins none;
  const auto found = groups_.find(group);
  return found == groups_.end() ? none : found->second;
}

EnvelopeBins Envelopes::of_all() const {
  EnvelopeBins all;
  for (const auto& [group, bins] : groups_) all.add(bins);
  return all;
}

std::string Envelopes::bytes() const {
  std::string bytes;
  put_whole(bytes, groups_.size());
  for (const auto& [group, bins] : groups_) {
    put_whole(bytes, static_cast<std::uint64_t>(group));
    put_whole(bytes, bins.visited());
    bins.visit([&](std::int64_t number, const EnvelopeBin& bin) {
      put_whole(bytes, folded(number));
      for (const CodeCounts& counts : bin.counts) put_counts(bytes, counts);
    });
  }
  return bytes;
}

Envelopes Envelopes::read(std::string_view bytes) {
  Envelopes envelopes;
  for (std::uint64_t groups = take_whole(bytes); groups > 0; --groups) {
    EnvelopeBins& bins = envelopes.groups_[static_cast<int>(take_whole(bytes))];
    std::optional<std::int64_t> first;
    for (std::uint64_t n = take_whole(bytes); n > 0; --n) {
      const std::int64_t number = unfolded(take_whole(bytes));
      if (std::abs(number) > farthest_bin || std::abs(number - first.value_or(number)) > most_bins)
        throw ColumnError("the bins of an envelope are too far from each other");
      if (!first) first = number;
      bins.cover(number, 1);
      EnvelopeBin& bin = bins.at(number);
      bin = {};
      for (CodeCounts& counts : bin.counts) counts = take_counts(bytes);
    }
  }
  if (!bytes.empty()) throw ColumnError("the envelopes are longer than their bins");
  return envelopes;
}

}  // namespace flyrock
