#pragma once
// What a solve is asked for, and how it ended.

#include <optional>
#include <string_view>

namespace flyrock {

/// Which solver is used; `automatic` is written "auto".
enum class SolverKind { automatic, nlgs, proximal_newton };

/// By what a solve is judged (residual.h): in a time step by the scaled error of every contact, in m/s and
/// relative to its speed_scale; for comparison with others by |F| / |q| of the whole.
enum class ErrorMeasure { step, merit };

/// Of a scenario that names none. Chosen by measurement over an arch, a stack, a wall, a pile, a box on its
/// edge and the bench blast (docs/numerics.md): at 1e-6 an arch creeps, at 1e-8 a pile takes three times as
/// long.
inline constexpr double default_tolerance = 1e-7;

/// A problem of so many contacts is small: it is swept plainly, and where `to_rounding` matters it costs
/// little.
inline constexpr int few_contacts = 8;

struct SolveSettings {
  double tolerance = default_tolerance;
  int max_iterations = 1000;  ///< sweeps of NLGS, or factorisations of the second solver
  ErrorMeasure measure = ErrorMeasure::step;
  SolverKind solver = SolverKind::automatic;
  bool to_rounding =
      false;  ///< continue beyond the tolerance, while sweeps still help, until only rounding is left
};

/// How a solve ended.
struct SolveResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0;                   ///< the largest local error [m/s], or |F| / |q|, by the measure
  int worst_contact = -1;                ///< where the error is largest
  SolverKind solver = SolverKind::nlgs;  ///< which gave the answer
};

/// "auto", "nlgs", "proximal_newton".
std::string_view name_of(SolverKind kind);
std::optional<SolverKind> solver_of_name(std::string_view name);

}  // namespace flyrock
