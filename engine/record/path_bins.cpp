#include "record/path_bins.h"

namespace flyrock {

PathBins::PathBins(double width, double x_low, double x_high) : width_(width) {
  if (width <= 0) return;
  low_ = static_cast<std::int64_t>(std::floor(x_low / width));
  count_ = static_cast<std::int64_t>(std::floor(x_high / width)) - low_ + 1;
  bins_.reserve(static_cast<std::size_t>(count_));  // so that nothing is allocated while the body moves
}

std::int64_t PathBins::index(double x) const {
  const double bin = std::floor(x / width_) - static_cast<double>(low_);
  return static_cast<std::int64_t>(std::clamp(bin, 0.0, static_cast<double>(count_ - 1)));
}

PathBin& PathBins::at(std::int64_t index) {
  if (bins_.empty()) begin_ = index;
  if (index < begin_) {
    bins_.insert(bins_.begin(), static_cast<std::size_t>(begin_ - index), PathBin{});
    begin_ = index;
  }
  const auto place = static_cast<std::size_t>(index - begin_);
  if (place >= bins_.size()) bins_.resize(place + 1);
  return bins_[place];
}

}  // namespace flyrock
