#include "solver/nlgs.h"

#include <algorithm>
#include <cmath>

#include "solver/local_2d.h"
#include "solver/residual.h"

namespace flyrock {

template <int D>
void Nlgs<D>::prepare(const Problem& problem) {
  if constexpr (D == 3) {
    friction_.clear();
    for (const auto& contact : problem.contacts)
      friction_.emplace_back(contact.w.template topLeftCorner<3, 3>(), contact.mu);
  }
}

/// One sweep over the leading N rows. Answers with the error that it met on its way: before each contact is solved, its
/// error by the measure, relative to its speed_scale; the greatest, or |F|.
template <int D>
template <int N>
double Nlgs<D>::sweep(const Problem& problem, ErrorMeasure measure, std::vector<Row>& r) const {
  double greatest = 0, squares = 0;
  for (int a = 0; a < problem.size(); ++a) {
    const auto& contact = problem.contacts[a];
    Row b;
    b.template head<N>() = contact.q.template head<N>();
    if constexpr (N < Problem::rows) b.template tail<Problem::rows - N>().setZero();
    problem.template add_couplings<N>(a, r, b);
    Row u = b;
    u.template head<N>().noalias() += contact.w.template topLeftCorner<N, N>() * r[a].template head<N>();
    if (measure == ErrorMeasure::merit)
      squares += natural_map_squared<D>(contact, u, r[a]);
    else
      greatest = std::max(greatest, local_error<D>(contact, u, r[a]) / contact.speed_scale);
    if constexpr (D == 2) {
      r[a] = solve_local(contact, b);
    } else if (contact.is_plain()) {
      r[a].template head<3>() = friction_[a].solve(b.template head<3>(), r[a].template head<3>());
    } else {
      r[a] = solve_bounded(contact, b, r[a]);
    }
  }
  return measure == ErrorMeasure::merit ? std::sqrt(squares) : greatest;
}

template <int D>
SolveResult Nlgs<D>::solve(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r, double worth) {
  constexpr int few = 8;       // contacts: judged after every sweep
  constexpr int window = 8;    // sweeps over which the fall of the errors is measured
  constexpr int at_least = 32; // sweeps between two judgements
  prepare(problem);
  errors_.clear();
  double wanted = settings.tolerance;
  if (settings.measure == ErrorMeasure::merit) wanted *= merit(problem, r).q;
  SolveResult result;
  for (int since_judged = 1; result.iterations < settings.max_iterations; ++since_judged) {
    errors_.push_back(problem.width() == D ? sweep<D>(problem, settings.measure, r)
                                           : sweep<Problem::rows>(problem, settings.measure, r));
    const int k = result.iterations++;
    const double fall = k > 0 ? errors_[k] / errors_[k - 1] : 0;
    if (problem.size() <= few || errors_[k] * fall <= wanted || since_judged == at_least ||
        result.iterations == settings.max_iterations) {
      judge(problem, settings, r, result);
      if (result.converged) return result;
      since_judged = 0;
    }
    if (result.iterations >= 0.25 * worth && k % window == window - 1 && k >= window) {
      const double fall_of_one = std::log(errors_[k] / errors_[k - window]) / window;
      if (!(std::log(wanted / errors_[k]) > fall_of_one * worth)) break;
    }
  }
  judge(problem, settings, r, result);
  return result;
}

template class Nlgs<2>;
template class Nlgs<3>;

}  // namespace flyrock
