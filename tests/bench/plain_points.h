#pragma once
// The lumped mass in 2D as a plain scalar loop: the same algorithm, streams and functions as the engine, for
// the scenario points.yaml alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/profile.h"
#include "math/parabola_length.h"
#include "record/observe.h"
#include "scenario/scenario.h"

namespace flyrock {

/// How a point came to its end, as RockRecord.
struct PlainAnswer {
  double x = 0, y = 0;
  int impacts = 0;
  // With `complete` only:
  double time = 0, max_distance = 0, flight_range = 0, bounce_height = 0, max_squared_speed = 0;
  bool landed = false;
  Travel travel = {};
};

/// One point. The ground is to the right of nothing: a point that leaves the profile ends there. `complete`:
/// also computes what the engine records of each rock, otherwise only the end and the number of impacts.
template <bool complete>
class PlainLoop {
 public:
  PlainLoop(const Profile& ground, const Scenario& scenario)
      : seed_(scenario.streams.seed),
        restitution_(scenario.draws[scenario.materials[0].restitution->slots[0].draw]),
        tilt_(scenario.draws[scenario.materials[0].roughness->draw]) {
    for (int i = 0; i < ground.segments(); ++i) {
      const Vec2 &a = ground.points[i], &b = ground.points[i + 1];
      const double length = std::sqrt((b - a).squaredNorm());
      const double tx = (b.x() - a.x()) / length, ty = (b.y() - a.y()) / length;
      segments_.push_back({a.x(), a.y(), b.x(), b.y(), tx, ty, -ty, tx, ty / tx});
    }
  }

  PlainAnswer run(std::uint64_t trial) {
    key_ = {trial, 1, 1, 0};
    x_ = start_x, y_ = start_y, u_ = start_u, v_ = start_v;
    on_ = other_ = -1;
    impacts_ = 0;
    if constexpr (complete) begin();
    for (int events = 0; events < 10'000; ++events) {
      if (on_ >= 0) settle();
      const int carrier = carrier_of();
      if (carrier < 0 && rests_between()) {
        if constexpr (complete) slows();
        return end();
      }
      if (carrier >= 0 ? slide(carrier) : fly()) return end();
    }
    return {infinity, infinity, impacts_};
  }

 private:
  static constexpr double g = 9.81, mu = 0.6, rest_speed = 0.02, slow = 0.05 * rest_speed, stop_speed = 0.05,
                          infinity = std::numeric_limits<double>::infinity();
  static constexpr double start_x = 19, start_y = 62, start_u = 2, start_v = -1;

  struct Segment {
    double x0, y0, x1, y1;  // from left to right
    double tx, ty, nx, ny;  // unit vectors along it and out of the ground
    double slope;
  };

  int first_segment() const {
    int i = 0;
    while (segments_[i].x1 < x_) ++i;
    return i;
  }

  void begin() {
    seen_ = {};
    time_ = 0;
    since_ = -1;
    const Segment& below = segments_[first_segment()];
    seen_.bounce_height = y_ - (below.y0 + below.slope * (x_ - below.x0));
    seen_.max_squared_speed = u_ * u_ + v_ * v_;
  }

  PlainAnswer end() {
    seen_.x = x_;
    seen_.y = y_;
    seen_.impacts = impacts_;
    if constexpr (complete) {
      seen_.time = since_ >= 0 ? since_ : time_;
      if (since_ >= 0) seen_.travel = rested_;
      if (!seen_.landed) seen_.flight_range = std::fabs(x_ - start_x);
    }
    return seen_;
  }

  /// From now on it is slower than stop_speed on the ground.
  void slows() {
    if (since_ >= 0) return;
    since_ = time_;
    rested_ = seen_.travel;
  }

  void lands() {
    if (seen_.landed || time_ == 0) return;
    seen_.landed = true;
    seen_.flight_range = std::fabs(x_ - start_x);
  }

  void moved(TravelMode mode, double time, double length) {
    time_ += time;
    seen_.travel.add(mode, time, length);
  }

  /// The present speed and place count.
  void arrived() {
    seen_.max_squared_speed = std::max(seen_.max_squared_speed, u_ * u_ + v_ * v_);
    seen_.max_distance = std::max(seen_.max_distance, std::fabs(x_ - start_x));
  }

  /// A flight of this duration over the segments i to `last` that the state before it leads to.
  void flies(int i, int last, int step, double duration) {
    const double per_u = 1 / u_, u = u_, v = v_;
    for (;; i += step) {
      const Segment& s = segments_[i];
      double from = 0, to = duration;
      if (u != 0) {
        from = std::max(from, ((step > 0 ? s.x0 : s.x1) - x_) * per_u);
        to = std::min(to, ((step > 0 ? s.x1 : s.x0) - x_) * per_u);
      }
      const double top = std::max(from, std::min((v - s.slope * u) / g, to));
      const double height = y_ - s.y0 - s.slope * (x_ - s.x0) + top * (v - s.slope * u - 0.5 * g * top);
      seen_.bounce_height = std::max(seen_.bounce_height, height);
      if (i == last) break;
    }
    const double length = parabola_length(u * u, -v, g, duration);
    if (duration > 1e-3) since_ = -1;  // it does not rest
    x_ += duration * u;
    y_ += duration * (v - 0.5 * g * duration);
    v_ -= g * duration;
    moved(seen_.landed ? TravelMode::bounce : TravelMode::flight, duration, length);
    arrived();
  }

  /// It has slid from the speed `along` to `speed` over the length `room`.
  void slid(double along, double speed, double room) {
    along = std::fabs(along);
    lands();
    double duration = along + speed > 0 ? 2 * room / (along + speed) : 0;
    if (speed >= stop_speed) since_ = -1;
    if (speed < stop_speed && along > stop_speed) {  // in two parts
      const double share = (along - stop_speed) / (along - speed), part = share * duration;
      const double length = 0.5 * (along + stop_speed) * part;
      moved(TravelMode::slide, part, length);
      slows();
      duration -= part;
      room -= length;
    }
    if (speed < stop_speed) slows();
    moved(TravelMode::slide, duration, room);
    arrived();
  }

  double approach(int i) const { return -(u_ * segments_[i].nx + v_ * segments_[i].ny); }

  /// Impacts and touches until the point approaches no segment on which it is.
  void settle() {
    for (int i = 0;; ++i) {
      int first = -1;
      double greatest = 1e-10 + 1e-9 * std::sqrt(u_ * u_ + v_ * v_);
      for (const int each : {on_, other_})
        if (each >= 0 && approach(each) > greatest) first = each, greatest = approach(each);
      if (first < 0) return;
      if constexpr (complete) lands();
      if (greatest > rest_speed && i < 100)
        collide(segments_[first]);
      else
        close(segments_[first], greatest);
    }
  }

  double draw(const Draw& draw, std::uint64_t n) const {
    DrawKey key = key_;
    if (n == 0) return draw.value(seed_, key);
    key.hole = 0;
    return draw.quantile(uniform_at(seed_, draw.stream_hash, key, n));
  }

  void collide(const Segment& face) {
    key_.impact = static_cast<std::uint64_t>(++impacts_);
    double nx = face.nx, ny = face.ny;
    double along = u_ * face.tx + v_ * face.ty;
    const double sign = along < 0 ? -1 : 1;
    for (std::uint64_t i = 0; i < 100; ++i) {
      const double ahead = draw(tilt_, 2 * i);
      if (!(std::fabs(ahead) < 0.5 * pi)) continue;
      const double slope = sign * std::tan(ahead);
      double tilted_x = face.nx + slope * face.tx, tilted_y = face.ny + slope * face.ty;
      const double length = std::sqrt(tilted_x * tilted_x + tilted_y * tilted_y);
      tilted_x /= length;
      tilted_y /= length;
      if (tilted_x * u_ + tilted_y * v_ >= 0) continue;
      nx = tilted_x, ny = tilted_y;
      break;
    }
    const double e = draw(restitution_, 0), vn = nx * u_ + ny * v_;
    along = ny * u_ - nx * v_;
    const double slip = std::fabs(along), lost = std::min(slip, -mu * (1 + e) * vn);
    if (slip > 0) along *= (slip - lost) / slip;
    u_ = -e * vn * nx + along * ny;
    v_ = -e * vn * ny - along * nx;
  }

  void close(const Segment& face, double speed) {
    u_ += speed * face.nx;
    v_ += speed * face.ny;
    const double slip = std::sqrt(u_ * u_ + v_ * v_);
    const double left = slip > 0 ? std::max(0.0, 1 - mu * speed / slip) : 0;
    u_ *= left;
    v_ *= left;
  }

  /// The segment on which the point slides or rests; -1: none, it flies.
  int carrier_of() {
    const double rounding = 1e-10 + 1e-9 * std::sqrt(u_ * u_ + v_ * v_);
    for (const int i : {on_, other_}) {
      if (i < 0 || -approach(i) > rounding || segments_[i].ny <= 0) continue;
      const double along = u_ * segments_[i].tx + v_ * segments_[i].ty;
      const bool at_left = x_ - segments_[i].x0 < 2e-9, at_right = segments_[i].x1 - x_ < 2e-9;
      // At an end, slow motion goes where the pull leads, and is taken off where friction holds the point.
      const bool held = std::fabs(segments_[i].ty) <= mu * segments_[i].ny;
      const double heading = std::fabs(along) > slow ? along : held ? 0 : -segments_[i].ty;
      if ((at_left && heading < 0) || (at_right && heading > 0)) continue;
      if ((at_left && along < 0) || (at_right && along > 0)) u_ = v_ = 0;
      return i;
    }
    return -1;
  }

  /// Whether two segments that meet in a valley hold the point.
  bool rests_between() const {
    if (on_ < 0 || other_ < 0 || -approach(on_) > slow || -approach(other_) > slow) return false;
    const Segment &left = segments_[std::min(on_, other_)], &right = segments_[std::max(on_, other_)];
    const bool valley = left.tx * right.ty - left.ty * right.tx > 1e-9;
    return valley && left.nx >= 0 && right.nx <= 0;
  }

  /// To rest, or to an end of the segment. Returns whether the point stops.
  bool slide(int i) {
    const Segment& face = segments_[i];
    const double along = u_ * face.tx + v_ * face.ty, pull = -g * face.ty, hold = mu * g * face.ny;
    if (along == 0 && std::fabs(pull) <= hold) return true;
    const double sign = along != 0 ? (along < 0 ? -1 : 1) : pull < 0 ? -1 : 1;
    const double rate = sign * pull - hold;  // of the speed
    const double room = sign > 0 ? (face.x1 - x_) / face.tx : (x_ - face.x0) / face.tx;
    const double needed = rate < 0 ? along * along / (-2 * rate) : infinity;
    if (needed <= room) {
      x_ += sign * needed * face.tx;
      y_ += sign * needed * face.ty;
      u_ = v_ = 0;
      on_ = i;
      other_ = -1;
      if constexpr (complete) slid(along, 0, needed);
      return std::fabs(pull) <= hold;  // otherwise it slides back
    }
    const double speed = std::sqrt(std::max(0.0, along * along + 2 * rate * room));
    u_ = sign * speed * face.tx;
    v_ = sign * speed * face.ty;
    x_ = sign > 0 ? face.x1 : face.x0;
    y_ = sign > 0 ? face.y1 : face.y0;
    if constexpr (complete) slid(along, speed, room);
    on_ = i;
    other_ = i + (sign > 0 ? 1 : -1);
    return is_outside(other_);
  }

  bool is_outside(int i) const { return i < 0 || i >= static_cast<int>(segments_.size()); }

  /// The parabola to the next segment, or to an end of the profile. Returns whether it is an end.
  bool fly() {
    const int step = u_ >= 0 ? 1 : -1;
    int i = on_;
    if (on_ >= 0 && other_ >= 0) i = step > 0 ? std::min(on_, other_) : std::max(on_, other_);
    if (i < 0) i = first_segment();
    const int begin = i;
    double first = infinity;
    int met = -1;
    for (; !is_outside(i); i += step) {
      const Segment& s = segments_[i];
      const double reached = step > 0 ? (s.x0 - x_) / u_ : (s.x1 - x_) / u_;
      if (u_ != 0 && reached > first) break;
      const double time = touch(s, i == on_ || i == other_);
      const double at = x_ + time * u_;
      if (time < first && at >= s.x0 - 1e-9 && at <= s.x1 + 1e-9) first = time, met = i;
    }
    if (met < 0) {
      const double end = u_ >= 0 ? segments_.back().x1 : segments_.front().x0;
      move(begin, u_ >= 0 ? static_cast<int>(segments_.size()) - 1 : 0, step, (end - x_) / u_);
      x_ = end;
      return true;
    }
    move(begin, met, step, first);
    on_ = met;
    const Segment& s = segments_[met];
    other_ = x_ - s.x0 <= 2e-9 ? met - 1 : s.x1 - x_ <= 2e-9 ? met + 1 : -1;
    if (is_outside(other_)) other_ = -1;
    return false;
  }

  void move(int first, int last, int step, double duration) {
    if constexpr (complete) {
      flies(first, last, step, duration);
    } else {
      x_ += duration * u_;
      y_ += duration * (v_ - 0.5 * g * duration);
      v_ -= g * duration;
    }
  }

  /// When the height above a segment's line falls through 0.
  double touch(const Segment& s, bool is_on) const {
    const double c0 = is_on ? 0 : (x_ - s.x0) * s.nx + (y_ - s.y0) * s.ny;
    const double c1 = u_ * s.nx + v_ * s.ny, c2 = -0.5 * g * s.ny;
    if (is_on) return c1 > 1e-10 + 1e-9 * std::sqrt(u_ * u_ + v_ * v_) && c2 < 0 ? -c1 / c2 : infinity;
    const double discriminant = c1 * c1 - 4 * c0 * c2;
    if (discriminant < 0) return infinity;
    if (c1 < 0) return c0 >= 0 ? 2 * c0 / (std::sqrt(discriminant) - c1) : infinity;
    return c2 < 0 ? (c1 + std::sqrt(discriminant)) / (-2 * c2) : infinity;
  }

  std::vector<Segment> segments_;
  std::uint64_t seed_;
  const Draw &restitution_, &tilt_;
  DrawKey key_;
  double x_ = 0, y_ = 0, u_ = 0, v_ = 0;
  int on_ = -1, other_ = -1;  // segments on which the point is
  int impacts_ = 0;
  // With `complete`:
  PlainAnswer seen_;
  double time_ = 0, since_ = -1;  // s, now and since when it has been slow on the ground; -1: it is not
  Travel rested_;                 // until then
};

}  // namespace flyrock
