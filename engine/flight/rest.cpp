#include "flight/rest.h"

namespace flyrock {

void RestWatch::rests(double start, double end, double from, double speed, const Travel& before) {
  constexpr double creep = 0.1;  // of the stop speed
  if (speed >= stop_speed_) return moves();
  if (since_ < 0) {
    const double share = from > stop_speed_ ? (from - stop_speed_) / (from - speed) : 0;
    begin(start + share * (end - start), speed, before);
  }
  if (end - since_ < rest_time) return;
  if (speed > speed_ && speed > creep * stop_speed_) return begin(end, speed, history_->travel);
  history_->stop_time = since_;
}

void RestWatch::begin(double time, double speed, const Travel& travel) {
  since_ = time;
  speed_ = speed;
  travel_ = travel;
}

}  // namespace flyrock
