#include "flight/body_log.h"

#include "flight/body_state.h"

namespace flyrock {

namespace {

/// Attitude and spin as results need them: in 2D the angle alone, without the sine and cosine of a rotation.
Turned<2> turn_for_results(const Motion2& motion, double t) {
  Attitude<2> attitude;
  attitude.angle = motion.angle_at(t);
  return {attitude, motion.spin(t)};
}
Turned<3> turn_for_results(const Motion3& motion, double t) { return turn_at(motion, t); }

}  // namespace

template <int D>
BodyLog<D>::BodyLog(const World<D>& world, int index, const AnyRun& run, PlanCells* cells,
                    BodyHistory& history)
    : world_(world),
      index_(index),
      keep_impacts_(run.keep_impacts),
      log_(run, world.terrain(), world.time, cells, history) {
  history = {};
  const auto domain = domain_of(world.terrain());
  const bool has_bins = body().kind == BodyKind::dynamic && log_.has_bins();
  log_.begin(present(), has_bins ? PathBins(run.bin_width, domain.low[0], domain.high[0]) : PathBins());
  passes(world.flight_of(index), 0);
  log_.store(history.first, body().attitude);
}

template <int D>
BodyState BodyLog<D>::along(const Motion& motion, double t, double time) const {
  return state_of(body(), time, motion.position(t), motion.velocity(t), turn_for_results(motion, t));
}

template <int D>
BodyState BodyLog<D>::present() const {
  return state_of(body(), world_.time);
}

template <int D>
void BodyLog<D>::include(const BodyState& state) {
  if (!state.position.allFinite() || !state.velocity.allFinite()) return;  // keep NaN out of the history
  BodyHistory& history = log_.history();
  history.include(state);
  history.last = state;
  log_.reaches(state.position.template head<D>());
}

template <int D>
void BodyLog<D>::store(Store how, const Motion& motion, double t, double time) {
  if (log_.stores()) (log_.*how)(along(motion, t, time), turn_for_results(motion, t).attitude);
}

/// Speed and energy are greatest at the ends, because squares of speeds are convex in time. Rotation keeps
/// its energy in free flight.
template <int D>
void BodyLog<D>::passes(const Motion& motion, double dt) {
  const double mass = body().mass, twice_spin = twice_spin_energy(body(), body().attitude, body().w);
  log_.passes(
      motion, dt, [&](double t) { return motion.velocity(t).squaredNorm(); },
      [&](double squared) { return 0.5 * (mass * squared + twice_spin); });
}

template <int D>
void BodyLog<D>::flew(const Motion& motion, double start, double dt) {
  constexpr int up = D - 1;
  store(&HistoryLog<D>::store_start, motion, 0, start);
  log_.travels(log_.flies(dt), dt, path_length<D>(motion, dt));
  const double apex = motion.a[up] < 0 ? motion.v[up] / -motion.a[up] : -1;
  if (apex > 0 && apex <= dt) {
    include(along(motion, apex, start + apex));
    if (keep_impacts_ && body().impacts > 0) log_.apex(start + apex, motion.position(apex));
  }
  passes(motion, dt);
  if (log_.stores())
    log_.visit_due(start + dt,
                   [&](double time) { store(&HistoryLog<D>::store, motion, time - start, time); });
  include(along(motion, dt, start + dt));
  store(&HistoryLog<D>::store_end, motion, dt, start + dt);
}

template <int D>
void BodyLog<D>::stepped(const Motion& motion, double dt, TravelMode mode) {
  log_.history().contact_time += dt;
  log_.travels(mode, dt, path_length<D>(motion, dt));
  const BodyState state = present();
  log_.passes(
      motion, dt, [&](double) { return state.velocity.squaredNorm(); },
      [&](double) { return state.kinetic_energy; });
  if (log_.has_fallen_due(world_.time)) log_.store(state, body().attitude);
}

template <int D>
void BodyLog<D>::struck(const Impact& impact) {
  log_.struck(body().x);
  if (!keep_impacts_) return;
  BodyHistory& history = log_.history();
  Impact mine = impact;
  mine.number = history.impact_count;
  if (index_ == impact.other) mine.other = impact.body;
  if (Impact* sum = world_.is_dense() ? summed_with(mine) : nullptr)
    add(*sum, mine);
  else
    history.impacts.push_back(mine);
}

/// The impact with the same other body or part of the terrain that began within the last 10 ms; null: none.
template <int D>
Impact* BodyLog<D>::summed_with(const Impact& impact) {
  constexpr double period = 0.01;  // s
  std::vector<Impact>& impacts = log_.history().impacts;
  for (auto before = impacts.rbegin(); before != impacts.rend() && before->time > impact.time - period;
       ++before)
    if (before->other == impact.other && before->part == impact.part) return &*before;
  return nullptr;
}

template <int D>
void BodyLog<D>::ended(StopReason reason) {
  BodyHistory& history = log_.history();
  history.reason = reason;
  if (reason != StopReason::diverged) history.last = present();
  if (log_.has_flown() && !history.landed) log_.ends_flight(history.last.position.template head<D>());
  log_.store(history.last, body().attitude);
}

template class BodyLog<2>;
template class BodyLog<3>;

}  // namespace flyrock
