#include "world/links.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// The angle between two attitudes [rad]; in 2D signed.
double angle_between(const Attitude<2>& from, const Attitude<2>& to) { return to.angle - from.angle; }
double angle_between(const Attitude<3>& from, const Attitude<3>& to) {
  return (to.rotation * from.rotation.inverse()).vector().norm();
}

Vec2 turned(const Attitude<2>& attitude, const Vec2& v) { return attitude.rotation * v; }
Vec3 turned(const Attitude<3>& attitude, const Vec3& v) { return attitude.rotation * v; }

/// By what the mean lever of a turn is longer, so that its velocity takes the lever from its start to its
/// end: tan(a/2) / (a/2).
double lengthening(double angle) {
  constexpr double small = 1e-4;  // rad, below which the series is exact
  const double half = 0.5 * angle;
  return std::abs(half) < small ? 1 + half * half / 3 : std::tan(half) / half;
}

/// The column of a velocity along `direction` at a lever.
Vec3 column(const Vec2& direction, const Vec2& lever) {
  return {direction.x(), direction.y(), cross(lever, direction)};
}
Eigen::Matrix<double, 6, 1> column(const Vec3& direction, const Vec3& lever) {
  Eigen::Matrix<double, 6, 1> both;
  both << direction, lever.cross(direction);
  return both;
}

template <int D>
double rate_of(const Eigen::Matrix<double, Space<D>::dof, 1>& columns, const Moment<D>& moment) {
  Eigen::Matrix<double, Space<D>::dof, 1> velocity;
  velocity << moment.v, moment.w;
  return columns.dot(velocity);
}

}  // namespace

template <int D>
bool Links<D>::keeps_apart(int a, int b) const {
  return std::any_of(links_.begin(), links_.end(), [&](const Link<D>& link) {
    return link.type == LinkType::hinge && ((link.a == a && link.b == b) || (link.a == b && link.b == a));
  });
}

template <int D>
bool Links<D>::holds(int body) const {
  return std::any_of(links_.begin(), links_.end(),
                     [&](const Link<D>& link) { return link.a == body || link.b == body; });
}

template <int D>
bool Links<D>::is_present(const Link<D>& link, const Bodies& bodies) const {
  const auto here = [&](int i) { return i < 0 || bodies[i].present; };
  const auto moves = [&](int i) { return i >= 0 && bodies[i].moves(); };
  return here(link.a) && here(link.b) && (moves(link.a) || moves(link.b));
}

template <int D>
std::array<Vec<D>, 2> Links<D>::ends(const Link<D>& link, const Bodies& bodies) const {
  const auto end = [&](int i, const Vec<D>& at) -> Vec<D> {
    return i < 0 ? at : Vec<D>(bodies[i].x + turned(bodies[i].attitude, at));
  };
  return {end(link.a, link.end_a), end(link.b, link.end_b)};
}

template <int D>
double Links<D>::length(const Link<D>& link, const Bodies& bodies) const {
  const auto [a, b] = ends(link, bodies);
  return (a - b).norm();
}

template <int D>
double Links<D>::angle(const Link<D>& link, const Bodies& bodies) const {
  const Body<D>& a = bodies[link.a];
  if constexpr (D == 2) {
    return a.attitude.angle - (link.b < 0 ? 0 : bodies[link.b].attitude.angle) - link.turned;
  } else {
    const auto of_b = [&](const Vec3& v) { return link.b < 0 ? v : turned(bodies[link.b].attitude, v); };
    const Vec3 side = turned(a.attitude, link.side);
    return std::atan2(side.dot(of_b(link.frame_b[2])), side.dot(of_b(link.frame_b[1])));
  }
}

template <int D>
double Links<D>::energy(const Link<D>& link, const Bodies& bodies) const {
  if (link.type != LinkType::spring || !is_present(link, bodies)) return 0;
  const double longer = length(link, bodies) - link.length;
  return 0.5 * link.stiffness * longer * longer;
}

template <int D>
double Links<D>::energy(const Bodies& bodies) const {
  double sum = 0;
  for (const Link<D>& link : links_) sum += energy(link, bodies);
  return sum;
}

/// Up to which e counts as 0: the rounding of places [m], in rows of angles of directions.
template <int D>
double Links<D>::rounding(const Row& row, const Bodies& bodies) const {
  constexpr double share = 4e-13;
  if (row.component >= D) return share;
  const Body<D>& body = bodies[links_[row.link].a];
  return share * (body.size + body.x.norm() + links_[row.link].length);
}

/// The moments of all bodies if they go on with their velocities for dt.
template <int D>
std::span<const Moment<D>> Links<D>::moments_ahead(const Bodies& bodies, double dt) {
  ahead_.clear();
  for (const Body<D>& body : bodies) {
    ahead_.push_back(moment_of(body));
    if (dt == 0 || !body.present || body.kind == BodyKind::fixed) continue;
    ahead_.back().x += dt * body.v;
    ahead_.back().attitude = body.attitude.turned(dt * body.w);
  }
  return ahead_;
}

/// The function e of a row.
template <int D>
double Links<D>::value(const Row& row, std::span<const Moment<D>> at) const {
  const Link<D>& link = links_[row.link];
  if (row.component >= D) {
    const Vec<D>& direction = link.frame_b[static_cast<std::size_t>(row.component - D + 1)];
    return turned(at[link.a].attitude, link.axis)
        .dot(link.b < 0 ? direction : turned(at[link.b].attitude, direction));
  }
  const auto end = [&](int i, const Vec<D>& place) -> Vec<D> {
    return i < 0 ? place : Vec<D>(at[i].x + turned(at[i].attitude, place));
  };
  const Vec<D> apart = end(link.a, link.end_a) - end(link.b, link.end_b);
  return link.type == LinkType::hinge ? apart[row.component] : apart.norm() - link.length;
}

/// The rows of all links. Ropes are slack.
template <int D>
void Links<D>::make_rows(const Bodies& bodies) {
  rows_.clear();
  for (int k = 0; k < static_cast<int>(links_.size()); ++k) {
    const Link<D>& link = links_[k];
    if (!is_present(link, bodies)) continue;
    const int count = link.type != LinkType::hinge ? 1 : D == 2 ? 2 : 5;
    for (int component = 0; component < count; ++component) {
      Row& row = rows_.emplace_back();
      row.link = k;
      row.component = component;
      row.acts = is_rigid(row);
    }
  }
}

/// G as the mean between two states. Of the length d of a link, with its ends apart by the vector d,
///   |d+| - |d| = (d+ - d) . (d+ + d) / (|d+| + |d|).
template <int D>
void Links<D>::set_gradients(std::span<const Moment<D>> from, std::span<const Moment<D>> to) {
  for (Row& row : rows_) {
    const Link<D>& link = links_[row.link];
    const auto factor = [&](int i) {
      return i < 0 ? 1 : lengthening(angle_between(from[i].attitude, to[i].attitude));
    };
    const auto sum = [&](int i, const Vec<D>& v) -> Vec<D> {
      return i < 0 ? Vec<D>(2 * v) : Vec<D>(turned(from[i].attitude, v) + turned(to[i].attitude, v));
    };
    const double of_a = factor(link.a), of_b = factor(link.b);
    if constexpr (D == 3) {
      if (row.component >= D) {
        const Vec3 direction = link.frame_b[static_cast<std::size_t>(row.component - D + 1)];
        const Vec3 turn = 0.25 * sum(link.a, link.axis).cross(sum(link.b, direction));
        row.of_a << Vec3::Zero(), of_a * turn;
        row.of_b << Vec3::Zero(), -of_b * turn;
        continue;
      }
    }
    Vec<D> direction = Vec<D>::Zero();
    if (link.type == LinkType::hinge) {
      direction[row.component] = 1;
    } else {
      const auto apart = [&](std::span<const Moment<D>> at) -> Vec<D> {
        const auto end = [&](int i, const Vec<D>& place) -> Vec<D> {
          return i < 0 ? place : Vec<D>(at[i].x + turned(at[i].attitude, place));
        };
        return end(link.a, link.end_a) - end(link.b, link.end_b);
      };
      const Vec<D> before = apart(from), after = apart(to);
      const double lengths = before.norm() + after.norm();
      if (lengths > 0) direction = (before + after) / lengths;
    }
    row.of_a = column(direction, Vec<D>(0.5 * of_a * sum(link.a, link.end_a)));
    row.of_b = link.b < 0 ? Columns::Zero().eval()
                          : (-column(direction, Vec<D>(0.5 * of_b * sum(link.b, link.end_b)))).eval();
  }
}

/// G v.
template <int D>
double Links<D>::rate(const Row& row, const Bodies& bodies) const {
  const Link<D>& link = links_[row.link];
  const double of_a = row.of_a.dot(bodies[link.a].velocity());
  return link.b < 0 ? of_a : of_a + row.of_b.dot(bodies[link.b].velocity());
}

/// G v at the start of the step.
template <int D>
double Links<D>::rate_at_start(const Row& row, std::span<const Moment<D>> starts) const {
  const Link<D>& link = links_[row.link];
  const double of_a = rate_of<D>(row.of_a, starts[link.a]);
  return link.b < 0 ? of_a : of_a + rate_of<D>(row.of_b, starts[link.b]);
}

/// The rows of a step whose end is `ends`, where the bodies have their velocities now.
template <int D>
void Links<D>::set_targets(const Bodies& bodies, std::span<const Moment<D>> starts,
                           std::span<const Moment<D>> ends) {
  set_gradients(starts, ends);
  for (Row& row : rows_) {
    const Link<D>& link = links_[row.link];
    const double at_start = rate_at_start(row, starts);
    row.impulse = 0;
    row.miss = value(row, ends) - row.start - h_ * ((1 - theta_) * at_start + theta_ * rate(row, bodies));
    double held = row.start;  // what the row works against
    if (link.type == LinkType::spring) {
      const double stiffness = h_ * theta_ * link.stiffness + link.damping;
      held *= h_ * link.stiffness / stiffness;
      row.compliance = 1 / (h_ * theta_ * stiffness);
    }
    row.target = -(held + row.miss) / (h_ * theta_) - (1 - theta_) / theta_ * at_start;
  }
  factorise(bodies);
}

template <int D>
void Links<D>::begin_step(const Bodies& bodies, std::span<const Moment<D>> starts, double h, double theta) {
  h_ = h;
  theta_ = theta;
  make_rows(bodies);
  const std::span<const Moment<D>> ends = moments_ahead(bodies, theta * h);
  for (Row& row : rows_) {
    const LinkType type = links_[row.link].type;
    row.start = value(row, starts);
    if (std::abs(row.start) <= rounding(row, bodies)) row.start = 0;
    row.acts = is_rigid(row) || type == LinkType::spring || value(row, ends) > 0;
  }
  set_targets(bodies, starts, ends);
}

/// A rope that has been let go twice in a step stays slack in it.
template <int D>
bool Links<D>::keeps_step(const Bodies& bodies, std::span<const Moment<D>> starts) {
  constexpr int most = 2;
  if (rows_.empty()) return true;
  const std::span<const Moment<D>> ends = moments_ahead(bodies, theta_ * h_);
  bool keeps = true;
  for (Row& row : rows_) {
    const double end = value(row, ends), rounds = rounding(row, bodies);
    const bool is_rope = links_[row.link].type == LinkType::rope;
    if (is_rope && row.acts && row.impulse > 0) {
      row.acts = keeps = false;
      ++row.let_go;
    } else if (is_rope && !row.acts && end > rounds && row.let_go < most) {
      row.acts = true;
      keeps = false;
    } else if (row.acts) {
      const double mean = (1 - theta_) * rate_at_start(row, starts) + theta_ * rate(row, bodies);
      keeps = keeps && std::abs(end - (row.start + h_ * mean + row.miss)) <= rounds;
    }
  }
  if (keeps && !turns(starts, ends)) return true;
  set_targets(bodies, starts, ends);
  return false;
}

/// Whether the end of the solved step gives another G than the one with which it was solved.
template <int D>
bool Links<D>::turns(std::span<const Moment<D>> starts, std::span<const Moment<D>> ends) {
  constexpr double rounding_of_g = 1e-10;
  rows_at_end_ = rows_;
  rows_.swap(rows_at_end_);
  set_gradients(starts, ends);
  rows_.swap(rows_at_end_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Row &old = rows_[k], &now = rows_at_end_[k];
    const double change = (now.of_a - old.of_a).norm() + (now.of_b - old.of_b).norm();
    if (old.acts && change > rounding_of_g * (old.of_a.norm() + old.of_b.norm())) return true;
  }
  return false;
}

template <int D>
void Links<D>::begin_instant(const Bodies& bodies) {
  constexpr double tight = 1e-9;  // of the length
  h_ = 0;
  make_rows(bodies);
  const std::span<const Moment<D>> now = moments_ahead(bodies, 0);
  set_gradients(now, now);
  for (Row& row : rows_) {
    row.start = value(row, now);
    const Link<D>& link = links_[row.link];
    row.is_taut = link.type == LinkType::rope && row.start > -tight * link.length;
    row.acts = is_rigid(row) || (row.is_taut && rate(row, bodies) > 0);
  }
  factorise(bodies);
}

template <int D>
bool Links<D>::keeps_instant(const Bodies& bodies) {
  constexpr int most = 2;
  constexpr double rounding_share = 1e-12;
  bool keeps = true;
  for (Row& row : rows_) {
    if (!row.is_taut) continue;
    const Link<D>& link = links_[row.link];
    const auto speed = [&](int i) {
      return i < 0 ? 0 : bodies[i].v.norm() + bodies[i].size * bodies[i].spin_speed();
    };
    if (row.acts && row.impulse > 0) {
      row.acts = keeps = false;
      ++row.let_go;
    } else if (!row.acts && row.let_go < most &&
               rate(row, bodies) > rounding_share * (speed(link.a) + speed(link.b))) {
      row.acts = true;
      keeps = false;
    }
  }
  note_impulses(true);
  if (keeps) return true;
  for (Row& row : rows_) row.impulse = 0;
  factorise(bodies);
  return false;
}

/// The mean velocity of a rope that became taut in the step brought it there. It stops now, with the rigid
/// links of its bodies.
template <int D>
void Links<D>::end_step(Bodies& bodies) {
  note_impulses(true);
  pulled_.clear();
  bool any_taut = false;
  for (const Row& row : rows_) {
    if (links_[row.link].type != LinkType::rope || !row.acts || row.impulse >= 0) continue;
    pulled_.push_back(row.link);
    any_taut = any_taut || row.start < 0;
  }
  if (!any_taut) return;
  make_rows(bodies);
  const std::span<const Moment<D>> now = moments_ahead(bodies, 0);
  set_gradients(now, now);
  for (Row& row : rows_)
    if (links_[row.link].type == LinkType::rope)
      row.acts = std::find(pulled_.begin(), pulled_.end(), row.link) != pulled_.end();
  factorise(bodies);
  hold(bodies);
  note_impulses(false);
}

/// Keeps what the rows gave to the bodies; `anew`: else in addition to what is known.
template <int D>
void Links<D>::note_impulses(bool anew) {
  for (Link<D>& link : links_)
    if (anew) link.impulse.setZero(), link.tension = 0;
  for (const Row& row : rows_) {
    Link<D>& link = links_[row.link];
    if (row.component >= D) continue;
    link.impulse += row.impulse * row.of_a.template head<D>();
    if (link.type != LinkType::hinge) link.tension -= row.impulse;
  }
  for (Link<D>& link : links_)
    if (link.type == LinkType::hinge) link.tension = link.impulse.norm();
}

template <int D>
void Links<D>::join(const Bodies& bodies, JoinedBodies& joined) const {
  for (const Link<D>& link : links_)
    if (link.b >= 0 && bodies[link.a].moves() && bodies[link.b].moves()) joined.join(link.a, link.b);
}

/// The matrices G M^-1 G^T + C of the assemblies. Rows are scaled to a diagonal of 1, because those of places
/// and of angles have other units.
template <int D>
void Links<D>::factorise(const Bodies& bodies) {
  constexpr double dependent = 1e-11;  // a pivot below it: other rows hold this one
  joined_.begin(bodies.size());
  join(bodies, joined_);
  used_assemblies_ = 0;
  assembly_of_.assign(bodies.size(), -1);
  fastest_ = 0;
  for (int k = 0; k < static_cast<int>(rows_.size()); ++k) {
    if (!rows_[k].acts) continue;
    const Link<D>& link = links_[rows_[k].link];
    const int island = joined_.island(bodies[link.a].moves() ? link.a : link.b);
    if (assembly_of_[island] < 0) {
      assembly_of_[island] = static_cast<int>(used_assemblies_++);
      if (assemblies_.size() < used_assemblies_) assemblies_.emplace_back();
      assemblies_[assembly_of_[island]].rows.clear();
    }
    assemblies_[assembly_of_[island]].rows.push_back(k);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) assembly_of_[i] = assembly_of_[joined_.island(static_cast<int>(i))];
  for (Assembly& assembly : assemblies()) {
    const auto n = static_cast<Eigen::Index>(assembly.rows.size());
    Eigen::MatrixXd& matrix = assembly.matrix;
    matrix.setZero(n, n);
    const auto side = [&](const Row& row, int body) -> const Columns* {
      const Link<D>& link = links_[row.link];
      return link.a == body ? &row.of_a : link.b == body ? &row.of_b : nullptr;
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      const Row& row = rows_[assembly.rows[i]];
      const Link<D>& link = links_[row.link];
      for (const int body : {link.a, link.b}) {
        if (body < 0 || !bodies[body].moves()) continue;
        const Columns mobility = bodies[body].inverse_mass_times(*side(row, body));
        for (Eigen::Index j = 0; j < n; ++j)
          if (const Columns* other = side(rows_[assembly.rows[j]], body))
            matrix(i, j) += mobility.dot(*other);
      }
      if (link.type == LinkType::spring)
        fastest_ = std::max(fastest_, std::sqrt(link.stiffness * std::max(0.0, matrix(i, i))));
      matrix(i, i) += row.compliance;
    }
    assembly.scale = matrix.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0; });
    matrix = assembly.scale.asDiagonal() * matrix * assembly.scale.asDiagonal();
    assembly.factors.compute(matrix);
    assembly.root = assembly.factors.vectorD().unaryExpr(
        [&](double pivot) { return pivot > dependent ? 1 / std::sqrt(pivot) : 0; });
  }
}

/// Multiplies by L^-1, in place.
template <int D>
template <class Right>
void Links<D>::Assembly::half_solve(Right& values) const {
  values = scale.asDiagonal() * values;
  values = factors.transpositionsP() * values;
  factors.matrixL().solveInPlace(values);
  values = root.asDiagonal() * values;
}

/// Of its right-hand side.
template <int D>
void Links<D>::Assembly::solve() {
  half_solve(right);
  right = root.asDiagonal() * right;
  factors.matrixU().solveInPlace(right);
  right = factors.transpositionsP().transpose() * right;
  right = scale.asDiagonal() * right;
}

template <int D>
void Links<D>::hold(Bodies& bodies) {
  for (Assembly& assembly : assemblies()) {
    Eigen::VectorXd& right = assembly.right;
    right.resize(static_cast<Eigen::Index>(assembly.rows.size()));
    for (std::size_t i = 0; i < assembly.rows.size(); ++i) {
      const Row& row = rows_[assembly.rows[i]];
      right[static_cast<Eigen::Index>(i)] = row.target - rate(row, bodies) - row.compliance * row.impulse;
    }
    assembly.solve();
    for (std::size_t i = 0; i < assembly.rows.size(); ++i) {
      Row& row = rows_[assembly.rows[i]];
      const Link<D>& link = links_[row.link];
      const double impulse = right[static_cast<Eigen::Index>(i)];
      row.impulse += impulse;
      bodies[link.a].add_velocity(bodies[link.a].inverse_mass_times(impulse * row.of_a));
      if (link.b >= 0) bodies[link.b].add_velocity(bodies[link.b].inverse_mass_times(impulse * row.of_b));
    }
  }
}

template <int D>
void Links<D>::hold(const Bodies& bodies, std::vector<Columns>& displacements) {
  for (Assembly& assembly : assemblies()) {
    Eigen::VectorXd& right = assembly.right;
    right.resize(static_cast<Eigen::Index>(assembly.rows.size()));
    for (std::size_t i = 0; i < assembly.rows.size(); ++i) {
      const Row& row = rows_[assembly.rows[i]];
      const Link<D>& link = links_[row.link];
      double moved = row.of_a.dot(displacements[link.a]);
      if (link.b >= 0) moved += row.of_b.dot(displacements[link.b]);
      right[static_cast<Eigen::Index>(i)] = -moved;
    }
    if (right.isZero(0)) continue;
    assembly.solve();
    for (std::size_t i = 0; i < assembly.rows.size(); ++i) {
      const Row& row = rows_[assembly.rows[i]];
      const Link<D>& link = links_[row.link];
      const double push = right[static_cast<Eigen::Index>(i)];
      displacements[link.a] += bodies[link.a].inverse_mass_times(push * row.of_a);
      if (link.b >= 0) displacements[link.b] += bodies[link.b].inverse_mass_times(push * row.of_b);
    }
  }
}

template <int D>
typename Links<D>::Work Links<D>::work(const Bodies& bodies) const {
  Work work;
  for (const Row& row : rows_) {
    const Link<D>& link = links_[row.link];
    const auto of_driven = [&](int i, const Columns& columns) {
      if (i < 0 || bodies[i].kind != BodyKind::driven) return;
      Columns mean = bodies[i].velocity();
      mean.template head<D>() -= 0.5 * h_ * bodies[i].push;
      work.of_driven -= row.impulse * columns.dot(mean);
    };
    of_driven(link.a, row.of_a);
    of_driven(link.b, row.of_b);
    if (h_ == 0) continue;
    const double start = link.type == LinkType::spring ? 0 : std::abs(row.start);
    work.in_doubt += std::abs(row.impulse) * (start + std::abs(row.miss)) / h_;
  }
  return work;
}

template <int D>
void Links<D>::forget_reactions() {
  reactions_.clear();
  values_of_reactions_.clear();
}

template <int D>
void Links<D>::add_reactions(const Bodies& bodies, int contact, const std::array<int, 2>& of,
                             const std::array<ContactColumns<D>, 2>& columns) {
  const auto assembly_of = [&](int body) { return body < 0 ? -1 : assembly_of_[body]; };
  const std::array<int, 2> known = {assembly_of(of[0]), assembly_of(of[1])};
  for (std::size_t side = 0; side < known.size(); ++side) {
    const int assembly = known[side];
    if (assembly < 0 || (side > 0 && assembly == known[0])) continue;
    const std::vector<int>& rows = assemblies_[assembly].rows;
    const std::size_t first = values_of_reactions_.size();
    values_of_reactions_.resize(first + rows.size() * Problem::rows, 0.0);
    Eigen::Map<Reacted> moved(values_of_reactions_.data() + first, static_cast<Eigen::Index>(rows.size()),
                              Problem::rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows_[rows[i]];
      const Link<D>& link = links_[row.link];
      for (std::size_t k = 0; k < of.size(); ++k) {
        if (of[k] < 0 || (of[k] != link.a && of[k] != link.b)) continue;
        const Columns mobility = bodies[of[k]].inverse_mass_times(of[k] == link.a ? row.of_a : row.of_b);
        moved.row(static_cast<Eigen::Index>(i)) += mobility.transpose() * columns[k];
      }
    }
    assemblies_[assembly].half_solve(moved);
    reactions_.push_back({contact, assembly, static_cast<std::ptrdiff_t>(first)});
  }
}

template <int D>
Eigen::Map<const typename Links<D>::Reacted> Links<D>::reacted(const Reaction& reaction) const {
  const auto rows = static_cast<Eigen::Index>(assemblies_[reaction.assembly].rows.size());
  return {values_of_reactions_.data() + reaction.first, rows, Problem::rows};
}

template <int D>
void Links<D>::take_reactions(int a, std::vector<typename Problem::Block>& blocks) const {
  for (const Reaction& own : reactions_) {
    if (own.contact != a) continue;
    for (const Reaction& other : reactions_)
      if (other.assembly == own.assembly)
        blocks[other.contact].noalias() -= reacted(own).transpose() * reacted(other);
  }
}

template class Links<2>;
template class Links<3>;

}  // namespace flyrock
