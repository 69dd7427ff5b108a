#include "random/pieces_by_mass.h"

#include <cmath>
#include <span>

namespace flyrock {

namespace {

constexpr int intervals = 2000;

/// Rising sizes from `low` to `high`: of a sieve curve its own, of others a geometric series.
std::vector<double> sizes_between(const Distribution& mass, double low, double high) {
  std::vector<double> sizes{low};
  const auto add = [&](double size) {
    if (size > sizes.back() && size < high) sizes.push_back(size);
  };
  if (mass.kind == DistributionKind::sieve)
    for (const double size : mass.values) add(size);
  else
    for (int i = 1; i < intervals; ++i) add(low * std::pow(high / low, i / static_cast<double>(intervals)));
  sizes.push_back(high);
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
  const std::vector<double> sizes = sizes_between(mass, mass.lowest(), mass.likely_highest());
  Distribution pieces;
  pieces.kind = DistributionKind::sieve;
  pieces.between = CountedBy::mass;
  pieces.values = {sizes.front()};
  pieces.weights = {0};
  double number = 0, mass_below = mass.cumulative(sizes.front());
  for (const double size : std::span(sizes).subspan(1)) {
    const double now_below = mass.cumulative(size);
    const double more = (now_below - mass_below) * pieces_of_a_mass(pieces.values.back(), size);
    if (!(number + more > number)) continue;  // so little mass that no piece is drawn from it
    number += more;
    pieces.values.push_back(size);
    pieces.weights.push_back(number);
    mass_below = now_below;
  }
  for (double& weight : pieces.weights) weight /= number;
  pieces.weights.back() = 1;
  return pieces;
}

}  // namespace flyrock
