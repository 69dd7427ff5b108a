#include "random/pieces_by_mass.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

constexpr int intervals = 2000;

/// Sizes from `low` to `high`, each greater than the last by the same factor, and the sieves between them.
std::vector<double> sizes_between(const Distribution& mass, double low, double high) {
  std::vector<double> sizes;
  if (mass.kind == DistributionKind::sieve)
    for (const double size : mass.values)
      if (size > low && size < high) sizes.push_back(size);
  const int count = mass.kind == DistributionKind::sieve ? 1 : intervals;
  for (int i = 0; i < count; ++i) sizes.push_back(low * std::pow(high / low, i / static_cast<double>(count)));
  sizes.push_back(high);
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

/// The number of pieces from size `low` to `high` for each unit of mass, which is linear in ln x between
/// them: the integral of x^-4 over that of 1/x.
double pieces_of_a_mass(double low, double high) {
  const double ratio = low / high;
  return (1 - ratio * ratio * ratio) / (3 * low * low * low * std::log(high / low));
}

}  // namespace

std::string by_mass_fault(const Distribution& mass) {
  if (!mass.is_continuous())
    return "single values are counted as they are, `by: mass` is for a continuous one";
  if (!(mass.lowest() > 0)) return "pieces without a least size have no number: give it a `min`";
  return {};
}

Distribution pieces_by_mass(const Distribution& mass) {
  const double low = mass.lowest(), high = mass.likely_highest();
  Distribution pieces;
  pieces.kind = DistributionKind::sieve;
  pieces.between = CountedBy::mass;
  double number = 0, last_share = 0;
  for (const double size : sizes_between(mass, low, high)) {
    const double share = mass.share_below(size);
    if (pieces.values.empty()) {
      pieces.values.push_back(size);
      pieces.weights.push_back(0);
    } else if (const double more = (share - last_share) * pieces_of_a_mass(pieces.values.back(), size);
               number + more > number) {
      number += more;
      pieces.values.push_back(size);
      pieces.weights.push_back(number);
    } else {
      continue;  // so little mass that no piece is drawn from it
    }
    last_share = share;
  }
  for (double& weight : pieces.weights) weight /= number;
  pieces.weights.back() = 1;
  return pieces;
}

}  // namespace flyrock
