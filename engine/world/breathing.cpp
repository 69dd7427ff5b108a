#include "world/breathing.h"

#include <algorithm>
#include <cmath>

#include "math/space.h"

namespace flyrock {

double Breathing::moment_at(double radius) const {
  const double share = radius / rest_radius;
  return moment * share * share;
}

double Breathing::gas_pressure() const {
  return gamma == 0 ? pressure : pressure * std::pow(rest_radius / now.radius, 2 * gamma);
}

double Breathing::force(double w) const {
  const double of_gas = 2 * pi * now.radius * thickness * (gas_pressure() - outside);
  const double of_spring = -stiffness * (now.radius - rest_radius);
  const double of_spin = moment_at(now.radius) / now.radius * w * w;  // J'(R) w^2 / 2 with J' = 2 J / R
  return of_gas + of_spring + of_spin;
}

double Breathing::frequency(double w) const {
  const double of_gas = 2 * pi * thickness * ((2 * gamma - 1) * gas_pressure() + outside);
  const double of_spin = 3 * moment_at(now.radius) / (now.radius * now.radius) * w * w;
  return std::sqrt(std::max(0.0, of_gas + stiffness + of_spin) / mass);
}

double Breathing::potential_energy() const {
  const double share = now.radius / rest_radius, stretch = now.radius - rest_radius;
  const double area = pi * rest_radius * rest_radius;
  // The work of the gas from R_0 to R is the integral of p 2 pi R T dR
  const double exponent = 2 - 2 * gamma;
  const double of_gas = exponent == 0
                            ? -2 * area * thickness * pressure * std::log(share)
                            : -2 * area * thickness * pressure * (std::pow(share, exponent) - 1) / exponent;
  const double of_air = area * thickness * outside * (share * share - 1);
  return of_gas + of_air + 0.5 * stiffness * stretch * stretch;
}

double Breathing::exchanged_energy(double w) const {
  const double moment_now = moment_at(now.radius);
  const double of_spin = 0.5 * moment_now * w * w * (1 - moment_now / moment);  // J w is kept
  return kinetic_energy() + std::abs(potential_energy()) + std::abs(of_spin);
}

double Breathing::free_rate(double w, double h, double theta) const {
  return now.rate + h * inverse_mass(theta * h) * (force(w) - damping * now.rate);
}

}  // namespace flyrock
