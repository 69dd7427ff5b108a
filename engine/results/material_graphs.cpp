#include "results/material_graphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "math/space.h"
#include "trial/instances.h"

namespace flyrock {

namespace {

constexpr int speeds = 41, draws = 50, of_low = 2,
              of_high = 47;  // indices among 50 sorted draws; nine tenths lie between
constexpr double slowest = 0.1, fastest = 50;

/// The answer of a law for values of its parameters, at a contact and a speed: one number for each curve.
using Answer = std::function<std::vector<double>(Values, const ContactState&, double speed)>;

/// The values of a law's parameters, drawn as often as a graph needs.
std::vector<std::vector<double>> parameters(const PluginUse& use, const Scenario& scenario) {
  std::vector<std::vector<double>> list;
  for (std::uint64_t i = 0; i < draws; ++i) list.push_back(values_of(use, scenario, {i, 1, 1, 1}));
  if (std::all_of(list.begin(), list.end(), [&](const auto& values) { return values == list.front(); }))
    list.resize(1);
  return list;
}

MaterialGraph sample(MaterialGraph graph, ContactState contact, const Scenario& scenario,
                     const PluginUse& use, const Answer& answer) {
  const PluginSpec& spec = use.plugin->spec;
  graph.law = spec.name;
  graph.doc = spec.doc;
  graph.source = spec.source;
  const std::vector<std::vector<double>> list = parameters(use, scenario);
  graph.drawn = list.size() > 1;
  try {
    for (int i = 0; i < speeds; ++i) {
      const double speed = slowest * std::pow(fastest / slowest, i / (speeds - 1.0));
      std::vector<std::vector<double>> answers(graph.curves.size());  // for each curve
      for (const std::vector<double>& values : list) {
        std::array<double, most_history> history{};  // of a new contact
        contact.history = history;
        const std::vector<double> one = answer(values, contact, speed);
        for (std::size_t c = 0; c < one.size(); ++c) answers[c].push_back(one[c]);
      }
      graph.speed.push_back(speed);
      for (std::size_t c = 0; c < answers.size(); ++c) {
        std::vector<double>& sorted = answers[c];
        std::sort(sorted.begin(), sorted.end());
        graph.curves[c].low.push_back(graph.drawn ? sorted[of_low] : sorted[0]);
        graph.curves[c].middle.push_back(sorted[sorted.size() / 2]);
        graph.curves[c].high.push_back(graph.drawn ? sorted[of_high] : sorted[0]);
      }
    }
  } catch (const PluginError& error) {
    graph.fault = error.what();
  }
  return graph;
}

/// The first contact of a rock.
ContactState contact_of(const Material& material, const LawSubject& subject, int dimension) {
  ContactState state;
  state.mass = state.effective_mass = subject.mass;
  state.radius = subject.radius;
  state.impact_number = 1;
  state.group_a = "rock";
  state.group_b = "terrain";
  state.material = material.name;
  set_on_level_ground(state, dimension);
  return state;
}

ContactState impact(ContactState state, double approach, double angle) {
  state.approach_speed = approach;
  state.slip_speed = angle < pi / 2 ? approach / std::tan(angle) : 0;
  state.impact_angle = angle;
  set_on_level_ground(state, state.dimension);
  state.kinetic_energy = 0.5 * state.mass * (approach * approach + state.slip_speed * state.slip_speed);
  return state;
}

/// A contact that stays closed while its rock moves along the surface.
ContactState moving(ContactState state, double slip, double spin, double speed) {
  state.slip_speed = slip;
  set_on_level_ground(state, state.dimension);
  state.spin = spin;
  state.kinetic_energy = 0.5 * state.mass * speed * speed;
  return state;
}

void add_graphs(const Material& material, const Scenario& scenario, const LawSubject& subject,
                std::vector<MaterialGraph>& graphs) {
  const ContactState contact = contact_of(material, subject, scenario.dimension);
  if (const auto& use = material.restitution) {
    const auto law = make_instance<RestitutionLaw>(*use, scenario.dimension);
    graphs.push_back(sample({.material = material.name,
                             .kind = "restitution",
                             .x = "approach speed in m/s",
                             .y = "e_n",
                             .curves = {{.name = "impact at 90°"}, {.name = "impact at 30°"}}},
                            contact, scenario, *use,
                            [&](Values values, const ContactState& at, double speed) {
                              std::vector<double> e_n;
                              for (const double angle : {pi / 2, pi / 6}) {
                                const Restitution answer = law->impact(values, impact(at, speed, angle));
                                check_answer(*law, answer);
                                e_n.push_back(answer.e_n);
                              }
                              return e_n;
                            }));
  }
  if (const auto& use = material.friction) {
    const auto law = make_instance<FrictionLaw>(*use, scenario.dimension);
    graphs.push_back(sample({.material = material.name,
                             .kind = "friction",
                             .x = "speed of slip in m/s",
                             .y = "mu",
                             .curves = {{.name = "static"}, {.name = "dynamic"}}},
                            contact, scenario, *use,
                            [&](Values values, const ContactState& at, double speed) {
                              const Friction answer = law->friction(values, moving(at, speed, 0, speed));
                              check_answer(*law, answer);
                              return std::vector{answer.mu_s, answer.mu_d};
                            }));
  }
  if (const auto& use = material.rolling) {
    const auto law = make_instance<RollingLaw>(*use, scenario.dimension);
    graphs.push_back(
        sample({.material = material.name,
                .kind = "rolling",
                .x = "speed of rolling in m/s",
                .y = "mu_r in m",
                .curves = {{.name = "bound of the torque over the normal force"}}},
               contact, scenario, *use, [&](Values values, const ContactState& at, double speed) {
                 const Rolling answer = law->rolling(values, moving(at, 0, speed / subject.radius, speed));
                 check_answer(*law, answer);
                 return std::vector{answer.mu_r};
               }));
  }
}

}  // namespace

std::vector<MaterialGraph> material_graphs(const Scenario& scenario, const LawSubject& subject) {
  std::vector<MaterialGraph> graphs;
  for (const Material& material : scenario.materials) add_graphs(material, scenario, subject, graphs);
  return graphs;
}

}  // namespace flyrock
