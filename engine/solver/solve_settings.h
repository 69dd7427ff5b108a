#pragma once
// The settings and the result of a solve.

#include <cstdint>
#include <optional>
#include <string_view>

namespace flyrock {

/// Which solver is used. Scenarios write `automatic` as "auto".
enum class SolverKind { automatic, nlgs, proximal_newton };

/// The error measure of a solve (residual.h). `step`: the scaled error of every contact, in m/s, relative to
/// its speed_scale; used in time steps. `merit`: |F| / |q| of the whole problem; used for comparison with
/// other solvers.
enum class ErrorMeasure { step, merit };

/// The tolerance of a scenario that names none. It was chosen by measurements on an arch, a stack, a wall, a
/// pile, a box on its edge and the bench blast (docs/numerics.md): at 1e-6 an arch creeps, at 1e-8 a pile
/// takes three times as long.
inline constexpr double default_tolerance = 1e-7;

/// A problem with at most this many contacts is small. It is solved by plain sweeps, and `to_rounding` costs
/// little.
inline constexpr int few_contacts = 8;

/// From this many contacts on, sweeps use the bodies of the contacts where the problem knows them
/// (ContactProblem::sides).
inline constexpr int many_contacts = 200;

struct SolveSettings {
  double tolerance = default_tolerance;
  int max_iterations = 1000;  ///< sweeps of NLGS, or factorisations of the second solver
  ErrorMeasure measure = ErrorMeasure::step;
  SolverKind solver = SolverKind::automatic;
  /// Few contacts: continue below the tolerance, as long as sweeps help, until only rounding is left.
  bool to_rounding = false;
};

/// How a solve ended.
struct SolveResult {
  bool converged = false;
  int iterations = 0;      ///< of islands that are solved apart, those of the slowest
  double residual = 0;     ///< the largest local error [m/s], or |F| / |q|, depending on the measure
  int worst_contact = -1;  ///< where the error is largest
  SolverKind solver = SolverKind::nlgs;  ///< the solver that gave the answer

  std::uint64_t work = 0;  ///< in the units of flight/jam.h
};

/// "auto", "nlgs", "proximal_newton".
std::string_view name_of(SolverKind kind);
std::optional<SolverKind> solver_of_name(std::string_view name);

}  // namespace flyrock
