#pragma once
// Histograms of positive numbers over bins of equal ratio, as lists of the bins that occur. Counts are whole
// numbers, so that the histograms of chunks have the same sum in any order; or they are sums of weights, and
// the chunks must be added in their order.

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// Bins of a ratio r: code 0 is below 0.001, code k > 0 is from 0.001 r^(k-1) to 0.001 r^k.
class CodeScale {
 public:
  explicit CodeScale(double ratio);
  std::uint32_t code(double value) const;
  /// The middle of a code's values, on a logarithmic scale.
  double value(std::uint32_t code) const;

 private:
  double ratio_;
  double codes_a_doubling_;
  std::vector<double> starts_;  ///< the least value of each code
};

struct CodeCount {
  std::uint32_t code = 0;
  double rocks = 0;  ///< or the sum of their weights
};
/// In increasing order of the codes. Those of a few rocks need no memory of their own.
using CodeCounts = boost::container::small_vector<CodeCount, 2>;

void add_code(CodeCounts& counts, std::uint32_t code, double rocks = 1);
void merge_counts(CodeCounts& counts, const CodeCounts& more);
double rocks_in(const CodeCounts& counts);
/// The code of the smallest value that at least a share p of `all` does not exceed. There must be a count.
std::uint32_t quantile_code(const CodeCounts& counts, double all, double p);

/// As compact bytes for chunk files, and back. take_counts() throws ColumnError.
void put_counts(std::string& bytes, const CodeCounts& counts);
CodeCounts take_counts(std::string_view& bytes);

}  // namespace flyrock
