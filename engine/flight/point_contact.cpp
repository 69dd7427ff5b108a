#include "flight/point_contact.h"

#include <algorithm>
#include <cmath>

#include "solver/point_impact.h"
#include "world/proportions.h"

namespace flyrock {

namespace {

/// The n-th value of a draw at a key, from 0.
double value_of(const Draw& draw, const Streams& streams, const DrawKey& at, int n) {
  if (n == 0) return draw.value(streams, at);
  DrawKey key = at;
  if (draw.scope != Scope::impact) key.impact = 0;
  key.hole = 0;
  return draw.quantile(
      uniform_at(streams.seed_of(draw.stream_hash), draw.stream_hash, key, static_cast<std::uint64_t>(n)));
}

/// The direction along a face in which a point slips; any, if it does not.
Vec2 slip_direction(const Vec2& normal, const Vec2& v) {
  const Vec2 along(normal.y(), -normal.x());
  return along.dot(v) < 0 ? Vec2(-along) : along;
}
Vec3 slip_direction(const Vec3& normal, const Vec3& v) {
  const Vec3 slip = v - normal.dot(v) * normal;
  return slip.squaredNorm() > 0 ? Vec3(slip.normalized()) : Vec3(contact_frame(normal).col(1));
}

}  // namespace

template <int D>
ContactState PointContact<D>::state_of(const Face<D>& face, const PairLaws& laws, const Vec<D>& normal,
                                       double time, const Vec<D>& at, const Vec<D>& v) const {
  const double vn = normal.dot(v);
  const Vec<D> slip = v - vn * normal;
  ContactState state;
  state.approach_speed = vn < 0 ? -vn : 0;
  state.slip_speed = slip.norm();
  state.impact_angle = std::atan2(state.approach_speed, state.slip_speed);
  state.effective_mass = state.mass = body_.mass;
  state.radius = body_.radius;
  state.kinetic_energy = 0.5 * body_.mass * v.squaredNorm();
  state.age = state.pair_age = age_;
  state.impact_number = impacts_;
  state.time = time;
  state.dimension = D;
  state.normal = Vec3::Zero();
  state.normal.template head<D>() = normal;
  state.place.template head<D>() = at + origin_;
  state.slip.template head<D>() = slip;
  state.group_a = body_.group;
  state.group_b = terrain_.names()[face.part];
  state.material = laws.material;
  return state;
}

template <int D>
void PointContact<D>::set_read_fields(ContactState& state, const ContactReads& reads) const {
  state.slip_length = slipped_.length;
  if (reads.shape) put_shape(body_, proportions_of(body_), state);
}

/// The normal of the face, tilted by the roughness of its material: the tilt is added to the dip along the
/// motion, and in 3D a second one to the dip across it.
template <int D>
typename PointContact<D>::Tilted PointContact<D>::tilted(const Face<D>& face, const PairLaws& laws,
                                                         const Vec<D>& v) const {
  constexpr int most_draws = 100;
  const Roughness& roughness = laws.roughness;
  const Vec<D> along = slip_direction(face.normal, v);
  const DrawKey& key = laws.key;  // of this impact
  for (int i = 0; i < most_draws; ++i) {
    const auto angle = [&](int n) {
      return roughness.draw ? value_of(*roughness.draw, *laws.streams, key, n) : roughness.constant;
    };
    const double ahead = angle(2 * i);
    if (!(std::abs(ahead) < 0.5 * pi)) continue;
    double aside = 0;
    Vec<D> normal = face.normal + std::tan(ahead) * along;
    if constexpr (D == 3) {
      if (roughness.draw) aside = angle(2 * i + 1);
      if (!(std::abs(aside) < 0.5 * pi)) continue;
      normal += std::tan(aside) * face.normal.cross(along);
    }
    normal.normalize();
    if (normal.dot(v) < 0) return {normal, {ahead, aside}};
    if (!roughness.draw) break;
  }
  return {face.normal};
}

template <int D>
typename PointContact<D>::Tilted PointContact<D>::begin_impact(const Face<D>& face, PairLaws* laws,
                                                               const Vec<D>& v) {
  ++impacts_;
  age_ = 0;
  if (!laws) return {face.normal};
  laws->begin_instant();
  laws->begin_impact(static_cast<std::uint64_t>(impacts_));
  if (laws->remembers_contacts()) memory_ = {};
  memory_part_ = face.part;
  ++laws->use.contacts;
  return laws->roughness.any() ? tilted(face, *laws, v) : Tilted{face.normal};
}

template <int D>
typename PointContact<D>::Bounce PointContact<D>::strike(const Face<D>& face, double time, const Vec<D>& at,
                                                         Vec<D>& v) {
  PairLaws* laws = laws_[face.part];
  since_ = time;
  slipped_ = {};
  Bounce bounce{begin_impact(face, laws, v), {}, {}};
  if (laws && laws->reads_state()) {
    state_ = state_of(face, *laws, bounce.face.normal, time, at, v);
    set_read_fields(state_, laws->reads());
  }
  const ContactLaw law = laws ? laws->ask(state_, true, memory_) : ContactLaw{};
  const auto frame = contact_frame(bounce.face.normal);
  bounce.before = frame.transpose() * v;
  bounce.after = rebound_of_point<D>(bounce.before, law, law.mu_d);
  v = frame * bounce.after;
  return bounce;
}

template <int D>
Impact PointContact<D>::record(const Face<D>& face, double time, const Vec<D>& at,
                               const Bounce& bounce) const {
  const Vec<D>&before = bounce.before, &after = bounce.after;
  // Signed in 2D, magnitudes in 3D, as the impacts of bodies.
  const auto slip = [](const Vec<D>& row) { return D == 2 ? row[1] : row.template tail<D - 1>().norm(); };
  Impact impact;
  impact.part = face.part;
  impact.number = impacts_;
  impact.time = time;
  impact.place.template head<D>() = at;
  impact.vn_before = before[0];
  impact.vn_after = after[0];
  impact.vt_before = slip(before);
  impact.vt_after = slip(after);
  impact.pn = body_.mass * (after[0] - before[0]);
  impact.pt = body_.mass * slip(after - before);
  impact.tilt = bounce.face.angle;
  impact.energy_change = energy_change(bounce);
  return impact;
}

template <int D>
typename PointContact<D>::Grip PointContact<D>::grip(const Face<D>& face, double time, const Vec<D>& at,
                                                     const Vec<D>& v, double press, double force) {
  PairLaws* laws = laws_[face.part];
  if (!laws) return {};
  if (memory_part_ != face.part) {
    memory_ = {};
    memory_part_ = face.part;
    since_ = time;
    slipped_ = {};
  }
  if (slipped_.time > 0) slipped_.length += 0.5 * (slipped_.speed + v.norm()) * (time - slipped_.time);
  slipped_.time = time;
  slipped_.speed = v.norm();
  age_ = time - since_;
  ++laws->use.contacts;
  laws->begin_instant();
  const ContactLaw* known = laws->known();
  Grip grip;
  ContactLaw law;
  if (known) {
    law = *known;
  } else {
    ContactState state = state_of(face, *laws, face.normal, time, at, v);
    state.was_sticking = v.isZero(0);
    state.normal_force = force;
    set_read_fields(state, laws->reads());
    law = laws->ask(state, false, memory_);
    grip.constant = laws->is_known();
  }
  double slides = law.mu_d, holds = law.mu_s;
  if (laws->rolling.law) {
    const double rolls = law.mu_r / body_.radius;
    grip.rolls = rolls < slides;
    slides = std::min(slides, rolls);
    holds = std::min(holds, rolls);
  }
  const double cohesion = law.c_t / body_.mass;
  grip.slides = slides * press + cohesion;
  grip.holds = holds * press + cohesion;
  return grip;
}

template class PointContact<2>;
template class PointContact<3>;

}  // namespace flyrock
