#include "flight/settle.h"

#include <fmt/format.h>

#include "flight/run.h"

namespace flyrock {

namespace {

/// The motion of a driven body.
template <int D>
struct DrivenMotion {
  Vec<D> v, push;
  typename Space<D>::Spin w;
};

template <int D>
void refuse_faults(const World<D>& world, const std::vector<BodyHistory>& histories) {
  for (std::size_t i = 0; i < histories.size(); ++i)
    if (world.bodies[i].kind == BodyKind::dynamic && histories[i].reason == StopReason::diverged)
      throw TrialError(fmt::format("`{}` does not settle: {}", world.bodies[i].group, histories[i].fault));
}

}  // namespace

template <int D>
void settle(World<D>& world, const SettleSettings& settings) {
  std::vector<DrivenMotion<D>> driven;
  for (Body<D>& body : world.bodies) {
    if (body.kind != BodyKind::driven) continue;
    driven.push_back({body.v, body.push, body.w});
    body.v.setZero();
    body.push.setZero();
    body.w = Space<D>::no_spin();
  }

  RunSettings before_start;
  before_start.stop_time = settings.at_most;
  before_start.stop_speed = settings.until;
  before_start.keep_impacts = false;
  before_start.loads = settings.loads;
  before_start.watch = settings.watch;
  before_start.interrupted = settings.interrupted;
  std::vector<BodyHistory> histories;
  world.settling = true;
  run(world, before_start, histories);
  world.settling = false;
  world.time = 0;
  refuse_faults(world, histories);

  auto motion = driven.begin();
  for (Body<D>& body : world.bodies) {
    body.impacts = 0;
    if (body.kind != BodyKind::driven) continue;
    body.v = motion->v;
    body.push = motion->push;
    body.w = motion->w;
    ++motion;
  }
}

template void settle(World<2>&, const SettleSettings&);
template void settle(World<3>&, const SettleSettings&);

}  // namespace flyrock
