#include "cli/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "batch/plan_chunks.h"
#include "batch/trial.h"
#include "cli/command.h"
#include "cli/terminal.h"
#include "files/safe_file.h"
#include "files/sha256.h"
#include "report/page/variance_page.h"
#include "report/tables/variance_data.h"
#include "results/risk/exposure.h"
#include "scenario/derived_inputs.h"
#include "units/units.h"

namespace flyrock::cli {

namespace {

/// Without `--of`: how far the farthest rock of each group comes.
std::vector<std::string> default_numbers(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const RockGroup& group : scenario.rocks)
    names.push_back(fmt::format("rocks.{}.runout.max", group.name));
  return names;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

InputChoice choice_of(const AnalysisRequest& words) {
  InputChoice choice;
  choice.inputs = split(words.inputs);
  for (const std::string& group : words.groups) {
    const std::size_t equals = group.find('=');
    const std::vector<std::string> streams =
        equals == std::string::npos ? std::vector<std::string>() : split(group.substr(equals + 1));
    if (equals == 0 || streams.empty())
      throw UsageError(fmt::format("--group: `{}`, expected NAME=STREAM,...", group));
    choice.groups.emplace_back(group.substr(0, equals), streams);
  }
  return choice;
}

/// Refuses what has no trials that are drawn alike.
void refuse_others(const LoadedScenario& scenario) {
  const Scenario& first = scenario.plan.points.front();
  if (scenario.plan.points.size() > 1)
    throw InputError(
        fmt::format("{} has a sweep; a sensitivity analysis is of one point, expected --set with one "
                    "value of each axis",
                    scenario.name));
  if (first.outer > 1)
    throw InputError("`outer` makes several runs; a sensitivity analysis is of one, expected --set outer=1");
  if (first.rocks.empty()) throw InputError("a sensitivity analysis needs `rocks`, the scenario has none");
}

/// What its pictures and tables would store, an analysis does not need.
void store_less(Scenario& scenario) {
  OutputPlan& output = scenario.output;
  output.trajectories_first = 0;
  output.impacts = false;
  output.hard_problems = false;
  output.envelopes = false;
  output.rocks = true;
  output.series.reset();
  output.maps.wanted = false;
}

double read_line(const std::string& text, const TrialMeasure& number) {
  const auto line = parse_quantity(text);
  const Dimension dimension = parse_unit(number.unit()).value_or(Unit{}).dimension;
  if (!line || line->unit.dimension != dimension)
    throw UsageError(fmt::format("--line: `{}`, expected a number in {}", text, number.unit()));
  return line->si();
}

/// A scenario with its own table of exchanged streams, and the runner of its trials.
class ExchangedRunner {
 public:
  ExchangedRunner(Plan& plan, const std::vector<Exchange>& tables) : tables_(tables) {
    Scenario& scenario = plan.points.front();
    store_less(scenario);
    ask_for_exchanges(scenario, &current_);
    runner_ = std::make_unique<TrialRunner>(scenario);
    runner_->stop_when(was_interrupted);
  }

  void run(int point, std::uint64_t trial, TrialRecords& out) {
    current_ = tables_[static_cast<std::size_t>(point)];
    const std::size_t inputs = out.inputs.size();
    runner_->run(trial, out);
    if (point > 1) out.inputs.resize(inputs);  // curves are drawn from the bases
  }

 private:
  const std::vector<Exchange>& tables_;
  Exchange current_;
  std::unique_ptr<TrialRunner> runner_;
};

/// The scenario that a thread has read again.
struct ReadAgain {
  std::optional<LoadedScenario> scenario;
  std::unique_ptr<ExchangedRunner> runner;
};

/// Groups whose number of rocks differs from trial to trial, and that others follow.
class CountedRocks {
 public:
  explicit CountedRocks(const Scenario& scenario) : scenario_(scenario), seen_(scenario.rocks.size()) {}

  void add(const TrialRecords& chunk) {
    std::vector<std::uint64_t> counts(seen_.size());
    for (std::size_t i = 0; i < chunk.rocks.size(); ++i) {
      ++counts[static_cast<std::size_t>(chunk.rocks[i].group)];
      const bool is_last = i + 1 == chunk.rocks.size() || chunk.rocks[i + 1].trial != chunk.rocks[i].trial;
      if (!is_last) continue;
      for (std::size_t g = 0; g < counts.size(); ++g) {
        seen_[g].least = std::min(seen_[g].least, counts[g]);
        seen_[g].greatest = std::max(seen_[g].greatest, counts[g]);
        counts[g] = 0;
      }
    }
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (std::size_t g = 0; g + 1 < seen_.size(); ++g)
      if (seen_[g].greatest > seen_[g].least) names.push_back(scenario_.rocks[g].name);
    return names;
  }

 private:
  struct Range {
    std::uint64_t least = ~std::uint64_t{0}, greatest = 0;
  };
  const Scenario& scenario_;
  std::vector<Range> seen_;
};

void set_radii(const Scenario& scenario, const Rows& rows, std::uint64_t trials,
               std::vector<TrialMeasure>& numbers) {
  if (std::none_of(numbers.begin(), numbers.end(), [](const TrialMeasure& n) { return n.exposure() >= 0; }))
    return;
  ExposureTally tally(scenario);
  rows(Part::brief, [&](const TrialRecords& chunk) { tally.add(chunk); });
  tally.needs_another_pass();
  const std::vector<ExposureSummary> summaries = tally.summaries(trials);
  for (TrialMeasure& number : numbers)
    if (number.exposure() >= 0)
      number.set_radius(summaries[static_cast<std::size_t>(number.exposure())].radius);
}

/// How a number moves with the inputs of which each trial has one value.
void add_responses(const Scenario& scenario, const Analysis& analysis, const InputValues& values,
                   const ExchangedRuns& runs, std::uint64_t seed, ExplainedNumber& number) {
  std::vector<double> f = runs.a;
  f.insert(f.end(), runs.b.begin(), runs.b.end());
  const auto response = [&](const std::string& path) -> std::optional<NamedResponse> {
    const std::vector<double>* x = values.of(path);
    if (!x) return std::nullopt;
    auto found = response_of(*x, f);
    if (!found) return std::nullopt;
    NamedResponse named{path, values.unit_of(path), std::move(*found), std::nullopt};
    if (analysis.line) named.crossing = crossing_of(*x, f, *analysis.line, seed);
    return named;
  };
  for (const ExchangedInput& input : analysis.inputs.inputs)
    number.responses.push_back(input.streams.size() == 1 ? response(input.streams.front()) : std::nullopt);
  std::vector<const NamedResponse*> strongest;
  for (const std::size_t i : ranked(number.indices))
    if (number.responses[i] && number.indices.inputs[i].total > 0) strongest.push_back(&*number.responses[i]);
  if (strongest.size() > 1) {
    const NamedResponse &x = *strongest[0], &y = *strongest[1];
    if (auto map = map_of(*values.of(x.path), *values.of(y.path), f))
      number.map = NamedMap{x.path, y.path, x.unit, y.unit, std::move(*map)};
  }
  if (!scenario.blast) return;
  for (std::size_t d = 0; d < derived_count; ++d) {
    const auto derived = static_cast<Derived>(d);
    if (auto found = response(path_of(derived))) {
      number.made.push_back(std::move(*found));
      number.made_of.push_back(paths_made_of(*scenario.blast, derived));
    }
  }
}

}  // namespace

Analysis make_analysis(LoadedScenario& loaded, const AnalysisRequest& words) {
  refuse_others(loaded);
  const Scenario& scenario = loaded.plan.points.front();
  Analysis analysis;
  try {
    analysis.inputs = exchanged_inputs(loaded.plan, choice_of(words));
  } catch (const std::invalid_argument& fault) {
    throw UsageError(fault.what());
  }
  for (const std::string& text : words.of.empty() ? default_numbers(scenario) : words.of) {
    std::string fault;
    const auto number = TrialMeasure::read(text, scenario, fault);
    if (!number) throw UsageError("--of: " + fault);
    analysis.numbers.push_back(*number);
  }
  if (!words.line.empty()) analysis.line = read_line(words.line, analysis.numbers.front());
  analysis.tables = exchanges(analysis.inputs, scenario.streams.seed);
  analysis.trials = scenario.trials;
  analysis.chunks =
      plan_chunks(static_cast<int>(analysis.tables.size()), scenario.trials, chunk_size(loaded.plan));
  std::string text = loaded.hash;
  for (const Exchange& table : analysis.tables) {
    text += fmt::format("\n{} {}", table.seed, table.all_but);
    for (const std::uint64_t name : table.names) text += fmt::format(" {}", name);
  }
  loaded.hash = sha256(text);
  return analysis;
}

void refuse_few_rocks(const LoadedScenario& scenario, const Analysis& analysis) {
  TrialRecords first;
  TrialRunner(scenario.plan.points.front()).run(0, first);
  for (const TrialMeasure& number : analysis.numbers) {
    const auto rocks = std::count_if(first.rocks.begin(), first.rocks.end(), [&](const RockRecord& rock) {
      return number.group() < 0 || rock.group == number.group();
    });
    if (number.text().ends_with(".p95") &&
        rocks < static_cast<std::ptrdiff_t>(TrialMeasure::least_rocks_for_p95))
      throw InputError(fmt::format("{}: a trial has {} such rocks, p95 needs {}; expected .max or .mean",
                                   number.text(), rocks, TrialMeasure::least_rocks_for_p95));
  }
}

MakeWorker analysis_workers(LoadedScenario& loaded, const Analysis& analysis, const Request& request) {
  return [&](int thread) -> RunTrial {
    const auto own = std::make_shared<ReadAgain>();
    LuaSession* session = loaded.session.get();
    Plan* plan = &loaded.plan;
    if (thread > 0) {
      Diagnostics diagnostics;
      own->scenario =
          load_scenario(request.scenario, request.overrides, diagnostics, Prints::collected, &loaded);
      if (own->scenario) make_analysis(*own->scenario, *request.analysis);
      if (!own->scenario || own->scenario->hash != loaded.hash)
        throw FileError(
            fmt::format("{}, or a file that it names, was changed while the run started", request.scenario));
      session = own->scenario->session.get();
      plan = &own->scenario->plan;
    }
    session->collect_prints();
    own->runner = std::make_unique<ExchangedRunner>(*plan, analysis.tables);
    return [own, session](int point, std::uint64_t trial, TrialRecords& out) {
      own->runner->run(point, trial, out);
      return session->take_prints();
    };
  };
}

ExplainedVariance explain(const LoadedScenario& loaded, const Analysis& analysis,
                          std::vector<ChunkFile> files) {
  const Scenario& scenario = loaded.plan.points.front();
  ExplainedVariance found{.scenario = loaded.name,
                          .title = scenario.title,
                          .hash = loaded.hash,
                          .seed = scenario.streams.seed,
                          .trials = analysis.trials,
                          .inputs = analysis.inputs,
                          .numbers = {},
                          .line = analysis.line,
                          .moves_later = {},
                          .not_of_launch = inputs_not_of_launch(scenario)};
  const int points = static_cast<int>(analysis.tables.size());
  const std::vector<Rows> rows = rows_in(std::move(files), points, loaded.hash);
  std::vector<TrialMeasure> numbers = analysis.numbers;
  set_radii(scenario, rows.front(), analysis.trials, numbers);

  std::vector<ExchangedRuns> runs(numbers.size());
  std::map<int, InputValues> values;
  for (const TrialMeasure& number : numbers)
    values.try_emplace(number.group(), scenario, number.group(), analysis.trials);
  CountedRocks counted(scenario);
  for (int point = 0; point < points; ++point) {
    std::vector<std::vector<double>> of_trial;
    for (const TrialMeasure& number : numbers) of_trial.emplace_back(analysis.trials, number.without_rocks());
    rows[static_cast<std::size_t>(point)](point < 2 ? Part::whole : Part::brief,
                                          [&](const TrialRecords& chunk) {
                                            for (std::size_t n = 0; n < numbers.size(); ++n)
                                              numbers[n].add(chunk, of_trial[n]);
                                            if (point < 2)
                                              for (auto& [group, inputs] : values) inputs.add(point, chunk);
                                            if (point == 0) counted.add(chunk);
                                          });
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      if (point == 0)
        runs[n].a = std::move(of_trial[n]);
      else if (point == 1)
        runs[n].b = std::move(of_trial[n]);
      else
        runs[n].ab.push_back(std::move(of_trial[n]));
    }
  }
  found.moves_later = counted.names();
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    ExplainedNumber number{.of = numbers[n].text(),
                           .words = numbers[n].words(),
                           .unit = numbers[n].unit(),
                           .indices = sobol_indices(runs[n], found.seed),
                           .responses = {},
                           .made = {},
                           .made_of = {},
                           .map = {}};
    add_responses(scenario, analysis, values.at(numbers[n].group()), runs[n], found.seed, number);
    found.numbers.push_back(std::move(number));
  }
  return found;
}

int exit_code(const ExplainedVariance& found) {
  const bool is_lost = std::any_of(found.numbers.begin(), found.numbers.end(),
                                   [](const ExplainedNumber& number) { return number.indices.is_lost(); });
  return is_lost ? faults : done;
}

void write_analysis(const ExplainedVariance& found, const std::filesystem::path& folder, bool quiet) {
  write_file(folder / analysis_page, variance_page(found));
  write_file(folder / analysis_file, variance_data(found).dump(2) + "\n");
  if (quiet) return;
  for (const ExplainedNumber& number : found.numbers)
    for (const std::string& sentence : sentences_of(found, number)) fmt::print("{}\n", sentence);
  for (const std::string& remark : remarks_of(found)) fmt::print("{}\n", remark);
  fmt::print("page: {}\n", (folder / analysis_page).string());
}

}  // namespace flyrock::cli
