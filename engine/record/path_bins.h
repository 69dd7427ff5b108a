#pragma once
// The extremes of one body's path in bins along x. Envelopes over many rocks are built from these bins.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace flyrock {

/// The greatest values of a body while its centre of mass was in a bin.
struct PathBin {
  double height = 0;  ///< m, of the centre of mass above the ground below it; not below 0
  double speed = 0;   ///< m/s
  double energy = 0;  ///< J, kinetic
};

/// Bin i is [i width, (i + 1) width). The visited bins are consecutive, because a path is continuous.
class PathBins {
 public:
  /// Records nothing.
  PathBins() = default;
  /// Bins over the ground from x_low to x_high [m]. Path points outside this range count in the first or last
  /// bin. A width of 0 records nothing.
  PathBins(double width, double x_low, double x_high);

  /// Number of the first visited bin; bins() starts with it.
  std::int64_t first() const { return low_ + begin_; }
  const std::vector<PathBin>& bins() const { return bins_; }

  /// Calls see(PathBin&, t0, t1) for each bin that x(t) = x + v t visits in [from, to]. t0 and t1 are the
  /// times of entry and exit.
  template <class See>
  void visit(double x, double v, double from, double to, See see) {
    if (width_ <= 0 || !std::isfinite(x) || !std::isfinite(v)) return;
    std::int64_t bin = index(x + v * from);
    const std::int64_t last = index(x + v * to);
    const int step = last < bin ? -1 : 1;
    for (double t = from;; bin += step) {
      const double edge = static_cast<double>(low_ + bin + (step > 0 ? 1 : 0)) * width_;
      const double leave = bin == last ? to : std::clamp((edge - x) / v, t, to);
      see(at(bin), t, leave);
      if (bin == last) return;
      t = leave;
    }
  }

 private:
  std::int64_t index(double x) const;  ///< counted from low_
  PathBin& at(std::int64_t index);

  double width_ = 0;
  std::int64_t low_ = 0, count_ = 0;  ///< the bins that cover the ground
  std::int64_t begin_ = 0;            ///< first bin of bins_, counted from low_
  std::vector<PathBin> bins_;
};

}  // namespace flyrock
