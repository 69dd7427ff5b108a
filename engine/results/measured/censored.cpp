#include "results/measured/censored.h"

#include <algorithm>

namespace flyrock {

namespace {

void add_to(std::vector<CensoredPlace>& places, const CensoredPlace& place) {
  const auto same = [&](const CensoredPlace& other) { return other.same_place(place); };
  const auto found = std::find_if(places.begin(), places.end(), same);
  if (found == places.end())
    places.push_back(place);
  else
    found->add(place);
}

std::vector<CensoredPlace> sorted(std::vector<CensoredPlace> places) {
  const auto more = [](const CensoredPlace& a, const CensoredPlace& b) { return a.rocks > b.rocks; };
  std::stable_sort(places.begin(), places.end(), more);
  return places;
}

}  // namespace

bool CensoredPlace::same_place(const CensoredPlace& other) const {
  // On a part, the part says where. In the air or outside the domain, only the direction distinguishes the
  // two ends.
  return reason == other.reason && part == other.part && (part >= 0 || ahead == other.ahead);
}

void CensoredPlace::add(const CensoredPlace& other) {
  rocks += other.rocks;
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

void CensoredTally::add(const RockRecord& rock) {
  if (!rock.censored) return;
  const Vec3 at(rock.stop_x, rock.stop_y, rock.stop_z);
  add_to(places_, {rock.reason, rock.end_part, rock.stop_x >= rock.start_x, 1, at, at});
}

std::vector<CensoredPlace> CensoredTally::places() const { return sorted(places_); }

std::vector<CensoredPlace> joined(const std::vector<std::vector<CensoredPlace>>& points) {
  std::vector<CensoredPlace> all;
  for (const std::vector<CensoredPlace>& point : points)
    for (const CensoredPlace& place : point) add_to(all, place);
  return sorted(std::move(all));
}

}  // namespace flyrock
