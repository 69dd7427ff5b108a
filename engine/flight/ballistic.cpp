#include "flight/ballistic.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

namespace flyrock {

namespace {

namespace odeint = boost::numeric::odeint;

constexpr double longest_arc = 0.5;  // s

/// Position and velocity in one array.
template <int D>
using State = std::array<double, 2 * D>;

template <int D>
Eigen::Map<const Vec<D>> position_of(const State<D>& state) {
  return Eigen::Map<const Vec<D>>(state.data());
}
template <int D>
Eigen::Map<const Vec<D>> velocity_of(const State<D>& state) {
  return Eigen::Map<const Vec<D>>(state.data() + D);
}
template <int D>
State<D> joined(const Vec<D>& position, const Vec<D>& velocity) {
  State<D> state;
  Eigen::Map<Vec<D>>(state.data()) = position;
  Eigen::Map<Vec<D>>(state.data() + D) = velocity;
  return state;
}

}  // namespace

template <int D>
Arc<D> BallisticFlight<D>::next_in_air(double longest) {
  const auto system = [this](const State<D>& state, State<D>& rate, double) {
    const Vec<D> velocity = velocity_of<D>(state);
    rate = joined<D>(velocity, forces_.acceleration(velocity));
  };
  using Pair = odeint::runge_kutta_dopri5<State<D>>;
  odeint::controlled_runge_kutta<Pair> stepper(
      odeint::default_error_checker<double, typename Pair::algebra_type, typename Pair::operations_type>(
          flight_tolerance, flight_tolerance));
  const State<D> from = joined<D>(now_.position, now_.velocity),
                 rate = joined<D>(now_.velocity, now_.acceleration);
  State<D> to, rate_at_end;
  const double limit = std::min(longest, longest_arc);
  double end = 0, step = std::min(step_, limit), tried = step;
  while (stepper.try_step(system, from, rate, end, to, rate_at_end, step) == odeint::fail) tried = step;
  // a step cut by `longest` says nothing about the next step size
  if (tried < limit || step < step_) step_ = step;
  FlightState<D> next;
  next.position = position_of<D>(to);
  next.velocity = velocity_of<D>(to);
  next.acceleration = velocity_of<D>(rate_at_end);
  const Arc<D> arc = arc_between(time_, end, now_, next);
  now_ = next;
  time_ += end;
  return arc;
}

template class BallisticFlight<2>;
template class BallisticFlight<3>;

}  // namespace flyrock
