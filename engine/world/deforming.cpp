// Deformable blocks in the world: the energy of their steps, corners between their nodes, their rest in the
// air.

#include <algorithm>

#include "elastic/elastic_block.h"
#include "geometry/ground.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// How deep a place in the frame of a deformable block lies inside of the lines between its surface nodes
/// [m]; 0: outside.
double depth_between_nodes(const Body<2>& block, const Vec2& own) {
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

/// The distance of the origin from a triangle [m].
double distance_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a).normalized(), foot = normal.dot(a) * normal;
  const auto is_within = [&](const Vec3& start, const Vec3& end) {
    return (end - start).cross(foot - start).dot(normal) >= 0;
  };
  if (is_within(a, b) && is_within(b, c) && is_within(c, a)) return foot.norm();
  const Vec3 origin = Vec3::Zero();
  return std::min({distance_to_segment(origin, a, b), distance_to_segment(origin, b, c),
                   distance_to_segment(origin, c, a)});
}

/// The same in 3D, of the triangles between the nodes: inside, they fill all directions (4 pi). The solid
/// angle of a triangle is that of Van Oosterom and Strackee (IEEE Trans. Biomed. Eng. 30, 1983).
double depth_between_nodes(const Body<3>& block, const Vec3& own) {
  Box3 around = Box3::empty();
  for (const Contactor3& node : block.contactors) around.add(node.points.front());
  if (!around.overlaps({own, own})) return 0;
  const Deformation<3>& shape = block.deformation;
  double seen = 0, nearest = infinite;
  for (const auto& side : shape.block->model.mesh().sides) {
    const Vec3 a = shape.place(side[0]) - own, b = shape.place(side[1]) - own, c = shape.place(side[2]) - own;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    seen += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    nearest = std::min(nearest, distance_to_triangle(a, b, c));
  }
  return seen > 2 * pi ? nearest : 0;
}

/// The same of a place in the frame of the world.
template <int D>
double depth_of(const Body<D>& block, const Vec<D>& point) {
  if ((point - block.x).norm() > block.size + block.deformation.greatest) return 0;
  return depth_between_nodes(block, block.attitude.rotation.inverse(Vec<D>(point - block.x)));
}

double deepest_corner_of_ground(const Body<2>& block, const Terrain2& ground, Workspace&) {
  double deepest = 0;
  for (const Vec2& corner : ground.profile().points) deepest = std::max(deepest, depth_of(block, corner));
  return deepest;
}
double deepest_corner_of_ground(const Body<3>& block, const Terrain3& ground, Workspace& work) {
  double deepest = 0;
  work.facets.clear();
  const double reach = block.size + block.deformation.greatest;
  ground.ground().facets(Box3{block.x, block.x}.grown(reach), work.facets);
  for (const Facet& facet : work.facets)
    for (const Vec3& corner : facet.corner)
      if (!facet.unbounded) deepest = std::max(deepest, depth_of(block, corner));
  return deepest;
}

/// The deepest corner of rigid bodies between the nodes of a block, which nothing holds [m].
template <int D>
double deepest_corner_of(const std::vector<Body<D>>& bodies, const Body<D>& block) {
  double deepest = 0;
  for (const Body<D>& other : bodies) {
    if (&other == &block || !other.present || other.deformation.moves()) continue;
    if ((other.x - block.x).norm() > other.size + block.size + block.deformation.greatest) continue;
    for (const auto& contactor : other.contactors)
      for (const Vec<D>& corner : contactor.points)
        if (contactor.form == Form::hull && contactor.radius == 0)
          deepest = std::max(deepest, depth_of<D>(block, other.pose() * corner));
  }
  return deepest;
}

/// By how much the spin of a body changed over a step that began with `start`, seen from the body and in its
/// present attitude: turned about itself, a spin stays the same in the frame of its body.
double spin_change(const Body<2>& body, const Moment<2>& start) { return body.w - start.w; }
Vec3 spin_change(const Body<3>& body, const Moment<3>& start) {
  return body.w - body.attitude.rotation * start.attitude.rotation.inverse(start.w);
}

}  // namespace

template <int D>
bool World<D>::deforms(const Contact& contact) const {
  return deforms_ && (bodies[contact.candidate].deforms() ||
                      (contact.antagonist >= 0 && bodies[contact.antagonist].deforms()));
}

/// How fast the turn of its block changes the velocity of a node at most, at the start of the step [m/s2]:
/// |w| (|w| |r| + 2 |u'|), with the lever r and the rate u' of its displacement (centripetal and Coriolis).
template <int D>
double World<D>::turn_of_node(const Contact& contact) const {
  const int block = bodies[contact.candidate].deforms() ? contact.candidate : contact.antagonist;
  const Body<D>& body = bodies[block];
  const int node = body.deformation.node_of(contactor_of(shape_touch(contact, block).feature));
  const double spin = spin_speed(starts_[block].w);
  return spin * (spin * (contact.at.point - body.x).norm() +
                 2 * body.deformation.start.template segment<D>(D * node).norm());
}

/// What the deformable blocks lose in a step of length h, without the contacts, for the rates u'_theta and
/// displacements over the step
///   h u'_theta.C u'_theta + (theta - 1/2) (du'.M du' + du.K du + m |dv|^2 + dw.J dw)
/// and by their contacts -r.u_theta, each with the velocity of the contact in its frame of the middle.
template <int D>
void World<D>::account_deformations(double h) {
  const double theta = settings_.theta, late = theta - 0.5;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body<D>& body = bodies[i];
    if (!body.deforms()) continue;
    Deformation<D>& own = body.deformation;
    const auto& model = own.block->model;
    const ElasticMaterial& of = model.material();
    double& deepest = quality_.max_penetration;
    deepest = std::max(deepest, deepest_corner_of_ground(body, *terrain_, work_));
    if (bodies_meet()) deepest = std::max(deepest, deepest_corner_of(bodies, body));
    own.change = own.rate - own.start;
    own.start += theta * own.change;
    const double twice_strain = 2 * model.strain_energy(own.start);  // of the rates
    own.damped += h * (2 * of.alpha * model.kinetic_energy(own.start) + of.beta * twice_strain);
    if (late == 0) continue;
    own.damped += late * (2 * model.kinetic_energy(own.change) + h * h * twice_strain +
                          body.mass * (body.v - starts_[i].v).squaredNorm() +
                          twice_spin_energy(body, body.attitude, spin_change(body, starts_[i])));
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

/// What lost_by_turning takes from deformable blocks is the doing of their contacts.
template <int D>
void World<D>::account_turns(double h) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].deforms()) bodies[i].deformation.touch += lost_by_turning(i, h);
}

/// Stops the small vibrations of deformable blocks in the air, which then fly as rigid bodies.
template <int D>
void World<D>::settle_deformations() {
  constexpr double small = 1e-9;  // of the kinetic energy at the last release
  for (Body<D>& body : bodies) {
    if (!body.deforms()) continue;
    Deformation<D>& own = body.deformation;
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

#define FLYROCK_INSTANTIATE(D)                                  \
  template bool World<D>::deforms(const Contact&) const;        \
  template double World<D>::turn_of_node(const Contact&) const; \
  template void World<D>::account_deformations(double);         \
  template void World<D>::account_turns(double);                \
  template void World<D>::settle_deformations();                \
  template bool World<D>::vibrates() const
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
