#include "flight/rest.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

/// Whether the body is slow apart from a pivot that has not changed since it became slow.
bool RestWatch::only_pivots(const Pace& pace) const {
  constexpr double rounding = 1e-9;  // of the pivot; what stops it within six years changes it by more
  return pace.unpivoted < stop_speed_ && std::abs(pace.pivot - pivot_) <= rounding * std::abs(pivot_);
}

void RestWatch::rests(double start, double end, const Pace& from, const Pace& pace, const Travel& before) {
  constexpr double creep = 0.1;      // of the stop speed
  constexpr double unsteady = 1e-3;  // of the speed and the stop speed
  if (slow_since_ < 0) pivot_ = from.pivot;
  const bool pivots = pace.speed >= stop_speed_;
  if (pivots && !only_pivots(pace)) return moves();
  const double speed = pivots ? pace.unpivoted : pace.speed;
  if (slow_since_ < 0) {
    const double faster = pivots ? from.unpivoted : from.speed;
    const double share = faster > stop_speed_ ? (faster - stop_speed_) / (faster - speed) : 0;
    slow_since_ = start + share * (end - start);
    greatest_ = speed;
    begin(slow_since_, speed, before);
  }
  const bool slower = speed < greatest_;
  greatest_ = std::max(greatest_, speed);
  if (kind_ == Kind::body && std::abs(speed - steady_speed_) > unsteady * (steady_speed_ + stop_speed_))
    steady_since_ = end, steady_speed_ = speed;
  const bool settled = kind_ == Kind::body && slower && end - slow_since_ >= settling_time;
  if (!settled) {
    if (end - since_ < rest_time) return;
    if (speed > speed_ && speed > creep * stop_speed_) return begin(end, speed, history_->travel);
    if (end - steady_since_ < rest_time) return;
  }
  history_->stop_time = since_;
}

void RestWatch::begin(double time, double speed, const Travel& travel) {
  since_ = steady_since_ = time;
  speed_ = steady_speed_ = speed;
  travel_ = travel;
}

}  // namespace flyrock
