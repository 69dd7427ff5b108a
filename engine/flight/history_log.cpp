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
