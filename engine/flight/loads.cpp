#include "flight/loads.h"

namespace flyrock {

double LoadTables::end_of_piece(double now) const {
  double end = gravity ? gravity->end_of_piece(now) : infinite;
  for (const OverTime* table : of_body)
    if (table) end = std::min(end, table->end_of_piece(now));
  return end;
}

template <int D>
double LoadTables::apply(World<D>& world, double now) const {
  const double end = world.settling ? infinite : end_of_piece(now);
  const double middle = world.settling ? 0 : end < infinite ? 0.5 * (now + end) : now;
  if (gravity) world.set_gravity(gravity->at(middle).template head<D>());
  for (std::size_t i = 0; i < of_body.size(); ++i) {
    const OverTime* table = of_body[i];
    if (!table) continue;
    Body<D>& body = world.bodies[i];
    if (body.kind == BodyKind::driven && !world.settling) {
      const Vec3 velocity = table->at(now);
      body.v = velocity.template head<D>();
      body.push.setZero();
      if (end < infinite) body.push = (table->at(end) - velocity).template head<D>() / (end - now);
    } else if (body.kind == BodyKind::dynamic) {
      world.set_force(static_cast<int>(i), table->at(middle).template head<D>());
    }
  }
  return end;
}

template double LoadTables::apply(World<2>&, double) const;
template double LoadTables::apply(World<3>&, double) const;

}  // namespace flyrock
