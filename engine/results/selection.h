#pragma once
// Order statistics of a column of numbers that is too long to keep: exact, in a few passes and in little
// memory.
//
// Doubles are mapped to whole numbers in the same order (of their bits, as IEEE 754 is laid out). Each
// stretch of that line which holds wanted ranks is cut into 1024 equal parts whose values are counted in a
// pass; parts that hold wanted ranks are the stretches of the next pass. A stretch of 1024 values or less is
// kept and sorted instead. A pass narrows a stretch by 1024, so that there are seven at most; a million
// values of one size take two. A column of 1024 values takes one. Source: Munro and Paterson 1980, Selection
// and sorting with limited storage.

#include <cstdint>
#include <vector>

namespace flyrock {

class Selection {
 public:
  /// Wants nothing and needs no pass.
  Selection() = default;
  /// Looks for x_r of each r in `ranks` (from 0, below `count`, in any order) among `count` numbers from
  /// `least` to `greatest`. None is NaN.
  Selection(std::vector<std::uint64_t> ranks, std::uint64_t count, double least, double greatest);

  /// Whether (another) pass is needed.
  bool open() const { return !open_.empty(); }
  /// Each number of the column, in any order.
  void add(double value);
  /// Ends a pass.
  void end_pass();

  /// x_rank, once no pass is needed. Throws std::out_of_range where the rank was not wanted.
  double at(std::uint64_t rank) const;

 private:
  /// Numbers whose keys lie from `low` to `high`.
  struct Stretch {
    std::uint64_t low, high;
    std::uint64_t before, count;       ///< numbers below `low`, and within
    int shift;                         ///< the part of a key is (key - low) >> shift
    std::vector<std::uint64_t> parts;  ///< how many numbers in each; empty where they are kept
    std::vector<double> kept;
  };

  void look_within(std::uint64_t low, std::uint64_t high, std::uint64_t before, std::uint64_t count);
  bool wants(std::uint64_t before, std::uint64_t count) const;
  void settle(Stretch& stretch);
  void narrow(const Stretch& stretch);
  void answer(std::uint64_t before, std::uint64_t count, const double* sorted, std::size_t stride);

  std::vector<std::uint64_t> ranks_;  ///< in order, each once
  std::vector<double> values_;        ///< of each rank
  std::vector<Stretch> open_;         ///< in order
};

}  // namespace flyrock
