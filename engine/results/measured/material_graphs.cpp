#include "results/measured/material_graphs.h"

#include <algorithm>
#include <cmath>

#include "math/space.h"
#include "trial/instances.h"

namespace flyrock {

namespace {

constexpr int speeds = 41, draws = 50, of_low = 2,
              of_high = 47;  // indices among 50 sorted draws; nine tenths lie between
constexpr double slowest = 0.1, fastest = 50;

/// The values of a law's parameters, drawn as often as a graph needs.
std::vector<std::vector<double>> parameters(const PluginUse& use, const Scenario& scenario) {
  std::vector<std::vector<double>> list;
  for (std::uint64_t i = 0; i < draws; ++i) list.push_back(values_of(use, scenario, {i, 1, 1, 1}));
  if (std::all_of(list.begin(), list.end(), [&](const auto& values) { return values == list.front(); }))
    list.resize(1);
  return list;
}

/// Samples a law. `answer(law, speed)` gives one number for each curve.
template <class LawKind, class Answer>
MaterialGraph sample(MaterialGraph graph, const Scenario& scenario, const PluginUse& use, Answer&& answer) {
  const PluginSpec& spec = use.plugin->spec;
  graph.law = spec.name;
  graph.doc = spec.doc;
  graph.source = spec.source;
  const std::vector<std::vector<double>> list = parameters(use, scenario);
  graph.drawn = list.size() > 1;
  SampledLaw<LawKind> law(use, scenario.dimension);
  try {
    for (int i = 0; i < speeds; ++i) {
      const double speed = slowest * std::pow(fastest / slowest, i / (speeds - 1.0));
      std::vector<std::vector<double>> answers(graph.curves.size());  // for each curve
      for (const std::vector<double>& values : list) {
        law.set(values);
        const std::vector<double> one = answer(law, speed);
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

void add_graphs(const Material& material, const Scenario& scenario, const LawSubject& subject,
                std::vector<MaterialGraph>& graphs) {
  const auto contact = [&](double approach, double slip) {
    ContactState state = first_contact(subject, scenario.dimension, approach, slip);
    state.material = material.name;
    if (approach == 0) state.normal_force = subject.mass * scenario.gravity.constant;
    return state;
  };
  if (const auto& use = material.restitution)
    graphs.push_back(sample<RestitutionLaw>(
        {.material = material.name,
         .kind = "restitution",
         .x = "approach speed in m/s",
         .y = "e_n",
         .curves = {{.name = "impact at 90°"}, {.name = "impact at 30°"}}},
        scenario, *use, [&](SampledLaw<RestitutionLaw>& law, double speed) {
          const double upright = law(contact(speed, 0)).e_n;
          law.forget();
          return std::vector{upright, law(contact(speed, speed / std::tan(pi / 6))).e_n};
        }));
  if (const auto& use = material.friction)
    graphs.push_back(sample<FrictionLaw>({.material = material.name,
                                          .kind = "friction",
                                          .x = "speed of slip in m/s",
                                          .y = "mu",
                                          .curves = {{.name = "static"}, {.name = "dynamic"}}},
                                         scenario, *use, [&](SampledLaw<FrictionLaw>& law, double speed) {
                                           const Friction answer = law(contact(0, speed));
                                           return std::vector{answer.mu_s, answer.mu_d};
                                         }));
  if (const auto& use = material.rolling)
    graphs.push_back(sample<RollingLaw>({.material = material.name,
                                         .kind = "rolling",
                                         .x = "speed of rolling in m/s",
                                         .y = "mu_r in m",
                                         .curves = {{.name = "bound of the torque over the normal force"}}},
                                        scenario, *use, [&](SampledLaw<RollingLaw>& law, double speed) {
                                          ContactState rolling = contact(0, 0);
                                          rolling.spin = speed / subject.radius;
                                          rolling.kinetic_energy = 0.5 * subject.mass * speed * speed;
                                          return std::vector{law(rolling).mu_r};
                                        }));
}

}  // namespace

std::vector<MaterialGraph> material_graphs(const Scenario& scenario, const LawSubject& subject) {
  std::vector<MaterialGraph> graphs;
  for (const Material& material : scenario.materials) add_graphs(material, scenario, subject, graphs);
  return graphs;
}

}  // namespace flyrock
