#include "flight/faults.h"

#include <fmt/format.h>

#include <algorithm>

#include "flight/ground.h"

namespace flyrock {

std::string energy_from_nowhere_text(double excess) {
  return fmt::format("it has {:.3g} J more than gravity, air and impacts gave it", excess);
}

std::string energy_of_impact_text(double share) {
  return fmt::format(
      "an impact gave it and the bodies that it touched {:.2g} % of their kinetic energy from nowhere",
      100 * share);
}

template <int D>
Faults<D>::Faults(const World<D>& world, bool exact_flight) : world_(world), exact_flight_(exact_flight) {
  for (const Body<D>& body : world.bodies) starts_.push_back(body.x);
  begin_anew();
}

template <int D>
double Faults<D>::energy_of(int i) const {
  const Body<D>& body = world_.bodies[i];
  if (!body.moves()) return 0;
  const double rigid = body.kinetic_energy() - body.mass * world_.gravity().dot(body.x);
  return changes_shape(body) ? rigid + potential_energy_of_shape(body) : rigid;
}

/// Whether a body whose centre of mass, at `place`, may be outside of it, has a point or the highest place of
/// a rim above the ground.
template <int D>
bool Faults<D>::straddles(const Body<D>& body, const Vec<D>& place) const {
  if (body.contactors.size() == 1 && body.contactors[0].form != Form::cloud) return false;
  const auto is_above = [&](const Vec<D>& point) {
    return !(depth_below_ground(world_.terrain(), place + body.pose().r * point) > 0);
  };
  for (const auto& contactor : body.contactors) {
    if (std::any_of(contactor.points.begin(), contactor.points.end(), is_above)) return true;
    if constexpr (D == 3)
      for (const Contactor3::Circle& circle : contactor.circles)
        if (is_above(circle.centre + circle.radius * circle.towards(body.pose().r.inverse(Vec3::UnitZ()))))
          return true;
  }
  return false;
}

template <int D>
std::optional<std::string> Faults<D>::below_ground(int i, const Vec<D>& place) const {
  const Body<D>& body = world_.bodies[i];
  const double depth = depth_below_ground(world_.terrain(), place);
  if (!(depth > 0)) return std::nullopt;
  double usual = world_.carry_reach(i, -1) + world_.touch(i);
  if (!exact_flight_) usual += body.size + body.v.norm() * world_.settings().time_step;
  if (depth <= usual || is_near_surface(world_.terrain(), place, usual)) return std::nullopt;
  if (straddles(body, place)) return std::nullopt;
  return fmt::format("its centre of mass lies {:.2g} m below the ground", depth);
}

template <int D>
std::optional<std::string> Faults<D>::energy_from_nowhere() {
  constexpr double share = 1e-6;
  const double g = world_.gravity().norm();
  double energy = world_.total_energy(), scale = 0, lift = 0;
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    const Body<D>& body = world_.bodies[i];
    if (!body.moves()) continue;
    const double pull = g + body.load.norm();  // m/s2
    scale += body.kinetic_energy() + body.mass * pull * ((body.x - starts_[i]).norm() + body.size);
    lift += body.mass * g * world_.carry_reach(static_cast<int>(i), -1);
  }
  greatest_ = std::max(greatest_, scale);
  const double excess = energy - (allowed_ + world_.energy_given());
  if (!(excess > share * greatest_ + lift + world_.energy_in_doubt())) return std::nullopt;
  return energy_from_nowhere_text(excess);
}

template class Faults<2>;
template class Faults<3>;

}  // namespace flyrock
