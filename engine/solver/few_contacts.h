#pragma once
// A problem of few contacts in dense matrices, also as a linear complementarity problem.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// u = q + W r,  0 <= u_n _|_ r_n >= 0,  |r_t| <= mu r_n against u_t  for each contact. Rows: (n, t) of each
/// contact, or n alone where no contact has friction. W need be neither symmetric nor positive. r in N s, u
/// in m/s, W in 1/kg; with forces in N and accelerations in m/s2 it is the problem of forces.
struct FewContacts {
  struct Contact {
    double mu = 0;
    int slip = 0;  ///< 1 or -1: it slips this way whatever r is, so that r_t = -slip mu r_n; 0: r decides
    /// Whether friction decides between sticking and both ways of slip.
    bool may_stick() const { return mu > 0 && slip == 0; }
  };
  std::vector<Contact> contacts;
  Eigen::MatrixXd w;
  Eigen::VectorXd q;
  int rows = 1;  ///< of a contact: 1 or 2

  int size() const { return static_cast<int>(contacts.size()); }
  Eigen::Index normal(int contact) const { return Eigen::Index{rows} * contact; }
  Eigen::Index tangential(int contact) const { return normal(contact) + 1; }
};

/// The same as a linear complementarity problem  w = q + M z,  0 <= w _|_ z >= 0.  A contact that cannot
/// stick has the pair  r_n _|_ u_n;  one that can has four, with the speed of slip s and r_t = r_t^+ - r_t^-:
///   r_n _|_ u_n,  r_t^+ _|_ u_t + s,  r_t^- _|_ s - u_t,  s _|_ mu r_n - r_t^+ - r_t^-.
/// z holds impulses times `scale`, so that the entries of M have similar sizes. M is copositive if W is
/// symmetric and positive semidefinite. Source: D. E. Stewart, J. C. Trinkle, An implicit time-stepping
/// scheme for rigid body dynamics with inelastic collisions and Coulomb friction, 1996; V. Acary, B.
/// Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008, chapter 13.
struct ContactLcp {
  enum class Row { normal, forward, back, slip };
  struct Pair {
    int contact = 0;
    Row row = Row::normal;
  };
  Eigen::MatrixXd m;
  Eigen::VectorXd q;
  std::vector<Pair> pairs;  ///< what the components of w and z are
  double scale = 1;         ///< 1/kg, the greatest diagonal entry of W
};

ContactLcp lcp_of(const FewContacts& problem);

/// The impulses r of a solution z.
Eigen::VectorXd impulses_of(const FewContacts& problem, const ContactLcp& lcp, const Eigen::VectorXd& z);

}  // namespace flyrock
