#include "trial/outcomes.h"

#include "world/proportions.h"

namespace flyrock {

void Outcomes::set_shape(const Body<2>& rock) {
  (*this)[Outcome::volume] = rock.volume;
  (*this)[Outcome::elongation] = proportions_of(rock).elongation;
}

void Outcomes::set_shape(const Body<3>& rock) {
  const Proportions proportions = proportions_of(rock);
  (*this)[Outcome::volume] = rock.volume;
  (*this)[Outcome::elongation] = proportions.elongation;
  (*this)[Outcome::flatness] = proportions.flatness;
}

}  // namespace flyrock
