#include "flight/run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "collision/pairs.h"
#include "flight/body_log.h"
#include "flight/crossing.h"
#include "flight/faults.h"
#include "flight/ground.h"
#include "flight/jam.h"
#include "flight/rest.h"
#include "flight/series_recorder.h"
#include "math/travel_time.h"

namespace flyrock {

namespace {

/// The pace of a body in 2D, where nothing pivots.
Pace pace_of(const Vec2& v, double w, double radius, const Vec2*) {
  return Pace::without_pivot(std::max(v.norm(), spin_speed(w) * radius));
}

/// The pace of a body in 3D. `normal`: of its only contact; null: it has several.
Pace pace_of(const Vec3& v, const Vec3& w, double radius, const Vec3* normal) {
  const double speed = std::max(v.norm(), spin_speed(w) * radius);
  if (!normal) return Pace::without_pivot(speed);
  const double pivot = normal->dot(w);
  const Vec3 rolling = w - pivot * *normal;
  return {.speed = speed, .unpivoted = std::max(v.norm(), rolling.norm() * radius), .pivot = pivot * radius};
}

template <int D>
class Runner {
 public:
  using Motion = typename Geometry<D>::Motion;

  Runner(World<D>& world, const RunSettings& settings, std::vector<BodyHistory>& histories)
      : world_(world),
        settings_(settings),
        histories_(histories),
        faults_(world, settings.exact_flight && !world.deforms()),
        jam_(world),
        running_(world.bodies.size()) {
    for (std::size_t i = 0; i < running_.size(); ++i) running_[i] = world.bodies[i].kind == BodyKind::dynamic;
    watch_bodies();
    steps_only_ = !world.links.empty() || std::any_of(world.bodies.begin(), world.bodies.end(),
                                                      [](const Body<D>& b) { return b.breathing.moves(); });
    in_air_ = std::any_of(world.bodies.begin(), world.bodies.end(),
                          [](const Body<D>& b) { return b.air.drag > 0; });
  }

  ~Runner() { world_.on_hit = nullptr; }

  void run() {
    world_.on_hit = [this] { hit(); };
    if (settings_.series) series_.emplace(world_, *settings_.series);
    release_held();
    apply_loads();
    world_.pull_links();
    energy_ = world_.total_energy();
    progress_.begin(world_);
    world_.choose_density();
    // A deformable block that touches at the start has no impact, and a flight would pass what it touches.
    bool in_contact = settings_.exact_flight && (world_.deforms() || collide());
    while (anybody() && has_time()) {
      if (settings_.interrupted()) throw Interrupted();
      if (progress_.stands_still(world_)) {
        diverge(progress_.fault());
        break;
      }
      if (settings_.watch) report();
      const double before = world_.time;
      const bool flies =
          settings_.exact_flight && !in_contact && !steps_only_ && !world_.is_dense() && !world_.vibrates();
      in_contact = flies ? fly() : step();
      if (!in_contact && world_.deforms()) world_.settle_deformations();
      release_held();
      apply_loads();
      look_for_jam();
      end_bodies();
      // Bodies in contact touch again and again and time does not advance: advance by one short step that
      // ignores new impacts of pairs in contact; if time still does not advance, ignore all impacts. What
      // ends at a touch without an impact, or at one that changes nothing, will do so again.
      const int patience = (flies && world_.impacts().empty()) || is_idle() ? 1 : 50;
      stalled_ = world_.time - before < 1e-9 * world_.settings().time_step ? stalled_ + 1 : 0;
      if (stalled_ > patience) {
        const double stuck = world_.time;
        in_contact = step(Touches::of_new_pairs);
        if (world_.time == stuck) in_contact = step(Touches::none);
        stalled_ = 0;
      }
    }
    for (int i = 0; i < bodies(); ++i)
      if (running_[i]) end(i, at_rest(i) ? StopReason::stopped : StopReason::timed_out);
    const double change = world_.total_energy() - energy_;
    world_.quality().energy_relative_change = energy_ != 0 ? change / std::abs(energy_) : change;
  }

 private:
  /// Whether no contact has an impulse.
  bool is_idle() const {
    return std::all_of(world_.contacts().begin(), world_.contacts().end(),
                       [](const auto& contact) { return contact.impulse.isZero(0); });
  }

  /// What follows each body. The histories stay where they are from now on.
  void watch_bodies() {
    histories_.resize(world_.bodies.size());
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      const Body<D>& body = world_.bodies[i];
      BodyHistory& history = histories_[i];
      logs_.emplace_back(world_, static_cast<int>(i), settings_,
                         settings_.cells.empty() ? nullptr : &settings_.cells[i], history);
      crossings_.emplace_back(settings_, world_.terrain(), body.x, body.volume,
                              i < settings_.keys.size() ? settings_.keys[i] : DrawKey(), history);
      rest_.emplace_back(RestWatch::Kind::body, settings_.stop_speed, history);
    }
  }

  int bodies() const { return static_cast<int>(world_.bodies.size()); }
  bool anybody() const {
    return std::any_of(running_.begin(), running_.end(), [](bool r) { return r; });
  }
  /// Says how far the run is.
  void report() {
    constexpr int each = 16;  // steps
    if (reported_++ % each != 0) return;
    TrialWatch& watch = *settings_.watch;
    watch.time = world_.time;
    watch.stop_time = settings_.stop_time;
    watch.step = world_.last_step();
    watch.moving = static_cast<int>(std::count_if(running_.begin(), running_.end(), [&](const char& runs) {
      return runs && !at_rest(static_cast<int>(&runs - running_.data()));
    }));
    watch.bodies = bodies();
  }
  bool at_rest(int i) const { return !std::isnan(histories_[i].stop_time); }
  /// Without air and contacts [m/s2].
  Vec<D> steady_acceleration(const Body<D>& body) const { return world_.gravity() + body.load; }

  /// Gives the world the loads of the next piece of time, once it begins.
  void apply_loads() {
    constexpr double rounding = 1e-12;  // s
    if (!settings_.loads || world_.time < loads_until_ - rounding) return;
    loads_until_ = settings_.loads->apply(world_, std::max(world_.time, loads_until_));
  }

  /// Until the end of the run or of a piece of its loads, or until a body is held no longer [s].
  double time_left() const {
    double end = settings_.loads ? std::min(settings_.stop_time, loads_until_) : settings_.stop_time;
    for (const Body<D>& body : world_.bodies)
      if (body.hold && !world_.settling) end = std::min(end, body.hold->until);
    return end - world_.time;
  }

  /// Steps of a deformable body have one length. The last one may end later than the run.
  bool has_time() const {
    constexpr double rounding = 1e-6;  // of a step
    return settings_.stop_time - world_.time >
           (world_.deforms() ? rounding * world_.settings().time_step : 0);
  }

  /// Bodies that are held no longer bring their energy with them, and are not at rest yet.
  void release_held() {
    if (world_.settling) return;
    bool any = false;
    for (int i = 0; i < bodies(); ++i) {
      const auto& hold = world_.bodies[i].hold;
      if (!hold || hold->until > world_.time) continue;
      rest_[i].moves();
      any = true;
    }
    if (!any) return;
    const double before = world_.total_energy();
    world_.release_held();
    energy_ += world_.total_energy() - before;
    faults_.begin_anew();
  }

  void end(int body, StopReason reason) {
    running_[body] = false;
    if (reason == StopReason::stopped) histories_[body].travel = rest_[body].travel();
    logs_[body].ended(reason);
  }

  /// Ends the run where a driven body presses others and something has to give way.
  void look_for_jam() {
    const std::vector<int>& jammed = jam_.look();
    const std::vector<int>& pressed = world_.pressed().empty() ? jammed : world_.pressed();
    if (!pressed.empty()) diverge(pressed_text(pressed));
  }

  /// Ends a body with a fault. It has no contacts from then on.
  void take_out(int i, const std::string& why) {
    histories_[i].fault = why;
    leave(i, StopReason::diverged);
    faults_.begin_anew();
  }

  /// Ends a body that leaves the world.
  void leave(int i, StopReason reason) {
    end(i, reason);
    world_.bodies[i].present = false;
  }

  std::string pressed_text(const std::vector<int>& pressed) const {
    constexpr std::size_t most = 3;
    std::string names;
    for (std::size_t k = 0; k < std::min(most, pressed.size()); ++k)
      names += (k > 0 ? ", `" : "`") + world_.bodies[pressed[k]].group + "`";
    if (pressed.size() > most) names += " and others";
    return "a driven body presses " + names + " and leaves no way out: not all contacts can hold";
  }

  /// Ends all bodies that still run as diverged.
  void diverge(const std::string& why) {
    for (int i = 0; i < bodies(); ++i) {
      if (!running_[i]) continue;
      histories_[i].fault = why;
      end(i, StopReason::diverged);
    }
  }

  /// Solves the impact problem of the contacts that are closed now. Returns whether contacts remain.
  bool collide() {
    if (series_) series_->before_impact();
    const auto outcome = world_.impact();
    if (outcome.endless)
      diverge(std::to_string(World<D>::most_hits) +
              " impacts one by one at one instant do not end: their losses do not "
              "stop these contacts");
    arrived();
    for (const auto& [body, share] : world_.gained())
      if (running_[body]) take_out(body, energy_of_impact_text(share));
    for (const auto& contact : world_.contacts()) land(contact);
    return outcome.in_contact;
  }

  /// Records the end of a step or an impact: its impacts and the present state of all bodies.
  void arrived() {
    for (const Impact& impact : world_.impacts())
      for (const int body : {impact.body, impact.other})
        if (body >= 0) logs_[body].struck(impact);
    for (BodyLog<D>& log : logs_) log.arrived();
  }

  /// Keeps the impact that was solved now; several may be at one instant.
  void hit() {
    if (series_) series_->after_impact();
    if (settings_.advanced) settings_.advanced(0);
  }

  void land(const typename World<D>::Contact& contact) {
    if (contact.antagonist < 0) logs_[contact.candidate].touches();
  }

  /// Flies all bodies to the next touch, or to the end of the domain, of the run or of a leg through air.
  /// Returns whether contacts remain there.
  bool fly() {
    if (!in_air_) return jump(time_left());
    double leg = time_left();
    for (const Body<D>& body : world_.bodies)
      if (body.moves()) leg = std::min(leg, leg_length(body.air, body.v, steady_acceleration(body)));
    accelerations_.clear();
    for (const Body<D>& body : world_.bodies)
      accelerations_.push_back(leg_accelerations(body.air, body.v, steady_acceleration(body), leg));
    for (const int half : {0, 1}) {
      for (int i = 0; i < bodies(); ++i)
        if (world_.bodies[i].moves()) world_.bodies[i].push = world_.bodies[i].load + accelerations_[i][half];
      const double begin = world_.time;
      if (jump(0.5 * leg)) return true;
      if (world_.time - begin < 0.499 * leg) break;  // the jump ended early
    }
    return false;
  }

  /// Moves all bodies along their parabolas to the next touch, the end of the domain or the time `longest`
  /// [s]. Returns whether contacts remain there.
  bool jump(double longest) {
    double dt = longest;
    bool touch = false;
    {
      const PhaseTimer timer(world_.clock, &PhaseTimes::flight);
      for (int i = 0; i < bodies(); ++i) {
        if (!world_.bodies[i].moves()) continue;
        const Body<D>& body = world_.bodies[i];
        const Motion flight = world_.flight_of(i);
        dt = std::min({dt, time_in_domain(flight), running_[i] ? crossings_[i].time_to_barrier(flight) : dt});
        const TouchSearch search{world_.held_in_flight(i, -1), 0, body.size,
                                 &world_.quality().toc_iterations};
        near_parts(world_.workspace(), body.parts, body.pose(), world_.terrain(),
                   greatest_travel(flight, body.size, dt), parts_);
        for (const int k : parts_)
          if (const auto t = time_of_contact<D>(world_.workspace(), {body.contactors[k], flight, k},
                                                world_.terrain(), dt, search))
            dt = *t, touch = true;
      }
    }
    for (int i = 0; i < bodies(); ++i)
      if (running_[i] && world_.bodies[i].moves())
        if (const double tree = crossings_[i].time_to_tree(world_.flight_of(i), dt); tree < dt)
          dt = tree, touch = false;
    for (int i = 0; i < bodies(); ++i) {
      if (!running_[i] || !world_.bodies[i].moves()) continue;
      if (const double end = time_over_ground(world_.terrain(), world_.flight_of(i), dt); end < dt)
        dt = end * (1 + 1e-9) + 1e-9, touch = false;  // slightly beyond, so that end_bodies finds it there
    }
    if (const auto t = touch_of_bodies(dt)) dt = *t, touch = true;
    const double start = world_.time;
    flights_.clear();
    for (int i = 0; i < bodies(); ++i) {
      flights_.push_back(world_.flight_of(i));
      if (!running_[i]) continue;
      logs_[i].flew(flights_[i], start, dt);
      // a resting body may lose contact for a shorter time
      if (dt > world_.settings().time_step) rest_[i].moves();
    }
    world_.fly(dt);
    if (series_) series_->flew(flights_, start, dt);
    arrive(start, dt);
    if (touch) return world_.deforms() || collide();
    world_.measure_penetration();
    return false;
  }

  /// The first touch of two bodies within dt [s].
  std::optional<double> touch_of_bodies(double dt) {
    std::optional<double> first;
    if (bodies() < 2) return first;
    const PhaseTimer timer(world_.clock, &PhaseTimes::flight);
    for (const auto& [i, j] : world_.near_pairs(dt)) {
      const Body<D>&a = world_.bodies[i], &b = world_.bodies[j];
      if (!a.present || !b.present || !(a.moves() || b.moves())) continue;
      const double size = world_.contact_size(i, j);
      const TouchSearch search{world_.held_in_flight(i, j), 0, size, &world_.quality().toc_iterations};
      const Motion of_a = world_.flight_of(i), of_b = world_.flight_of(j);
      const double travel = greatest_travel(of_a, a.size, dt) + greatest_travel(of_b, b.size, dt);
      near_parts(world_.workspace(), a.parts, a.pose(), b.parts, b.pose(), travel, part_pairs_);
      for (const auto& [k, l] : part_pairs_)
        if (const auto t = time_of_contact<D>(world_.workspace(), {a.contactors[k], of_a, k},
                                              {b.contactors[l], of_b, l}, first.value_or(dt), search))
          first = t;
    }
    return first;
  }

  /// The time at which a path passes the end x of the domain [s]. One that starts at the end and does not
  /// move outwards is still inside.
  static double departure(const Path<D>& path, double x, int side, int axis) {
    const double speed = side * path.v[axis], push = side * path.a[axis];
    const bool inside = side * (x - path.x[axis]) > 0;
    if (inside || speed > 0 || (speed == 0 && push > 0))
      return travel_times(side * (x - path.x[axis]), speed, push)[0];
    return push > 0 ? -2 * speed / push : infinite;
  }

  double time_in_domain(const Path<D>& flight) const {
    const Domain<D> domain = domain_of(world_.terrain());
    double first = infinite;
    for (int k = 0; k < D - 1; ++k)
      first =
          std::min({first, departure(flight, domain.low[k], -1, k), departure(flight, domain.high[k], 1, k)});
    // Go slightly beyond the edge, so that end_bodies finds the body outside.
    return first * (1 + 1e-12) + 1e-12;
  }

  /// Which touches cut a step.
  enum class Touches { all, of_new_pairs, none };

  bool step(Touches touches = Touches::all) {
    const double start = world_.time;
    starts_.clear();
    flights_.clear();
    for (const Body<D>& body : world_.bodies) starts_.push_back(moment_of(body));
    const double wanted = touches == Touches::all ? step_length() : blind_step();
    // The last step takes what rounding of the time would leave over. In so short a step, forces are noise.
    const bool is_last = time_left() < wanted * (1 + 1e-9);
    const double h = world_.deforms() ? world_.settings().time_step : is_last ? time_left() : wanted;
    if (in_air_)
      for (Body<D>& body : world_.bodies)
        if (body.moves())
          body.push = body.load + mean_acceleration(body.air, body.v, steady_acceleration(body), h);
    const bool cut = touches != Touches::none && settings_.exact_flight && !world_.deforms();
    const auto outcome = world_.step(h, cut, touches == Touches::of_new_pairs);
    if (series_) series_->stepped(outcome.duration);
    if (settings_.advanced && outcome.duration > 0) settings_.advanced(outcome.duration);
    touching_.assign(bodies(), 0);
    slipping_.assign(bodies(), false);
    normals_.resize(bodies());
    for (const auto& contact : world_.contacts()) {
      if (contact.impulse[0] <= 0) continue;
      land(contact);
      for (const int body : {contact.candidate, contact.antagonist}) {
        if (body < 0) continue;
        ++touching_[body];
        normals_[body] = contact.at.normal;
        slipping_[body] = slipping_[body] || world_.slips(contact, body);
      }
    }
    for (int i = 0; i < bodies(); ++i) {
      const Body<D>& body = world_.bodies[i];
      const bool is_linked = world_.links.holds(i);
      flights_.push_back((touching_[i] || is_linked) && outcome.duration > 0
                             ? mean_motion(starts_[i], body, outcome.duration)
                             : free_motion(body, starts_[i], world_.gravity()));
      if (!running_[i]) continue;
      const Travel before = histories_[i].travel;
      if (touching_[i]) {
        logs_[i].stepped(flights_[i], outcome.duration, slipping_[i] ? TravelMode::slide : TravelMode::roll);
      } else if (outcome.duration > 0) {
        logs_[i].flew(flights_[i], start, outcome.duration);
      }
      if (!touching_[i] && !is_linked) {
        rest_[i].moves();
        continue;
      }
      const Vec<D>* pivot = touching_[i] == 1 && !is_linked ? &normals_[i] : nullptr;
      rest_[i].rests(start, world_.time, pace_of(starts_[i].v, starts_[i].w, body.radius, pivot),
                     pace_of(body.v, body.w, body.radius, pivot), before);
    }
    arrived();
    arrive(start, outcome.duration);
    return outcome.new_touch ? collide() : outcome.in_contact;
  }

  /// The step length, cut at the time at which a barrier or a tree is expected. Contact forces bend the path
  /// within a step, so a step is at least a hundredth of the full length. Otherwise the body would approach
  /// the barrier in ever shorter steps.
  double step_length() {
    const double chosen = world_.step_length();
    double h = chosen;
    if (world_.settings().step_tolerance > 0)
      for (const RestWatch& rest : rest_)
        if (const double left = rest.time_to_rest(world_.time); left > 1e-9)
          h = std::min(h, left * (1 + 1e-12));
    for (int i = 0; i < bodies(); ++i) {
      if (!running_[i]) continue;
      const Path<D> ahead{world_.bodies[i].x, world_.bodies[i].v};
      const double meets =
          std::min(crossings_[i].time_to_barrier(ahead), crossings_[i].time_to_tree(ahead, h));
      h = std::min(h, std::max(meets, 0.01 * chosen));
    }
    return h;
  }

  /// The length of a step that ignores touches [s]: bodies sink by a small share of their size. If they touch
  /// again at its end, the next one is twice as long, up to a tenth of a step.
  double blind_step() {
    constexpr double sinks = 1e-4, longest = 0.1;
    const double most = longest * std::min(step_length(), world_.settings().time_step);
    double h = most;
    for (const Body<D>& body : world_.bodies)
      if (body.moves()) h = std::min(h, sinks * body.size / (body.v.norm() + body.size * body.spin_speed()));
    if (world_.time - blind_until_ <= blind_) h = std::min(most, std::max(h, 2 * blind_));
    blind_ = h;
    blind_until_ = world_.time + h;
    return h;
  }

  /// Looks for bodies below the ground, and applies gates, barriers and trees, where the motions along
  /// flights_ since `start` end.
  void arrive(double start, double dt) {
    for (int i = 0; i < bodies(); ++i) {
      if (!running_[i]) continue;
      if (const auto fault = faults_.below_ground(i, last_over_ground(i, dt))) {
        take_out(i, *fault);
        continue;
      }
      const double energy = faults_.energy_of(i);
      if (crossings_[i].moved(world_.bodies[i], flights_[i], start, dt, world_.time))
        leave(i, StopReason::caught);
      faults_.take(energy - faults_.energy_of(i));
    }
  }

  /// Where a motion along flights_ of length dt ends, or has just not left the terrain.
  Vec<D> last_over_ground(int i, double dt) const {
    constexpr double before = 1e-9;  // s, and share of the time: nowhere is the ground higher by so much
    const Motion& flight = flights_[i];
    const Vec<D>& end = world_.bodies[i].x;
    if (domain_of(world_.terrain()).contains(end) && is_over_ground(world_.terrain(), end)) return end;
    const double leaves =
        std::min({dt, time_in_domain(flight), time_over_ground(world_.terrain(), flight, dt)});
    return flight.position(std::max(0.0, leaves * (1 - before) - before));
  }

  /// Whether a body is beyond an end of the terrain, or where it has no ground. One that touches an upright
  /// wall at the end, where rounding may put it beyond, does not move outwards.
  bool has_left(int i, const Domain<D>& domain) const {
    const Body<D>& body = world_.bodies[i];
    for (int k = 0; k < D - 1; ++k) {
      const double past = std::max(domain.low[k] - body.x[k], body.x[k] - domain.high[k]);
      const double outwards = body.x[k] < domain.low[k] ? -body.v[k] : body.v[k];
      if (past > world_.touch(i) || (past > 0 && outwards > 0)) return true;
    }
    return domain.contains(body.x) && !is_over_ground(world_.terrain(), body.x);
  }

  /// Ends bodies that have come to rest, left the terrain or diverged. In a world of several bodies, a body
  /// at rest may be hit again. Therefore all bodies must be at rest, no driven body may move, no load may
  /// change, and none may be held until a time within the run.
  void end_bodies() {
    const Domain<D> domain = domain_of(world_.terrain());
    bool all_at_rest = std::none_of(world_.bodies.begin(), world_.bodies.end(), [&](const Body<D>& body) {
      if (body.hold) return !world_.settling && body.hold->until < settings_.stop_time;
      return body.kind == BodyKind::driven &&
             (body.v.norm() > 0 || body.spin_speed() > 0 || body.push.norm() > 0);
    });
    if (settings_.loads && !world_.settling && world_.time < settings_.loads->last_change)
      all_at_rest = false;
    for (int i = 0; i < bodies(); ++i) {
      if (!running_[i]) continue;
      Body<D>& body = world_.bodies[i];
      if (!body.is_finite() || body.v.norm() > greatest_speed) {
        take_out(i, "its state is not finite, or it is faster than 100 km/s");
      } else if (body.breathing.collapsed()) {
        take_out(
            i, "its radius fell below 5 % of the one at rest: its gas and spring are too soft for this load");
      } else if (has_left(i, domain)) {
        histories_[i].fault = left_text(domain, body.x);
        faults_.take(faults_.energy_of(i));
        leave(i, StopReason::left_domain);
      }
      if (running_[i]) all_at_rest = all_at_rest && (at_rest(i) || body.hold);
    }
    if (const auto fault = faults_.energy_from_nowhere()) diverge(*fault);
    if (!all_at_rest) return;
    for (int i = 0; i < bodies(); ++i)
      if (running_[i]) end(i, StopReason::stopped);
  }

  World<D>& world_;
  const RunSettings& settings_;
  std::vector<BodyHistory>& histories_;
  std::optional<SeriesRecorder<D>> series_;
  Faults<D> faults_;
  ProgressWatch progress_;
  JamWatch<D> jam_;
  // Of each body:
  std::vector<BodyLog<D>> logs_;
  std::vector<Crossing<D>> crossings_;
  std::vector<RestWatch> rest_;
  std::vector<char> running_;  ///< of characters, because bits cost more to set than they save
  std::vector<int> touching_;  ///< the number of contacts of each body in the last step
  std::vector<char> slipping_;
  std::vector<Vec<D>> normals_;  ///< of a contact of each body that touches
  std::vector<Moment<D>> starts_;
  std::vector<Motion> flights_;  ///< of the last flight or step, from its start
  bool steps_only_ = false;      ///< links or radii act in the air too: flights are made of steps
  bool in_air_ = false;
  std::vector<std::array<Vec<D>, 2>> accelerations_;  ///< accelerations by the air in the current leg
  std::vector<int> parts_;                            ///< of one body near the ground
  std::vector<std::pair<int, int>> part_pairs_;       ///< of two bodies near each other
  double blind_ = 0, blind_until_ = 0;                ///< s, the last step that ignored touches and its end
  double loads_until_ = -infinite;                    ///< s, the end of the piece of the loads
  double energy_ = 0;                                 ///< J, at the start, of bodies held until later too
  int stalled_ = 0;
  unsigned reported_ = 0;
};

}  // namespace

template <int D>
void run(World<D>& world, const RunSettings& settings, std::vector<BodyHistory>& histories) {
  Runner<D>(world, settings, histories).run();
}

template void run(World<2>&, const RunSettings&, std::vector<BodyHistory>&);
template void run(World<3>&, const RunSettings&, std::vector<BodyHistory>&);

}  // namespace flyrock
