#pragma once
// The design of a blast, computed from the data of its holes: missing fields, mass of explosive, volume of
// rock.

#include <string>

#include "blast/holes.h"
#include "blast/sources.h"

namespace flyrock {

/// Fills in fields that follow from other fields. Given fields are not changed.
///   - Two of length, stemming and charge length of the hole give the third:
///     length = stemming + charge length.
///   - The burdens at crest and toe give the smallest burden along the charge. From the collar to the bench
///     floor, at the depth H = length - subdrilling, the burden changes linearly from one to the other. A
///     deviation of the hole towards the face [m per m of depth] is subtracted in proportion to the depth.
///     The smallest burden is at an end of the charge above the floor.
///   - The charge of a hole, or its charge per length, gives the other one and the density that the explosive
///     has in the hole, or the diameter that it fills; diameter and density give both.
/// Notes in `sources` from which fields each one follows. Throws std::invalid_argument if the charge, the
/// stemming or the burden would not be positive.
void complete(Blast& blast, BlastSources* sources = nullptr);

/// Rows of holes behind a face, or holes that were measured, and their firing times.
struct Pattern {
  int rows = 1, holes_per_row = 1;
  double row_distance = 0;                                  ///< m; 0 if it is not given
  double delay_row = 0, delay_hole = 0, delay_in_hole = 0;  ///< s

  std::vector<Hole> measured = {};  ///< in place of rows; empty: rows

  int holes() const { return measured.empty() ? rows * holes_per_row : static_cast<int>(measured.size()); }
  /// The row of hole k, from 0. Holes are numbered along the rows, the front row first.
  int row(int hole) const { return hole / holes_per_row; }
  /// The firing time of hole k [s]: the sum of the delay of its row, its delay within the row, and the
  /// in-hole delay.
  double time(int hole) const {
    if (!measured.empty()) return measured[static_cast<std::size_t>(hole)].time;
    return row(hole) * delay_row + hole % holes_per_row * delay_hole + delay_in_hole;
  }
};

/// Quantities of a blast. NaN if the fields that they need are not given.
struct BlastDesign {
  double linear_charge = 0;    ///< kg/m
  double charge_per_hole = 0;  ///< kg
  double explosive = 0;        ///< kg, total of all holes
  /// m3, total of all holes: burden (for rows behind the front row, the row distance) x spacing x H
  double rock = 0;
  double powder_factor = 0;  ///< kg/m3, explosive / rock
  double powder_factor_shallow = 0,
         powder_factor_deep = 0;  ///< kg/m3, 0.5 and 0.8 rho c/m, of the breakout prism
  double depth_of_burial = 0;     ///< m/kg^(1/3), scaled (McKenzie)
  double fragment = 0;            ///< m, size of the fragment that flies farthest (McKenzie)
  double last_time = 0;           ///< s, when the last hole goes off
  double charge_to_mass = 0;      ///< c/m of the breakout prism (Roth)
};

/// The design of a completed blast. Source of the powder factors from c/m: Fly-rock distance (Ninh Dan),
/// after Roth 1979.
BlastDesign design_of(const Blast& blast, const Pattern& pattern);

/// The design of a blast from those of its holes: explosive and rock are sums, the charge of a hole is their
/// mean, powder factors are weighted by the rock. What belongs to one hole only is NaN.
BlastDesign design_of_holes(const std::vector<BlastDesign>& holes, const Pattern& pattern);

/// What is inconsistent in a design, or an empty text. Reports a given powder factor that differs from the
/// geometric one by more than a fifth, and a geometric one that lies outside the two values from c/m by more
/// than a fifth.
std::string disagreement(const Blast& blast, const BlastDesign& design);

}  // namespace flyrock
