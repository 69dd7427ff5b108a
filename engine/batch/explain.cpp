#include "batch/explain.h"

#include <Eigen/SVD>
#include <memory>
#include <utility>

#include "solver/islands.h"
#include "solver/nlgs.h"
#include "solver/residual.h"

namespace flyrock {

namespace {

constexpr int most_sweeps = 1000;
constexpr double rank_tolerance = 1e-10;

/// The leading rows of each contact, one after the other.
template <class Rows>
Eigen::VectorXd stacked(const Rows& rows, int width) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(rows.size()) * width);
  for (std::size_t a = 0; a < rows.size(); ++a)
    all.segment(static_cast<Eigen::Index>(a) * width, width) = rows[a].head(width).array() + 0.0;  // no -0
  return all;
}

template <int D>
Eigen::MatrixXd full_matrix(const ContactProblem<D>& problem) {
  const int width = problem.width();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(problem.size() * width, problem.size() * width);
  for (int a = 0; a < problem.size(); ++a) {
    w.block(a * width, a * width, width, width) = problem.contacts[a].w.topLeftCorner(width, width);
    for (int k = problem.first[a]; k < problem.first[a + 1]; ++k)
      w.block(a * width, problem.other(k) * width, width, width) +=  // one block for each body they share
          problem.full_block(k).topLeftCorner(width, width);
  }
  return w;
}

template <int D>
ExplainedPhase phase_of(const SolvedProblem<D>& solved, std::string name, double tolerance) {
  using Row = typename ContactProblem<D>::Row;
  const ContactProblem<D>& problem = solved.problem;
  const int width = problem.width();
  std::vector<Row> q, u, r(solved.r.size(), Row::Zero());
  ExplainedPhase phase;
  phase.name = std::move(name);
  for (int a = 0; a < problem.size(); ++a) {
    q.push_back(problem.contacts[a].q);
    u.push_back(problem.velocity(a, solved.r));
    phase.warm = phase.warm || !solved.start[a].isZero();
  }
  phase.q = stacked(q, width);
  phase.u = stacked(u, width);
  phase.r = stacked(solved.r, width);
  SolveSettings settings;
  settings.tolerance = tolerance;
  SolveResult result;
  judge(problem, settings, solved.r, result);
  phase.residual = result.residual;
  Nlgs<D> nlgs;
  nlgs.begin(problem, settings, r);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    nlgs.sweep_once(r);
    judge(problem, settings, r, result);
    phase.sweeps.push_back({stacked(r, width), result.residual});
    if (result.converged) break;
  }
  return phase;
}

template <int D>
ExplainedContact contact_of(const World<D>& world, std::size_t a, const WorldNames& names, int width) {
  const WorldContact<D>& contact = world.contacts()[a];
  ExplainedContact row;
  row.a = names.bodies[contact.candidate];
  row.b = antagonist_of(names, world, contact);
  row.place.template head<D>() = contact.at.point + world.origin;
  const auto frame = contact_frame(contact.at.normal);
  row.normal.template head<D>() = frame.col(0).array() + 0.0;
  row.tangent.template head<D>() = frame.col(1).array() + 0.0;
  row.gap = contact.at.gap;
  row.law = contact.law;
  if (D == 2) row.law.mu_spin = 0;  // nothing spins about a normal in the plane
  row.impact = contact.manifold >= 0;
  row.before = contact.before.head(width);
  row.after = world.velocities_after()[a].head(width);
  row.impulse = contact.impulse.head(width);
  row.energy = 0.5 * row.impulse.dot(row.before + row.after);
  return row;
}

template <int D>
Explanation explain(const World<D>& world, const SolveTrace<D>& trace, const WorldNames& names, double step) {
  Explanation all;
  all.dimension = D;
  all.time = world.time;
  all.step = step;
  if (world.contacts().empty()) return all;
  const ContactProblem<D>& problem = trace.common.problem;
  all.rows = problem.width();
  all.w = full_matrix(problem);
  all.free = stacked(trace.free, all.rows);
  for (std::size_t a = 0; a < world.contacts().size(); ++a) {
    all.contacts.push_back(contact_of(world, a, names, all.rows));
    ExplainedContact& contact = all.contacts.back();
    contact.alone = !trace.alone[a].isZero();
    contact.mu = trace.mu[a];
    all.energy += contact.energy;
  }
  Islands<D> islands;
  islands.find(problem);
  for (int i = 0; i < islands.count(); ++i)
    all.islands.emplace_back(islands.contacts(i).begin(), islands.contacts(i).end());
  const double tolerance = world.settings().tolerance;
  all.phases.push_back(phase_of(trace.common, trace.restitution ? "compression" : "", tolerance));
  if (trace.restitution) all.phases.push_back(phase_of(*trace.restitution, "restitution", tolerance));
  all.singular_values =
      Eigen::BDCSVD<Eigen::MatrixXd>(all.w).singularValues();  // a damper makes W unsymmetric
  all.rank =
      static_cast<int>((all.singular_values.array() > rank_tolerance * all.singular_values[0]).count());
  all.problem = StoredProblem<D>{problem, trace.common.start};
  return all;
}

}  // namespace

template <int D>
void Explainer::watch(World<D>& world, WorldNames names, RunSettings& settings) {
  const auto trace = std::make_shared<SolveTrace<D>>();
  world.trace_solves(trace.get());
  settings.advanced = [this, &world, trace, names = std::move(names)](double step) {
    if ((step == 0) != request_.impact || ++seen_ != request_.number) return;
    found_ = explain(world, *trace, names, step);
  };
}

template void Explainer::watch(World<2>&, WorldNames, RunSettings&);
template void Explainer::watch(World<3>&, WorldNames, RunSettings&);

}  // namespace flyrock
