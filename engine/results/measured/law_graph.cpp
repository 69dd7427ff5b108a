#include "results/measured/law_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "results/measured/sampled_law.h"
#include "solver/law_terms.h"
#include "solver/spring.h"

namespace flyrock {

namespace {

constexpr double gravity = 9.81, step_length = 1e-3;
constexpr int half_count = 100;      // points on each side of 0
constexpr double load = 10;          // the greatest, in weights of the ball
constexpr double load_in_pulls = 4;  // the greatest, in pulls of a contact that bears a pull

/// Where the axis of the first graph ends, in SI units.
double range(const LawBall& ball, const Dimension& dimension, double usual) {
  if (!ball.to) return usual;
  if (ball.to->has_unit && ball.to->unit.dimension != dimension)
    throw PluginError(fmt::format("the axis of this graph has the unit {}, not {}", si_unit(dimension),
                                  ball.to->unit_text));
  if (!(ball.to->si() > 0))
    throw PluginError(fmt::format("the axis of the graph ends at {:.6g}, must be above 0", ball.to->si()));
  return ball.to->si();
}

template <class LawKind>
SampledLaw<LawKind> law_of(const PluginUse& use) {
  SampledLaw<LawKind> law(use, 2);
  std::vector<double> values;
  for (const Number& slot : use.slots) values.push_back(slot.constant);
  law.set(std::move(values));
  return law;
}

ContactState at_contact(const LawBall& ball, double approach, double slip) {
  ContactState state = first_contact({ball.mass, ball.radius}, 2, approach, slip);
  state.area = state.length = 1;
  if (approach == 0) state.normal_force = ball.mass * gravity;
  return state;
}

/// A contact of the ball: its law, and its motion before and without contact, rows (n, t, rolling).
struct Posed {
  ContactLaw law;
  bool sticking = false;
  double gap = 0, stretch = 0;    // m
  double duration = step_length;  // s
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), free = Eigen::Vector3d::Zero();
};

/// One solved contact of the ball: impulse and velocity, rows (n, t, rolling).
struct Solved {
  Eigen::Vector3d impulse, velocity;
};

Solved solve(const LawBall& ball, const Posed& posed) {
  const double inertia = 0.4 * ball.mass * ball.radius * ball.radius, lever = ball.radius / inertia;
  Eigen::Matrix3d w;
  w << 1 / ball.mass, 0, 0, 0, 1 / ball.mass + ball.radius * lever, lever, 0, lever, 1 / inertia;
  ContactProblem<2> problem;
  ContactProblem<2>::Contact contact;
  contact.w = w;
  contact.q = posed.free;
  contact.speed_scale = std::max(posed.before.norm(), gravity * step_length);
  Rebound<2> rebound;
  rebound.before = posed.before;
  set_law<2>(posed.law, posed.sticking, posed.gap, posed.duration, contact, rebound);
  problem.contacts.push_back(contact);
  problem.first = {0, 0};
  if (posed.law.condition == NormalCondition::penalty)
    set_spring<2>(posed.law.spring, -posed.gap, Eigen::Matrix<double, 1, 1>::Constant(posed.stretch),
                  posed.duration, problem, 0, rebound);
  std::vector<Eigen::Vector3d> r(1, Eigen::Vector3d::Zero());
  SolveSettings settings;
  settings.tolerance = 1e-12;
  ImpactSolver<2>().solve(problem, {rebound}, settings, r);
  return {r[0], posed.free + w * r[0]};
}

void put(LawGraph::Case& to, double at, double value) {
  to.at.push_back(at);
  to.value.push_back(value);
}

/// The shortest of several ranges beyond which a function changes by less than a fiftieth of all its change.
template <std::size_t n, class Function>
double range_of_change(const std::array<double, n>& ranges, Function&& value) {
  std::array<double, n> values;
  for (std::size_t i = 0; i < n; ++i) values[i] = value(ranges[i]);
  const double all = std::abs(value(0) - values.back());
  for (std::size_t i = 0; i < n; ++i)
    if (std::abs(values[i] - values.back()) <= 0.02 * all) return ranges[i];
  return ranges.back();
}

/// A graph of impacts: the shares of the normal and of the tangential speed that remain.
LawGraph shares_of_speed(const std::string& title, const char* x) {
  return {title, x, "share of speed that is left", {{"normal", {}, {}}, {"tangential", {}, {}}}};
}

/// Adds an impact of the ball to such a graph.
void add_impact(SampledLaw<RestitutionLaw>& asked, const LawBall& ball, const ContactState& state, double at,
                LawGraph& graph) {
  const double approach = state.approach_speed, slip = state.slip_speed;
  Posed posed{.law = asked(state), .duration = 0};
  posed.law.mu_s = posed.law.mu_d = ball.mu;
  posed.before = posed.free = {-approach, slip, 0};
  const Solved solved = solve(ball, posed);
  put(graph.cases[0], at, solved.velocity[0] / approach);
  put(graph.cases[1], at, solved.velocity[1] / slip);
}

/// The impacts of a ball that is thrown again and again at one speed and angle: what changes is the law's.
/// Between two of them it is in the air for as long as a throw of that speed.
LawGraph impact_by_impact(SampledLaw<RestitutionLaw>& asked, const LawBall& ball, double speed, int count) {
  LawGraph graph = shares_of_speed(
      fmt::format("one impact after the other at {:.4g} m/s and 45 degrees, mu {:.4g}", speed, ball.mu),
      "number of the impact");
  const double component = speed * std::sqrt(0.5);
  asked.forget();
  for (int number = 1; number <= count; ++number) {
    ContactState state = at_contact(ball, component, component);
    state.impact_number = number;
    state.time = (number - 1) * 2 * component / gravity;
    add_impact(asked, ball, state, number, graph);
    asked.part();
  }
  return graph;
}

bool changes(const LawGraph& graph) {
  return std::any_of(graph.cases.begin(), graph.cases.end(), [](const LawGraph::Case& curve) {
    const auto [low, high] = std::minmax_element(curve.value.begin(), curve.value.end());
    return *high - *low > 1e-9;
  });
}

std::vector<LawGraph> graphs_of(SampledLaw<RestitutionLaw> asked, const LawBall& ball) {
  const double fastest = range(ball, dimension::speed, 30);
  const auto add = [&](LawGraph& graph, double at, double approach, double slip) {
    asked.forget();
    add_impact(asked, ball, at_contact(ball, approach, slip), at, graph);
  };
  LawGraph by_speed =
      shares_of_speed(fmt::format("impact at 45 degrees, mu {:.4g}", ball.mu), "normal speed before [m/s]");
  for (int i = 1; i <= half_count; ++i) {
    const double speed = fastest * i / half_count;
    add(by_speed, speed, speed, speed);
  }
  const double speed = fastest / 3;
  LawGraph by_angle = shares_of_speed(fmt::format("impact at {:.4g} m/s, mu {:.4g}", speed, ball.mu),
                                      "angle from the surface [deg]");
  for (int i = 2; i <= 89; ++i) {
    const double angle = i * pi / 180;
    add(by_angle, i, speed * std::sin(angle), speed * std::cos(angle));
  }
  const auto after = [&](double impacts) {
    const LawGraph graph = impact_by_impact(asked, ball, speed, std::max(1, static_cast<int>(impacts)));
    return graph.cases[0].value.back() + graph.cases[1].value.back();
  };
  constexpr std::array numbers{10.0, 20.0, 50.0, 100.0};
  const LawGraph by_number =
      impact_by_impact(asked, ball, speed, static_cast<int>(range_of_change(numbers, after)));
  if (changes(by_number)) return {by_speed, by_angle, by_number};
  return {by_speed, by_angle};
}

/// r_t / r_n of a contact that the ball's weight presses.
Solved slide(SampledLaw<FrictionLaw>& asked, const LawBall& ball, double slip, double way, bool sticking) {
  ContactState state = at_contact(ball, 0, std::abs(slip));
  state.was_sticking = sticking;
  state.age = state.pair_age = way;
  state.step = way > 0 ? 0.01 : step_length;
  if (way == 0) state.age = state.pair_age = step_length;
  Posed posed{.law = asked(state), .sticking = sticking};
  posed.before = {0, slip, 0};
  posed.free = {-gravity * step_length, slip, 0};
  return solve(ball, posed);
}

std::vector<LawGraph> graphs_of(SampledLaw<FrictionLaw> asked, const LawBall& ball) {
  const double weight = ball.mass * gravity * step_length;
  const auto coefficient = [&](double slip) {
    asked.forget();
    return asked(at_contact(ball, 0, slip)).mu_d;
  };
  constexpr std::array slips{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
  const double fastest = range(ball, dimension::speed, range_of_change(slips, coefficient));
  LawGraph graph{"pressed by its weight",
                 "slip velocity after the step [m/s]",
                 "r_t / (m g h)",
                 {{"it stuck before", {}, {}}, {"it slid before", {}, {}}}};
  for (const bool sticking : {true, false})
    for (int i = -half_count; i <= half_count; ++i) {
      asked.forget();
      const Solved solved = slide(asked, ball, fastest * i / half_count, 0, sticking);
      put(graph.cases[sticking ? 0 : 1], solved.velocity[1], solved.impulse[1] / weight);
    }
  if (!asked.remembers()) return {graph};

  LawGraph along{"along a slide at 1 m/s", "way [m]", "r_t / (m g h)", {{"", {}, {}}}};
  const auto slide_to = [&](double end) {
    asked.forget();
    along.cases[0] = {};
    for (int i = 0; i <= 100 * end; ++i)
      put(along.cases[0], 0.01 * i, slide(asked, ball, -1, 0.01 * i, false).impulse[1] / weight);
    return along.cases[0].value.back();
  };
  constexpr std::array ways{2.0, 5.0, 20.0, 50.0};
  slide_to(range_of_change(ways, slide_to));
  return {graph, along};
}

std::vector<LawGraph> graphs_of(SampledLaw<RollingLaw> asked, const LawBall& ball) {
  LawGraph graph{
      "pressed by its weight", "rolling velocity after the step [rad/s]", "m_r / r_n [m]", {{"", {}, {}}}};
  const double fastest = range(ball, dimension::spin, 5);
  for (int i = -half_count; i <= half_count; ++i) {
    asked.forget();
    const double spin = fastest * i / half_count;
    ContactState state = at_contact(ball, 0, 0);
    state.spin = std::abs(spin);
    state.step = step_length;
    Posed posed{.law = asked(state)};
    posed.before = {0, 0, spin};
    posed.free = {-gravity * step_length, 0, spin};
    const Solved solved = solve(ball, posed);
    put(graph.cases[0], solved.velocity[2], solved.impulse[2] / solved.impulse[0]);
  }
  return {graph};
}

/// A spring: its force at constant rates of the overlap, and of its tangential spring at constant overlap.
std::vector<LawGraph> graphs_of_spring(const ContactLaw& law, const LawBall& ball) {
  const Spring& spring = law.spring;
  const double weight = ball.mass * gravity;
  const double deepest =
      range(ball, dimension::length, std::pow(load * weight / spring.stiffness, 1 / spring.exponent));
  const auto force_at = [&](double overlap, double rate) {
    Posed posed{.law = law, .gap = -overlap};
    const double power = overlap_power(spring, overlap);
    const double force = power * std::max(0.0, spring.stiffness * overlap + spring.damping * rate);
    // A damper acts by a mean velocity of a step: the force changes the velocity at its end.
    const double end = damper_weight(step_length * spring.damping * power / ball.mass);
    posed.before = posed.free = {-rate - end * step_length * force / ball.mass, 0, 0};
    return solve(ball, posed).impulse[0] / step_length;
  };
  LawGraph by_overlap{"by overlap", "overlap [m]", "force r_n / h [N]", {}};
  const double power = overlap_power(spring, deepest);
  const double fast = deepest * std::sqrt(spring.stiffness * power / ball.mass);  // on the way to `deepest`
  for (const double rate : {0.0, fast, -fast}) {
    if (rate != 0 && spring.damping == 0) break;
    LawGraph::Case curve{
        rate == 0 ? "at rest" : fmt::format("{} at {:.3g} m/s", rate > 0 ? "closing" : "opening", fast),
        {},
        {}};
    if (spring.damping == 0) curve.name.clear();
    for (int i = -half_count / 4; i <= half_count; ++i) {
      const double overlap = deepest * i / half_count;
      put(curve, overlap, force_at(overlap, rate));
    }
    by_overlap.cases.push_back(std::move(curve));
  }
  if (spring.tangential_stiffness == 0) return {by_overlap};
  LawGraph by_stretch{fmt::format("tangential, mu {:.4g}, pressed by the weight", ball.mu),
                      "stretch [m]",
                      "force r_t / h [N]",
                      {{"", {}, {}}}};
  Posed pressed{.law = law};
  pressed.law.mu_s = pressed.law.mu_d = ball.mu;
  pressed.law.spring.damping = 0;
  pressed.gap = -std::pow(weight / spring.stiffness, 1 / spring.exponent);
  const double longest = 2 * ball.mu * weight / spring.tangential_stiffness;
  for (int i = -half_count; i <= half_count; ++i) {
    pressed.stretch = longest * i / half_count;
    put(by_stretch.cases[0], pressed.stretch, solve(ball, pressed).impulse[1] / step_length);
  }
  return {by_overlap, by_stretch};
}

std::vector<LawGraph> graphs_of(SampledLaw<UnilateralLaw> asked, const LawBall& ball) {
  const auto law_at = [&](double gap) {
    asked.forget();
    ContactState state = at_contact(ball, 0, 0);
    state.gap = gap;
    state.step = step_length;
    return asked(state);
  };
  const NormalCondition condition = law_at(0).condition;
  if (condition == NormalCondition::penalty) return graphs_of_spring(law_at(0), ball);
  /// A contact with a gap. Without contact it would reach the end of the step with the speed `free`.
  const auto solved_at = [&](double gap, double free) {
    Posed posed{.law = law_at(gap), .gap = gap};
    posed.before = posed.free = {free, 0, 0};
    return solve(ball, posed);
  };
  // A pull sets the scale of both graphs: in that of the ball's weight it may be too small to be seen.
  const double pull = law_at(0).c_n;
  const double greatest = pull > 0 ? load_in_pulls * pull : load * ball.mass * gravity;  // N
  const double fastest = range(ball, dimension::speed, pull > 0 ? greatest * step_length / ball.mass : 2);
  LawGraph by_speed{"by velocity, h = 1 ms",
                    "normal velocity after the step [m/s]",
                    "force r_n / h [N]",
                    {{"closed", {}, {}}}};
  const auto add_speeds = [&](LawGraph::Case& to, double gap) {
    for (int i = -half_count; i <= half_count; ++i) {
      const Solved solved = solved_at(gap, fastest * i / half_count);
      put(to, solved.velocity[0], solved.impulse[0] / step_length);
    }
  };
  add_speeds(by_speed.cases[0], 0);
  // The other laws do nothing at an open contact.
  if (condition == NormalCondition::quasi_shock) {
    by_speed.cases.push_back({"open by 1 mm", {}, {}});
    add_speeds(by_speed.cases[1], 1e-3);
  }
  LawGraph by_gap{fmt::format("from {0} pushing to {0} pulling, h = 1 ms",
                              pull > 0 ? fmt::format("{:.4g} N", greatest) : "ten weights"),
                  "gap that is left [m]",
                  "force r_n / h [N]",
                  {{"", {}, {}}}};
  for (int i = half_count; i >= -half_count; --i) {
    const Solved solved = solved_at(0, -greatest / ball.mass * i / half_count * step_length);
    put(by_gap.cases[0], step_length * solved.velocity[0], solved.impulse[0] / step_length);
  }
  return {by_speed, by_gap};
}

}  // namespace

std::vector<LawGraph> law_graphs(const PluginUse& use, const LawBall& ball) {
  switch (use.plugin->spec.kind) {
    case PluginKind::restitution:
      return graphs_of(law_of<RestitutionLaw>(use), ball);
    case PluginKind::friction:
      return graphs_of(law_of<FrictionLaw>(use), ball);
    case PluginKind::rolling:
      return graphs_of(law_of<RollingLaw>(use), ball);
    case PluginKind::unilateral:
      return graphs_of(law_of<UnilateralLaw>(use), ball);
    default:
      break;
  }
  throw PluginError(
      fmt::format("plugin {}: a {} has no graph, expected a restitution, friction, rolling or unilateral law",
                  use.plugin->spec.name, name_of(use.plugin->spec.kind)));
}

}  // namespace flyrock
