#include "batch/fixture.h"

#include "flight/body_state.h"

namespace flyrock {

template <int D>
Fixture fixture_of(const World<D>& world, const Body<D>& body) {
  Fixture fixture{body.group, state_of(body, world.time), quaternion_of(body.attitude)};
  fixture.start.position.template head<D>() += world.origin;
  if (body.kind == BodyKind::driven) fixture.acceleration.template head<D>() = body.push;
  return fixture;
}

template Fixture fixture_of(const World<2>&, const Body<2>&);
template Fixture fixture_of(const World<3>&, const Body<3>&);

}  // namespace flyrock
