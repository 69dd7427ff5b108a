#pragma once
// What plugins and releases draw for a rock from their own random numbers, as numbers that describe the rock.

#include <array>
#include <limits>
#include <string_view>

#include "math/space.h"

namespace flyrock {

template <int D>
struct Body;

/// `volume` [m3]; `elongation`, the intermediate axis over the longest, and `flatness`, the shortest over the
/// intermediate, of the ellipsoid with the same moments of inertia (in 2D the ellipse: its shorter axis over
/// the longer, without flatness); `orientation` [rad], the angle of the turn from the shape's description to
/// the start; `release`: the centre of mass at the start [m].
enum class Outcome { volume, elongation, flatness, orientation, release_x, release_y, release_z };

struct OutcomeInfo {
  std::string_view name;
  const char* unit;  ///< SI
};
inline constexpr std::array<OutcomeInfo, 7> outcome_infos{{{"rock.volume", "m3"},
                                                           {"rock.elongation", "1"},
                                                           {"rock.flatness", "1"},
                                                           {"rock.orientation", "rad"},
                                                           {"release.x", "m"},
                                                           {"release.y", "m"},
                                                           {"release.z", "m"}}};

/// The outcomes of one rock; NaN where nothing was drawn.
class Outcomes {
 public:
  Outcomes() { values_.fill(std::numeric_limits<double>::quiet_NaN()); }
  double& operator[](Outcome outcome) { return values_[static_cast<std::size_t>(outcome)]; }
  double operator[](Outcome outcome) const { return values_[static_cast<std::size_t>(outcome)]; }

  void set_shape(const Body<2>& rock);
  void set_shape(const Body<3>& rock);
  template <int D>
  void set_release(const Vec<D>& place) {
    for (int k = 0; k < D; ++k)
      values_[static_cast<std::size_t>(Outcome::release_x) + static_cast<std::size_t>(k)] = place[k];
  }

 private:
  std::array<double, outcome_infos.size()> values_;
};

}  // namespace flyrock
