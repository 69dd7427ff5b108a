#pragma once
// The friction problem of one step or impact: no bodies, only numbers.

#include <Eigen/Dense>
#include <cstdint>
#include <vector>

namespace flyrock {

/// Find impulses r and velocities u with
///   u = q + W r,   0 <= u_n _|_ r_n >= 0,   |r_t| <= mu r_n + c_t opposing u_t,   |r_r| <= mu_r r_n opposing u_r
/// for each contact. A contact with c_t > 0 resists slip also where r_n = 0. A lower bound L of r_n other than 0 is a change
/// of variable: q + W L e_n in place of q, c_t + mu L in place of c_t. Rows are (n, t, rolling) in 2D and (n, t, s, spinning, 2 rolling) in 3D. q holds the free
/// velocity and the shift of restitution (e_n v_n^-, e_t v_t^-), so that u is not the velocity after the impact but
/// that plus the shift. W is the Delassus operator H^T M^-1 H in blocks. SI units: impulses N s, velocities m/s; the
/// rolling row N m s and rad/s.
template <int D>
struct ContactProblem {
  static constexpr int rows = D == 2 ? 3 : 6;
  using Block = Eigen::Matrix<double, rows, rows>;
  using Row = Eigen::Matrix<double, rows, 1>;

  struct Contact {
    Block w;                  ///< the diagonal block
    Row q;
    double mu = 0;
    double c_t = 0;           ///< N s, at least 0
    double mu_r = 0;          ///< m; 0: no rolling row
    bool normal = true;       ///< false: r_n = 0 whatever u_n, because the normal impulse is given and stands in q
    double speed_scale = 1;   ///< m/s, to which the tolerance is relative
  };
  /// The block that couples contact a (the owner of the range) with contact `other`.
  struct Coupling {
    int other = 0;
    Block w;
  };

  std::vector<Contact> contacts;
  std::vector<int> first;            ///< couplings of contact a: [first[a], first[a + 1])
  std::vector<Coupling> couplings;

  int size() const { return static_cast<int>(contacts.size()); }
  void clear() { contacts.clear(), first.clear(), couplings.clear(); }

  /// q_a + sum over b != a of W_ab r_b.
  Row outside_velocity(int a, const std::vector<Row>& r) const {
    Row u = contacts[a].q;
    for (int k = first[a]; k < first[a + 1]; ++k) u.noalias() += couplings[k].w * r[couplings[k].other];
    return u;
  }
};

/// How a solve ended.
struct SolveResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0;     ///< m/s, the largest scaled local error
  int worst_contact = -1;  ///< where it is
};

}  // namespace flyrock
