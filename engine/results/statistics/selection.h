#pragma once
// Order statistics of a column of numbers that is too long to keep: exact, in a few passes and with little
// memory.
//
// Doubles are mapped to whole numbers in the same order, by their IEEE 754 bits. Each stretch of whole
// numbers that contains wanted ranks is cut into equal parts, and a pass counts the values in each part. The
// parts that contain wanted ranks are the stretches of the next pass. A stretch of at most 4096 values is
// kept and sorted instead. There are 1024 parts, of more than 500,000 values up to 65,536, so that few values
// of a similar size share a part. Each pass narrows a stretch by a factor of 1024 or more, so at most seven
// passes are needed. Ten million values of similar size take two passes, a column of at most 4096 values
// takes one. Further ranks of the same column begin with the parts that the first pass has counted. Source:
// Munro and Paterson 1980, Selection and sorting with limited storage.
//
// A number may count with a weight. The order statistic of rank r is then the least number x for which the
// numbers up to x weigh more than r; with weights of 1 that is the r-th one, counted from 0.

#include <cstdint>
#include <vector>

namespace flyrock {

class Selection {
 public:
  /// Looks for nothing and needs no pass.
  Selection() = default;
  /// Looks for x_r for each r in `ranks` (from 0, below `weight`, in any order) among `count` numbers from
  /// `least` to `greatest` that weigh `weight` together. No number may be NaN.
  Selection(std::vector<double> ranks, std::uint64_t count, double weight, double least, double greatest);

  /// Whether a pass, or another pass, is needed.
  bool open() const { return !open_.empty(); }
  /// Adds a number of the column, in any order if all weights are whole, else in the same order in each pass.
  void add(double value, double weight = 1);
  /// Ends a pass.
  void end_pass();
  /// A search for other ranks of the same column, once this one has ended. It takes over what the first pass
  /// has counted, so it can be asked for once.
  Selection search_again(std::vector<double> ranks);
  /// Frees what the first pass has counted.
  void forget() { first_ = {}; }

  /// x_rank, after the last pass. Throws std::out_of_range if the rank was not in `ranks`.
  double at(double rank) const;

 private:
  /// Numbers of a column that lie close to each other.
  struct Heap {
    std::uint64_t count = 0;
    double weight = 0;
  };
  struct Kept {
    double value, weight;
  };
  /// Ranks that are looked for, by their places in ranks_: from `first` to before `end`.
  struct Wanted {
    std::size_t first, end;
  };
  /// The numbers whose keys are from `low` to `high`.
  struct Stretch {
    std::uint64_t low, high;
    double before;  ///< weight of the values below `low`
    Wanted wanted;
    int shift;                ///< part of a key = (key - low) >> shift
    std::vector<Heap> parts;  ///< empty if the values are kept
    std::vector<Kept> kept;
  };

  void look_for(std::vector<double> ranks);
  void find_lows();
  void look_within(std::uint64_t low, std::uint64_t high, double before, std::uint64_t count, Wanted wanted);
  Wanted take(Wanted& left, double end) const;
  void settle(Stretch& stretch);
  void narrow(const Stretch& stretch);

  /// Least and greatest key of the column, and how many numbers it has.
  std::uint64_t low_ = 0, high_ = 0, count_ = 0;
  double weight_ = 0;

  std::vector<double> ranks_;        ///< sorted, each once
  std::vector<double> values_;       ///< for each rank
  std::vector<Stretch> open_;        ///< sorted
  std::vector<std::uint64_t> lows_;  ///< Stretch::low of each, close together for the search of each number
  Stretch first_ = {};               ///< of the first pass; without parts: not counted, or forgotten
};

}  // namespace flyrock
