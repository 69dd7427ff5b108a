// Adding and removing bodies, free flight, energy.

#include "world/world.h"

#include <algorithm>

#include "solver/spring.h"
#include "world/manifold.h"

namespace flyrock {

template <int D>
World<D>::World(const Terrain& terrain, const Vec<D>& gravity, const WorldSettings& settings)
    : terrain_(&terrain),
      gravity_(gravity),
      g_(gravity.norm()),
      settings_(settings),
      control_(settings.step_tolerance),
      reach_time_(settings.time_step) {}

template <int D>
int World<D>::add(Body<D> body) {
  g_ = std::max(g_, (gravity_ + body.load).norm());
  deforms_ = deforms_ || body.deformation.moves();
  bodies.push_back(std::move(body));
  terrain_laws_.emplace_back(parts_of(*terrain_).size(), nullptr);
  pair_laws_.emplace_back();
  for (auto& row : pair_laws_) row.resize(bodies.size(), nullptr);
  contacts_of_.emplace_back();
  unsolved_.emplace_back();
  return static_cast<int>(bodies.size()) - 1;
}

template <int D>
void World<D>::set_gravity(const Vec<D>& gravity) {
  const double before = total_energy();
  gravity_ = gravity;
  energy_given_ += total_energy() - before;
  g_ = std::max(g_, gravity.norm());
}

template <int D>
void World<D>::set_force(int body, const Vec<D>& force) {
  Body<D>& pulled = bodies[body];
  pulled.push -= pulled.load;
  pulled.load = force / pulled.mass;
  pulled.push += pulled.load;
  g_ = std::max(g_, (gravity_ + pulled.load).norm());
}

template <int D>
void World<D>::release_held() {
  for (Body<D>& body : bodies) {
    if (!body.hold || body.hold->until > time) continue;
    body.v = body.hold->v;
    body.w = body.hold->w;
    body.hold.reset();
    forget_steps();
  }
  pull_links();
}

template <int D>
void World<D>::remove_last() {
  bodies.pop_back();
  terrain_laws_.pop_back();
  pair_laws_.pop_back();
  for (auto& row : pair_laws_) row.pop_back();
  contacts_of_.pop_back();
  unsolved_.pop_back();
}

template <int D>
void World<D>::set_terrain_laws(int body, int part, PairLaws* laws) {
  terrain_laws_[body][part] = laws;
  know(laws);
}

template <int D>
PairLaws* World<D>::pair_laws(int a, int b) {
  PairLaws*& laws = pair_laws_[a][b];
  if (!laws && laws_between) {
    const int rock = rock_of(a, b);
    laws = rock == a ? laws_between(a, b) : laws_between(b, a);
    know(laws);
  }
  return laws;
}

/// Registers laws with memory, because a repeated step must restore its memory. Laws that are first
/// used within the step are restored to their initial memory.
template <int D>
void World<D>::know(PairLaws* laws) {
  if (!laws || !laws->remembers() || std::find(laws_.begin(), laws_.end(), laws) != laws_.end()) return;
  laws_.push_back(laws);
  laws->save_history(memory_);
}

template <int D>
typename World<D>::Motion World<D>::flight_of(int body) const {
  return free_motion(bodies[body], moment_of(bodies[body]), gravity_);
}

template <int D>
void World<D>::fly(double dt) {
  for (Body<D>& body : bodies) {
    if (!body.present || body.kind == BodyKind::fixed) continue;
    const Motion motion = free_motion(body, moment_of(body), gravity_);
    const Turned<D> turned = turn_at(motion, dt);
    if (body.moves()) energy_given_ += body.mass * body.push.dot(motion.position(dt) - body.x);
    body.move_to(motion.position(dt), turned.attitude);
    body.v = motion.velocity(dt);
    body.w = turned.spin;
  }
  forget_steps();
  time += dt;
  ++quality_.flights;
}

template <int D>
double World<D>::total_energy() const {
  double energy = 0;
  for (const Body<D>& body : bodies)
    if (body.moves()) energy += body.kinetic_energy() - body.mass * gravity_.dot(body.x);
  for (const Body<D>& body : bodies)
    if (changes_shape(body)) energy += potential_energy_of_shape(body);
  energy += links.energy(bodies);
  for (const Contact& c : last_) {
    // Of one that has opened, the features may be anywhere.
    if (c.law.condition != NormalCondition::penalty || !c.carried) continue;
    energy += elastic_energy(c.law.spring, c.compression(gap_at(c, false))) +
              0.5 * c.law.spring.tangential_stiffness * c.stretch.squaredNorm();
  }
  return energy;
}

// With the functions that the header defines, which other files call
template class World<2>;
template class World<3>;

}  // namespace flyrock
