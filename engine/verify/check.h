#pragma once
// A row of the verification suite: a computed number and its expected value.

#include <string>
#include <vector>

namespace flyrock {

struct Check {
  std::string name;  ///< "rod impact C, poisson: v_n"
  std::string kind;  ///< problem: one solve; formula; run: a scenario
  double computed = 0;
  double expected = 0;
  double tolerance = 0;  ///< for the difference
  bool passed = false;
};

/// A named number, computed and expected.
struct Compared {
  const char* name;
  double computed;
  double expected;
};

using Checks = std::vector<Check>;

/// Adds one row for all numbers: the number with the greatest error.
void add_worst(Checks& checks, const std::string& name, const std::string& kind, double tolerance,
               const std::vector<Compared>& numbers);

// The groups of problems. Their sources are given with the numbers.

/// A rod that hits the ground with its tip, a double pendulum, a box on its corner; all forms of restitution.
void check_worked_impacts(Checks& checks);
/// A ball with an oblique impact: newton, poisson and energy agree.
void check_oblique_ball(Checks& checks);
/// Rows of three and five balls in contact, hit by the first ball.
void check_ball_rows(Checks& checks);
/// A rod beyond the Painleve paradox: there is an impulse and no energy gain.
void check_painleve_rod(Checks& checks);
/// Random rod impacts: which forms gain energy, and how often.
void check_random_impacts(Checks& checks);

/// Bounces and slides of a lumped mass on inclines.
void check_lumped_mass(Checks& checks);

/// The order in the step where the normal, or the other surface, turns: drum, turntable.
void check_turning_contacts(Checks& checks);

/// Launch speeds and ranges of blasts: Roth, the fit of bench blasts, Richards and Moore, McKenzie.
void check_launch_formulas(Checks& checks);

/// Runs the course scenarios and the contact law examples in the folder `share` and checks their
/// expectations. Throws std::runtime_error if a scenario cannot be read, TrialError if it cannot be run.
void check_scenarios(Checks& checks, const std::string& share);

/// The friction problems (solver/fclib.h) *.hdf5 in `folder`, or in its folder fclib: |F|/|q| <= 1e-8 by the
/// automatic solver. Throws std::runtime_error if there is none, or if one cannot be read.
void check_fclib_problems(Checks& checks, const std::string& folder);

/// All groups that need no data, in this order.
Checks all_checks(const std::string& share);

}  // namespace flyrock
