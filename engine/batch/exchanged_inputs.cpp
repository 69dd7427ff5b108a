#include "batch/exchanged_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "document/wording.h"
#include "scenario/schema.h"

namespace flyrock {

namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}
void add(Names& names, const std::string& name) {
  if (!has(names, name)) names.push_back(name);
}

/// All draws, those of trees too, and of branches.
std::vector<const Draw*> draws_of(const Scenario& scenario) {
  std::vector<const Draw*> draws;
  for (const Draw& draw : scenario.draws) draws.push_back(&draw);
  if (scenario.forest)
    for (const Draw& draw : scenario.forest->draws) draws.push_back(&draw);
  for (const BranchPlan& branch : scenario.branches)
    for (const Draw& draw : branch.scenario->draws) draws.push_back(&draw);
  return draws;
}

/// Trees are drawn once a run, but for what they do at a hit.
bool is_once_a_run(const Draw& draw) {
  return draw.scope == Scope::run || (draw.stream.starts_with("forest.") && draw.scope != Scope::impact);
}

Names once_a_run(const Scenario& scenario) {
  Names names;
  for (const Draw* draw : draws_of(scenario))
    if (is_once_a_run(*draw)) add(names, draw->stream);
  if (scenario.forest && scenario.forest->is_drawn) add(names, "forest.place");
  return names;
}

bool has_random_place(const RockGroup& group) {
  if (!group.release) return false;
  const ReleaseKind kind = group.release->kind;
  return kind != ReleaseKind::position && kind != ReleaseKind::above_ground && kind != ReleaseKind::collar;
}

bool has_random_orientation(const Scenario& scenario, const RockGroup& group) {
  return scenario.method == Method::nscd &&
         !(scenario.dimension == 2 ? group.orientation.has_value() : group.turn.has_value());
}

/// What the plan says of a stream that nothing reads: "bench_fit does not read it"; empty: it is read.
std::string why_not_read(const Plan& plan, const Draw& draw) {
  for (const std::string& line : plan.not_used) {
    const std::size_t end = line.find(" (");
    const std::string key = line.substr(0, end);
    for (const std::string* path : {&draw.path, &draw.stream})
      if (*path == key || path->starts_with(key + "."))
        return end == std::string::npos ? "nothing reads it" : line.substr(end + 2, line.size() - end - 3);
  }
  return {};
}

/// The streams of a name: its own and all below it, without those that are named apart.
Names streams_named(const Names& all, const std::string& name, const Names& apart) {
  Names streams;
  for (const std::string& stream : all)
    if (stream == name || (stream.starts_with(name + ".") && !has(apart, stream))) streams.push_back(stream);
  if (streams.empty())
    throw std::invalid_argument(
        fmt::format("the scenario draws from no stream `{}`{}", name, did_you_mean(name, all)));
  return streams;
}

void refuse_twice(const std::vector<ExchangedInput>& inputs) {
  std::set<std::string> names, streams;
  for (const ExchangedInput& input : inputs) {
    if (!names.insert(input.name).second || input.name == everything_else)
      throw std::invalid_argument(fmt::format("two inputs are called `{}`", input.name));
    for (const std::string& stream : input.streams)
      if (!streams.insert(stream).second)
        throw std::invalid_argument(fmt::format("`{}` stands in two inputs", stream));
  }
}

}  // namespace

std::vector<std::string> streams_of(const Scenario& scenario) {
  Names names;
  for (const Draw* draw : draws_of(scenario))
    if (!is_once_a_run(*draw)) add(names, draw->stream);
  for (const RockGroup& group : scenario.rocks)
    for (const char* of : {"population", "release", "shape", "orientation", "launch"})
      add(names, fmt::format("rocks.{}.{}", group.name, of));
  for (const BodyPlan& body : scenario.bodies) add(names, fmt::format("bodies.{}.shape", body.name));
  add(names, "terrain");
  if (!scenario.branches.empty()) add(names, "branches");
  return names;
}

ExchangedInputs exchanged_inputs(const Plan& plan, const InputChoice& choice) {
  const Scenario& scenario = plan.points.front();
  ExchangedInputs found;
  found.once_a_run = once_a_run(scenario);
  const Names all = streams_of(scenario);
  Names grouped, named = choice.inputs;
  for (const auto& [name, members] : choice.groups) named.insert(named.end(), members.begin(), members.end());
  for (const auto& [name, members] : choice.groups) {
    ExchangedInput group{name, {}};
    for (const std::string& member : members)
      for (const std::string& stream : streams_named(all, member, named)) add(group.streams, stream);
    grouped.insert(grouped.end(), group.streams.begin(), group.streams.end());
    found.inputs.push_back(std::move(group));
  }
  for (const Draw* draw : draws_of(scenario)) {
    const bool is_known = std::any_of(found.not_read.begin(), found.not_read.end(),
                                      [&](const NoInput& known) { return known.stream == draw->stream; });
    if (const std::string why = why_not_read(plan, *draw); !why.empty() && !is_known && !is_once_a_run(*draw))
      found.not_read.push_back({draw->stream, why});
  }
  if (!choice.inputs.empty()) {
    for (const std::string& name : choice.inputs)
      found.inputs.push_back({name, streams_named(all, name, named)});
  } else {
    Names names;
    for (const Draw* draw : draws_of(scenario))
      if (!is_once_a_run(*draw) && why_not_read(plan, *draw).empty()) add(names, draw->stream);
    for (const RockGroup& group : scenario.rocks) {
      if (group.population.plugin && group.population.plugin->spec.name != default_population &&
          !group.table && !group.per_hole)
        add(names, fmt::format("rocks.{}.population", group.name));
      if (has_random_place(group)) add(names, fmt::format("rocks.{}.release", group.name));
      if (has_random_orientation(scenario, group))
        add(names, fmt::format("rocks.{}.orientation", group.name));
    }
    if (!scenario.branches.empty()) add(names, "branches");
    for (const std::string& name : names)
      if (!has(grouped, name)) found.inputs.push_back({name, {name}});
  }
  refuse_twice(found.inputs);
  found.inputs.push_back({everything_else, {}});
  return found;
}

std::vector<Exchange> exchanges(const ExchangedInputs& inputs, std::uint64_t seed) {
  const std::uint64_t other = hash_name(fmt::format("the second base of seed {}", seed));
  const auto table = [&](bool all_but, const Names& streams) {
    Exchange exchange{other, all_but, {}};
    for (const std::string& stream : streams) exchange.names.push_back(hash_name(stream));
    std::sort(exchange.names.begin(), exchange.names.end());
    return exchange;
  };
  std::vector<Exchange> tables{table(false, {}), table(true, inputs.once_a_run)};
  Names taken = inputs.once_a_run;
  for (const ExchangedInput& input : inputs.inputs) {
    tables.push_back(input.name == everything_else ? table(true, taken) : table(false, input.streams));
    taken.insert(taken.end(), input.streams.begin(), input.streams.end());
  }
  return tables;
}

void ask_for_exchanges(Scenario& scenario, const Exchange* exchange) {
  scenario.streams.exchange = exchange;
  for (BranchPlan& branch : scenario.branches) {
    auto own = std::make_shared<Scenario>(*branch.scenario);
    ask_for_exchanges(*own, exchange);
    branch.scenario = std::move(own);
  }
}

}  // namespace flyrock
