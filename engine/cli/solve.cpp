// Solves a friction problem from a file.

#include "solver/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "document/wording.h"
#include "solver/fclib.h"
#include "solver/residual.h"
#include "units/units.h"

namespace flyrock::cli {

namespace po = boost::program_options;

namespace {

SolverKind solver_option(const std::string& name) {
  if (const auto kind = solver_of_name(name)) return *kind;
  throw UsageError(
      fmt::format("unknown solver `{}`{}", name, suggestion(name, {"auto", "nlgs", "proximal_newton"})));
}

double tolerance_option(const std::string& text) {
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number) || *number <= 0)
    throw UsageError(fmt::format("--tolerance is `{}`, expected a number above 0", text));
  return *number;
}

struct Answer {
  SolveResult result;
  Merit merit;
  double seconds = 0, processor_seconds = 0;
  int contacts = 0, dimension = 0;
  std::vector<double> r;
  std::vector<double> residuals;  ///< |F|/|q| after each plain sweep of Gauss-Seidel, if asked for
};

/// The relative error after each of `sweeps` plain sweeps of Gauss-Seidel from the start.
template <int D>
std::vector<double> sweep_residuals(const StoredProblem<D>& stored, int sweeps) {
  std::vector<double> residuals;
  auto r = stored.start;
  Nlgs<D> nlgs;
  nlgs.begin(stored.problem, {}, r);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    nlgs.sweep_once(r);
    residuals.push_back(merit(stored.problem, r).relative());
  }
  return residuals;
}

template <int D>
Answer solve_stored(const StoredProblem<D>& stored, const SolveSettings& settings) {
  using Clock = std::chrono::steady_clock;
  Answer answer;
  answer.contacts = stored.problem.size();
  answer.dimension = D;
  auto r = stored.start;
  const std::clock_t processor_begin = std::clock();
  const auto begin = Clock::now();
  answer.result = flyrock::solve(stored.problem, settings, r);
  answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  answer.processor_seconds = static_cast<double>(std::clock() - processor_begin) / CLOCKS_PER_SEC;
  answer.merit = merit(stored.problem, r);
  for (const auto& row : r)
    for (int i = 0; i < stored.problem.width(); ++i) answer.r.push_back(row[i]);
  return answer;
}

void print(const Answer& answer, bool json) {
  const SolveResult& result = answer.result;
  if (json) {
    const nlohmann::ordered_json tree = {
        {"iterations", result.iterations},
        {"seconds", answer.seconds},
        {"processor_seconds", answer.processor_seconds},
        {"converged", result.converged},
        {"solver", name_of(result.solver)},
        {"merit", {{"rel", answer.merit.relative()}, {"fclib", answer.merit.fclib()}}},
        {"r", answer.r},
        {"residuals", answer.residuals}};
    fmt::print("{}\n", tree.dump());
    return;
  }
  fmt::print("{} contacts in {}D: {} after {} {} of {} in {:.3g} s\n", answer.contacts, answer.dimension,
             result.converged ? "converged" : "not converged", result.iterations,
             result.solver == SolverKind::nlgs ? "sweeps" : "steps", name_of(result.solver), answer.seconds);
  fmt::print("relative error |F|/|q| {:.3g} (FCLIB's measure {:.3g}), greatest at contact {}\n",
             answer.merit.relative(), answer.merit.fclib(), answer.merit.worst_contact);
  for (std::size_t sweep = 0; sweep < answer.residuals.size(); ++sweep)
    fmt::print("sweep {:>6}  {:.4g}\n", sweep + 1, answer.residuals[sweep]);
}

}  // namespace

int solve(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("solver", po::value<std::string>()->default_value("auto")->value_name("S"),
                        "auto, nlgs or proximal_newton")(
      "tolerance", po::value<std::string>()->default_value("1e-8")->value_name("T"),
      "greatest |F|/|q| that counts as converged")(
      "max-iterations", po::value<std::string>()->default_value("100000")->value_name("N"),
      "sweeps, or steps of proximal_newton")(
      "sweeps", po::value<std::string>()->default_value("0")->value_name("N"),
      "also prints the error after each of N Gauss-Seidel sweeps without acceleration")(
      "json", "as JSON, with the impulses r");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  SolveSettings settings;
  settings.measure = ErrorMeasure::merit;
  settings.solver = solver_option(line.text("solver"));
  settings.tolerance = tolerance_option(line.text("tolerance"));
  const std::uint64_t iterations = whole_number(line.text("max-iterations"), "--max-iterations", 1);
  settings.max_iterations = static_cast<int>(std::min<std::uint64_t>(iterations, 1'000'000'000));
  std::optional<AnyProblem> problem;
  try {
    problem = read_fclib_guarded(line.words[0]);
  } catch (const std::runtime_error& error) {
    std::cerr << "error: " << error.what() << '\n';
    return bad_input;
  }
  const int sweeps =
      static_cast<int>(std::min<std::uint64_t>(whole_number(line.text("sweeps"), "--sweeps", 0), 1'000'000));
  Answer answer = std::visit([&](const auto& stored) { return solve_stored(stored, settings); }, *problem);
  answer.residuals =
      std::visit([&](const auto& stored) { return sweep_residuals(stored, sweeps); }, *problem);
  print(answer, line.has("json"));
  return answer.result.converged ? done : expectation_failed;
}

}  // namespace flyrock::cli
