#pragma once
// The impact problem: contacts with restitution, alone or several at once.

#include <algorithm>
#include <optional>
#include <vector>

#include "plugin/contact_law.h"
#include "solver/contact_problem.h"
#include "solver/solve.h"

namespace flyrock {

/// How one contact of an impact rebounds. A contact that closes too slowly to rebound, or that rests, keeps
/// the defaults. With `as_lmgc90`, a contact that separates before the impact has v_n^+ >= -e_n v_n^- in
/// place of v_n^+ >= 0.
template <int D>
struct Rebound : Restitution {
  double given = 0;  ///< N s, prescribed part of the normal impulse; negative: a pull that the contact bears
  typename ContactProblem<D>::Row before = ContactProblem<D>::Row::Zero();  ///< its velocity v^-

  /// v_n^* of the forms `newton` and `newton_mean` [m/s].
  double shift() const { return as_lmgc90 ? before[0] : std::min(0.0, before[0]); }
};

/// A friction problem with its start and its answer.
template <int D>
struct SolvedProblem {
  ContactProblem<D> problem;
  std::vector<typename ContactProblem<D>::Row> start, r;
};

/// The problems of one impact or step as they were solved: with the shifts of restitution in q, and with
/// impulses that count from the given ones.
template <int D>
struct SolveTrace {
  using Row = typename ContactProblem<D>::Row;

  std::vector<double> mu;   ///< coefficient of friction of each contact
  std::vector<Row> free;    ///< q without the shifts of restitution
  std::vector<Row> alone;   ///< impulses of contacts that were solved apart; they are part of q of `common`
  SolvedProblem<D> common;  ///< of two phases, compression
  std::optional<SolvedProblem<D>> restitution;  ///< the second phase
};

/// Solves the friction problem of contacts that rebound. On entry `problem.q` is the free velocity;
/// `rebounds` has one entry per contact. With v = q + W r and v_n^* = min(0, v_n^-):
///  - newton: 0 <= v_n + e_n v_n^* _|_ r_n >= 0, Coulomb friction on v_t + e_t v_t^-. May gain energy.
///  - newton_mean: the same normal condition, Coulomb friction (and rolling) on the mean of v_t and v_t^-
///    (Fremond). Never gains energy for e_n <= 1. A contact that sticks ends with v_t = -v_t^-.
///  - poisson, energy: an isolated contact (coupled to no other) without rolling resistance and cohesion
///    follows its path in impulse space (impact_path.h). Several contacts go through two phases (Glocker and
///    Pfeiffer). Compression is solved as with e = 0 and gives the impulses r_C. Restitution then has
///    r_n >= f r_Cn, and Coulomb friction (and rolling) on the velocity at its end. For poisson, f = e_n. For
///    energy, f is iterated, contact by contact, until the normal work of restitution is -e_n^2 times that of
///    compression (at most so, if other contacts press harder).
///  - velocity: v_n = -e_n v_n^-, v_t = e_t v_t^-, whatever the friction, as if the contact were alone. So it
///    enters the common problem, with e = 0. Two of them may share no moving body (ask_laws.cpp sees to it).
/// A given impulse L is part of r_n. If the contact has normal rows, r_n >= L, and its c_t belongs to a bound
/// on r_n - L. Forms can be mixed: a contact of newton or newton_mean keeps its conditions in both phases.
/// `r` holds the start (zero, or the warm start from the last step) and the answer. `problem` is left as it
/// was solved last. Instantiated for D = 2, 3. Sources: M. Jean 1999; M. Fremond 1995; C. Glocker and F.
/// Pfeiffer 1995; W. J. Stronge 1990.
template <int D>
class ImpactSolver {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  SolveResult solve(Problem& problem, const std::vector<Rebound<D>>& rebounds, const SolveSettings& settings,
                    std::vector<Row>& r);

  /// Where each solve is kept, so that it can be explained; null: nowhere.
  SolveTrace<D>* trace = nullptr;

 private:
  bool two_phase(int a, const Rebound<D>& rebound) const;
  void add_given(Problem& problem) const;
  bool solve_alone(Problem& problem, int a, const Rebound<D>& rebound);
  SolveResult expand(Problem& problem, const SolveSettings& settings, const std::vector<Row>& compression);
  double adjust_factors(const Problem& problem, const std::vector<Rebound<D>>& rebounds,
                        const std::vector<Row>& compression);

  Solver<D> solver_;
  std::vector<Row> alone_;      // impulses of isolated contacts
  std::vector<Row> free_;       // q of compression, without shifts
  std::vector<Row> turn_;       // velocity at the end of compression
  std::vector<Row> given_;      // given normal impulses in q: those of rebounds, or f r_Cn in restitution
  std::vector<Row> expansion_;  // impulses of restitution
  std::vector<double> factor_;  // f of each contact; -1: it has no second phase
};

}  // namespace flyrock
