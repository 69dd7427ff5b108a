#include "flight/history_log.h"

namespace flyrock {

template <int D>
void HistoryLog<D>::store(const BodyState& state, const Attitude<D>& attitude) {
  if (!stores()) return;
  auto& points = history_.trajectory;
  if (!points.empty() && points.back().state.time == state.time)
    points.back().state = state;
  else
    points.push_back({state, mode_, quaternion_of(attitude)});
  ends_flight_ = false;
}

template <int D>
void HistoryLog<D>::store_start(const BodyState& state, const Attitude<D>& attitude) {
  const auto goes_on = [&](const BodyState& last) {
    return last.time == state.time && last.velocity == state.velocity && last.spin == state.spin;
  };
  if (ends_flight_ && goes_on(history_.trajectory.back().state))
    history_.trajectory.pop_back();
  else
    store(state, attitude);
}

template <int D>
void HistoryLog<D>::store_end(const BodyState& state, const Attitude<D>& attitude) {
  store(state, attitude);
  ends_flight_ = stores();
}

template <int D>
bool HistoryLog<D>::has_fallen_due(double now) {
  if (!stores() || now < next_sample_) return false;
  while (next_sample_ <= now) next_sample_ += run_.trajectory_every;
  return true;
}

template class HistoryLog<2>;
template class HistoryLog<3>;

}  // namespace flyrock
