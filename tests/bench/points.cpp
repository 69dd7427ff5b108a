// The lumped mass beside a plain loop of the same algorithm: points points.yaml [ROCKS]. Both draw from the
// same streams and call the same functions. Prints whether they agree rock by rock, their ratio, and what an
// impact costs; then the same with rows and envelopes, and with the restitution in Lua. Exit code 1 if they
// do not agree.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "batch/load.h"
#include "batch/trial.h"

using namespace flyrock;

namespace {

constexpr double g = 9.81, mu = 0.6, rest_speed = 0.02, slow = 0.05 * rest_speed,
                 infinity = std::numeric_limits<double>::infinity();
constexpr double start_x = 19, start_y = 62, start_u = 2, start_v = -1;

struct Segment {
  double x0, y0, x1, y1;  // from left to right
  double tx, ty, nx, ny;  // unit vectors along it and out of the ground
};

struct Answer {
  double x = 0, y = 0;
  int impacts = 0;
};

/// One point. The ground is to the right of nothing: a point that leaves the profile ends there.
class PlainLoop {
 public:
  PlainLoop(const Profile& ground, const Scenario& scenario)
      : seed_(scenario.seed),
        restitution_(scenario.draws[scenario.materials[0].restitution->slots[0].draw]),
        tilt_(scenario.draws[scenario.materials[0].roughness->draw]) {
    for (int i = 0; i < ground.segments(); ++i) {
      const Vec2 &a = ground.points[i], &b = ground.points[i + 1];
      const double length = std::sqrt((b - a).squaredNorm());
      const double tx = (b.x() - a.x()) / length, ty = (b.y() - a.y()) / length;
      segments_.push_back({a.x(), a.y(), b.x(), b.y(), tx, ty, -ty, tx});
    }
  }

  Answer run(std::uint64_t trial) {
    key_ = {trial, 1, 1, 0};
    x_ = start_x, y_ = start_y, u_ = start_u, v_ = start_v;
    on_ = other_ = -1;
    impacts_ = 0;
    for (int events = 0; events < 10'000; ++events) {
      if (on_ >= 0) settle();
      const int carrier = carrier_of();
      if (carrier < 0 && rests_between()) return {x_, y_, impacts_};
      if (carrier >= 0 ? slide(carrier) : fly()) return {x_, y_, impacts_};
    }
    return {infinity, infinity, impacts_};
  }

 private:
  double approach(int i) const { return -(u_ * segments_[i].nx + v_ * segments_[i].ny); }

  /// Impacts and touches until the point approaches no segment on which it is.
  void settle() {
    for (int i = 0;; ++i) {
      int first = -1;
      double greatest = 1e-10 + 1e-9 * std::sqrt(u_ * u_ + v_ * v_);
      for (const int each : {on_, other_})
        if (each >= 0 && approach(each) > greatest) first = each, greatest = approach(each);
      if (first < 0) return;
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
      return std::fabs(pull) <= hold;  // otherwise it slides back
    }
    const double speed = std::sqrt(std::max(0.0, along * along + 2 * rate * room));
    u_ = sign * speed * face.tx;
    v_ = sign * speed * face.ty;
    x_ = sign > 0 ? face.x1 : face.x0;
    y_ = sign > 0 ? face.y1 : face.y0;
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
    if (i < 0)
      for (i = 0; segments_[i].x1 < x_;) ++i;
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
      const double end = u_ >= 0 ? segments_.back().x1 : segments_.front().x0, time = (end - x_) / u_;
      y_ += time * (v_ - 0.5 * g * time);
      x_ = end;
      return true;
    }
    x_ += first * u_;
    y_ += first * (v_ - 0.5 * g * first);
    v_ -= g * first;
    on_ = met;
    const Segment& s = segments_[met];
    other_ = x_ - s.x0 <= 2e-9 ? met - 1 : s.x1 - x_ <= 2e-9 ? met + 1 : -1;
    if (is_outside(other_)) other_ = -1;
    return false;
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
};

/// Processor time [s], because others use the machine too.
double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The engine on the scenario with some keys changed.
class Engine {
 public:
  Engine(const char* path, std::vector<std::string> set)
      : loaded_(load(path, std::move(set))), runner_(scenario()) {}

  const Scenario& scenario() const { return loaded_.plan.points.front(); }
  TrialRunner& runner() { return runner_; }

  /// Runs the trials in chunks, as a program does. Keeps the least time of all calls [s].
  void run(std::uint64_t trials) {
    constexpr std::uint64_t chunk = 250;
    const double start = seconds_now();
    for (std::uint64_t first = 0; first < trials; first += chunk) {
      TrialRecords records;
      for (std::uint64_t trial = first; trial < std::min(first + chunk, trials); ++trial)
        runner_.run(trial, records);
    }
    seconds = std::min(seconds, seconds_now() - start);
  }

  double seconds = infinity;

 private:
  static LoadedScenario load(const char* path, std::vector<std::string> set) {
    Diagnostics diagnostics;
    std::optional<LoadedScenario> loaded = load_scenario(path, {.set = std::move(set)}, diagnostics);
    if (loaded) return std::move(*loaded);
    fmt::print(stderr, "{}", diagnostics.to_text());
    std::exit(2);
  }

  LoadedScenario loaded_;
  TrialRunner runner_;
};

}  // namespace

int main(int count, char** words) {
  if (count != 2 && count != 3) return 2;
  const std::uint64_t trials = count == 3 ? std::strtoull(words[2], nullptr, 10) : 20'000;
  Engine engine(words[1], {});
  Engine with_rows(words[1], {"output.rocks=true", "output.envelopes=true"});
  Engine in_lua(words[1], {"plugins=[newton_in_lua.lua]", "materials.rock.restitution.type=newton_in_lua"});
  PlainLoop plain(engine.runner().picture_of(0).profile, engine.scenario());

  double worst = 0;
  std::uint64_t impacts = 0, different = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    TrialRecords records, records_of_lua;
    engine.runner().run(trial, records);
    in_lua.runner().run(trial, records_of_lua);
    const RockRecord& rock = records.rocks.front();
    const Answer answer = plain.run(trial);
    const double distance = std::hypot(answer.x - rock.stop_x, answer.y - rock.stop_y);
    const bool same = answer.impacts == rock.impacts && distance < 1e-6 &&
                      records_of_lua.rocks.front().stop_x == rock.stop_x;
    different += !same;
    if (same) worst = std::max(worst, distance);
    impacts += static_cast<std::uint64_t>(rock.impacts);
  }

  // In turn; the fastest of each.
  double loop = infinity, sum = 0;
  for (int round = 0; round < 5; ++round) {
    for (Engine* each : {&engine, &with_rows, &in_lua}) each->run(trials);
    const double start = seconds_now();
    for (std::uint64_t trial = 0; trial < trials; ++trial) sum += plain.run(trial).x;
    loop = std::min(loop, seconds_now() - start);
  }
  const auto cost = [&](double seconds) {
    return fmt::format("{:.2f} us a rock, {:.0f} ns an impact", 1e6 * seconds / static_cast<double>(trials),
                       1e9 * seconds / static_cast<double>(impacts));
  };
  fmt::print(
      "points: {} of {} rocks as in a plain loop (to {:.1g} m, {:.1f} impacts each); {}, in the plain loop "
      "{}: {:.2f} of its speed\n",
      trials - different, trials, worst, static_cast<double>(impacts) / static_cast<double>(trials),
      cost(engine.seconds), cost(loop), loop / engine.seconds);
  fmt::print("points with rows and envelopes: {}: {:.2f} of the plain loop\n", cost(with_rows.seconds),
             loop / with_rows.seconds);
  fmt::print("points with the restitution in Lua: {}: {:.2f} of the native run, {:.0f} ns more an impact\n",
             cost(in_lua.seconds), engine.seconds / in_lua.seconds,
             1e9 * (in_lua.seconds - engine.seconds) / static_cast<double>(impacts));
  return different == 0 && std::isfinite(sum) ? 0 : 1;
}
