#include "scenario/trial_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "random/sampling.h"
#include "scenario/schema.h"

namespace flyrock {

namespace {

/// Whether each trial has one rock of a group.
bool has_one_rock(const RockGroup& group) {
  const PluginUse& population = group.population;
  return !group.table && !group.per_hole && population.plugin &&
         population.plugin->spec.name == default_population && population.slots.size() == 1 &&
         population.slots.front().is_constant() && population.slots.front().constant == 1;
}

bool is_one_a_trial(const Scenario& scenario, const Draw& draw) {
  if (draw.scope == Scope::trial) return true;
  if (draw.scope == Scope::hole) return scenario.blast && scenario.blast->pattern.holes() == 1;
  if (draw.scope != Scope::rock || scenario.rocks.empty()) return false;
  if (draw.group >= 0) return has_one_rock(scenario.rocks[static_cast<std::size_t>(draw.group)]);
  return scenario.rocks.size() == 1 && has_one_rock(scenario.rocks.front());
}

}  // namespace

void cover_draws(const Node& root, Scenario& scenario, Diagnostics& diagnostics) {
  const auto sampling = root.find("sampling");
  const std::string* name = sampling ? sampling->value->text() : nullptr;
  if (!name) return;
  Streams& streams = scenario.streams;
  for (const Sampling one : {Sampling::latin_hypercube, Sampling::sobol})
    if (*name == name_of(one)) streams.sampling = one;
  if (streams.sampling == Sampling::random) return;
  const auto refuse = [&](const std::string& text) {
    sampling->error(diagnostics, fmt::format("`{}` {}", *name, text));
  };
  streams.trials = scenario.trials;
  if (const std::string_view fault = trials_fault(streams.sampling, scenario.trials); !fault.empty())
    refuse(fmt::format("with {} trials: {}", scenario.trials, fault));
  if (!scenario.clearances.empty())
    refuse("has no `clearance`: its bound needs independent trials, expected `random`");
  if (scenario.observed) refuse("has no `observed`: its noise needs independent trials, expected `random`");
  if (scenario.outer > 1) refuse("has no `outer`: expected `random`");
  std::set<std::string> covered;
  for (const Draw& draw : scenario.draws)
    if (is_one_a_trial(scenario, draw)) covered.insert(draw.stream);
  if (static_cast<int>(covered.size()) > most_sobol_dimensions)
    refuse(
        fmt::format("covers at most {} draws, the scenario has {}", most_sobol_dimensions, covered.size()));
  streams.dimensions = static_cast<int>(covered.size());
  for (Draw& draw : scenario.draws)
    if (const auto at = covered.find(draw.stream); at != covered.end())
      draw.dimension = static_cast<int>(std::distance(covered.begin(), at));
}

std::uint64_t trials_of_unit(const Scenario& scenario) {
  if (scenario.streams.sampling == Sampling::random) return 1;
  return std::max<std::uint64_t>(1, scenario.trials / replicates);
}

void cover_alike(const Scenario& regular, Scenario& branch) {
  branch.streams = regular.streams;
  for (Draw& draw : branch.draws) {
    const auto alike = std::find_if(regular.draws.begin(), regular.draws.end(),
                                    [&](const Draw& other) { return other.stream == draw.stream; });
    draw.dimension = alike == regular.draws.end() ? -1 : alike->dimension;
  }
}

}  // namespace flyrock
