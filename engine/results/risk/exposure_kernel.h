#pragma once
// How likely a rock hits what is exposed, from where it lands: its landing is spread over Epanechnikov's
// kernel (results/risk/exposure.h).

#include <optional>

#include "record/records.h"
#include "results/risk/traffic.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The geometry of an exposure in a scenario of 2 or 3 dimensions. Places are in plan [m]; in 2D y is not
/// read.
class ExposureKernel {
 public:
  ExposureKernel(const ExposurePlan& plan, int dimension) : plan_(plan), dimension_(dimension) {}

  /// From a place [m].
  double distance(const Vec2& place) const;
  /// The probability q that a rock hits, with a kernel of this radius [m]: A K, on a line A times the mean of
  /// K along it, in 2D A K1 / (spread x way), `way` [m] from its release to the exposure.
  double chance(const Vec2& landing, double way, double radius) const;
  /// The greatest q of any landing.
  double greatest_chance(double way, double radius) const;

  /// With traffic: spread across the line only, so that the place along it stays. Nothing for a landing
  /// beyond the ends of the line.
  std::optional<StoneOnRoad> on_road(const Vec2& landing, double radius) const;

 private:
  double part_of_area(double way) const;
  double kernel_at(const Vec2& landing, double radius) const;
  double kernel_peak(double radius) const;

  const ExposurePlan& plan_;
  int dimension_;
};

/// Where a rock ended and where it started, in plan [m].
inline Vec2 landing_of(const RockRecord& rock) { return {rock.stop_x, rock.stop_y}; }
inline Vec2 release_of(const RockRecord& rock) { return {rock.start_x, rock.start_y}; }

/// The length of a line in plan [m].
double length_of(const std::vector<Vec2>& line);

}  // namespace flyrock
