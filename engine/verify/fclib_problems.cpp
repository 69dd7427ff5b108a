// Published friction problems, read from files.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "solver/fclib.h"
#include "solver/residual.h"
#include "solver/solve.h"
#include "verify/check.h"

namespace flyrock {

namespace {

constexpr double wanted = 1e-8;  // |F| / |q|

template <int D>
Check solved(const std::string& name, const StoredProblem<D>& stored) {
  SolveSettings settings;
  settings.measure = ErrorMeasure::merit;
  settings.tolerance = wanted;
  settings.max_iterations = 100000;
  auto r = stored.start;
  const SolveResult result = solve(stored.problem, settings, r);
  const double error = merit(stored.problem, r).relative();
  return {fmt::format("FCLIB {}: |F|/|q|, {} {}", name, result.iterations,
                      result.solver == SolverKind::nlgs ? "sweeps" : "steps"),
          "problem",
          error,
          0,
          wanted,
          error <= wanted};
}

}  // namespace

void check_fclib_problems(Checks& checks, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path inside = fs::path(folder) / "fclib",
                 where = fs::is_directory(inside) ? inside : fs::path(folder);
  if (!fs::is_directory(where)) throw std::runtime_error(fmt::format("{}: no such folder", folder));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(where))
    if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
  if (files.empty())
    throw std::runtime_error(
        fmt::format("{}: holds no friction problems, expected *.hdf5 there or in its folder fclib", folder));
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    std::visit([&](const auto& stored) { checks.push_back(solved(file.stem().string(), stored)); },
               read_fclib(file.string()));
}

}  // namespace flyrock
