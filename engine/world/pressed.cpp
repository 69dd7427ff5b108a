// Bodies that a driven body presses against something that does not give way.

#include <algorithm>
#include <cmath>

#include "solver/nonnegative.h"
#include "world/driven.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// A failed solve of more contacts than `easy_contacts` is searched only if its answer is far from the driven
/// approach or throws a body; one of more than `most_contacts`, where the search would take seconds, never.
constexpr std::size_t easy_contacts = 64, most_contacts = 200;
/// Times the driven one: a motion of the free bodies that has to be faster than this is no way out.
constexpr double most_speed_ratio = 1e4;
/// The same for chosen steps, times the tolerance. Over a long phase, the places of both bodies of a contact
/// may be off by 2.5 tolerances each, and a normal by as much as an angle. A way out that is narrower exists
/// by these errors alone; friction of a few thousandths closes it, too.
constexpr double most_speed_ratio_by_tolerance = 0.2;
/// Share of the driven approach that is rounding: two driven bodies hold a body and move together.
constexpr double rounding_share = 1e-6;
/// Share of the driven approach that the answer of a failed solve leaves open, from which on friction is
/// asked whether it holds the bodies: a solve that is only inaccurate leaves less.
constexpr double missed_share = 1e-2;
/// Times the mass of all free bodies and the fastest approach: no lever or wedge makes an impulse so great.
constexpr double boundless = 1e6;

/// Whether r >= 0 with the columns of `a` has no resultant (all rows but the last) while the driven bodies
/// approach (the last row), and this r; empty if there is none. A resultant that a motion of `most_ratio`
/// times the approach balances is none. It is the least squares of (H r, b . r) and (0, 1).
Eigen::VectorXd self_stress(const Eigen::MatrixXd& a, double most_ratio) {
  const Eigen::Index last = a.rows() - 1;
  const Eigen::VectorXd r = nonnegative_least_squares(a, Eigen::VectorXd::Unit(a.rows(), last));
  const double closes = a.row(last).dot(r), resultant = (a.topRows(last) * r).norm();
  const bool is_rounding = closes <= rounding_share * a.row(last).cwiseAbs().dot(r);
  if (is_rounding || closes < most_ratio * resultant) return {};
  return r;
}

/// Unit directions in the plane of a contact whose hull stands for its circle of friction.
template <int D>
std::vector<Eigen::Matrix<double, D - 1, 1>> slip_directions() {
  if constexpr (D == 2) {
    return {Eigen::Matrix<double, 1, 1>(1.0), Eigen::Matrix<double, 1, 1>(-1.0)};
  } else {
    constexpr int count = 8;
    std::vector<Eigen::Vector2d> directions;
    for (int k = 0; k < count; ++k)
      directions.emplace_back(std::cos(2 * pi * k / count), std::sin(2 * pi * k / count));
    return directions;
  }
}

}  // namespace

template <int D>
double World<D>::most_ratio_of_speeds() const {
  return chooses_steps()
             ? std::min(most_speed_ratio, most_speed_ratio_by_tolerance / settings_.step_tolerance)
             : most_speed_ratio;
}

/// The speeds at which the driven bodies alone approach at a contact, along its normal and tangents [m/s].
template <int D>
Vec<D> World<D>::driven_approach(std::size_t a) const {
  Vec<D> approach = Vec<D>::Zero();
  for_bodies(a, [&](int i, const auto& columns) {
    if (bodies[i].kind == BodyKind::driven)
      approach -= columns.template leftCols<D>().transpose() * bodies[i].velocity();
  });
  approach[0] = driven_approach_beyond_rounding(approach[0], approach.norm());
  return approach;
}

/// Whether the impulses of a solve give a free body a speed that only a jam explains: a way out that is
/// narrower than places are known, along which driven bodies would throw it.
template <int D>
bool World<D>::throws() {
  double fastest = 0, approach = 0;
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    fastest = std::max(fastest, driven_approach(a)[0]);
    approach = std::max(approach, contacts_[a].approach());
  }
  if (!(fastest > 0)) return false;
  drift_.assign(bodies.size(), Body<D>::Rows::Zero());  // of velocity
  for (std::size_t a = 0; a < contacts_.size(); ++a)
    for_bodies(a, [&](int i, const auto& columns) {
      if (bodies[i].moves()) drift_[i] += bodies[i].inverse_mass_times(columns * impulses_[a]);
    });
  const double most = most_ratio_of_speeds() * std::max(fastest, approach);
  return std::any_of(drift_.begin(), drift_.end(),
                     [&](const auto& gain) { return gain.template head<D>().norm() > most; });
}

/// Whether the contacts of a solve that failed or throws leave the free bodies no motion at all, and which of
/// them are pressed. Let H map impulses r to the free bodies, and b be the speeds at which the driven bodies
/// alone approach at the contacts. A motion v keeps the contacts if H^T v >= b along the normals. For any
/// normal impulses r >= 0 then
///   |v| >= b . r / |H r|,
/// so that none exists if r >= 0 has no resultant and b . r > 0 (Farkas). Where the answer is far from the
/// driven approach, friction takes part: r lies in the cones of friction, and bodies that it wedges are held
/// whatever the force. Restitution has no part in it. Speeds of turning count at the size of the body.
/// Contacts that yield are left out.
template <int D>
void World<D>::find_pressed() {
  const std::size_t count = contacts_.size();
  if (count > most_contacts) return;
  double fastest = 0;
  for (std::size_t a = 0; a < count; ++a) fastest = std::max(fastest, driven_approach(a)[0]);
  if (!(fastest > 0)) return;
  const bool is_missed = missed_last_solve() && last_solve_.residual > missed_share * fastest;
  if (count > easy_contacts && !is_missed && !throws()) return;

  constexpr int dof = Space<D>::dof;
  std::vector<int> first(bodies.size(), -1);  // row of each free body
  int rows = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) first[i] = rows, rows += dof;
  const auto is_rigid = [&](const Contact& c) {
    const auto yields = [&](int i) { return i >= 0 && changes_shape(bodies[i]); };
    const bool holds = c.law.condition == NormalCondition::signorini ||
                       c.law.condition == NormalCondition::cohesive ||
                       (c.law.condition == NormalCondition::quasi_shock && c.at.gap <= 0);
    return holds && !yields(c.candidate) && !yields(c.antagonist);
  };
  // The column of an impulse of contact k along its normal with `share` of it along the tangents.
  const auto put = [&](auto column, std::size_t k, const Vec<D - 1>& share) {
    if (!is_rigid(contacts_[k])) return;
    for_bodies(k, [&](int i, const auto& of_body) {
      if (first[i] < 0) return;
      auto of_rows = column.template segment<dof>(first[i]);
      of_rows = of_body.col(0) + of_body.template middleCols<D - 1>(1) * share;
      of_rows.template tail<dof - D>() /= bodies[i].size;
    });
    const Vec<D> approach = driven_approach(k);
    column[rows] = (approach[0] + share.dot(approach.template tail<D - 1>())) / fastest;
  };
  const auto search = [&](const std::vector<Vec<D - 1>>& directions, bool rubs) {
    const auto each = static_cast<Eigen::Index>(directions.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows + 1, each * static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k)
      for (Eigen::Index d = 0; d < each; ++d)
        put(a.col(static_cast<Eigen::Index>(k) * each + d), k,
            (rubs ? problem_.contacts[k].mu : 0) * directions[static_cast<std::size_t>(d)]);
    const Eigen::VectorXd r = self_stress(a, most_ratio_of_speeds());
    if (r.size() == 0) return;
    const double least = 1e-3 * r.maxCoeff();
    for (Eigen::Index column = 0; column < r.size(); ++column)
      for (const Contact* c = &contacts_[static_cast<std::size_t>(column / each)];
           const int i : {c->candidate, c->antagonist})
        if (r[column] > least && i >= 0 && first[i] >= 0) pressed_.push_back(i);
  };
  search({Vec<D - 1>::Zero()}, false);
  if (pressed_.empty() && is_missed) search(slip_directions<D>(), true);
  if (pressed_.empty() && is_missed) {  // impulses that grow without bound, until rounding ends them
    double mass = 0, greatest = 0, work = 0, work_in_all = 0;
    for (const Body<D>& body : bodies) mass += body.moves() ? body.mass : 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_rigid(contacts_[k])) continue;
      fastest = std::max(fastest, contacts_[k].approach());
      greatest = std::max(greatest, impulses_[k][0]);
      work += impulses_[k][0] * driven_approach(k)[0];
      work_in_all += std::abs(impulses_[k][0] * driven_approach(k)[0]);
    }
    if (greatest > boundless * mass * fastest && work > missed_share * work_in_all)
      for (std::size_t k = 0; k < count; ++k)
        for (const int i : {contacts_[k].candidate, contacts_[k].antagonist})
          if (is_rigid(contacts_[k]) && impulses_[k][0] > 1e-3 * greatest && i >= 0 && first[i] >= 0)
            pressed_.push_back(i);
  }
  std::sort(pressed_.begin(), pressed_.end());
  pressed_.erase(std::unique(pressed_.begin(), pressed_.end()), pressed_.end());
}

template bool World<2>::throws();
template bool World<3>::throws();
template void World<2>::find_pressed();
template void World<3>::find_pressed();

}  // namespace flyrock
