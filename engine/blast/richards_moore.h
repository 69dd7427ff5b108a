#pragma once
// Launch speeds from scaled burden and scaled stemming (Richards and Moore).

#include "blast/blast.h"

namespace flyrock {

/// Where the gas breaks out.
enum class RichardsMooreMode {
  face_burst,        ///< through the burden, out of the face
  cratering,         ///< through the stemming, where the rock around the collar breaks
  stemming_ejection  ///< along the hole, which throws its stemming
};

/// v = k (sqrt(m) / s)^1.3 [m/s] with the charge per metre m [kg/m]. s [m] is the burden for a face burst,
/// otherwise the stemming. k [m/s at sqrt(m) = s] is a site constant. In a vacuum, the range at the elevation
/// theta is (v^2/g) sin(2 theta). This gives the published distances (k^2/g)(sqrt(m)/s)^2.6, at 45 degrees or
/// at the drill angle. Throws std::invalid_argument that names a field that is not positive. Source: A. B.
/// Richards and A. J. Moore, Flyrock control - by chance or design, ISEE 2004.
double richards_moore_speed(RichardsMooreMode mode, double k, const Blast& blast);

}  // namespace flyrock
