#pragma once
// Envelopes: how high, how fast and with which energy rocks pass each x.
//
// Of each group, bin along x and quantity the number of rocks is counted whose greatest value in that bin is
// v, with v rounded to 1 %: code 0 is below 0.001 (m, m/s, J), code k > 0 the values from 0.001 * 1.02^(k-1)
// to 0.001 * 1.02^k. Counts are whole numbers, so that envelopes of chunks add up to the same in any order,
// and they need no more room for a million rocks than for a thousand.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/profile.h"
#include "world/path_bins.h"

namespace flyrock {

enum class EnvelopeQuantity { height, speed, energy };
inline constexpr std::array<std::string_view, 3> envelope_quantity_names = {"height", "speed", "energy"};

/// The width of the bins over a terrain [m]: a 400th of its length, rounded up to 1, 2 or 5 times a power of
/// ten. It is taken from the terrain of trial 0, so that all chunks of a point have the same bins.
double envelope_width(const Profile& terrain);

/// How many rocks had a value of this code.
struct CodeCount {
  std::uint32_t code = 0, rocks = 0;
};

/// The rocks of one group that visited one bin.
struct EnvelopeBin {
  std::array<std::vector<CodeCount>, 3>
      counts;  ///< [EnvelopeQuantity], in the order of their codes, those that occur

  /// The least value that at least a share p of the rocks does not exceed, to 1 %; the bin is not empty.
  double quantile(EnvelopeQuantity quantity, double p) const;
  std::uint64_t rocks() const;
  void add(const EnvelopeBin& other);
};

class Envelopes {
 public:
  /// A rock without fault.
  void add(int group, const PathBins& path);
  void add(const Envelopes& later);

  /// The bins that rocks of a group visited, by number.
  const std::map<std::int64_t, EnvelopeBin>& of_group(int group) const;
  /// All groups together.
  std::map<std::int64_t, EnvelopeBin> of_all() const;

  /// In little room, for chunk files; and back. Throws ColumnError where the bytes are no envelopes.
  std::string bytes() const;
  static Envelopes read(std::string_view bytes);

 private:
  std::map<int, std::map<std::int64_t, EnvelopeBin>> groups_;
};

}  // namespace flyrock
