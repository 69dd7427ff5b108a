#include "batch/envelope.h"

#include "batch/whole_numbers.h"
#include "math/round_step.h"

namespace flyrock {

namespace {

const CodeScale one_percent{1.02};

/// A single walk, because the bins of both are sorted.
void add_bins(std::map<std::int64_t, EnvelopeBin>& bins, const std::map<std::int64_t, EnvelopeBin>& more) {
  auto at = bins.begin();
  for (const auto& [bin, counts] : more) {
    while (at != bins.end() && at->first < bin) ++at;
    if (at == bins.end() || at->first != bin) at = bins.emplace_hint(at, bin, EnvelopeBin());
    at->second.add(counts);
  }
}

/// Maps ..., -1, 0, 1, ... to whole numbers from 0, small ones to small ones.
std::uint64_t folded(std::int64_t n) {
  return static_cast<std::uint64_t>(n) << 1 ^ static_cast<std::uint64_t>(n >> 63);
}
std::int64_t unfolded(std::uint64_t n) {
  return static_cast<std::int64_t>(n >> 1) ^ -static_cast<std::int64_t>(n & 1);
}

}  // namespace

double envelope_width(const Profile& terrain) {
  return round_step((terrain.x_max() - terrain.x_min()) / 400);
}

double EnvelopeBin::quantile(EnvelopeQuantity quantity, double p) const {
  return one_percent.value(quantile_code(counts[static_cast<std::size_t>(quantity)], rocks(), p));
}

std::uint64_t EnvelopeBin::rocks() const { return rocks_in(counts[0]); }

void EnvelopeBin::add(const EnvelopeBin& other) {
  for (std::size_t q = 0; q < counts.size(); ++q) merge_counts(counts[q], other.counts[q]);
}

void Envelopes::add(int group, const PathBins& path) {
  if (path.bins().empty()) return;
  auto& bins = groups_[group];
  for (std::size_t i = 0; i < path.bins().size(); ++i) {
    const PathBin& seen = path.bins()[i];
    auto& counts = bins[path.first() + static_cast<std::int64_t>(i)].counts;
    add_code(counts[0], one_percent.code(seen.height));
    add_code(counts[1], one_percent.code(seen.speed));
    add_code(counts[2], one_percent.code(seen.energy));
  }
}

void Envelopes::add(const Envelopes& later) {
  for (const auto& [group, bins] : later.groups_) add_bins(groups_[group], bins);
}

const std::map<std::int64_t, EnvelopeBin>& Envelopes::of_group(int group) const {
  static const std::map<std::int64_t, EnvelopeBin> none;
  const auto found = groups_.find(group);
  return found == groups_.end() ? none : found->second;
}

std::map<std::int64_t, EnvelopeBin> Envelopes::of_all() const {
  std::map<std::int64_t, EnvelopeBin> all;
  for (const auto& [group, bins] : groups_) add_bins(all, bins);
  return all;
}

std::string Envelopes::bytes() const {
  std::string bytes;
  put_whole(bytes, groups_.size());
  for (const auto& [group, bins] : groups_) {
    put_whole(bytes, static_cast<std::uint64_t>(group));
    put_whole(bytes, bins.size());
    for (const auto& [bin, envelope] : bins) {
      put_whole(bytes, folded(bin));
      for (const CodeCounts& counts : envelope.counts) put_counts(bytes, counts);
    }
  }
  return bytes;
}

Envelopes Envelopes::read(std::string_view bytes) {
  Envelopes envelopes;
  for (std::uint64_t groups = take_whole(bytes); groups > 0; --groups) {
    auto& bins = envelopes.groups_[static_cast<int>(take_whole(bytes))];
    for (std::uint64_t n = take_whole(bytes); n > 0; --n) {
      EnvelopeBin& bin = bins[unfolded(take_whole(bytes))];
      bin = {};
      for (CodeCounts& counts : bin.counts) counts = take_counts(bytes);
    }
  }
  if (!bytes.empty()) throw ColumnError("the envelopes are longer than their bins");
  return envelopes;
}

}  // namespace flyrock
