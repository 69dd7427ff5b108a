#include "random/spacings.h"

#include <algorithm>
#include <stdexcept>

namespace flyrock {

namespace {

double draw(const Distribution& law, RandomStream& rng) { return law.quantile(rng.uniform()); }

/// A gap drawn with a probability in proportion to its length, by rejection.
double draw_by_length(const Distribution& law, RandomStream& rng) {
  const double longest = law.likely_highest();
  for (;;) {
    const double gap = draw(law, rng);
    if (rng.uniform() * longest <= gap) return gap;
  }
}

}  // namespace

double mean_of(const Distribution& law) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += law.quantile((i + 0.5) / steps);
  return sum / steps;
}

std::vector<double> places_with_spacing(const Distribution& law, std::optional<double> origin, double low,
                                        double high, RandomStream& rng) {
  double first = origin.value_or(0), before = first;  // the places next to the gap where both walks begin
  if (!origin) {
    const double gap = draw_by_length(law, rng);
    first = 0.5 * (low + high) + gap * rng.uniform();
    before = first - gap;
  }
  std::vector<double> places;
  std::size_t count = 0;
  const auto meet = [&](double place) {
    if (++count > most_places) throw std::length_error("too many places");
    if (place >= low && place <= high) places.push_back(place);
  };
  for (double place = origin ? first - draw(law, rng) : before; place >= low; place -= draw(law, rng))
    meet(place);
  std::reverse(places.begin(), places.end());
  for (double place = first; place <= high; place += draw(law, rng)) meet(place);
  return places;
}

}  // namespace flyrock
