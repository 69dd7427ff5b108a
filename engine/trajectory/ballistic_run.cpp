#include "trajectory/ballistic_run.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "math/polynomial.h"

namespace flyrock {

namespace {

/// Writes the history of one flight, arc by arc.
class FlightLog {
 public:
  FlightLog(const Body<2>& body, const Profile& ground, const BallisticRun& run)
      : body_(body), ground_(ground), run_(run), next_sample_(run.start_time) {
    history_.first = history_.last = history_.min = history_.max = state(run.start_time, body.x, body.v);
    history_.min_speed = history_.max_speed = body.v.norm();
    history_.bounce_height = height(body.x);
    history_.path = PathBins(run.bin_width, ground.x_min(), ground.x_max());
  }

  void see(const Arc<2>& arc, double end) {
    for (double t = next_sample_; run_.trajectory_every > 0 && t < arc.start + end * arc.length; t = next_sample_) {
      store(at(arc, (t - arc.start) / arc.length));
      next_sample_ += run_.trajectory_every;
    }
    for (const Vec2& way : {Vec2(0, 1), Vec2(1, 0), Vec2(-1, 0)})  // the apex, and where a wind turns the rock
      if (const auto turn = first_fall(rates(arc, way), 0, end)) widen(at(arc, *turn));
    widen(at(arc, end));
    highest(arc, end);
    bins(arc, end);
    const double length = boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double s) { return arc.velocity(s).norm() * arc.length; }, 0.0, end);
    history_.travel.add(TravelMode::flight, end * arc.length, length);
  }

  BodyHistory finish(const Landing& landing) {
    history_.reason = landing.on_ground ? StopReason::stopped
                      : landing.left    ? StopReason::left_domain
                                        : StopReason::timed_out;
    history_.last = state(landing.time, landing.position, landing.velocity);
    if (landing.on_ground) history_.stop_time = landing.time;
    history_.flight_range = std::abs(landing.position.x() - body_.x.x());
    if (run_.trajectory_every > 0) store(history_.last);
    return std::move(history_);
  }

 private:
  BodyState state(double time, const Vec2& position, const Vec2& velocity) const {
    BodyState state;
    state.time = time;
    state.position.head<2>() = position;
    state.velocity.head<2>() = velocity;
    state.spin.z() = body_.w;
    state.angle = body_.attitude.angle + body_.w * (time - run_.start_time);
    state.kinetic_energy = 0.5 * (body_.mass * velocity.squaredNorm() + body_.inertia * body_.w * body_.w);
    return state;
  }

  BodyState at(const Arc<2>& arc, double s) const {
    return state(arc.start + s * arc.length, arc.position(s), arc.velocity(s));
  }

  void store(const BodyState& point) { history_.trajectory.push_back({point, TravelMode::flight}); }

  void widen(const BodyState& s) {
    const auto stretch = [](auto& low, auto& high, const auto& value) {
      low = low.cwiseMin(value);
      high = high.cwiseMax(value);
    };
    stretch(history_.min.position, history_.max.position, s.position);
    stretch(history_.min.velocity, history_.max.velocity, s.velocity);
    history_.min.angle = std::min(history_.min.angle, s.angle);
    history_.max.angle = std::max(history_.max.angle, s.angle);
    history_.min.kinetic_energy = std::min(history_.min.kinetic_energy, s.kinetic_energy);
    history_.max.kinetic_energy = std::max(history_.max.kinetic_energy, s.kinetic_energy);
    history_.min_speed = std::min(history_.min_speed, s.velocity.norm());
    history_.max_speed = std::max(history_.max_speed, s.velocity.norm());
    history_.max_distance = std::max(history_.max_distance, std::abs(s.position.x() - body_.x.x()));
  }

  double height(const Vec2& p) const {
    return p.y() - ground_.height(std::clamp(p.x(), ground_.x_min(), ground_.x_max()));
  }

  /// The coefficients of d/ds of n . p(s).
  static std::array<double, 5> rates(const Arc<2>& arc, const Vec2& n) {
    std::array<double, 5> rate;
    for (int k = 1; k <= 5; ++k) rate[k - 1] = k * n.dot(arc.c[k]);
    return rate;
  }

  /// The greatest height above the ground: at the end, above a corner of the ground, or where the path runs along it.
  void highest(const Arc<2>& arc, double end) {
    const auto look = [&](double s) { history_.bounce_height = std::max(history_.bounce_height, height(arc.position(s))); };
    look(end);
    const Eigen::AlignedBox2d box = arc.box();
    for (int i = 0; i < ground_.segments(); ++i) {
      const Vec2 &a = ground_.points[i], &b = ground_.points[i + 1];
      if (b.x() < box.min().x() || a.x() > box.max().x()) continue;
      for (const double side : {-1.0, 1.0}) {
        std::array<double, 6> past;
        for (int k = 0; k < 6; ++k) past[k] = side * arc.c[k].x();
        past[0] -= side * b.x();
        if (const auto s = first_fall(past, 0, end)) look(*s);
      }
      if (const auto s = first_fall(rates(arc, perpendicular(b - a)), 0, end)) look(*s);
    }
  }

  /// The bins along x, in pieces of an arc so short that x is linear in them.
  void bins(const Arc<2>& arc, double end) {
    constexpr int pieces = 16;
    for (int i = 0; i < pieces; ++i) {
      const double from = end * i / pieces, to = end * (i + 1) / pieces;
      const double x = arc.position(from).x(), rate = (arc.position(to).x() - x) / (to - from);
      history_.path.visit(x - rate * from, rate, from, to, [&](PathBin& bin, double s0, double s1) {
        for (const double s : {s0, 0.5 * (s0 + s1), s1}) {
          const BodyState seen = at(arc, s);
          bin.height = std::max(bin.height, height(seen.position.head<2>()));
          bin.speed = std::max(bin.speed, seen.velocity.norm());
          bin.energy = std::max(bin.energy, seen.kinetic_energy);
        }
      });
    }
  }

  const Body<2>& body_;
  const Profile& ground_;
  const BallisticRun& run_;
  BodyHistory history_;
  double next_sample_;
};

}  // namespace

BodyHistory run_ballistic(const Body<2>& body, const Profile& ground, const BallisticRun& run) {
  FlightLog log(body, ground, run);
  const BallisticFlight<2> flight(run.forces, body.x, body.v, run.start_time);
  const Landing landing =
      land(flight, run.start_time, ground, run.stop_time, [&](const Arc<2>& arc, double end) { log.see(arc, end); });
  return log.finish(landing);
}

}  // namespace flyrock
