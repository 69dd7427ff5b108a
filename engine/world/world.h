#pragma once
// Bodies, terrain, contacts, and one step of the Moreau-Jean scheme or one impact.

#include <functional>
#include <optional>
#include <vector>

#include "collision/broad_phase.h"
#include "collision/contact.h"
#include "collision/contact_motion.h"
#include "collision/geometry.h"
#include "collision/touch_search.h"
#include "record/observe.h"
#include "solver/restitution.h"
#include "world/contact_rows.h"
#include "world/joined_bodies.h"
#include "world/links.h"
#include "world/motions.h"
#include "world/pair_laws.h"
#include "world/phase_clock.h"
#include "world/shape_motion.h"
#include "world/step_control.h"

namespace flyrock {

/// How bodies that touch are moved: exactly, in dense steps (dense_step.cpp), or as their islands ask.
enum class ManyBodies { automatic, exact, dense };

struct WorldSettings {
  double time_step = 1e-3;               ///< s; of chosen steps only the scale for what counts as short
  double step_tolerance = 0;             ///< steps are chosen by their error (StepControl); 0: fixed
  double theta = 0.5;                    ///< parameter of the scheme, in [1/2, 1]
  double tolerance = default_tolerance;  ///< of the contact solver
  int max_iterations = 1000;
  double rest_speed = 0.02;  ///< m/s; a slower approach has no restitution
  SolverKind solver = SolverKind::automatic;
  bool body_contacts = true;  ///< false: bodies meet the terrain only
  bool one_by_one = false;    ///< contacts that close at one instant collide one after the other
  ManyBodies many = ManyBodies::exact;
  double dense_step = 4e-3;                  ///< s
  double dense_tolerance = 1e-4;             ///< of the contact solver in dense steps
  std::optional<int> dense_iterations = {};  ///< absent: World::dense_sweeps
};

/// How deep places that a step has not solved may lie in each other: share of the smaller size of a pair.
inline constexpr double slop = 1e-5;

/// A contact of the world, with its law, its impulse and its memory.
template <int D>
struct WorldContact {
  using Row = typename ContactProblem<D>::Row;

  ContactPoint<D> at;
  int candidate = 0;
  int antagonist = -1;  ///< a body, or -1 for the terrain
  PairLaws* laws = nullptr;
  ContactLaw law;
  ContactHistory history{};  ///< memory of the laws of this contact
  Row impulse = Row::Zero();
  Row before = Row::Zero();   ///< velocity at the start of the step or impact
  Row turning = Row::Zero();  ///< acceleration of its velocity by geometry alone (World::turning_of)
  bool lasts = false;         ///< it turns in a way that may go on for long (World::Turning)
  bool walks = false;         ///< its place runs round a rim
  bool has_turned = false;    ///< so, by more than a little, since it closed
  double mu_before = 0;       ///< coefficient of friction in the last step, if the contact is carried on
  double c_t_before = 0;      ///< N, its tangential cohesion
  Vec<D> stretch = Vec<D>::Zero();  ///< m, of the tangential spring of `penalty` at the end of the last step
  double born = 0;                  ///< m, the overlap from which a spring counts (World::overlap_at_birth)
  double sunk = 0;                  ///< m, how deep the step sank a node of a deformable block until it met
  double age = 0;                   ///< s since the contact closed
  double normal_force = ContactState::none;  ///< N, of the last accepted step
  double slip_length = 0;                    ///< m, slipped since it closed; kept only if a law reads it
  bool carried = false;                      ///< true if the contact did not open in the last step
  bool sticking = false;                     ///< so in the last step (World::sticks)
  bool at_bound = true;                      ///< friction bore all it can in the last step
  double speed_scale = 0;                    ///< m/s, as ContactProblem<D>::Contact
  int manifold = -1;      ///< index of the manifold among the impacts of this step; -1: no impact
  int rock = 0;           ///< whose impact it is (World::rock_of), if this contact is part of one
  int impact_number = 0;  ///< of its rock
  // Of a dense step
  bool stays_apart = false;  ///< along the free path
  bool late = false;         ///< it closes within the step so slowly that it does not collide
  bool bounces = false;      ///< by its law
  double touch = 0;          ///< s from the start, when it closes, if it collides

  /// The one of the two bodies that is not `body`; -1: the terrain.
  int other_than(int body) const { return body == candidate ? antagonist : candidate; }
  /// What a spring of `penalty` is compressed by [m], if the features of the contact have this gap.
  double compression(double gap) const { return std::max(0.0, -gap - born); }
  /// The impulse on the candidate in the axes of the world, without its moments [N s].
  Vec<D> impulse_on_candidate() const { return contact_frame(at.normal) * impulse.template head<D>(); }
  /// The current coefficient of friction.
  double mu() const { return sticking ? law.mu_s : law.mu_d; }
  double approach() const { return before[0] < 0 && !stays_apart ? -before[0] : 0; }
};

/// One world of D dimensions. It keeps its buffers between steps, so that the step loop does not allocate
/// once they have grown to the number of contacts.
template <int D>
class World {
 public:
  using Contact = WorldContact<D>;
  using Terrain = typename Geometry<D>::Terrain;
  using Motion = typename Geometry<D>::Motion;
  using Pose = typename Geometry<D>::Pose;
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  World(const Terrain& terrain, const Vec<D>& gravity, const WorldSettings& settings);

  /// Adds a body; returns its index.
  int add(Body<D> body);
  /// Changes gravity [m/s2]. The potential energy that bodies gain or lose by it is energy_given.
  void set_gravity(const Vec<D>& gravity);
  /// Changes the force on a body that contacts move [N].
  void set_force(int body, const Vec<D>& force);
  /// Gives the bodies their velocities that are held until now or earlier.
  void release_held();
  /// Removes the body that was added last.
  void remove_last();
  /// The laws between a body and a part of the terrain; null if the scenario names none. The caller
  /// owns them.
  void set_terrain_laws(int body, int part, PairLaws* laws);
  /// The laws between two bodies, of which `rock` (rock_of) may have drawn their parameters. Called once,
  /// when the bodies first come near each other. Empty: no laws.
  std::function<PairLaws*(int rock, int other)> laws_between;

  double time = 0;
  bool settling = false;  ///< no contact bounces (flight/settle.h)
  std::vector<Body<D>> bodies;
  Links<D> links;  ///< between the bodies; a world with links moves in steps, none of them dense
  /// From where the coordinates of the world count, in those of the scenario [m]. Laws see the latter.
  Vec<D> origin = Vec<D>::Zero();

  const Terrain& terrain() const { return *terrain_; }
  const Vec<D>& gravity() const { return gravity_; }
  const WorldSettings& settings() const { return settings_; }
  bool bodies_meet() const { return settings_.body_contacts && bodies.size() > 1; }
  /// Whether two bodies may touch, one of which contacts move.
  bool may_touch(int a, int b) const {
    return bodies[a].present && bodies[b].present && (bodies[a].moves() || bodies[b].moves()) &&
           !links.keeps_apart(a, b);
  }
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// The memory of searches, for those that a flight makes between the bodies.
  Workspace& workspace() { return work_; }
  /// The velocities of contacts() after the last step or impact.
  const std::vector<Row>& velocities_after() const { return after_; }
  /// The gap between the features of a contact now [m].
  double gap_now(const Contact& contact) const { return gap_at(contact, false); }
  /// How the problem of contacts() was solved; nothing was solved in an impact in which nothing approached.
  const SolveResult& last_solve() const { return last_solve_; }
  /// Whether its error is above its tolerance. Of bodies that are pressed, impulses may grow until their
  /// rounding hides that it has not converged.
  bool missed_last_solve() const {
    const int worst = last_solve_.worst_contact;
    return worst >= 0 && last_solve_.residual > tolerance() * problem_.contacts[worst].speed_scale;
  }
  /// Whether a body is deformable. All steps then have the length time_step, no touch cuts them, and impacts
  /// happen in them: impact() is not called.
  bool deforms() const { return deforms_; }
  /// Whether a deformable body vibrates or is strained: nothing flies exactly then.
  bool vibrates() const;
  /// Stops vibrations with less than 1e-9 of the kinetic energy that the body had when a contact last pushed
  /// it. Called while no contact is closed.
  void settle_deformations();
  /// Of the contact solver, in the steps that are made now.
  int dense_sweeps() const;
  double tolerance() const { return dense_ ? settings_.dense_tolerance : settings_.tolerance; }
  /// Whether the next step is a dense one (dense_step.cpp); nothing flies then.
  bool is_dense() const { return dense_; }
  void choose_density();
  /// The work of all solves, also of those that were repeated: the sum over their contacts.
  std::uint64_t solver_work() const { return solver_work_; }
  /// The bodies that driven bodies press, in the last solve, so that no motion satisfies their contacts.
  const std::vector<int>& pressed() const { return pressed_; }
  const SolverQuality& quality() const { return quality_; }
  SolverQuality& quality() { return quality_; }
  /// Where the wall time of each phase is added; null: phases are not timed.
  PhaseTimes* clock = nullptr;
  /// Called with each problem that did not converge and its start impulses. May be empty.
  std::function<void(const Problem&, const std::vector<Row>&)> on_hard_problem;
  /// Where each solve is kept, so that it can be explained; null: nowhere.
  void trace_solves(SolveTrace<D>* trace) { solver_.trace = trace; }

  /// What a step or an impact returns.
  struct Outcome {
    double duration = 0;      ///< s
    bool new_touch = false;   ///< the step was cut because two features that were not in contact touch
    bool in_contact = false;  ///< at least one contact stays closed
    bool endless = false;     ///< of impacts one by one: most_hits did not end them
  };

  /// One step of at most h [s]; the step is shortened if a contact would drift too far. With `cut`, the step
  /// ends at the first touch of features that are not in contact; an impact problem must follow. With
  /// `pass_held`, only touches of bodies that have no contact with each other cut the step. Without `cut`,
  /// impacts inside the step are reported in `impacts`.
  Outcome step(double h, bool cut, bool pass_held = false);
  /// Of the step before the next one [s]; 0: none was made yet.
  double last_step() const { return last_step_; }
  /// The length of the next step: the fixed one, or chosen by error [s].
  double step_length();

  /// Takes the velocities away that links do not let the bodies have, as where the scenario gives them.
  void pull_links();

  /// Solves the impacts of the contacts that are closed now (instant.cpp). Velocities jump; time does not
  /// advance. With `one_by_one`, the contact that approaches fastest collides as if it were alone, then the
  /// next one, until none is faster than rest_speed; one problem of all contacts then stops what still
  /// approaches.
  Outcome impact();
  /// Called after each impact of an instant, with contacts() those that bear its impulses. May be empty.
  std::function<void()> on_hit;
  static constexpr int most_hits = 100'000;    ///< at one instant, one by one
  static constexpr int most_together = 1'000;  ///< impacts at one instant; after them the rest has e = 0
  /// The bodies of impacts of the last instant that gained more than a thousandth of their kinetic energy
  /// from nowhere: a fault of the program, never a result.
  struct Gained {
    int body = 0;
    double share = 0;  ///< of the kinetic energy of all bodies of the impact
  };
  const std::vector<Gained>& gained() const { return gained_; }

  /// All bodies fly for dt without contacts.
  void fly(double dt);
  /// The motion of a body in free flight.
  Motion flight_of(int body) const;

  /// The impacts of the last step or impact, one per manifold.
  const std::vector<Impact>& impacts() const { return impacts_; }
  /// The contacts of a body with the terrain (other = -1) or with another body, as the search for a touch in
  /// flight knows them (collision/held.h). Valid until the next call.
  HeldContacts held_in_flight(int body, int other);
  /// The deepest penetration of a body into the terrain or another body now. Used to check a start.
  struct Overlap {
    double depth = 0;  ///< m
    int body = -1;     ///< for two bodies, the one that was added later
    int other = -1;    ///< -1: the terrain
  };
  Overlap deepest_overlap();
  /// The same of the body that was added last only, for as long as bodies are added.
  Overlap overlap_of_last();
  /// Updates the maximum penetration with the present state. Used at the end of a flight that no touch has
  /// ended.
  void measure_penetration();
  /// The pairs of bodies whose boxes overlap during the next `dt` [s] of flight; only these may meet.
  const std::vector<std::pair<int, int>>& near_pairs(double dt);

  /// Whose quantities the laws of a contact read: the body that moves; of two the lighter one, then the
  /// smaller, then the one with less kinetic energy, then by name. So it is the same for any order of bodies.
  int rock_of(int body, int other) const;

  /// Whether a contact slips faster than a twentieth of the speed of one of its bodies.
  bool slips(const Contact& contact, int body) const;

  /// Kinetic energy, potential energy (height above the origin) and energy of springs: of links, and of
  /// compressed contacts (`penalty`) [J].
  double total_energy() const;
  /// The energy that has come from outside since the world was made [J]: the work of the air and of driven
  /// bodies, also by links, and the energy that impacts gain by their laws. If nothing is wrong, total_energy
  /// never exceeds its start value plus this energy, apart from the error of the scheme.
  double energy_given() const { return energy_given_; }
  /// The energy by which the steps so far may err [J]: of each contact a tenth of its impulse times the speed
  /// by which its lever arms turned in the step; of a spring, which swings by the angle a in a step, a^2 / 4
  /// of its energy, and its force times the error of a place that chosen steps may make; of a dense step what
  /// projection lifts and theta 1 gives more than it takes.
  double energy_in_doubt() const { return energy_in_doubt_ + spring_energy_in_doubt_; }
  /// The gap up to which a contact of the last step stays active, and its drift is projected out [m].
  double carry_reach(int candidate, int antagonist) const;
  /// The size of the smaller of two bodies that move, or of the only one [m].
  double contact_size(int candidate, int antagonist) const;
  /// The gap below which a contact of two bodies, or of one with the ground, is closed [m].
  double touch(int body, int other = -1) const { return 1e-9 * contact_size(body, other) + 1e-12; }

 private:
  /// The columns of H^T of a contact for its two bodies; zero for the terrain.
  struct ContactRows {
    ContactColumns<D> candidate, antagonist;
  };
  /// Sums over the contacts of one impact: means weighted by the normal impulse, and the tangential impulse.
  struct ImpactSum {
    double weight = 0;
    Vec<D> place = Vec<D>::Zero();
    double vn_before = 0, vn_after = 0;
    Vec<D - 1> vt_before = Vec<D - 1>::Zero(), vt_after = Vec<D - 1>::Zero(), pt = Vec<D - 1>::Zero();
  };

  /// How far the contacts of a step drift into penetration by its middle.
  struct Drift {
    double share = 0;        ///< the largest drift since the start, divided by what one step can cause
    double penetration = 0;  ///< the largest in the middle [m]
  };

  void know(PairLaws* laws);
  PairLaws* pair_laws(int a, int b);

  /// Calls use(body, columns) for the bodies of contact a, the candidate first.
  template <class Use>
  void for_bodies(std::size_t a, Use use) const {
    use(contacts_[a].candidate, rows_[a].candidate);
    if (contacts_[a].antagonist >= 0) use(contacts_[a].antagonist, rows_[a].antagonist);
  }

  // detect.cpp: which contacts are active
  void detect(double ahead);
  void match_last();
  const Contact* carried_on(const Contact& contact, std::span<const Contact> last,
                            std::span<const Contact> now) const;
  double overlap_at_birth(const Contact& contact, std::span<const Contact> last,
                          std::span<const Contact> now) const;
  double sunk_by_step(const Contact& contact) const;
  void keep_closed(double share_of_size);
  double reach_within(double h, int candidate, int antagonist) const;
  double reach_in_middle(int candidate, int antagonist) const;
  Placed<D> placed(int body, FeatureId feature, const Pose& pose) const;
  Pose pose_of(int body, bool at_start) const;
  double gap_of_solver(const Contact& contact) const;
  double gap_at(const Contact& contact, const Pose& of_candidate, const Pose& of_antagonist) const;
  double gap_at(const Contact& contact, bool at_start) const;
  const std::vector<std::pair<int, int>>& close_pairs();

  void find_contacts(double ahead);
  void find_points(int body, int other, const Pose& pose, const Pose& of_other, double reach, double ahead);
  void find_between(int candidate, int antagonist, double ahead);
  void append_points(int candidate, int antagonist);
  Overlap deepest_of_contacts();
  double reach_of_step(int candidate, int antagonist) const;

  // dense_step.cpp: the step of many bodies that touch
  bool can_be_dense() const;
  int most_contacts_of_island();
  double dense_length() const;
  double travel_ahead(const Body<D>& body) const;
  double reach_ahead(int candidate, int antagonist) const;
  void foresee_touches(double h);
  bool ask_dense_laws(double h);
  void put_gaps(double h);
  void find_lone_bounces();
  void move_densely(double h);
  double unsolved_depth(double h);
  template <class Use>
  void see_ahead(double h, Use use);
  void find_dense_contacts(double h);
  void start_from_last_try(double h, double before);
  Outcome dense_step(double h);

  // held_contacts.cpp: which contacts a step solves, and what the search for touches knows of them
  Drift keep_closed_at_start(double h);
  bool enters_step(Contact& contact, double gap, double h);
  double may_drift(const Contact& contact) const;
  double opened(const Contact& contact) const;
  bool settles(const Contact& contact, double gap, double h) const;
  bool is_deep(const Contact& contact, double gap, bool at_start);
  HeldContacts held_in_step(int body, int other);
  double sunk_springs(int body, int other);
  std::optional<double> first_return(double h);

  // close_pairs.cpp: touches within a step of bodies that touch already
  bool is_close(int body, int other) const;
  bool is_searched(int body, int contactor) const;
  bool is_searched(int body, int contactor, int other, int contactor_of_other) const;
  double unsolved_depth(int body, int other, double t);
  void note_unsolved(int body, int other);
  std::optional<double> first_event(int body, int other, double h);
  void measure_unsolved(double h);

  // instant.cpp: the impacts of one instant
  bool solve_impact(bool plastic = false);
  void set_rest_at_impact(bool plastic);
  bool collide_together();
  void join(const std::vector<Contact>& contacts);
  int island_of(const Contact& contact);
  void measure_rest();
  bool choose_bearers(bool first);
  void take_back_bearers();
  bool collide_one_by_one();
  bool is_spring(Contact& contact);

  // ask_laws.cpp: the answers of the contact laws
  void count_impact(Contact& contact);
  void begin_manifolds();
  ContactState state_of(const Contact& contact, double h);
  void set_shape(ContactState& state, int rock);
  void set_partner(ContactState& state, int partner) const;
  void ask_law(Contact& contact, double h);
  void ask_laws(double h);

  // assemble.cpp: the friction problem
  ShapeTouch<D> shape_touch(const Contact& contact, int body) const;
  void add_shape_velocity(const Contact& contact, Row& velocity) const;
  Row relative_velocity(const Contact& contact) const;
  TouchingPart<D> touching_part_of(const Contact& contact, int body, FeatureId feature) const;
  struct Turning {
    Row rate = Row::Zero();  ///< m/s2, in the spin rows rad/s2
    bool bends = false;  ///< the normal turns or the contact walks, as velocities alone tell: not over a rim
    bool lasts = false;  ///< and it may go on for long: a round part, or a driven body
    bool walks = false;  ///< the place walks around a rim or side: the rate is of first order only
  };
  Turning turning_of(const Contact& contact, double ahead, double h) const;
  void measure_before(double h);
  void assemble(double h, double warm);
  template <int N>
  void couple();
  void find_reactions();
  void couple_by_links(int a);
  void scale_by_island(double h);

  // rebound.cpp: solves the friction problem with restitution and applies the impulses to the bodies; records
  // impacts
  void apply_laws(double h);
  void apply_spring(int a, double h);
  SolveResult solve();
  void solve_and_apply();
  void solve_instant();
  double most_ratio_of_speeds() const;
  Vec<D> driven_approach(std::size_t a) const;
  bool throws();
  void find_pressed();
  Row velocity_after(int a, double h) const;
  void measure_after(double h);
  void find_shocks(double h);
  void record_impacts();
  double energy_of(int a) const;
  double rounding_of_solver(const Contact& contact) const;
  bool stays_closed(int a, double duration) const;
  bool is_at_bound(int a, double duration) const;
  bool sticks(int a) const;
  Vec<D> stretch_after(int a, double duration) const;

  // audit.cpp: the energy of impacts and steps
  double work_of_driven(int a, double h) const;
  void audit_energy(double h);
  void doubt_springs(double h);
  void audit_impact();

  // deforming.cpp: deformable blocks
  bool deforms(const Contact& contact) const;
  void account_deformations(double h);
  double turn_of_node(const Contact& contact) const;
  void account_turns(double h);
  double slack(int body) const { return deforms_ ? bodies[body].deformation.greatest : 0; }

  // choose_step.cpp: the length of a step by its error
  bool chooses_steps() const { return settings_.step_tolerance > 0; }
  double phases_so_far() const;
  double fastest_breath() const;
  double longest_of_springs() const;
  void limit_by_dampers();
  double sunk_rims() const;
  std::span<const double> doubt_of_friction(double h);

  // step.cpp: the scheme
  void save();
  void restore();
  void forget_steps();
  void finish_bodies();
  void find_motions(double h);
  std::optional<double> first_touch(double h, bool pass_held);
  Outcome keep(double duration, bool new_touch);

  // pushes.cpp: the pushes of contacts on spins, which the gyroscopic moment of a step feels
  typename Space<D>::Spin foreseen_push(std::size_t body, double h) const;
  typename Space<D>::Spin push_of_contacts(std::size_t body) const;
  double lost_by_turning(std::size_t i, double h) const;
  bool pushed_otherwise(double h) const;
  void solve_step(double h, double warm);
  void solve_with_found_pushes(double h);

  // project_drift.cpp: closes the gaps that a step leaves
  void project_drift(bool exact);

  const Terrain* terrain_;
  Vec<D> gravity_;
  double g_;  ///< |g|, or the greatest with the load of a body, m/s2
  WorldSettings settings_;
  SolverQuality quality_;
  SolveResult last_solve_;
  std::uint64_t solver_work_ = 0;
  std::vector<int> pressed_;
  StepControl<D> control_;
  bool dense_ = false;                   ///< the next step is a dense one
  bool deforms_ = false;                 ///< a body is deformable
  bool has_springs_ = false;             ///< a contact yields (`penalty`): never dense
  std::vector<int> contacts_of_island_;  ///< [the body that names it]
  std::vector<int> partner_;             ///< [body], what alone pushes it in a dense step
  std::vector<double> bounce_;           ///< s, [body], when it bounces in a dense step
  double sunk_ = 0;                    ///< m, the deepest contact of a step before its drift is projected out
  double sunk_share_ = 0;              ///< the same, of the size
  std::vector<Row> free_of_contacts_;  ///< q of a dense problem
  double theta_loss_ = 0;              ///< J, of the dense step that is made now
  double ahead_ = 0;                   ///< s, the dense step that is made now
  std::vector<Row> gained_in_step_;    ///< m/s, by each contact of a dense step along the free path
  std::vector<Contact> unseen_;  ///< that the end of a dense step has shown, not the search at its start
  std::vector<Contact> solved_;  ///< by the dense step, while its end is looked at
  std::vector<Contact> late_;    ///< that close slowly within the step
  std::vector<Contact> tried_;   ///< those of the try before of a dense step that is made again
  double walked_ = 0;            ///< how far a resting rim closes by the middle of a step, in rest_speeds
  double last_step_ = 0;         ///< s
  double reach_time_ = 0;        ///< s, the longer of this step and the last one; fixed steps: their length
  double theta_h_ = 0;           ///< s, theta times the step that is solved; 0 in an impact
  double spring_rate_ = 0;       ///< rad/s, the greatest rate of the springs in the last step or impact
  std::vector<double> damper_rates_;                         ///< rad/s, c W of each of its contacts
  double longest_of_dampers_ = infinite;                     ///< s
  double energy_given_ = 0;                                  ///< J
  double energy_in_doubt_ = 0, spring_energy_in_doubt_ = 0;  ///< J
  std::vector<std::vector<PairLaws*>> terrain_laws_;         ///< [body][part]
  /// [a][b], a < b; null before the bodies first come near each other
  std::vector<std::vector<PairLaws*>> pair_laws_;

  std::vector<Contact> contacts_;  ///< active in the current step
  std::vector<Contact> last_;      ///< of the last completed step
  std::vector<Contact> closed_;    ///< at an instant of several impacts
  /// Of a contact of closed_, when impacts follow each other at one instant.
  struct ClosedState {
    double normal_speed = 0;  ///< m/s, now
    double rest = 0;          ///< m/s, up to which it is rounding
    double drift = 0;         ///< m/s, by which it opens although the last step held it
    bool solved = false;      ///< by an impact since which its bodies have kept their velocities
  };
  std::vector<ClosedState> closed_states_;
  std::vector<int> bearers_;  ///< the contacts of closed_ that contacts_ has
  std::vector<char> drifts_;  ///< those of contacts_ that open by drift; empty: none
  /// Of an island of the contacts of an instant.
  struct IslandAtInstant {
    int contacts = 0;
    double speed = 0;             ///< m/s, the greatest of its bodies
    bool approaches = false;      ///< a contact that is not solved approaches
    bool has_other_form = false;  ///< a contact collides by another form than `newton_mean`
  };
  std::vector<IslandAtInstant> islands_at_instant_;  ///< [the body that names it]
  JoinedBodies joined_;
  /// Of an island of one impact.
  struct ImpactBalance {
    double contacts = 0;     ///< J, the work of the contacts, without that of driven bodies
    double by_slip = 0;      ///< J, what slip of contacts of form `newton` gives of it
    double kinetic = 0;      ///< J, kinetic energy after the impact
    double driven = 0;       ///< J, the work of driven bodies
    int size = 0;            ///< contacts
    bool by_newton = false;  ///< a contact collides by the form `newton`
    bool may_gain = false;   ///< a law answers with more than 1
  };
  std::vector<ImpactBalance> balances_;
  std::vector<Gained> gained_;
  std::vector<bool> springs_;  ///< which of closed_ are springs
  std::vector<ContactPoint<D>> points_;
  std::vector<int> parts_;                       ///< of one body near the ground
  std::vector<std::pair<int, int>> part_pairs_;  ///< of two bodies near each other
  std::vector<Vec<D>> patch_;                    ///< the points of one manifold
  std::vector<ContactRows> rows_;
  std::vector<Impact> impacts_;
  std::vector<ImpactSum> sums_;
  std::vector<HeldContact> held_;
  mutable Workspace work_;  ///< means nothing between two calls
  Problem problem_;
  std::vector<Row> impulses_;
  std::vector<Rebound<D>> rebounds_;
  ImpactSolver<D> solver_;
  struct Unsolved {
    double residual = 0;  ///< m/s
    double since = 0;     ///< s
  };
  std::vector<Unsolved> unsolved_;               ///< of each body: residual and time of its last solve
  std::vector<Row> after_;                       ///< velocities of the contacts after the step or impact
  std::vector<Row> last_after_;                  ///< of last_, while a step may still be given up
  std::vector<Row> start_;                       ///< start impulses, kept only if hard problems are reported
  std::vector<std::vector<int>> contacts_of_;    ///< [body], for bodies that contacts move
  std::vector<typename Problem::Block> blocks_;  ///< that couple a contact to each other one
  Islands<D> islands_;
  std::vector<double> island_speed_;
  std::vector<double> island_gain_;  ///< J, energy that an island gains, minus what rounding allows
  /// rad/s2, of each body: the change of its spin by contacts in the last step; empty: unknown, taken as zero
  std::vector<typename Space<D>::Spin> by_contacts_;
  std::vector<typename Space<D>::Spin> foreseen_;  ///< rad/s, of each body, that change as this step takes it
  std::vector<typename Body<D>::Rows> free_;       ///< velocity of each body without the contacts of the step
  std::vector<typename Body<D>::Rows> velocities_;  ///< of each body, before an impact
  /// m/s2 and rad/s2, of each body: the rate of its velocity in the last step; empty: unknown
  std::vector<typename Body<D>::Rows> gains_;
  std::vector<double> doubt_;          ///< m/s, of each body
  std::vector<char> touching_;         ///< [body], a mark that the functions of a step set anew
  std::vector<char> island_collides_;  ///< whether the island has an impact in this step
  SortAndSweep broad_phase_;
  std::vector<typename Geometry<D>::Box> boxes_;
  std::vector<Moment<D>> starts_;    ///< of the bodies, at the start of the step
  std::vector<int> impacts_before_;  ///< of the bodies, at the start of the step
  std::vector<Motion> motions_;      ///< of the bodies over the current step
  std::vector<PairLaws*> laws_;      ///< those with memory of a pair, each once
  std::vector<double> memory_;       ///< memory of the laws at the start of the step
  std::vector<typename Body<D>::Rows> drift_;
  std::vector<typename Body<D>::Rows> push_;  ///< of drift_, by one contact and the links
  std::vector<double> swell_;                 ///< m, of the radii of pneumatic disks, as drift_
  std::vector<std::optional<double>> gaps_;   ///< gaps of the contacts whose drift is projected out
};

}  // namespace flyrock
