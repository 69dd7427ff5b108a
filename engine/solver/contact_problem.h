#pragma once
// The friction problem of one step or impact, in numbers only, without bodies.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Find impulses r and velocities u with
///   u = q + W r,   0 <= u_n _|_ r_n >= 0,   |r_g| <= mu_g r_n + c_g opposing u_g for each group g of rows
/// for each contact. Rows are (n, t, rolling) in 2D and (n, t, s, spinning, 2 rolling) in 3D. The groups are
/// friction (t, or t and s), spinning and rolling. Their coefficients are mu, mu_spin and mu_r; their
/// constant parts are c_t, c_spin and c_r. A contact with c_g > 0 also resists if r_n = 0. A lower bound L of
/// r_n other than 0 is a change of variable: q + W L e_n instead of q, c_g + mu_g L instead of c_g. q
/// contains the free velocity and the shift of restitution (e_n v_n^-, e_t v_t^-). Therefore u is not the
/// velocity after the impact, but that velocity plus the shift. W is the Delassus operator H^T M^-1 H in
/// blocks. It may be singular and slightly unsymmetric. SI units: impulses in N s and velocities in m/s; in
/// rolling and spinning rows N m s and rad/s.
template <int D>
struct ContactProblem {
  static constexpr int rows = D == 2 ? 3 : 6;
  using Block = Eigen::Matrix<double, rows, rows>;
  using Row = Eigen::Matrix<double, rows, 1>;

  /// Rows of a contact that share one bound: a segment or a disc whose radius grows with r_n.
  struct Group {
    int first, count;
  };
  static constexpr auto groups = [] {
    if constexpr (D == 2)
      return std::array<Group, 2>{{{1, 1}, {2, 1}}};
    else
      return std::array<Group, 3>{{{1, 2}, {3, 1}, {4, 2}}};
  }();

  struct Contact {
    Block w;  ///< the diagonal block
    Row q;
    double mu = 0;
    double c_t = 0;      ///< N s, at least 0
    double mu_r = 0;     ///< m; 0: no rolling resistance
    double mu_spin = 0;  ///< m; 0: no spinning resistance; 3D only
    double c_r = 0;      ///< N m s, at least 0
    double c_spin = 0;   ///< N m s, at least 0; 3D only
    /// false: r_n = 0 for any u_n, because the normal impulse is prescribed and already part of q
    bool normal = true;
    double speed_scale = 1;  ///< m/s, to which the tolerance is relative

    /// The coefficient of a group of rows, and the constant part of its bound.
    double bound(int group) const { return of_group(group, mu, mu_spin, mu_r); }
    double constant(int group) const { return of_group(group, c_t, c_spin, c_r); }
    /// The radius of a group's segment or disc for the normal impulse r_n.
    double radius(int group, double r_n) const { return bound(group) * r_n + constant(group); }
    /// Whether a group of rows can carry an impulse.
    bool resists(int group) const { return bound(group) > 0 || constant(group) > 0; }
    /// Whether any row can carry an impulse if r_n = 0.
    bool resists_open() const { return c_t > 0 || c_spin > 0 || c_r > 0; }
    /// Whether the contact has Coulomb friction only.
    bool is_plain() const { return normal && !resists_open() && !resists_rotation(); }
    /// Whether rolling or spinning rows can carry an impulse.
    bool resists_rotation() const { return mu_r > 0 || mu_spin > 0 || c_r > 0 || c_spin > 0; }
    /// Sets the constant parts if r_n counts from a given impulse L on: c_g = max(0, mu_g L). Friction has
    /// the shear strength in addition: c_t = max(0, strength + mu L).
    void bound_from(double given, double strength) {
      c_t = std::max(0.0, strength + mu * given);
      c_spin = std::max(0.0, mu_spin * given);
      c_r = std::max(0.0, mu_r * given);
    }

   private:
    static double of_group(int group, double friction, double spinning, double rolling) {
      return group == 0 ? friction : group + 1 == static_cast<int>(groups.size()) ? rolling : spinning;
    }
  };

  /// A body that a contact pushes.
  struct Side {
    int body = -1;                                                 ///< -1: none
    Eigen::Matrix<double, Space<D>::dof, rows> columns, mobility;  ///< H and M^-1 H
  };

  std::vector<Contact> contacts;
  std::vector<int> first;  ///< the couplings of contact a are [first[a], first[a + 1])

  /// The matrices of each contact, so that W_ab is the sum of H_a^T (M^-1 H_b) over the bodies of both; or
  /// none, where W is known by its blocks alone.
  std::vector<std::array<Side, 2>> sides;
  int bodies = 0;  ///< those of the sides have lower numbers

  int size() const { return static_cast<int>(contacts.size()); }
  /// The number of leading rows in use: D if no contact resists rotation, otherwise `rows`. Coupling blocks
  /// have this size.
  int width() const { return width_; }
  /// The contact that coupling k couples to the contact that owns k.
  int other(int k) const { return other_[k]; }
  int couplings() const { return static_cast<int>(other_.size()); }

  /// Empties the problem; `width` is D or `rows`.
  void clear(int width = rows) {
    contacts.clear(), first.clear(), other_.clear(), blocks_.clear(), sides.clear();
    width_ = width;
  }
  /// Adds the block that couples the contact under construction (the owner of the range) with contact `b`.
  void couple(int b, const Block& w) {
    other_.push_back(b);
    for (int column = 0; column < width_; ++column)
      for (int row = 0; row < width_; ++row) blocks_.push_back(w(row, column));
  }
  /// Adds the block of coupling k of another problem of this width.
  void couple_as(const ContactProblem& other, int k, int b) {
    const auto size = static_cast<std::ptrdiff_t>(width_) * width_;
    other_.push_back(b);
    blocks_.insert(blocks_.end(), other.blocks_.begin() + k * size, other.blocks_.begin() + (k + 1) * size);
  }
  /// Multiplies the couplings of contact `a` to others by a factor, in one row of `a`.
  void scale_couplings(int a, int row, double factor) {
    sides.clear();
    for (int k = first[a]; k < first[a + 1]; ++k)
      for (int column = 0; column < width_; ++column)
        blocks_[(static_cast<std::size_t>(k) * width_ + column) * width_ + row] *= factor;
  }
  /// The block of coupling k; N = width().
  template <int N>
  Eigen::Map<const Eigen::Matrix<double, N, N>> block(int k) const {
    return Eigen::Map<const Eigen::Matrix<double, N, N>>(blocks_.data() +
                                                         static_cast<std::size_t>(k) * N * N);
  }

  /// The block of coupling k with all rows; rows beyond width() are zero.
  Block full_block(int k) const {
    Block w = Block::Zero();
    w.topLeftCorner(width_, width_) = Eigen::Map<const Eigen::MatrixXd>(
        blocks_.data() + static_cast<std::size_t>(k) * width_ * width_, width_, width_);
    return w;
  }

  /// q_a + sum over b != a of W_ab r_b; rows beyond width() are copied from q.
  Row outside_velocity(int a, const std::vector<Row>& r) const {
    Row u = contacts[a].q;
    if (width_ == D)
      add_couplings<D>(a, r, u);
    else
      add_couplings<rows>(a, r, u);
    return u;
  }
  /// q_a + sum over all b of W_ab r_b.
  Row velocity(int a, const std::vector<Row>& r) const {
    Row u = outside_velocity(a, r);
    if (width_ == D)
      u.template head<D>().noalias() +=
          contacts[a].w.template topLeftCorner<D, D>() * r[a].template head<D>();
    else
      u.noalias() += contacts[a].w * r[a];
    return u;
  }
  /// u += sum over b != a of W_ab r_b; N = width().
  template <int N>
  void add_couplings(int a, const std::vector<Row>& r, Row& u) const {
    for (int k = first[a]; k < first[a + 1]; ++k)
      u.template head<N>().noalias() += block<N>(k) * r[other_[k]].template head<N>();
  }

 private:
  int width_ = rows;
  std::vector<int> other_;
  std::vector<double> blocks_;  ///< blocks of width x width, column by column, in the order of the couplings
};

}  // namespace flyrock
