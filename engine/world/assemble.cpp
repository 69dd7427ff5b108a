// The friction problem of the active contacts: Delassus operator and free velocity.

#include <algorithm>

#include "collision/pairs.h"
#include "collision/smooth/support_feature.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// The line with which a body, or the terrain where it is null, touches; see touching_line.
std::optional<Vec3> line_of(const Body<3>* body, const Terrain3& terrain, FeatureId feature,
                            const Vec3& direction) {
  if (!body) return touching_line(terrain, feature);
  const Contactor3& contactor = body->contactor_with(feature);
  if (contactor.form != Form::outline)
    return touching_line(Placed3{contactor, body->pose()}, feature, direction);
  const auto line = touching_line(*contactor.ground, feature);
  return line ? std::optional<Vec3>(body->pose().r * *line) : line;
}

}  // namespace

template <int D>
ShapeTouch<D> World<D>::shape_touch(const Contact& contact, int body) const {
  const bool is_candidate = body == contact.candidate;
  return {.feature = is_candidate ? contact.at.feature : contact.at.against,
          .frame = contact_frame(contact.at.normal),
          .side = is_candidate ? 1.0 : -1.0};
}

/// What the shapes of both bodies add to the velocity of a contact.
template <int D>
void World<D>::add_shape_velocity(const Contact& contact, Row& velocity) const {
  for (const int i : {contact.candidate, contact.antagonist})
    if (i >= 0 && changes_shape(bodies[i]))
      velocity.template head<D>() += shape_velocity(bodies[i], shape_touch(contact, i));
}

template <int D>
typename World<D>::Row World<D>::relative_velocity(const Contact& contact) const {
  const Body<D>& a = bodies[contact.candidate];
  Vec<D> v = a.velocity_at(contact.at.point);
  auto spin = a.w;
  if (contact.antagonist >= 0) {
    v -= bodies[contact.antagonist].velocity_at(contact.at.point);
    spin -= bodies[contact.antagonist].w;
  }
  Row u = contact_velocity<D>(contact.at.normal, v, spin);
  add_shape_velocity(contact, u);
  return u;
}

/// The part with which a body touches, or the terrain where it is negative, at rest.
template <int D>
TouchingPart<D> World<D>::touching_part_of(const Contact& contact, int body, FeatureId feature) const {
  if (body < 0) return touching_part(*terrain_, feature);
  return touching_part(Placed<D>{bodies[body].contactor_with(feature), bodies[body].pose()}, feature,
                       contact.at.normal);
}

/// The acceleration of the velocity of a contact [m/s2] that comes from geometry alone: the lever arms turn,
/// the contact walks over both surfaces, and its frame turns with its normal n. For the sides i = a, b with
/// the lever l_i from the centre to the contact,
///   a = w_a x l_a' - w_b x l_b' - W x (v_a + w_a x l_a - v_b - w_b x l_b),   W = n x n'
/// in the frame of the contact, and -W x (w_a - w_b) in the rows of rolling and spinning. The velocities are
/// those that the bodies have after `ahead` [s] if they go on as in the last step. `h` [s]: of the step.
template <int D>
typename World<D>::Turning World<D>::turning_of(const Contact& contact, double ahead, double h) const {
  // rad, by which the place of a rim may walk in the step. Where a cap is nearly level, it runs around the
  // rim at once, and a correction of second order is greater than all velocities: the place then stays.
  constexpr double most_walk = 0.2;
  const Vec<D>& normal = contact.at.normal;
  TouchingPart<D> a = touching_part_of(contact, contact.candidate, contact.at.feature);
  TouchingPart<D> b = touching_part_of(contact, contact.antagonist, contact.at.against);
  Vec<D> slip = Vec<D>::Zero();
  // Adds the motion of a part of body i; returns the acceleration of its core.
  const auto move = [&](TouchingPart<D>& part, int i, FeatureId feature, int other, FeatureId against,
                        bool other_is_plane, double side) -> Vec<D> {
    if (i < 0) return Vec<D>::Zero();
    const Body<D>& body = bodies[i];
    const typename Body<D>::Rows now = ahead > 0 ? body.velocity() + ahead * gains_[i] : body.velocity();
    const Vec<D> v = now.template head<D>();
    part.velocity = v;
    if (body.is_outline()) {  // it does not turn
      slip += side * v;
      return Vec<D>::Zero();
    }
    const auto& contactor = body.contactor_with(feature);
    if (part.rolls && other_is_plane) {
      part.kind = TouchingPart<D>::Kind::place;
      part.radius = contactor.radius;
    }
    const Vec<D> arm = contact.at.point - body.x, lever = arm + side * part.radius * normal;
    if constexpr (D == 2) {
      const double w = part.spin = now[2];
      part.velocity += cross(w, lever);
      slip += side * (v + cross(w, arm));
      return -w * w * lever;
    } else {
      const Vec3 w = part.spin = now.template tail<3>();
      Vec3 rate = w.cross(lever);
      if (part.rolls && part.kind == TouchingPart<3>::Kind::place) {
        const auto line = line_of(other < 0 ? nullptr : &bodies[other], *terrain_, against, side * normal);
        const Vec3 walking =
            lever_rate(Placed3{contactor, body.pose()}, feature, -side * normal, w, lever, line);
        if ((walking - rate).norm() * h < most_walk * contactor.bound) rate = walking;
      }
      part.velocity += rate;
      slip += side * (v + w.cross(arm));
      return w.cross(rate);
    }
  };
  const auto is_driven = [&](int i) { return i >= 0 && bodies[i].kind == BodyKind::driven; };
  const auto is_plane = [](const TouchingPart<D>& part) { return part.kind == TouchingPart<D>::Kind::plane; };
  Vec<D> change =
      move(a, contact.candidate, contact.at.feature, contact.antagonist, contact.at.against, is_plane(b), 1);
  change -=
      move(b, contact.antagonist, contact.at.against, contact.candidate, contact.at.feature, is_plane(a), -1);
  Turning turning;
  turning.rate = contact_velocity<D>(normal, change, Space<D>::no_spin());
  turning.walks = a.rolls || b.rolls;
  if (contact.antagonist < 0 && is_plane(b)) return turning;  // a face of the ground keeps its normal
  turning.lasts = a.radius != 0 || b.radius != 0;
  const auto [normal_rate, over_a, over_b] = contact_motion(a, b, normal);
  Row bend;
  if constexpr (D == 2) {
    const Vec2 more = cross(a.spin, over_a) - cross(b.spin, over_b) - cross(cross(normal, normal_rate), slip);
    bend = contact_velocity<2>(normal, more, 0);
  } else {
    const Vec3 turn = normal.cross(normal_rate);
    const Vec3 more = a.spin.cross(over_a) - b.spin.cross(over_b) - turn.cross(slip);
    bend = contact_velocity<3>(normal, more, -turn.cross(a.spin - b.spin));
  }
  constexpr double at_rest = 1e-6;  // of g: piles at rest keep their loads
  if (bend.template head<D>().norm() <= at_rest * g_) return turning;
  turning.rate += bend;
  turning.lasts = turning.lasts || is_driven(contact.candidate) || is_driven(contact.antagonist);
  turning.bends = !turning.walks;  // the place of a rim depends on the attitude as much as on the spin
  return turning;
}

/// Measures the velocities of the contacts at the start of the step. The contact frames are those of the
/// middle of the step. The velocity is therefore corrected by the turn of the lever arms up to the middle:
///   u^- = H^T v - (1 - theta) h a
/// (docs/numerics.md). A body that collides in the step is left out, because its spin jumps.
template <int D>
void World<D>::measure_before(double h) {
  // The share of the step after which the velocities are taken. After 0.875 they give H(end) - H(middle)
  // times v(end) to the second order, where n' and v change alike: 3/4 of the step for n', the whole step for
  // v. Those of the middle err by more in place; but what contacts work against the turn before the middle,
  // they give back after it, and a swing keeps its energy to the third order.
  constexpr double late = 0.875, middle = 0.5;
  constexpr double hardly = 0.01;          // of g: less is no turn that counts
  touching_.assign(bodies.size(), false);  // those that collide
  walked_ = 0;
  for (Contact& contact : contacts_) {
    contact.before = relative_velocity(contact);
    contact.turning.setZero();
    contact.lasts = false;
    if (h == 0 || deforms(contact)) continue;  // the condition of a node holds for its velocity in the middle
    Turning turning = turning_of(contact, 0, h);
    if (turning.bends && !gains_.empty())
      turning = turning_of(contact, (turning.lasts ? middle : late) * h, h);
    const double in_middle = contact.approach();
    contact.turning = turning.rate;
    contact.lasts = turning.lasts;
    contact.walks = turning.walks;
    if (turning.lasts && turning.rate.template head<D>().norm() > hardly * g_) contact.has_turned = true;
    contact.before -= (1 - settings_.theta) * h * contact.turning;
    if (in_middle <= settings_.rest_speed) continue;
    // A contact of a body that spins fast only seems to close in the middle, if it is at rest at the start.
    const bool rests = std::abs(contact.before[0]) <= settings_.rest_speed;
    if (rests && (!turning.walks || !chooses_steps())) continue;
    if (rests) walked_ = std::max(walked_, in_middle / settings_.rest_speed);
    touching_[contact.candidate] = true;
    if (contact.antagonist >= 0) touching_[contact.antagonist] = true;
  }
  for (Contact& contact : contacts_) {
    const bool collides =
        touching_[contact.candidate] || (contact.antagonist >= 0 && touching_[contact.antagonist]);
    if (h == 0 || !collides) continue;
    contact.before += (1 - settings_.theta) * h * contact.turning;
    contact.turning.setZero();
    contact.lasts = false;
  }
}

/// Assembles W = sum over bodies of H^T M^-1 H, q = u_free and the laws. The laws apply to the velocity at
/// the end of the step, when the lever arms have turned further; without this, a body that pivots about a
/// corner would leave it by w^2 h^2 / 2 times the lever in each step. The solver starts from the impulses
/// that the contacts have, times `warm`. If the loads are not unique, it finds the solution nearest to them.
template <int D>
void World<D>::assemble(double h, double warm) {
  const auto turns = [](const Contact& c) { return c.law.mu_r > 0 || c.law.mu_spin > 0; };
  problem_.clear(std::any_of(contacts_.begin(), contacts_.end(), turns) ? Problem::rows : D);
  theta_h_ = settings_.theta * h;
  rows_.clear();
  impulses_.clear();
  for (auto& list : contacts_of_) list.clear();
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    Contact& contact = contacts_[a];
    ContactRows rows;
    rows.antagonist.setZero();
    const auto columns = [&](int body) {
      return contact_columns<D>(contact.at.normal, contact.at.point - bodies[body].x);
    };
    rows.candidate = columns(contact.candidate);
    if (contact.antagonist >= 0) rows.antagonist = -columns(contact.antagonist);
    rows_.push_back(rows);
    if (bodies[contact.candidate].moves()) contacts_of_[contact.candidate].push_back(a);
    if (contact.antagonist >= 0 && bodies[contact.antagonist].moves())
      contacts_of_[contact.antagonist].push_back(a);

    typename Problem::Contact row;
    row.q = relative_velocity(contact) + settings_.theta * h * contact.turning;
    if (contact.late) row.q[0] += std::max(0.0, contact.at.gap) / theta_h_;
    row.w.setZero();
    problem_.contacts.push_back(row);
    impulses_.push_back(warm * contact.impulse);
  }
  if (!links.empty()) find_reactions();
  if (problem_.width() == D)
    couple<D>();
  else
    couple<Problem::rows>();
  apply_laws(h);
  scale_by_island(h);
}

/// What the contacts do to the rows of links.
template <int D>
void World<D>::find_reactions() {
  links.forget_reactions();
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a)
    links.add_reactions(bodies, a, {contacts_[a].candidate, contacts_[a].antagonist},
                        {rows_[a].candidate, rows_[a].antagonist});
}

/// Takes from the blocks of W in the row of contact a what links hold, and keeps them.
template <int D>
void World<D>::couple_by_links(int a) {
  links.take_reactions(a, blocks_);
  problem_.contacts[a].w += blocks_[a];
  for (int b = 0; b < static_cast<int>(contacts_.size()); ++b)
    if (b != a && !blocks_[b].isZero(0)) problem_.couple(b, blocks_[b]);
}

/// The blocks of W. Blocks between two contacts have N = problem_.width() rows.
template <int D>
template <int N>
void World<D>::couple() {
  const auto of = [&](int a, int body) -> const auto& {
    return contacts_[a].candidate == body ? rows_[a].candidate : rows_[a].antagonist;
  };
  const bool knows_bodies = contacts_.size() >= many_contacts && !deforms_ && links.empty() &&
                            std::none_of(bodies.begin(), bodies.end(), changes_shape<D>);
  problem_.bodies = static_cast<int>(bodies.size());
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    problem_.first.push_back(problem_.couplings());
    if (knows_bodies) problem_.sides.emplace_back();
    int side = 0;
    if (!links.empty()) blocks_.assign(contacts_.size(), Problem::Block::Zero());
    for (const int body : {contacts_[a].candidate, contacts_[a].antagonist}) {
      if (body < 0 || !bodies[body].moves()) continue;
      ContactColumns<D> mobility;  // M^-1 H of contact a
      for (int k = 0; k < Problem::rows; ++k)
        mobility.col(k) = bodies[body].inverse_mass_times(of(a, body).col(k));
      problem_.contacts[a].w.noalias() += mobility.transpose() * of(a, body);
      if (knows_bodies) problem_.sides[a][side++] = {body, of(a, body), mobility};
      const bool yields = changes_shape(bodies[body]);
      if (yields) {
        const ShapeTouch<D> own = shape_touch(contacts_[a], body);
        problem_.contacts[a].w.template topLeftCorner<D, D>() +=
            shape_mobility(bodies[body], own, own, theta_h_);
      }
      for (const int b : contacts_of_[body]) {
        if (b == a) continue;
        typename Problem::Block w = Problem::Block::Zero();
        w.template topLeftCorner<N, N>().noalias() =
            mobility.template leftCols<N>().transpose() * of(b, body).template leftCols<N>();
        if (yields)
          w.template topLeftCorner<D, D>() += shape_mobility(bodies[body], shape_touch(contacts_[a], body),
                                                             shape_touch(contacts_[b], body), theta_h_);
        if (links.empty())
          problem_.couple(b, w);
        else
          blocks_[b] += w;
      }
    }
    if (!links.empty()) couple_by_links(a);
  }
  problem_.first.push_back(problem_.couplings());
}

/// Sets the speed_scale of each contact, to which its tolerance is relative: the larger of g h (chosen steps:
/// g x 1 ms at most) and the fastest approach in its island of touching bodies.
template <int D>
void World<D>::scale_by_island(double h) {
  // A long step must be as accurate as a short one, because a residual is a velocity error that acts for the
  // whole step. Therefore a chosen step longer than settings_.time_step counts as that long.
  double spell = h > 0 ? h : settings_.time_step;
  if (chooses_steps()) spell = std::min(spell, settings_.time_step);
  islands_.find(problem_);
  island_speed_.assign(islands_.count(), g_ * spell);
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    double& speed = island_speed_[islands_.of(a)];
    speed = std::max(speed, contacts_[a].approach());
  }
  for (std::size_t a = 0; a < contacts_.size(); ++a)
    contacts_[a].speed_scale = problem_.contacts[a].speed_scale = island_speed_[islands_.of(a)];
}

#define FLYROCK_INSTANTIATE(D)                                              \
  template ShapeTouch<D> World<D>::shape_touch(const Contact&, int) const;  \
  template void World<D>::add_shape_velocity(const Contact&, Row&) const;   \
  template World<D>::Row World<D>::relative_velocity(const Contact&) const; \
  template void World<D>::measure_before(double);                           \
  template void World<D>::assemble(double, double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
