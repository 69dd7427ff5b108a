#pragma once
// The vertical section through quarry benches, which the profile of 2D is and the surface of 3D is swept
// from.

#include <optional>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock::plugins {

/// A ditch at the lowest toe: the lowest face goes on down to its bottom, which is level; the far side rises
/// to the floor.
struct Ditch {
  double width = 0;  ///< m, of the bottom
  double depth = 0;  ///< m, below the floor
  double slope = 0;  ///< rad, of the far side
};

/// A bank with two equal sides and a level top.
struct Bund {
  double height = 0, top = 0;  ///< m
  double slope = 0;            ///< rad, of its sides
  bool on_berms = false;       ///< at the outer edge of each berm between two benches; otherwise on the floor
  double distance = 0;         ///< m, on the floor: from the ditch, or from the lowest toe
  double base() const;         ///< m, its width at the ground
};

/// A prism that is taken out of a bench: between its face, a plane parallel to it and a base through the toe.
struct Notch {
  int bench = 1;
  double depth = 0;         ///< m, horizontal, from the face to the plane behind it
  double base = 0;          ///< rad, by which the base rises from the toe into the rock
  double from = 0, to = 0;  ///< m, in 3D, along the crest
};

struct BenchNumbers {
  int count = 1;
  double height = 0;      ///< m
  double face_angle = 0;  ///< rad
  double berm = 0;        ///< m
  double floor = 0;       ///< m, beyond the lowest toe
  double top = 50;        ///< m of berm behind the uppermost crest
  std::optional<Ditch> ditch;
  std::optional<Bund> bund;
  std::optional<Notch> notch;
};

/// What a stretch of the section is, in the order of `parts`.
enum class BenchPart { face, berm, floor, ditch, bund, notch_back, notch_base, notch_end };

/// Points from left to right: x = 0 at the uppermost crest, y = 0 on the floor.
struct Section {
  std::vector<Vec2> points;
  std::vector<BenchPart> part;     ///< of each stretch
  std::vector<int> bench;          ///< of each stretch, from 1; 0: below all benches
  std::vector<int> crests, toes;   ///< of each face, from the uppermost: indices of points
  std::vector<std::string> parts;  ///< names: face, berm, floor, and those of what else there is
  /// The notch, in the order of the section: the crest of its back, the end of its base, the toe; and the
  /// crest that was taken away.
  struct NotchRows {
    int back = 0, base = 0, toe = 0;
    Vec2 crest = Vec2::Zero();
  };
  std::optional<NotchRows> notch;

  /// The index of a part in `parts`.
  int index_of(BenchPart one) const;
};

/// Throws ParameterError if the numbers do not fit together.
Section section_of(const BenchNumbers& numbers);

/// "the face of bench 2", "the berm below bench 1", "the ditch".
std::string stretch_name(const Section& section, int stretch);

}  // namespace flyrock::plugins
