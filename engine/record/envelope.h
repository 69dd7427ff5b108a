#pragma once
// Envelopes: how high, how fast and with which energy rocks pass each x.
//
// For each group, bin along x and quantity, an envelope counts the rocks by their greatest value v in that
// bin. v is rounded to a code: code 0 is below 0.001 (m, m/s, J), code k > 0 is from 0.001 * 1.02^(k-1) to
// 0.001 * 1.02^k, so v is known to 1 %. Counts are whole numbers, so the envelopes of chunks have the same
// sum in any order, and a million rocks take no more memory than a thousand.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "record/code_counts.h"
#include "record/path_bins.h"

namespace flyrock {

enum class EnvelopeQuantity { height, speed, energy };
inline constexpr std::array<std::string_view, 3> envelope_quantity_names = {"height", "speed", "energy"};

/// The width of the bins over a terrain of this length along x [m]: a 400th of it, rounded up to 1, 2 or 5
/// times a power of ten. The terrain is that of trial 0, so all chunks of a point have the same bins.
double envelope_width(double length);

/// The rocks of one group that visited one bin.
struct EnvelopeBin {
  std::array<CodeCounts, 3> counts;  ///< [EnvelopeQuantity]; codes that occur, in increasing order

  bool empty() const { return counts[0].empty(); }

  /// The smallest value that at least a share p of the rocks does not exceed, to 1 %. The bin must not be
  /// empty.
  double quantile(EnvelopeQuantity quantity, double p) const;
  /// Rocks, or the sum of their weights.
  double rocks() const;
  void add(const EnvelopeBin& other);
};

/// The bins of one group, side by side from the first to the last visited one.
class EnvelopeBins {
 public:
  bool empty() const { return bins_.empty(); }
  /// The number of bins that rocks visited.
  std::size_t visited() const;
  /// Makes `count` bins from `first` on, where they are not there yet.
  void cover(std::int64_t first, std::size_t count);
  /// A bin that is there, by its number.
  EnvelopeBin& at(std::int64_t number) { return bins_[static_cast<std::size_t>(number - first_)]; }
  const EnvelopeBin& at(std::int64_t number) const {
    return bins_[static_cast<std::size_t>(number - first_)];
  }
  void add(const EnvelopeBins& more);
  /// Calls see(number, bin) for each visited bin, in order.
  template <class See>
  void visit(See see) const {
    for (std::size_t i = 0; i < bins_.size(); ++i)
      if (!bins_[i].empty()) see(first_ + static_cast<std::int64_t>(i), bins_[i]);
  }

 private:
  std::int64_t first_ = 0;
  std::vector<EnvelopeBin> bins_;
};

class Envelopes {
 public:
  /// Adds a rock that has no fault.
  void add(int group, const PathBins& path, double weight = 1);
  void add(const Envelopes& later);

  const EnvelopeBins& of_group(int group) const;
  /// All groups together.
  EnvelopeBins of_all() const;

  /// The envelopes as compact bytes for chunk files, and back. Throws ColumnError if the bytes are no
  /// envelopes.
  std::string bytes() const;
  static Envelopes read(std::string_view bytes);

 private:
  std::map<int, EnvelopeBins> groups_;
};

}  // namespace flyrock
