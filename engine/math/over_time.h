#pragma once
// A number or a vector that changes over time, as the rows of a table: linear between two rows, constant
// before the first one and after the last one.

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/space.h"

namespace flyrock {

class OverTime {
 public:
  struct Row {
    double time = 0;            ///< s
    Vec3 value = Vec3::Zero();  ///< a number is the x of it; in 2D z = 0
  };

  /// `rows`: at least one, at rising times.
  explicit OverTime(std::vector<Row> rows) : rows_(std::move(rows)) {
    for (const Row& row : rows_) greatest_ = std::max(greatest_, row.value.norm());
  }

  const std::vector<Row>& rows() const { return rows_; }
  /// The value is constant from then on [s].
  double last_change() const { return rows_.back().time; }

  Vec3 at(double time) const {
    const auto next = row_after(time);
    if (next == rows_.begin()) return next->value;
    const Row& before = *(next - 1);
    if (next == rows_.end()) return before.value;
    return before.value + (time - before.time) / (next->time - before.time) * (next->value - before.value);
  }

  /// The end of the piece of time after `time` over which a load may act with its mean [s]: the next row, or
  /// the time in which it changes by a thousandth of its greatest value, but at least 1 ms.
  double end_of_piece(double time) const {
    const auto next = row_after(time);
    if (next == rows_.begin() || next == rows_.end()) return next_row(time);
    constexpr double notable = 1e-3, shortest = 1e-3;  // of the greatest value; s
    const Row& before = *(next - 1);
    const double length = next->time - before.time;
    const double change = (next->value - before.value).norm();
    const double pieces = change > 0 ? std::ceil(change / (notable * greatest_) - notable) : 1;
    const double piece = length / std::clamp(pieces, 1.0, std::max(1.0, std::floor(length / shortest)));
    const double end = before.time + piece * (std::floor((time - before.time) / piece + notable) + 1);
    return end > next->time - 0.5 * piece ? next->time : end;
  }

  /// The time of the first row after `time` [s]; infinite after the last one.
  double next_row(double time) const {
    const auto next = row_after(time);
    return next == rows_.end() ? infinite : next->time;
  }

 private:
  std::vector<Row>::const_iterator row_after(double time) const {
    return std::upper_bound(rows_.begin(), rows_.end(), time,
                            [](double t, const Row& row) { return t < row.time; });
  }

  std::vector<Row> rows_;
  double greatest_ = 0;
};

}  // namespace flyrock
