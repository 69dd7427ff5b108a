#include "collision/broad_phase.h"

#include <algorithm>
#include <numeric>

namespace flyrock {

template <int D>
const std::vector<std::pair<int, int>>& SortAndSweep::pairs(const std::vector<Box<D>>& boxes) {
  if (order_.size() != boxes.size()) {
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0);
  }
  auto left = [&](int i) { return boxes[i].low.x(); };
  // Insertion sort, because the order hardly changes between calls
  for (std::size_t i = 1; i < order_.size(); ++i)
    for (std::size_t j = i; j > 0 && left(order_[j]) < left(order_[j - 1]); --j)
      std::swap(order_[j], order_[j - 1]);
  pairs_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i)
    for (std::size_t j = i + 1; j < order_.size() && left(order_[j]) <= boxes[order_[i]].high.x(); ++j)
      if (boxes[order_[i]].overlaps(boxes[order_[j]])) pairs_.push_back(std::minmax(order_[i], order_[j]));
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

template const std::vector<std::pair<int, int>>& SortAndSweep::pairs(const std::vector<Box2>&);
template const std::vector<std::pair<int, int>>& SortAndSweep::pairs(const std::vector<Box3>&);

}  // namespace flyrock
