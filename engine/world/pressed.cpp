// Bodies that a driven body presses against something that does not give way.

#include <algorithm>

#include "solver/nonnegative.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// Of solves with more contacts than `easy_contacts`, each 32nd is looked at; of those with more than
/// `most_contacts`, where the search would take seconds, none.
constexpr std::size_t easy_contacts = 64, look_every = 32, most_contacts = 200;
/// No motion of the free bodies slower than this many times the driven one keeps all contacts closed or open.
constexpr double most_speed_ratio = 1e4;
/// Share of the driven approach that is rounding: two driven bodies hold a body and move together.
constexpr double rounding_share = 1e-6;

}  // namespace

/// Whether the contacts of a solve that failed leave the free bodies no motion at all, and which of
/// them are pressed. Let H map normal impulses r to the free bodies, and b be the speeds at which the driven
/// bodies alone approach at the contacts. A motion v keeps the contacts if H^T v >= b. For any r >= 0 then
///   |v| >= b . r / |H r|,
/// so that none exists if r >= 0 has no resultant and b . r > 0 (Farkas). The r of the greatest bound is the
/// least squares of (H r, b . r / |b|) and (0, 1). Friction and restitution have no part in it: they ask for
/// more. Speeds of turning count at the size of the body. Contacts that yield are left out.
template <int D>
void World<D>::find_pressed() {
  const std::size_t count = contacts_.size();
  if (count > most_contacts || (count > easy_contacts && quality_.problems % look_every != 0)) return;
  const auto approach_of = [&](std::size_t a) {
    const Contact& c = contacts_[a];
    double approach = 0;
    if (bodies[c.candidate].kind == BodyKind::driven)
      approach -= rows_[a].candidate.col(0).dot(bodies[c.candidate].velocity());
    if (c.antagonist >= 0 && bodies[c.antagonist].kind == BodyKind::driven)
      approach -= rows_[a].antagonist.col(0).dot(bodies[c.antagonist].velocity());
    return approach;
  };
  double fastest = 0;
  for (std::size_t a = 0; a < count; ++a) fastest = std::max(fastest, approach_of(a));
  if (!(fastest > 0)) return;

  constexpr int dof = Space<D>::dof;
  std::vector<int> first(bodies.size(), -1);  // row of each free body
  int rows = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) first[i] = rows, rows += dof;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows + 1, static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const Contact& c = contacts_[k];
    const auto yields = [&](int i) { return i >= 0 && bodies[i].breathes(); };
    const bool is_rigid = c.law.condition == NormalCondition::signorini ||
                          c.law.condition == NormalCondition::cohesive ||
                          (c.law.condition == NormalCondition::quasi_shock && c.at.gap <= 0);
    if (!is_rigid || yields(c.candidate) || yields(c.antagonist)) continue;
    const auto column = static_cast<Eigen::Index>(k);
    const auto add = [&](int i, const auto& of_body) {
      if (i < 0 || first[i] < 0) return;
      a.col(column).template segment<dof>(first[i]) = of_body.col(0);
      a.col(column).template segment<dof - D>(first[i] + D) /= bodies[i].size;
    };
    add(c.candidate, rows_[k].candidate);
    add(c.antagonist, rows_[k].antagonist);
    a(rows, column) = approach_of(k) / fastest;
  }
  const Eigen::VectorXd r = nonnegative_least_squares(a, Eigen::VectorXd::Unit(rows + 1, rows));
  const double closes = a.row(rows).dot(r), resultant = (a.topRows(rows) * r).norm();
  if (closes <= rounding_share * a.row(rows).cwiseAbs().dot(r) || closes < most_speed_ratio * resultant)
    return;
  const double least = 1e-3 * r.maxCoeff();
  for (std::size_t k = 0; k < count; ++k)
    for (const int i : {contacts_[k].candidate, contacts_[k].antagonist})
      if (r[static_cast<Eigen::Index>(k)] > least && i >= 0 && first[i] >= 0) pressed_.push_back(i);
  std::sort(pressed_.begin(), pressed_.end());
  pressed_.erase(std::unique(pressed_.begin(), pressed_.end()), pressed_.end());
}

template void World<2>::find_pressed();
template void World<3>::find_pressed();

}  // namespace flyrock
