#pragma once
// The design of a blast from what is known of its holes: what is left open, how much explosive, how much
// rock.

#include <string>

#include "blast/blast.h"

namespace flyrock {

/// Fills in what follows from other fields, and leaves what is given:
///   - of length, stemming and charge length of the hole the third from two: length = stemming + charge
///   length;
///   - the least burden of the charge from the burdens at crest and toe. From the collar to the bench's
///   floor, at the depth
///     H = length - subdrilling, it goes linearly from one to the other, and a deviation of the hole towards
///     the face [m per m of depth] takes its part of the depth from it; the least is at an end of the charge
///     above the floor.
/// Throws std::invalid_argument where nothing is left of the charge, the stemming or the burden.
void complete(Blast& blast);

/// Rows of holes behind a face and when they go off.
struct Pattern {
  int rows = 1, holes_per_row = 1;
  double row_distance = 0;                                  ///< m; 0 where it is not given
  double delay_row = 0, delay_hole = 0, delay_in_hole = 0;  ///< s

  int holes() const { return rows * holes_per_row; }
  /// Row of hole k, from 0; holes are numbered along the rows, the front row first.
  int row(int hole) const { return hole / holes_per_row; }
  /// When hole k goes off [s]: its row's delay, its own in the row, and that in the hole.
  double time(int hole) const {
    return row(hole) * delay_row + hole % holes_per_row * delay_hole + delay_in_hole;
  }
};

/// Quantities of a blast; NaN where the fields that they need are not given.
struct BlastDesign {
  double linear_charge = 0;    ///< kg/m
  double charge_per_hole = 0;  ///< kg
  double explosive = 0;        ///< kg, of all holes
  double rock = 0;  ///< m3, of all holes: burden (behind the front row the distance of rows) x spacing x H
  double powder_factor = 0;  ///< kg/m3, explosive / rock
  double powder_factor_shallow = 0,
         powder_factor_deep = 0;  ///< kg/m3, 0.5 and 0.8 rho c/m, of the breakout prism
  double depth_of_burial = 0;     ///< m/kg^(1/3), scaled (McKenzie)
  double fragment = 0;            ///< m, that flies farthest (McKenzie)
  double last_time = 0;           ///< s, when the last hole goes off
};

/// Of a completed blast. Source of the powder factors by c/m: Fly-rock distance (Ninh Dan), after Roth 1979.
BlastDesign design_of(const Blast& blast, const Pattern& pattern);

/// What does not agree in a design, or an empty text: the powder factor that is given with the geometry's by
/// more than a fifth, or the geometry's beyond both forms of c/m by more than a fifth.
std::string disagreement(const Blast& blast, const BlastDesign& design);

}  // namespace flyrock
