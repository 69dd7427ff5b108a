#include "batch/envelope.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "batch/columns.h"
#include "math/round_step.h"

namespace flyrock {

namespace {

constexpr double least = 1e-3, ratio = 1.02;
constexpr std::uint64_t most_codes = 4096;  // above the code of any finite energy

std::uint32_t code_of(double value) {
  if (!(value >= least)) return 0;
  const double code = std::floor(std::log(value / least) / std::log(ratio)) + 1;
  return static_cast<std::uint32_t>(std::min(code, static_cast<double>(most_codes - 1)));
}

/// The middle of a code's values, on a logarithmic scale.
double value_of(std::uint32_t code) {
  return code == 0 ? 0 : least * std::pow(ratio, static_cast<double>(code) - 0.5);
}

void count(std::vector<CodeCount>& counts, std::uint32_t code) {
  const auto at = std::lower_bound(counts.begin(), counts.end(), code,
                                   [](const CodeCount& c, std::uint32_t wanted) { return c.code < wanted; });
  if (at != counts.end() && at->code == code)
    ++at->rocks;
  else
    counts.insert(at, {code, 1});
}

/// Both are sorted by code. Merges in place from the end, because this runs for each bin of each chunk.
void merge(std::vector<CodeCount>& counts, const std::vector<CodeCount>& more) {
  std::size_t from = counts.size(), to = from;
  auto at = counts.begin();
  for (const CodeCount& next : more) {
    while (at != counts.end() && at->code < next.code) ++at;
    to += at == counts.end() || at->code != next.code;
  }
  counts.resize(to);
  for (auto next = more.rbegin(); next != more.rend(); ++next) {
    while (from > 0 && counts[from - 1].code > next->code) counts[--to] = counts[--from];
    const bool known = from > 0 && counts[from - 1].code == next->code;
    counts[--to] = {next->code, next->rocks + (known ? counts[--from].rocks : 0)};
  }
}

/// A single walk, because the bins of both are sorted.
void add_bins(std::map<std::int64_t, EnvelopeBin>& bins, const std::map<std::int64_t, EnvelopeBin>& more) {
  auto at = bins.begin();
  for (const auto& [bin, counts] : more) {
    while (at != bins.end() && at->first < bin) ++at;
    if (at == bins.end() || at->first != bin) at = bins.emplace_hint(at, bin, EnvelopeBin());
    at->second.add(counts);
  }
}

// Whole numbers with 7 bits in each byte; the highest bit is 0 in the last byte (LEB128).

void put(std::string& bytes, std::uint64_t number) {
  for (; number >= 128; number >>= 7) bytes.push_back(static_cast<char>(number | 128));
  bytes.push_back(static_cast<char>(number));
}

std::uint64_t take(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (bytes.empty()) throw ColumnError("the envelopes end early");
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint64_t>(byte & 127) << shift;
    if (byte < 128) return number;
  }
  throw ColumnError("a number of the envelopes is too long");
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
  const std::vector<CodeCount>& of = counts[static_cast<std::size_t>(quantity)];
  const double wanted = p * static_cast<double>(rocks());
  std::uint64_t seen = 0;
  auto at = of.begin();
  // Always stops at the last count: in a chunk that flyrock did not write, the counts may not agree.
  while (static_cast<double>(seen += at->rocks) < wanted && at + 1 != of.end()) ++at;
  return value_of(at->code);
}

std::uint64_t EnvelopeBin::rocks() const {
  return std::accumulate(counts[0].begin(), counts[0].end(), std::uint64_t{0},
                         [](std::uint64_t sum, const CodeCount& c) { return sum + c.rocks; });
}

void EnvelopeBin::add(const EnvelopeBin& other) {
  for (std::size_t q = 0; q < counts.size(); ++q) merge(counts[q], other.counts[q]);
}

void Envelopes::add(int group, const PathBins& path) {
  if (path.bins().empty()) return;
  auto& bins = groups_[group];
  for (std::size_t i = 0; i < path.bins().size(); ++i) {
    const PathBin& seen = path.bins()[i];
    auto& counts = bins[path.first() + static_cast<std::int64_t>(i)].counts;
    count(counts[0], code_of(seen.height));
    count(counts[1], code_of(seen.speed));
    count(counts[2], code_of(seen.energy));
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
  put(bytes, groups_.size());
  for (const auto& [group, bins] : groups_) {
    put(bytes, static_cast<std::uint64_t>(group));
    put(bytes, bins.size());
    for (const auto& [bin, envelope] : bins) {
      put(bytes, folded(bin));
      for (const std::vector<CodeCount>& counts : envelope.counts) {
        put(bytes, counts.size());
        std::uint32_t before = 0;
        for (const auto& [code, rocks] : counts) {
          put(bytes, code - before);
          put(bytes, rocks);
          before = code;
        }
      }
    }
  }
  return bytes;
}

Envelopes Envelopes::read(std::string_view bytes) {
  Envelopes envelopes;
  for (std::uint64_t groups = take(bytes); groups > 0; --groups) {
    auto& bins = envelopes.groups_[static_cast<int>(take(bytes))];
    for (std::uint64_t n = take(bytes); n > 0; --n) {
      EnvelopeBin& bin = bins[unfolded(take(bytes))];
      bin = {};
      for (std::vector<CodeCount>& counts : bin.counts) {
        std::uint64_t code = 0;
        for (std::uint64_t entries = take(bytes); entries > 0; --entries) {
          code += take(bytes);
          if (code >= most_codes) throw ColumnError("a code of the envelopes is too great");
          if (!counts.empty() && code <= counts.back().code)
            throw ColumnError("the codes of the envelopes are out of order");
          counts.push_back({static_cast<std::uint32_t>(code), static_cast<std::uint32_t>(take(bytes))});
        }
        if (counts.empty()) throw ColumnError("a bin of the envelopes has no rock");
      }
    }
  }
  if (!bytes.empty()) throw ColumnError("the envelopes are longer than their bins");
  return envelopes;
}

}  // namespace flyrock
