#pragma once
// Whether a vehicle is hit on a road. Vehicles are a Poisson stream: their centres lie on the line, which
// goes on beyond its ends, rho a metre (flow / speed). A stone at s hits each vehicle whose centre is within
// half a length l of it. Of stones that cover |C| metres together, none hits a vehicle with exp(-rho |C|).
//
// Stone i is on the strip with the probability p_i, independently of the others, at the place s_i along the
// line (s_1 <= s_2 <= ...). Then with W_j = E exp(-rho |covered by stones before j|), and A_k its part where
// k is the last stone before j that is there:
//   A_j = p_j [ e^(-rho l) (W_j - sum_k A_k miss_kj) + sum_k A_k miss_kj e^(-rho (s_j - s_k)) ],
//   W_j+1 = (1 - p_j) W_j + A_j,
// over the k within l of j, miss_kj = prod (1 - p_m) over the stones between. The expected |C| adds up in the
// same way. For p_i of 0 and 1 that is 1 - exp(-rho |C|); where nothing overlaps a stone hits with p (1 -
// e^(-rho l)).

#include <cstdint>
#include <span>
#include <vector>

namespace flyrock {

struct StoneOnRoad {
  double at;      ///< m, along the line
  double chance;  ///< that it is on the strip of the vehicles
};

struct VehicleHits {
  double chance = 0;   ///< that at least one vehicle is hit
  double covered = 0;  ///< m, the expected |C|: times rho, the expected number of vehicles that are hit
};

/// `stones` in the order of `at`; l and rho [m, 1/m].
VehicleHits vehicle_hits(std::span<const StoneOnRoad> stones, double vehicle, double per_metre);

/// S(s), the share of the trials in which a stone covers the place s of a road, by cells along it.
class CoveredRoad {
 public:
  /// m: the line and the length of a vehicle.
  CoveredRoad(double line, double vehicle);
  /// The stones of a trial, in any order.
  void add(std::span<const StoneOnRoad> stones);
  /// The integral of 1 - (1 - factor S(s))^weight over the line and half a vehicle beyond each end [m].
  double covered(std::uint64_t trials, double factor, double weight) const;

 private:
  double vehicle_, cell_;
  std::vector<double> log_missed_;  ///< of the trial that is being added: ln(1 - q), by cell
  std::vector<double> sum_;         ///< of q over the trials, by cell
};

}  // namespace flyrock
