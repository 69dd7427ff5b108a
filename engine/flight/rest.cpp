#include "flight/rest.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

void RestWatch::rests(double start, double end, double from, double speed, const Travel& before) {
  constexpr double creep = 0.1;      // of the stop speed
  constexpr double unsteady = 1e-3;  // of the speed and the stop speed
  if (speed >= stop_speed_) return moves();
  if (slow_since_ < 0) {
    const double share = from > stop_speed_ ? (from - stop_speed_) / (from - speed) : 0;
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
