#include "solver/nlgs.h"

#include <algorithm>
#include <limits>

#include "solver/local_2d.h"

namespace flyrock {

namespace {

template <int D>
using Row = typename ContactProblem<D>::Row;

/// 32 eps (|q| + sum |W_ab| |r_b|) over the translational rows.
template <int D>
double rounding(const ContactProblem<D>& problem, int a, const std::vector<Row<D>>& r) {
  const auto& contact = problem.contacts[a];
  double size = contact.q.template head<D>().norm() + contact.w.template topRows<D>().norm() * r[a].norm();
  for (int k = problem.first[a]; k < problem.first[a + 1]; ++k)
    size += problem.couplings[k].w.template topRows<D>().norm() * r[problem.couplings[k].other].norm();
  return 32 * std::numeric_limits<double>::epsilon() * size;
}

/// Fills the residual of `result`; true where every contact has converged.
template <int D>
bool judge(const ContactProblem<D>& problem, const NlgsSettings& settings, const std::vector<Row<D>>& r,
           SolveResult& result) {
  bool converged = true;
  result.residual = 0;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    const Row<D> u = problem.outside_velocity(a, r) + contact.w * r[a];
    const double error = local_error(contact, u, r[a]);
    if (result.worst_contact < 0 || error > result.residual) result.residual = error, result.worst_contact = a;
    const double allowed = settings.tolerance * contact.speed_scale;
    converged = converged && (error <= allowed || error <= allowed + rounding(problem, a, r));
  }
  return converged;
}

}  // namespace

template <int D>
SolveResult solve_nlgs(const ContactProblem<D>& problem, const NlgsSettings& settings, std::vector<Row<D>>& r) {
  SolveResult result;
  while (result.iterations < settings.max_iterations) {
    for (int a = 0; a < problem.size(); ++a) r[a] = solve_local(problem.contacts[a], problem.outside_velocity(a, r));
    ++result.iterations;
    if (judge(problem, settings, r, result)) {
      result.converged = true;
      break;
    }
  }
  return result;
}

template SolveResult solve_nlgs<2>(const ContactProblem<2>&, const NlgsSettings&, std::vector<Row<2>>&);

}  // namespace flyrock
