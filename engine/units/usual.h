#pragma once
// Usual ranges of physical quantities, so that flyrock warns of a rock density of 2.7 kg/m3.

namespace flyrock {

/// The usual range of a quantity in practice, ends included [SI]. A value outside it is accepted with a
/// warning.
struct UsualRange {
  double least = 0, greatest = 0;
  bool or_zero = false;  ///< 0 means that there is none

  bool holds(double value) const { return (least <= value && value <= greatest) || (or_zero && value == 0); }
};

/// Ranges for keys that several sections have. Plugins declare their own in their manifests.
namespace usual {
inline constexpr UsualRange density{500, 8000};
inline constexpr UsualRange launch{-300, 300};  ///< one component of a velocity
inline constexpr UsualRange spin{-500, 500};
inline constexpr UsualRange burden{0.3, 20};  ///< also used for the stemming
inline constexpr UsualRange hole_diameter{0.025, 0.5};
inline constexpr UsualRange detonation_velocity{1500, 8500};
inline constexpr UsualRange drag_coefficient{0.1, 2.5, true};
inline constexpr UsualRange stop_time{0, 3600};
inline constexpr UsualRange barrier_height{0.5, 12};
inline constexpr UsualRange barrier_capacity{1e4, 1e7};
inline constexpr double face_angle = 30;  ///< deg, of the flattest face
}  // namespace usual

}  // namespace flyrock
