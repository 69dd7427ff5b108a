#pragma once
// Gates, barriers (world/places.h) and trees (world/tree_law.h) on the path of one body or point.
//
// In free flight the time of arrival is that of the parabola or arc. In a contact step the centre of mass
// moves on a straight line. Instantiated for D = 2, 3.

#include <optional>
#include <vector>

#include "flight/any_run.h"
#include "flight/tree_watch.h"
#include "record/observe.h"
#include "world/world.h"

namespace flyrock {

template <int D>
class Crossing {
 public:
  using Motion = typename Geometry<D>::Motion;
  using Terrain = typename Geometry<D>::Terrain;

  /// Of a body that starts at a place; the run, the terrain and the history outlive the object, which
  /// appends to the history passages of gates and hits of barriers and trees. `key`: of the draws of the
  /// body, for trees.
  Crossing(const AnyRun& run, const Terrain& terrain, const Vec<D>& start, double volume, const DrawKey& key,
           BodyHistory& history);

  bool has_trees() const { return trees_.any(); }
  bool has_barriers() const { return !to_barriers_.empty(); }

  /// The time until a body on `path` arrives at its next barrier [s]; infinity if it does not.
  double time_to_barrier(const Path<D>& path) const;
  /// The time until it hits a tree that changes its motion, within `longest` [s]; infinity if it does not.
  double time_to_tree(const Path<D>& path, double longest) const;
  /// Applies gates, barriers and trees to a body that has moved along `motion` for dt, from the time `start`
  /// to `now`. Returns whether a barrier or a tree has caught it.
  bool moved(Body<D>& body, const Motion& motion, double start, double dt, double now);

  /// Records the gates that a curve passes on its way to its parameter `end`: arrival(parameter, place in
  /// plan) is what is recorded. Arrivals count until `until`.
  template <class Curve, class ArrivalAt>
  void pass_gates(const Curve& curve, double end, double until, ArrivalAt arrival);
  /// The first barrier at which a curve arrives up to its parameter `end`.
  struct AtBarrier {
    int barrier;
    Approach::Arrival at;
  };
  template <class Curve>
  std::optional<AtBarrier> first_barrier(const Curve& curve, double end);
  /// The first tree that changes motions on a curve, up to its parameter `end`.
  template <class Curve>
  std::optional<Forest::Touch> first_tree(const Curve& curve, double end) const {
    return trees_.passive() ? std::nullopt : trees_.first(curve, end);
  }
  /// Records the trees that change nothing: energy(parameter) in J, time(parameter) in s.
  template <class Curve, class Energy, class Time>
  void pass_trees(const Curve& curve, double end, Energy energy, Time time);

  /// What a barrier and a tree have done: velocity and spin are to be scaled by `left`.
  struct Effect {
    double left = 1;
    bool caught = false;
  };
  Effect meets_barrier(int barrier, const Arrival& arrival);
  /// Turns and slows `velocity`; the spin is to be scaled.
  Effect hits_tree(int tree, double time, double energy, const Vec<D>& place, Vec<D>& velocity);

 private:
  bool meets_trees(Body<D>& body, const Motion& motion, double start, double dt, double now);
  /// The height of `position` above the ground after it is moved in plan to `at`, where the body crosses a
  /// gate or barrier [m]; infinity if there is no ground.
  double height(const Vec<D>& position, const Vec2& at) const;

  const AnyRun& run_;
  const Terrain& terrain_;
  double volume_;  ///< m3
  BodyHistory& history_;
  std::vector<Approach> to_gates_, to_barriers_;
  TreeWatch<D> trees_;
};

template <int D>
template <class Curve, class ArrivalAt>
void Crossing<D>::pass_gates(const Curve& curve, double end, double until, ArrivalAt arrival) {
  for (std::size_t g = 0; g < to_gates_.size(); ++g) {
    const auto at = to_gates_[g].arrival(in_plan(curve), until);
    to_gates_[g].move_to(in_plan(curve.position(end)));
    if (!at) continue;
    to_gates_[g].arrive();
    history_.passages.push_back({arrival(*at), static_cast<int>(g)});
  }
}

template <int D>
template <class Curve>
auto Crossing<D>::first_barrier(const Curve& curve, double end) -> std::optional<AtBarrier> {
  std::optional<AtBarrier> first;
  for (std::size_t b = 0; b < to_barriers_.size(); ++b) {
    const auto arrival = to_barriers_[b].arrival(in_plan(curve), end);
    if (!arrival || (first && arrival->time >= end)) continue;
    end = arrival->time;
    first = {static_cast<int>(b), *arrival};
  }
  for (Approach& to_barrier : to_barriers_) to_barrier.move_to(in_plan(curve.position(end)));
  return first;
}

template <int D>
template <class Curve, class Energy, class Time>
void Crossing<D>::pass_trees(const Curve& curve, double end, Energy energy, Time time) {
  if (!has_trees() || !trees_.passive()) return;
  while (const auto touch = trees_.first(curve, end)) {
    Vec<D> velocity = curve.velocity(touch->time);
    hits_tree(touch->tree, time(touch->time), energy(touch->time), curve.position(touch->time), velocity);
  }
}

}  // namespace flyrock
