#include "flight/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// When a motion whose x is linear in time arrives at `x`, which lies on its side `side`; 0 where it is there already.
double arrival(const Motion2& motion, double x, int side) {
  if (side == 0) return never;
  const double ahead = side * (x - motion.x.x()), speed = side * motion.v.x();
  if (ahead <= 0) return 0;
  return speed > 0 ? ahead / speed : never;
}

template <class Place>
std::vector<int> sides_of(std::span<const Place> places, double start) {
  std::vector<int> sides;
  for (const Place& place : places) sides.push_back(place.x >= start ? 1 : -1);
  return sides;
}

}  // namespace

Crossings::Crossings(World<2>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
                     std::vector<BodyHistory>& histories)
    : world_(world), gates_(gates), barriers_(barriers), histories_(histories) {
  for (const Body<2>& body : world.bodies) {
    gate_side_.push_back(sides_of(gates, body.x.x()));
    barrier_side_.push_back(sides_of(barriers, body.x.x()));
  }
}

double Crossings::time_to_barrier(int body) const {
  double first = never;
  for (std::size_t b = 0; b < barriers_.size(); ++b)
    first = std::min(first, arrival(world_.flight_of(body), barriers_[b].x, barrier_side_[body][b]));
  return first;
}

bool Crossings::moved(int body, const Motion2& motion, double start, double dt) {
  const Body<2>& b = world_.bodies[body];
  const Profile& profile = world_.terrain().profile();
  for (std::size_t g = 0; g < gates_.size(); ++g) {
    const double t = arrival(motion, gates_[g].x, gate_side_[body][g]);
    if (t > dt) continue;
    gate_side_[body][g] = 0;
    Passage passage;
    passage.gate = static_cast<int>(g);
    passage.time = start + t;
    passage.speed = motion.velocity(t).norm();
    passage.kinetic_energy = 0.5 * (b.mass * passage.speed * passage.speed + b.inertia * std::pow(motion.spin(t), 2));
    passage.height = motion.position(t).y() - profile.height(gates_[g].x);
    histories_[body].passages.push_back(passage);
  }
  for (std::size_t k = 0; k < barriers_.size(); ++k) {
    if (arrival(motion, barriers_[k].x, barrier_side_[body][k]) > dt) continue;
    barrier_side_[body][k] = 0;
    if (meet(body, static_cast<int>(k))) return true;
  }
  return false;
}

bool Crossings::meet(int body, int barrier) {
  const Barrier& fence = barriers_[barrier];
  Body<2>& b = world_.bodies[body];
  const double energy = b.kinetic_energy();
  BarrierHit hit;
  hit.barrier = barrier;
  hit.time = world_.time;
  hit.speed = b.v.norm();
  hit.kinetic_energy = energy;
  hit.height = b.x.y() - world_.terrain().profile().height(fence.x);
  if (hit.height >= fence.height) {
    hit.outcome = BarrierOutcome::over_top;
  } else if (energy <= fence.capacity) {
    hit.outcome = BarrierOutcome::caught;
  } else {
    hit.outcome = BarrierOutcome::over_energy;
    const double left = std::sqrt(1 - fence.capacity / energy);
    b.v *= left;
    b.w *= left;
  }
  histories_[body].barriers.push_back(hit);
  return hit.outcome == BarrierOutcome::caught;
}

}  // namespace flyrock
