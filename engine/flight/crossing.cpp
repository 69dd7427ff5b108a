#include "flight/crossing.h"

#include <algorithm>

#include "flight/ground.h"

namespace flyrock {

namespace {

constexpr double never = infinite;

/// The kinetic energy of a body along a motion [J].
template <int D, class Motion>
double energy_along(const Body<D>& body, const Motion& motion, double t) {
  const Turned<D> turned = turn_at(motion, t);
  const double speed = motion.velocity(t).norm();
  return 0.5 * (body.mass * speed * speed + twice_spin_energy(body, turned.attitude, turned.spin));
}

}  // namespace

template <int D>
Crossing<D>::Crossing(const AnyRun& run, const Terrain& terrain, const Vec<D>& start, double volume,
                      const DrawKey& key, BodyHistory& history)
    : run_(run),
      terrain_(terrain),
      volume_(volume),
      history_(history),
      to_gates_(approaches(run.gates, in_plan(start))),
      to_barriers_(approaches(run.barriers, in_plan(start))),
      trees_(run.forest, terrain, volume, key) {}

template <int D>
double Crossing<D>::time_to_barrier(const Path<D>& path) const {
  double first = never;
  for (const Approach& approach : to_barriers_)
    if (const auto arrival = approach.arrival(in_plan(path), first)) first = std::min(first, arrival->time);
  return first;
}

template <int D>
double Crossing<D>::time_to_tree(const Path<D>& path, double longest) const {
  if (!has_trees()) return never;
  const auto touch = first_tree(path, longest);
  return touch ? touch->time : never;
}

template <int D>
bool Crossing<D>::moved(Body<D>& body, const Motion& motion, double start, double dt, double now) {
  pass_gates(motion, dt, dt, [&](const Approach::Arrival& at) -> Arrival {
    return {start + at.time, motion.velocity(at.time).norm(), energy_along(body, motion, at.time),
            height(motion.position(at.time), at.place), at.along};
  });
  for (std::size_t b = 0; b < to_barriers_.size(); ++b) {
    const auto at = to_barriers_[b].arrival(in_plan(motion), dt);
    to_barriers_[b].move_to(in_plan(motion.position(dt)));
    if (!at) continue;
    const Effect effect = meets_barrier(static_cast<int>(b), {now, body.v.norm(), body.kinetic_energy(),
                                                              height(body.x, at->place), at->along});
    body.v *= effect.left;
    body.w *= effect.left;
    if (effect.caught) return true;
  }
  return has_trees() && meets_trees(body, motion, start, dt, now);
}

/// Whether a tree catches the body.
template <int D>
bool Crossing<D>::meets_trees(Body<D>& body, const Motion& motion, double start, double dt, double now) {
  pass_trees(
      motion, dt, [&](double t) { return energy_along(body, motion, t); },
      [&](double t) { return start + t; });
  // Slightly beyond the end, because a flight that ends at a tree may end before it by rounding.
  const auto touch = first_tree(motion, dt * (1 + 1e-12) + 1e-12);
  if (!touch) return false;
  const Effect effect = hits_tree(touch->tree, now, body.kinetic_energy(), body.x, body.v);
  body.w *= effect.left;
  return effect.caught;
}

template <int D>
auto Crossing<D>::meets_barrier(int barrier, const Arrival& arrival) -> Effect {
  const Barrier& fence = run_.barriers[barrier];
  to_barriers_[barrier].arrive();
  const BarrierHit hit = meet(fence, barrier, arrival, volume_);
  history_.barriers.push_back(hit);
  return {velocity_left(fence, hit), hit.outcome == BarrierOutcome::caught};
}

template <int D>
auto Crossing<D>::hits_tree(int tree, double time, double energy, const Vec<D>& place, Vec<D>& velocity)
    -> Effect {
  double left = 1;
  history_.trees.push_back(trees_.hit(tree, time, energy, place, velocity, left));
  return {left, left == 0};
}

template <int D>
double Crossing<D>::height(const Vec<D>& position, const Vec2& at) const {
  const auto ground = ground_height(terrain_, moved_to<D>(position, at));
  return ground ? position[D - 1] - *ground : never;
}

template class Crossing<2>;
template class Crossing<3>;

}  // namespace flyrock
