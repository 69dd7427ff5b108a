#pragma once
// Order statistics of a column of numbers that is too long to keep: exact, in a few passes and with little
// memory.
//
// Doubles are mapped to whole numbers in the same order, by their IEEE 754 bits. Each stretch of whole
// numbers that contains wanted ranks is cut into 1024 equal parts, and a pass counts the values in each part.
// The parts that contain wanted ranks are the stretches of the next pass. A stretch of at most 1024 values is
// kept and sorted instead. Each pass narrows a stretch by a factor of 1024, so at most seven passes are
// needed. A million values of similar size take two passes, a column of at most 1024 values takes one.
// Source: Munro and Paterson 1980, Selection and sorting with limited storage.

#include <cstdint>
#include <vector>

namespace flyrock {

class Selection {
 public:
  /// Looks for nothing and needs no pass.
  Selection() = default;
  /// Looks for x_r for each r in `ranks` (from 0, below `count`, in any order) among `count` numbers from
  /// `least` to `greatest`. No number may be NaN.
  Selection(std::vector<std::uint64_t> ranks, std::uint64_t count, double least, double greatest);

  /// Whether a pass, or another pass, is needed.
  bool open() const { return !open_.empty(); }
  /// Adds a number of the column, in any order.
  void add(double value);
  /// Ends a pass.
  void end_pass();

  /// x_rank, after the last pass. Throws std::out_of_range if the rank was not in `ranks`.
  double at(std::uint64_t rank) const;

 private:
  /// The numbers whose keys are from `low` to `high`.
  struct Stretch {
    std::uint64_t low, high;
    std::uint64_t before, count;       ///< number of values below `low`, and within
    int shift;                         ///< part of a key = (key - low) >> shift
    std::vector<std::uint64_t> parts;  ///< number of values in each part; empty if the values are kept
    std::vector<double> kept;
  };

  void look_within(std::uint64_t low, std::uint64_t high, std::uint64_t before, std::uint64_t count);
  bool wants(std::uint64_t before, std::uint64_t count) const;
  void settle(Stretch& stretch);
  void narrow(const Stretch& stretch);
  void answer(std::uint64_t before, std::uint64_t count, const double* sorted, std::size_t stride);

  std::vector<std::uint64_t> ranks_;  ///< sorted, each once
  std::vector<double> values_;        ///< for each rank
  std::vector<Stretch> open_;         ///< sorted
};

}  // namespace flyrock
