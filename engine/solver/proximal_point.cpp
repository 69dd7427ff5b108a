#include "solver/proximal_point.h"

#include <algorithm>

#include "solver/anderson.h"
#include "solver/residual.h"

namespace flyrock {

namespace {

template <int D>
std::vector<double> flat(const ContactProblem<D>& problem, const std::vector<typename ContactProblem<D>::Row>& r) {
  std::vector<double> numbers;
  for (const auto& row : r)
    for (int i = 0; i < problem.width(); ++i) numbers.push_back(row[i]);
  return numbers;
}

/// The residual as a tolerance: relative to the speed_scale of the worst contact, or |F| / |q|.
template <int D>
double as_tolerance(const ContactProblem<D>& problem, const SolveSettings& settings, const SolveResult& result) {
  if (settings.measure == ErrorMeasure::merit) return result.residual;
  return result.residual / problem.contacts[result.worst_contact].speed_scale;
}

}  // namespace

template <int D>
SolveResult solve_proximal_point(const ContactProblem<D>& problem, const SolveSettings& settings, int sweeps,
                                 std::vector<typename ContactProblem<D>::Row>& r) {
  constexpr double first_alpha = 0.05, sharper = 3e-4, least_tolerance = 1e-14;
  constexpr int most_inner = 200, patience = 3;
  SolveResult best, found;
  judge(problem, settings, r, best);
  found = best;
  auto best_r = r;
  ContactProblem<D> shifted = problem;
  SolveSettings inner = settings;
  inner.max_iterations = most_inner;
  Nlgs<D> nlgs;
  Anderson anderson;
  std::vector<double> scale;
  for (const auto& contact : problem.contacts)
    for (int i = 0; i < problem.width(); ++i) scale.push_back(std::sqrt(std::max(0.0, contact.w(i, i))));
  anderson.begin(scale);
  double alpha = first_alpha;
  int used = 0, unsolved = 0;
  while (!best.converged && used < sweeps) {
    for (int a = 0; a < problem.size(); ++a) {
      const auto& contact = problem.contacts[a];
      const auto shift = (alpha * contact.w.diagonal()).eval();
      shifted.contacts[a].w = contact.w;
      shifted.contacts[a].w.diagonal() += shift;
      shifted.contacts[a].q = contact.q - shift.cwiseProduct(r[a]);
    }
    const std::vector<double> centre = flat(problem, r);
    inner.tolerance = std::max(least_tolerance, sharper * as_tolerance(problem, settings, found));
    const SolveResult solved = nlgs.solve(shifted, inner, r);
    used += solved.iterations;
    judge(problem, settings, r, found);
    if (found.converged || found.residual < best.residual) best = found, best_r = r;
    if (solved.converged) {
      std::vector<double> next = flat(problem, r);
      anderson.mix(centre.data(), next.data());
      for (std::size_t a = 0, k = 0; a < r.size(); ++a)
        for (int i = 0; i < problem.width(); ++i) r[a][i] = next[k++];
    } else {
      anderson.begin(scale);
      if (++unsolved > patience) alpha *= 2, unsolved = 0;
    }
  }
  r = best_r;
  best.iterations = used;
  best.solver = SolverKind::proximal_newton;
  return best;
}

template SolveResult solve_proximal_point<2>(const ContactProblem<2>&, const SolveSettings&, int,
                                             std::vector<ContactProblem<2>::Row>&);
template SolveResult solve_proximal_point<3>(const ContactProblem<3>&, const SolveSettings&, int,
                                             std::vector<ContactProblem<3>::Row>&);

}  // namespace flyrock
