#pragma once
// A row of the verification suite: a computed number beside the one that it must be.

#include <string>
#include <vector>

namespace flyrock {

struct Check {
  std::string name;  ///< "rod impact C, poisson: v_n"
  std::string kind;  ///< problem: one solve; formula; run: a scenario
  double computed = 0;
  double expected = 0;
  double tolerance = 0;  ///< of the difference
  bool passed = false;
};

/// A number with its name, computed and as it must be.
struct Compared {
  const char* name;
  double computed;
  double expected;
};

using Checks = std::vector<Check>;

/// Adds the number that is farthest from what it must be, as the row of them all.
void add_worst(Checks& checks, const std::string& name, const std::string& kind, double tolerance,
               const std::vector<Compared>& numbers);

// The groups of problems; sources beside the numbers.

/// A rod that strikes the ground with its tip, a double pendulum, a box on its corner; all forms of
/// restitution.
void check_worked_impacts(Checks& checks);
/// A ball that strikes obliquely: newton, poisson and energy agree.
void check_oblique_ball(Checks& checks);
/// Three and five balls in contact, struck by the first.
void check_ball_rows(Checks& checks);
/// A rod beyond the paradox of Painleve: an impulse, and no energy gained.
void check_painleve_rod(Checks& checks);
/// Random rod impacts: which forms gain energy, and how often.
void check_random_impacts(Checks& checks);

/// Launch speeds and ranges of blasts: Roth, the fit of bench blasts, Richards and Moore, McKenzie.
void check_launch_formulas(Checks& checks);

/// Runs of the scenarios of the course and of the examples of contact laws, in the folder `share`, against
/// what they expect. Throws std::runtime_error for one that cannot be read, TrialError for one that cannot be
/// run.
void check_scenarios(Checks& checks, const std::string& share);

/// The friction problems (solver/fclib.h) *.hdf5 in `folder`, or in its folder fclib: |F|/|q| <= 1e-8 by the
/// automatic solver. Throws std::runtime_error where there is none, or one cannot be read.
void check_fclib_problems(Checks& checks, const std::string& folder);

/// All that need no data, in this order.
Checks all_checks(const std::string& share);

}  // namespace flyrock
