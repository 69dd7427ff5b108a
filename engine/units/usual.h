#pragma once
// What physical quantities are in practice, so that 2.7 kg/m3 of rock is asked about.

namespace flyrock {

/// A range of a quantity in practice, ends included [SI]. A value outside is taken, and warned of.
struct UsualRange {
  double least = 0, greatest = 0;
  bool or_zero = false;  ///< 0 means that there is none

  bool holds(double value) const { return (least <= value && value <= greatest) || (or_zero && value == 0); }
};

/// Of keys that several sections have. Plugins state theirs in their manifests.
namespace usual {
inline constexpr UsualRange density{500, 8000};
inline constexpr UsualRange launch{-300, 300};  ///< of a component of a velocity
inline constexpr UsualRange spin{-500, 500};
inline constexpr UsualRange burden{0.3, 20};  ///< and stemming
inline constexpr UsualRange hole_diameter{0.025, 0.5};
inline constexpr UsualRange detonation_velocity{1500, 8500};
inline constexpr UsualRange drag_coefficient{0.1, 2.5, true};
inline constexpr UsualRange stop_time{0, 3600};
}  // namespace usual

}  // namespace flyrock
