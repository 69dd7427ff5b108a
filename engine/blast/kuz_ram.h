#pragma once
// The sizes into which a blast breaks rock (Kuznetsov's mean size, Cunningham's uniformity).

#include "blast/blast.h"

namespace flyrock {

/// The sizes of broken rock by mass: F(x) = 1 - 2^-(x/median)^uniformity (Rosin and Rammler).
struct FragmentSizes {
  double median = 0;  ///< m
  double uniformity = 0;
};

/// What Kuz-Ram asks beside the blast.
struct KuzRam {
  double rock_factor = 7;  ///< A: 7 medium, 10 hard and fissured, 13 hard and massive rock
  double strength = 1;     ///< RWS / 100: by weight, relative to ANFO
  double deviation = 0;    ///< m, standard deviation W of where holes are drilled
};

/// The volume [m3] that one hole breaks, burden x spacing x H with the bench height H = length -
/// subdrilling. Throws std::invalid_argument.
double volume_of_hole(const Blast& blast);

/// With B burden, S spacing, d diameter of the hole [mm], V volume_of_hole, Q charge of a hole [kg], L the
/// charge length above the floor:
///   median = A (V/Q)^0.8 Q^(1/6) (115/RWS)^(19/30) cm
///   uniformity = (2.2 - 14 B/d) sqrt((1 + S/B)/2) (1 - W/B) 1.1^0.1 (L/H)
/// 1.1^0.1 is (|bottom - column|/L + 0.1)^0.1 for one charge in the hole. Throws std::invalid_argument if a
/// field is missing or the uniformity is not positive. Source: C. V. B. Cunningham, Fragmentation estimations
/// and the Kuz-Ram model, Fragblast 1987 (recalled, unverified; the median as open programs have it).
FragmentSizes kuz_ram(const Blast& blast, const KuzRam& rock);

}  // namespace flyrock
