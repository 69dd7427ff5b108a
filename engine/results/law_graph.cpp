#include "results/law_graph.h"

#include <fmt/format.h>

#include <cmath>

#include "results/sampled_law.h"
#include "solver/law_terms.h"

namespace flyrock {

namespace {

constexpr double mass = 500, radius = 0.3, inertia = 0.4 * mass * radius * radius, g = 9.81, step = 1e-3;

template <class LawKind>
SampledLaw<LawKind> law_of(const PluginUse& use) {
  SampledLaw<LawKind> law(use, 2);
  std::vector<double> values;
  for (const Number& slot : use.slots) values.push_back(slot.constant);
  law.set(std::move(values));
  return law;
}

ContactState ball_at(double approach, double slip) {
  ContactState state = first_contact({mass, radius}, 2, approach, slip);
  state.area = state.length = 1;
  return state;
}

/// One solved contact of the ball: impulse and velocity, rows (n, t, rolling).
struct Solved {
  Eigen::Vector3d impulse, velocity;
};

Solved solve(const ContactLaw& law, bool sticking, double gap, double h, const Eigen::Vector3d& before,
             const Eigen::Vector3d& free) {
  ContactProblem<2> problem;
  ContactProblem<2>::Contact contact;
  contact.w << 1 / mass, 0, 0, 0, 1 / mass + radius * radius / inertia, radius / inertia, 0, radius / inertia,
      1 / inertia;
  contact.q = free;
  contact.speed_scale = std::max(before.norm(), g * step);
  Rebound<2> rebound;
  rebound.before = before;
  set_law<2>(law, sticking, gap, h, contact, rebound);
  problem.contacts.push_back(contact);
  problem.first = {0, 0};
  std::vector<Eigen::Vector3d> r(1, Eigen::Vector3d::Zero());
  SolveSettings settings;
  settings.tolerance = 1e-12;
  ImpactSolver<2>().solve(problem, {rebound}, settings, r);
  return {r[0], free + contact.w * r[0]};
}

std::vector<LawGraph> graphs_of(SampledLaw<RestitutionLaw> asked) {
  const auto shares_along = [&](std::string title, std::string x, auto&& point, int from, int to) {
    LawGraph graph{std::move(title),
                   std::move(x),
                   "share of speed that is left",
                   {{"normal", {}, {}}, {"tangential", {}, {}}}};
    for (int i = from; i <= to; ++i) {
      const auto [at, approach, slip] = point(i);
      asked.forget();
      ContactLaw law = asked(ball_at(approach, slip));
      law.mu_s = law.mu_d = 0.5;
      const Eigen::Vector3d before(-approach, slip, 0);
      const Solved solved = solve(law, false, 0, 0, before, before);
      const double shares[] = {solved.velocity[0] / approach, solved.velocity[1] / slip};
      for (int c = 0; c < 2; ++c) {
        graph.cases[c].at.push_back(at);
        graph.cases[c].value.push_back(shares[c]);
      }
    }
    return graph;
  };
  struct Point {
    double at, approach, slip;
  };
  return {shares_along(
              "impact at 45 degrees, mu 0.5", "normal speed before [m/s]",
              [](int i) {
                return Point{0.3 * i, 0.3 * i, 0.3 * i};
              },
              1, 100),
          shares_along(
              "impact at 10 m/s, mu 0.5", "angle from the surface [deg]",
              [](int i) {
                const double angle = i * pi / 180;
                return Point{static_cast<double>(i), 10 * std::sin(angle), 10 * std::cos(angle)};
              },
              2, 89)};
}

std::vector<LawGraph> graphs_of(SampledLaw<FrictionLaw> asked) {
  LawGraph graph{"pressed by its weight",
                 "slip velocity after the step [m/s]",
                 "r_t / (m g h)",
                 {{"it stuck before", {}, {}}, {"it slid before", {}, {}}}};
  for (const bool sticking : {true, false})
    for (int i = -100; i <= 100; ++i) {
      asked.forget();
      const double slip = 1e-3 * i;
      ContactState state = ball_at(0, std::abs(slip));
      state.was_sticking = sticking;
      state.age = state.pair_age = state.step = step;
      const Solved solved = solve(asked(state), sticking, 0, step, {0, slip, 0}, {-g * step, slip, 0});
      LawGraph::Case& to = graph.cases[sticking ? 0 : 1];
      to.at.push_back(solved.velocity[1]);
      to.value.push_back(solved.impulse[1] / (mass * g * step));
    }
  if (!asked.remembers()) return {graph};
  asked.forget();
  LawGraph slide{"along a slide at 1 m/s", "way [m]", "r_t / (m g h)", {{"", {}, {}}}};
  for (int i = 0; i <= 200; ++i) {
    ContactState state = ball_at(0, 1);
    state.age = state.pair_age = i * 0.01;
    state.step = 0.01;
    const Solved solved = solve(asked(state), false, 0, step, {0, -1, 0}, {-g * step, -1, 0});
    slide.cases[0].at.push_back(state.age);
    slide.cases[0].value.push_back(solved.impulse[1] / (mass * g * step));
  }
  return {graph, slide};
}

std::vector<LawGraph> graphs_of(SampledLaw<RollingLaw> asked) {
  LawGraph graph{
      "pressed by its weight", "rolling velocity after the step [rad/s]", "m_r / r_n [m]", {{"", {}, {}}}};
  for (int i = -100; i <= 100; ++i) {
    asked.forget();
    const double spin = 0.05 * i;
    ContactState state = ball_at(0, 0);
    state.spin = std::abs(spin);
    state.step = step;
    const Solved solved = solve(asked(state), false, 0, step, {0, 0, spin}, {-g * step, 0, spin});
    graph.cases[0].at.push_back(solved.velocity[2]);
    graph.cases[0].value.push_back(solved.impulse[2] / solved.impulse[0]);
  }
  return {graph};
}

std::vector<LawGraph> graphs_of(SampledLaw<UnilateralLaw> asked) {
  NormalCondition condition{};
  /// A contact with a gap. Without contact it would reach the end of the step with the speed `free`.
  const auto solved_at = [&](double gap, double free) {
    asked.forget();
    ContactState state = ball_at(0, 0);
    state.gap = gap;
    state.step = step;
    const ContactLaw law = asked(state);
    condition = law.condition;
    return solve(law, false, gap, step, {free, 0, 0}, {free, 0, 0});
  };
  const auto put = [](LawGraph::Case& to, double at, const Solved& solved) {
    to.at.push_back(at);
    to.value.push_back(solved.impulse[0] / step);
  };
  LawGraph by_speed{"by velocity, h = 1 ms",
                    "normal velocity after the step [m/s]",
                    "force r_n / h [N]",
                    {{"closed", {}, {}}}};
  for (int i = -100; i <= 100; ++i) {
    const Solved solved = solved_at(0, 0.02 * i);
    put(by_speed.cases[0], solved.velocity[0], solved);
  }
  // The other laws do nothing at an open contact.
  if (condition == NormalCondition::quasi_shock) {
    by_speed.cases.push_back({"open by 1 mm", {}, {}});
    for (int i = -100; i <= 100; ++i) {
      const Solved solved = solved_at(1e-3, 0.02 * i);
      put(by_speed.cases[1], solved.velocity[0], solved);
    }
  }
  LawGraph by_gap{"by gap", "gap [m]", "force r_n / h [N]", {{"", {}, {}}}};
  if (condition == NormalCondition::penalty) {
    for (int i = -100; i <= 100; ++i) put(by_gap.cases[0], 2e-5 * i, solved_at(2e-5 * i, 0));
  } else {
    by_gap.title = "from a push of ten times the weight to a pull of ten times the weight, h = 1 ms";
    by_gap.x = "gap that is left [m]";
    for (int i = 100; i >= -100; --i) {
      const Solved solved = solved_at(0, -0.1 * i * g * step);
      put(by_gap.cases[0], step * solved.velocity[0], solved);
    }
  }
  return {by_speed, by_gap};
}

}  // namespace

std::vector<LawGraph> law_graphs(const PluginUse& use) {
  switch (use.plugin->spec.kind) {
    case PluginKind::restitution:
      return graphs_of(law_of<RestitutionLaw>(use));
    case PluginKind::friction:
      return graphs_of(law_of<FrictionLaw>(use));
    case PluginKind::rolling:
      return graphs_of(law_of<RollingLaw>(use));
    case PluginKind::unilateral:
      return graphs_of(law_of<UnilateralLaw>(use));
    default:
      break;
  }
  throw PluginError(
      fmt::format("plugin {}: a {} has no graph, expected a restitution, friction, rolling or unilateral law",
                  use.plugin->spec.name, name_of(use.plugin->spec.kind)));
}

}  // namespace flyrock
