#include "record/code_counts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "record/whole_numbers.h"

namespace flyrock {

namespace {

constexpr double least_coded = 1e-3;
constexpr std::size_t most_codes = 4096;  // above the code of any finite energy

/// log2(x) and a constant, to 0.01. The bits of a double, read as a whole number, are its exponent and then
/// the fraction m of its mantissa, and log2(1 + m) is nearly m + 0.344 m (1 - m).
double rough_log2(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  const double m = 0x1p-52 * static_cast<double>(bits & 0xFFFFFFFFFFFFF);
  return 0x1p-52 * static_cast<double>(bits) + 0.344 * m * (1 - m);
}

}  // namespace

CodeScale::CodeScale(double ratio) : ratio_(ratio), codes_a_doubling_(1 / std::log2(ratio)) {
  starts_ = {0, least_coded};
  while (starts_.size() < most_codes) starts_.push_back(starts_.back() * ratio);
}

/// A step or two from the rough logarithm lead to the code.
std::uint32_t CodeScale::code(double value) const {
  if (!(value >= least_coded)) return 0;
  const double doublings = std::max(0.0, rough_log2(value) - rough_log2(least_coded));
  std::size_t code =
      std::min(static_cast<std::size_t>(1 + doublings * codes_a_doubling_), starts_.size() - 1);
  while (value < starts_[code]) --code;
  while (code + 1 < starts_.size() && value >= starts_[code + 1]) ++code;
  return static_cast<std::uint32_t>(code);
}

double CodeScale::value(std::uint32_t code) const {
  return code == 0 ? 0 : least_coded * std::pow(ratio_, static_cast<double>(code) - 0.5);
}

void add_code(CodeCounts& counts, std::uint32_t code, double rocks) {
  const auto at = std::lower_bound(counts.begin(), counts.end(), code,
                                   [](const CodeCount& c, std::uint32_t wanted) { return c.code < wanted; });
  if (at != counts.end() && at->code == code)
    at->rocks += rocks;
  else
    counts.insert(at, {code, rocks});
}

// Both are sorted by code. Merges in place from the end, because this runs for each bin of each chunk. The
// few codes of a small chunk are searched for: most of them are there already, and nothing has to move.
void merge_counts(CodeCounts& counts, const CodeCounts& more) {
  constexpr std::size_t as_long_as_a_search = 8;
  if (more.size() == 1 || as_long_as_a_search * more.size() < counts.size()) {
    for (const CodeCount& next : more) add_code(counts, next.code, next.rocks);
    return;
  }
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

double rocks_in(const CodeCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0,
                         [](double sum, const CodeCount& c) { return sum + c.rocks; });
}

std::uint32_t quantile_code(const CodeCounts& counts, double all, double p) {
  const double wanted = p * all;
  double seen = 0;
  auto at = counts.begin();
  // Always stops at the last count: in a chunk that flyrock did not write, the counts may not agree.
  while ((seen += at->rocks) < wanted && at + 1 != counts.end()) ++at;
  return at->code;
}

void put_counts(std::string& bytes, const CodeCounts& counts) {
  put_whole(bytes, counts.size());
  std::uint32_t before = 0;
  for (const auto& [code, rocks] : counts) {
    put_whole(bytes, code - before);
    put_weight(bytes, rocks);
    before = code;
  }
}

CodeCounts take_counts(std::string_view& bytes) {
  CodeCounts counts;
  std::uint64_t code = 0;
  for (std::uint64_t entries = take_whole(bytes); entries > 0; --entries) {
    code += take_whole(bytes);
    if (code >= most_codes) throw ColumnError("a code of a histogram is too great");
    if (!counts.empty() && code <= counts.back().code)
      throw ColumnError("the codes of a histogram are out of order");
    counts.push_back({static_cast<std::uint32_t>(code), take_weight(bytes)});
  }
  if (counts.empty()) throw ColumnError("damaged chunk: an empty histogram");
  return counts;
}

}  // namespace flyrock
