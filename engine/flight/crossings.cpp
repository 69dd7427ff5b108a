#include "flight/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flight/ground.h"
#include "math/travel_time.h"

namespace flyrock {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

template <int D>
double arrival(const Path<D>& path, double x, int side, int axis) {
  return travel_times(side * (x - path.x[axis]), side * path.v[axis], side * path.a[axis])[0];
}

template <int D>
Crossings<D>::Crossings(World<D>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
                        const RunForest& trees, std::span<const DrawKey> keys,
                        std::vector<BodyHistory>& histories)
    : world_(world), gates_(gates), barriers_(barriers), histories_(histories) {
  for (const Body<D>& body : world.bodies) {
    to_gates_.push_back(approaches(gates, in_plan(body.x)));
    to_barriers_.push_back(approaches(barriers, in_plan(body.x)));
  }
  for (std::size_t i = 0; i < world.bodies.size() && trees.forest; ++i)
    trees_.emplace_back(trees, world.terrain(), world.bodies[i].volume,
                        i < keys.size() ? keys[i] : DrawKey());
}

template <int D>
double Crossings<D>::time_to_barrier(int body, const Path<D>& path) const {
  double first = never;
  for (const Approach& approach : to_barriers_[body])
    if (const auto arrival = approach.arrival(in_plan(path), first)) first = std::min(first, arrival->time);
  return first;
}

template <int D>
double Crossings<D>::time_to_tree(int body, const Path<D>& path, double longest) const {
  if (trees_.empty() || trees_[body].passive()) return never;
  const auto touch = trees_[body].first(path, longest);
  return touch ? touch->time : never;
}

template <int D>
bool Crossings<D>::moved(int body, const Motion& motion, double start, double dt) {
  if (gates_.empty() && barriers_.empty() && trees_.empty()) return false;
  const PlanPath path = in_plan(motion);
  const Vec2 end = in_plan(motion.position(dt));
  for (std::size_t g = 0; g < gates_.size(); ++g) {
    Approach& to_gate = to_gates_[body][g];
    const auto arrival = to_gate.arrival(path, dt);
    to_gate.move_to(end);
    if (!arrival) continue;
    to_gate.arrive();
    const double t = arrival->time;
    histories_[body].passages.push_back({{start + t, motion.velocity(t).norm(), energy_at(body, motion, t),
                                          height(motion.position(t), arrival->place), arrival->along},
                                         static_cast<int>(g)});
  }
  for (std::size_t k = 0; k < barriers_.size(); ++k) {
    Approach& to_barrier = to_barriers_[body][k];
    const auto arrival = to_barrier.arrival(path, dt);
    to_barrier.move_to(end);
    if (!arrival) continue;
    to_barrier.arrive();
    if (catches(static_cast<int>(k), body, *arrival)) return true;
  }
  return !trees_.empty() && caught_by_tree(body, motion, start, dt);
}

template <int D>
double Crossings<D>::energy_at(int body, const Motion& motion, double t) const {
  const Body<D>& b = world_.bodies[body];
  const Turned<D> turned = turn_at(motion, t);
  const double speed = motion.velocity(t).norm();
  return 0.5 * (b.mass * speed * speed + twice_spin_energy(b, turned.attitude, turned.spin));
}

template <int D>
bool Crossings<D>::caught_by_tree(int body, const Motion& motion, double start, double dt) {
  TreeWatch<D>& trees = trees_[body];
  std::vector<TreeHit>& hits = histories_[body].trees;
  Body<D>& b = world_.bodies[body];
  double left = 1;
  if (trees.passive()) {
    while (const auto touch = trees.first(motion, dt)) {
      const double t = touch->time;
      Vec<D> velocity = motion.velocity(t);
      hits.push_back(
          trees.hit(touch->tree, start + t, energy_at(body, motion, t), motion.position(t), velocity, left));
    }
    return false;
  }
  // Slightly beyond the end, because a flight that ends at a tree may end before it by rounding.
  const auto touch = trees.first(motion, dt * (1 + 1e-12) + 1e-12);
  if (!touch) return false;
  hits.push_back(trees.hit(touch->tree, world_.time, b.kinetic_energy(), b.x, b.v, left));
  b.w *= left;
  return left == 0;
}

template <int D>
double Crossings<D>::height(const Vec<D>& position, const Vec2& at) const {
  const auto ground = ground_height(world_.terrain(), moved_to<D>(position, at));
  return ground ? position[D - 1] - *ground : never;
}

template <int D>
bool Crossings<D>::catches(int barrier, int body, const Approach::Arrival& at) {
  const Barrier& fence = barriers_[barrier];
  Body<D>& b = world_.bodies[body];
  const BarrierHit hit =
      meet(fence, barrier, {world_.time, b.v.norm(), b.kinetic_energy(), height(b.x, at.place), at.along},
           b.volume);
  const double left = velocity_left(fence, hit);
  b.v *= left;
  b.w *= left;
  histories_[body].barriers.push_back(hit);
  return hit.outcome == BarrierOutcome::caught;
}

template double arrival(const Path<2>&, double, int, int);
template double arrival(const Path<3>&, double, int, int);
template class Crossings<2>;
template class Crossings<3>;

}  // namespace flyrock
