#include "blast/richards_moore.h"

#include <cmath>

namespace flyrock {

double richards_moore_speed(RichardsMooreMode mode, double k, const Blast& blast) {
  const BlastField confinement =
      mode == RichardsMooreMode::face_burst ? BlastField::burden : BlastField::hole_stemming;
  return k * std::pow(std::sqrt(linear_charge(blast)) / positive(blast, confinement), 1.3);
}

}  // namespace flyrock
