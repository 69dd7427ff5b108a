#include "solver/solve_settings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flyrock {

namespace {

constexpr std::array<std::pair<SolverKind, std::string_view>, 3> names{
    {{SolverKind::automatic, "auto"},
     {SolverKind::nlgs, "nlgs"},
     {SolverKind::proximal_newton, "proximal_newton"}}};

}  // namespace

std::string_view name_of(SolverKind kind) {
  return std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == kind; })->second;
}

std::optional<SolverKind> solver_of_name(std::string_view name) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.second == name; });
  if (found == names.end()) return std::nullopt;
  return found->first;
}

}  // namespace flyrock
