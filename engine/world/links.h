#pragma once
// Links: hinges, rods, springs and ropes between bodies, or between a body and the terrain.
//
// A row of a link is a function e(q) of the places of its bodies: of a hinge how far its two ends are apart
// along each axis (in 3D also the cosines between its axis and two directions at right angles to it), of a
// rod, spring or rope its length less the given one. With G = de/dq, the mean velocity
// v_m = (1 - theta) v + theta v+ and impulses l along G^T, a step of length h has
//   hinge, rod   e+ = 0
//   rope         e+ <= 0 _|_ l <= 0
//   spring       l = -h (k (e + theta (e+ - e)) + c (e+ - e)/h)
//   v+ = v_free + M^-1 (G^T l + H r)          r: impulses of the contacts
// G is the mean over the step for which e+ - e = h G v_m holds exactly in 2D (a discrete gradient); what is
// left of it in 3D is `miss`. With theta = 1/2, links that are rigid then do no work, and springs give back
// what they took. All rows of an assembly of linked bodies are solved at once,
//   (G M^-1 G^T + C) l = b - G v,
// so that contacts see bodies of the mobility M^-1 - M^-1 G^T (G M^-1 G^T + C)^-1 G M^-1. G depends on the
// end of the step: the step is solved again until all rows are met. At an instant, and at the end of a step
// in which a rope became taut, rigid rows have G v = 0, and those of taut ropes G v <= 0.
//
// Source: O. Gonzalez, Time integration and discrete Hamiltonian systems, J. Nonlinear Sci. 6 (1996).

#include <Eigen/Dense>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "record/link_type.h"
#include "world/body.h"
#include "world/contact_rows.h"
#include "world/joined_bodies.h"
#include "world/motions.h"

namespace flyrock {

/// A link of body `a` with body `b`, or with a place of the terrain.
template <int D>
struct Link {
  std::string name;
  LinkType type = LinkType::rod;
  int a = -1, b = -1;  ///< b = -1: the terrain
  /// m, its ends in the frames of the bodies; of the terrain in the world frame
  Vec<D> end_a = Vec<D>::Zero(), end_b = Vec<D>::Zero();
  double length = 0;                  ///< m, of a spring at rest; of a hinge 0
  double stiffness = 0, damping = 0;  ///< N/m and N s/m, of a spring
  /// 3D: the axis of a hinge in the frame of `a`; in the frame of `b` that axis, and two directions at right
  /// angles to it
  Vec<D> axis = Vec<D>::Zero();
  std::array<Vec<D>, 3> frame_b = {};
  Vec<D> side = Vec<D>::Zero();  ///< the first of these directions as built, in the frame of `a`
  double turned = 0;             ///< rad, the angle between the frames of both bodies as built, in 2D

  // Of the last step or impact
  Vec<D> impulse = Vec<D>::Zero();  ///< N s, on `a`
  double tension = 0;               ///< N s, along the link, positive where it pulls; of a hinge |impulse|
};

/// The links of a world. They allocate only where an assembly has other rows than before. Instantiated for
/// D = 2, 3.
template <int D>
class Links {
 public:
  using Columns = typename Body<D>::Rows;
  using Bodies = std::vector<Body<D>>;
  using Problem = ContactProblem<D>;

  void add(Link<D> link) { links_.push_back(std::move(link)); }
  bool empty() const { return links_.empty(); }
  const std::vector<Link<D>>& list() const { return links_; }
  /// Whether a hinge joins two bodies, which then do not touch each other.
  bool keeps_apart(int a, int b) const;
  /// Whether a body has a link.
  bool holds(int body) const;

  /// The places of both ends of a link now [m].
  std::array<Vec<D>, 2> ends(const Link<D>& link, const Bodies& bodies) const;
  /// The distance of its ends [m].
  double length(const Link<D>& link, const Bodies& bodies) const;
  /// The angle by which a hinge has turned since the start: of `a` against `b` [rad]; in 3D about its axis,
  /// within (-pi, pi].
  double angle(const Link<D>& link, const Bodies& bodies) const;
  /// The energy of a link, and of all [J]: of springs.
  double energy(const Link<D>& link, const Bodies& bodies) const;
  double energy(const Bodies& bodies) const;
  /// The greatest angular frequency of the springs, in the last step [rad/s].
  double fastest() const { return fastest_; }

  /// Begins a step of length h [s] that began at `starts`. The bodies are in its middle, with the velocities
  /// of its start.
  void begin_step(const Bodies& bodies, std::span<const Moment<D>> starts, double h, double theta);
  /// Begins what has no duration: an impact.
  void begin_instant(const Bodies& bodies);
  /// Gives the bodies the velocities that the links leave them, with the impulses that this needs in addition
  /// to those since the begin.
  void hold(Bodies& bodies);
  /// The same for small displacements.
  void hold(const Bodies& bodies, std::vector<Columns>& displacements);
  /// Whether the solved step keeps the links; the bodies are in its middle, with their new velocities. If
  /// not, the rows are ready for another solve of the same step, from its free velocities.
  bool keeps_step(const Bodies& bodies, std::span<const Moment<D>> starts);
  /// The same of an impact: whether just those ropes pull that are taut.
  bool keeps_instant(const Bodies& bodies);
  /// At the end of a step: stops ropes that have become taut in it.
  void end_step(Bodies& bodies);

  struct Work {
    double of_driven = 0;  ///< J, of driven bodies on the others
    double in_doubt = 0;   ///< J, by which the energy of the step errs
  };
  /// In the step that is solved.
  Work work(const Bodies& bodies) const;

  /// What a contact with columns H^T does to the rows of the links of its bodies: B = L^-1 G M^-1 H, where
  /// G M^-1 G^T + C = L L^T. The mobility of the contacts a and b is less by B_a^T B_b, summed over the
  /// assemblies.
  void forget_reactions();
  /// Of a contact of two bodies (-1: the terrain), with the columns H^T of each.
  void add_reactions(const Bodies& bodies, int contact, const std::array<int, 2>& of,
                     const std::array<ContactColumns<D>, 2>& columns);
  /// Takes B_a^T B_b from the block of each contact b.
  void take_reactions(int a, std::vector<typename Problem::Block>& blocks) const;
  /// Joins the bodies that links move together.
  void join(const Bodies& bodies, JoinedBodies& joined) const;

 private:
  struct Row {
    int link = 0, component = 0;
    Columns of_a = Columns::Zero(), of_b = Columns::Zero();  ///< G
    double start = 0;                                        ///< e at the start of the step
    double miss = 0;        ///< e+ - e - h G v_m, in the last solve of the step
    double target = 0;      ///< b
    double compliance = 0;  ///< C
    double impulse = 0;     ///< l
    bool acts = true;       ///< false: of a slack rope, of a spring at an instant, of bodies that do not move
    bool is_taut = false;   ///< of a rope at an instant
    int let_go = 0;         ///< how often a rope was let go
  };
  /// The rows of bodies that links join, and the factors of their matrix, of which those are left out that
  /// the others already hold.
  struct Assembly {
    std::vector<int> rows;
    Eigen::LDLT<Eigen::MatrixXd> factors;
    Eigen::MatrixXd matrix;
    Eigen::VectorXd scale;  ///< of the rows
    Eigen::VectorXd root;   ///< of the inverse pivots
    Eigen::VectorXd right;  ///< right-hand side of the system, and its solution
    template <class Right>
    void half_solve(Right& values) const;
    void solve();
  };
  /// B of one contact and one assembly, with as many rows as this.
  struct Reaction {
    int contact, assembly;
    std::ptrdiff_t first;  ///< in values_of_reactions_
  };
  using Reacted = Eigen::Matrix<double, Eigen::Dynamic, Problem::rows>;

  bool is_rigid(const Row& row) const {
    const LinkType type = links_[row.link].type;
    return type == LinkType::hinge || type == LinkType::rod;
  }
  double rounding(const Row& row, const Bodies& bodies) const;
  bool is_present(const Link<D>& link, const Bodies& bodies) const;
  void make_rows(const Bodies& bodies);
  std::span<const Moment<D>> moments_ahead(const Bodies& bodies, double dt);
  double value(const Row& row, std::span<const Moment<D>> at) const;
  void set_gradients(std::span<const Moment<D>> from, std::span<const Moment<D>> to);
  double rate(const Row& row, const Bodies& bodies) const;
  double rate_at_start(const Row& row, std::span<const Moment<D>> starts) const;
  void set_targets(const Bodies& bodies, std::span<const Moment<D>> starts, std::span<const Moment<D>> ends);
  bool turns(std::span<const Moment<D>> starts, std::span<const Moment<D>> ends);
  void factorise(const Bodies& bodies);
  void note_impulses(bool anew);
  std::span<Assembly> assemblies() { return std::span(assemblies_).first(used_assemblies_); }
  Eigen::Map<const Reacted> reacted(const Reaction& reaction) const;

  std::vector<Link<D>> links_;
  std::vector<Row> rows_, rows_at_end_;
  std::vector<Moment<D>> ahead_;  ///< what moments_ahead has given
  std::vector<int> pulled_;       ///< the ropes that pulled in a step
  JoinedBodies joined_;
  std::vector<Assembly> assemblies_;
  std::size_t used_assemblies_ = 0;  ///< the others wait with their memory
  std::vector<Reaction> reactions_;
  std::vector<double> values_of_reactions_;
  std::vector<int> assembly_of_;  ///< [body]; -1: none
  double h_ = 0, theta_ = 0.5;    ///< of the step; h = 0: an impact
  double fastest_ = 0;
};

}  // namespace flyrock
