// Deformable blocks in the world: the energy of their steps, corners between their nodes, their rest in the
// air.

#include <algorithm>

#include "elastic/elastic_block.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// How deep a point lies inside of the line through the surface nodes of a deformable block [m]; 0: outside.
double depth_between_nodes(const Body<2>& block, const Vec2& point) {
  if ((point - block.x).norm() > block.size + block.deformation.greatest) return 0;
  const Vec2 own = block.attitude.rotation.inverse(Vec2(point - block.x));
  bool is_inside = false;
  double nearest = infinite;
  for (std::size_t k = 0; k < block.contactors.size(); ++k) {
    const Vec2& start = block.contactors[k].points.front();
    const Vec2& end = block.contactors[(k + 1) % block.contactors.size()].points.front();
    const Vec2 edge = end - start;
    if ((start.y() > own.y()) != (end.y() > own.y()) &&
        own.x() < start.x() + edge.x() * (own.y() - start.y()) / edge.y())
      is_inside = !is_inside;
    const double share = std::clamp((own - start).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (own - start - share * edge).norm());
  }
  return is_inside ? nearest : 0;
}

/// The deepest corner of the ground or of a rigid body between two nodes of a block, which nothing holds [m].
double deepest_corner(const Body<2>& block, const Terrain2& ground, const std::vector<Body<2>>& bodies,
                      bool bodies_meet) {
  double deepest = 0;
  for (const Vec2& corner : ground.profile().points)
    deepest = std::max(deepest, depth_between_nodes(block, corner));
  for (const Body<2>& other : bodies) {
    if (&other == &block || !bodies_meet || !other.present || other.deformation.moves()) continue;
    if ((other.x - block.x).norm() > other.size + block.size + block.deformation.greatest) continue;
    for (const Contactor2& contactor : other.contactors)
      for (const Vec2& corner : contactor.points)
        if (contactor.form == Form::hull && contactor.radius == 0)
          deepest = std::max(deepest, depth_between_nodes(block, other.pose() * corner));
  }
  return deepest;
}

}  // namespace

template <int D>
bool World<D>::deforms(const Contact& contact) const {
  return deforms_ && (bodies[contact.candidate].deforms() ||
                      (contact.antagonist >= 0 && bodies[contact.antagonist].deforms()));
}

/// What the deformable blocks lose in a step of length h, without the contacts, for the rates u'_theta and
/// displacements over the step
///   h u'_theta.C u'_theta + (theta - 1/2) (du'.M du' + du.K du + m |dv|^2 + J dw^2)
/// and by their contacts -r.u_theta, each with the velocity of the contact in its frame of the middle.
template <int D>
void World<D>::account_deformations(double h) {
  if constexpr (D == 2) {
    const double theta = settings_.theta, late = theta - 0.5;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body<D>& body = bodies[i];
      if (!body.deforms()) continue;
      Deformation& own = body.deformation;
      const auto& model = own.block->model;
      const ElasticMaterial& of = model.material();
      quality_.max_penetration =
          std::max(quality_.max_penetration, deepest_corner(body, *terrain_, bodies, bodies_meet()));
      own.change = own.rate - own.start;
      own.start += theta * own.change;
      const double twice_strain = 2 * model.strain_energy(own.start);  // of the rates
      own.damped += h * (2 * of.alpha * model.kinetic_energy(own.start) + of.beta * twice_strain);
      if (late == 0) continue;
      const double turned = body.w - starts_[i].w;
      own.damped +=
          late * (2 * model.kinetic_energy(own.change) + h * h * twice_strain +
                  body.mass * (body.v - starts_[i].v).squaredNorm() + body.inertia * turned * turned);
    }
    for (std::size_t a = 0; a < contacts_.size(); ++a) {
      const Contact& contact = contacts_[a];
      if (!deforms(contact)) continue;
      const Row before = contact.before + (1 - theta) * h * contact.turning,
                after = after_[a] - theta * h * contact.turning;
      Body<D>& body = bodies[bodies[contact.candidate].deforms() ? contact.candidate : contact.antagonist];
      body.deformation.touch -= contact.impulse.dot((1 - theta) * before + theta * after);
      if (contact.impulse[0] > 0)
        body.deformation.at_release = body.kinetic_energy() - body.deformation.vibration_energy();
    }
  }
}

/// Stops the small vibrations of deformable blocks in the air, which then fly as rigid bodies.
template <int D>
void World<D>::settle_deformations() {
  constexpr double small = 1e-9;  // of the kinetic energy at the last release
  if constexpr (D == 2)
    for (Body<D>& body : bodies) {
      Deformation& own = body.deformation;
      if (!body.deforms()) continue;
      const double energy = own.strain_energy() + own.vibration_energy();
      if (energy > small * own.at_release) continue;
      own.settled += energy;
      own.u.setZero();
      own.rate.setZero();
      body.place_nodes();
    }
}

template <int D>
bool World<D>::vibrates() const {
  return deforms_ && std::any_of(bodies.begin(), bodies.end(), [](const Body<D>& body) {
           return body.deforms() && (body.deformation.greatest > 0 || !body.deformation.rate.isZero(0));
         });
}

#define FLYROCK_INSTANTIATE(D)                           \
  template bool World<D>::deforms(const Contact&) const; \
  template void World<D>::account_deformations(double);  \
  template void World<D>::settle_deformations();         \
  template bool World<D>::vibrates() const
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
