// flyrock calibrate: fits numbers of a scenario to what was measured.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "batch/runners.h"
#include "cli/loading.h"
#include "cli/terminal.h"
#include "document/wording.h"
#include "files/folder_lock.h"
#include "files/safe_file.h"
#include "files/sha256.h"
#include "flight/run.h"
#include "report/page/calibration_page.h"
#include "report/tables/calibration_data.h"
#include "results/compare/misfit.h"
#include "results/compare/simulate.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_varied = 3;

struct CalibrationJob {
  std::string scenario;
  Overrides overrides;
  std::vector<VariedNumber> varied;
  bool of_quantiles = false;
  std::string hold;
  fs::path folder;
  int threads = 1;
  int search_evaluations = 0;
  bool force = false, quiet = false;
};

po::options_description calibrate_options() {
  po::options_description options("options");
  options.add_options()("vary", po::value<std::vector<std::string>>()->value_name("PATH=LOW:HIGH"),
                        "a number of the scenario and its range; one to three times")(
      "statistic", po::value<std::string>()->value_name("energy|quantiles"),
      "what is made least; default energy")(
      "hold", po::value<std::string>()->value_name("GROUP|FILE"),
      "rows that are not fitted and judge the fit: a label of rows, another table of measured places "
      "(.csv), or another scenario with `observed`")(
      "output,o", po::value<std::string>()->value_name("DIR"),
      "folder of the results; default out/<scenario name>-calibration. Goes on where it was interrupted")(
      "evaluations", po::value<std::string>()->value_name("N"),
      "of the search after the grid; default 40 for each number");
  add_override_options(options);
  options.add_options()("jobs,j", po::value<std::string>()->value_name("N"), "threads; default all cores")(
      "force", "replaces the results in an existing folder")("quiet", "no progress and no summary");
  return options;
}

CalibrationJob read_calibration_job(const CommandLine& line) {
  CalibrationJob job;
  job.scenario = line.words[0];
  job.overrides = overrides_of(line);
  if (!line.has("vary")) throw UsageError("expected --vary PATH=LOW:HIGH");
  std::set<std::string> paths;
  for (const std::string& text : line.options["vary"].as<std::vector<std::string>>()) {
    std::string fault;
    const auto varied = read_varied(text, fault);
    if (!varied) throw UsageError(fmt::format("--vary `{}`: {}", text, fault));
    if (!paths.insert(varied->path).second)
      throw UsageError(fmt::format("--vary: {} is given twice", varied->path));
    job.varied.push_back(*varied);
  }
  if (job.varied.size() > most_varied)
    throw UsageError(
        fmt::format("--vary: {} numbers, at most {} can be fitted at once", job.varied.size(), most_varied));
  if (line.has("statistic")) {
    const std::string& name = line.text("statistic");
    if (name != "energy" && name != "quantiles")
      throw UsageError(fmt::format("--statistic: `{}`, expected energy or quantiles", name));
    job.of_quantiles = name == "quantiles";
  }
  if (line.has("hold")) job.hold = line.text("hold");
  if (line.has("hold") && job.hold.empty()) throw UsageError("--hold: expected a label of rows or a file");
  job.folder = line.has("output")
                   ? fs::path(line.text("output"))
                   : fs::path("out") / (fs::path(job.scenario).stem().string() + "-calibration");
  if (job.folder.empty()) throw UsageError("--output: expected a folder");
  job.threads = threads_of(line);
  constexpr int per_number = 40;
  job.search_evaluations = per_number * static_cast<int>(job.varied.size());
  if (line.has("evaluations"))
    job.search_evaluations = static_cast<int>(
        std::min<std::uint64_t>(whole_number(line.text("evaluations"), "--evaluations", 1), 100'000));
  job.force = line.has("force");
  job.quiet = line.has("quiet");
  return job;
}

bool is_file_of(const std::string& name, std::initializer_list<const char*> extensions) {
  const std::string extension = fs::path(name).extension().string();
  return std::any_of(extensions.begin(), extensions.end(), [&](const char* one) { return extension == one; });
}

/// The scenario at a point of the lattice.
Overrides overrides_at(const CalibrationJob& job, const LatticePoint& at) {
  Overrides overrides = job.overrides;
  for (std::size_t k = 0; k < job.varied.size(); ++k)
    overrides.set.push_back(job.varied[k].path + "=" +
                            job.varied[k].text_at(static_cast<double>(at[k]) / lattice));
  return overrides;
}

/// Its errors are those of the input, and are told.
LoadedScenario load_at(const std::string& path, const Overrides& overrides, const LoadedScenario* before) {
  Diagnostics diagnostics;
  auto loaded = load_scenario(path, overrides, diagnostics, Prints::collected, before);
  if (!loaded) throw InputError(diagnostics.to_text());
  return std::move(*loaded);
}

void require_comparable(const LoadedScenario& loaded, const std::string& path) {
  if (loaded.plan.points.size() > 1)
    throw InputError(fmt::format("{} has a sweep; --vary takes its place", path));
  if (!loaded.plan.points.front().observed)
    throw InputError(fmt::format("{} has no `observed`, with which it could be compared", path));
}

/// Which rows are fitted, and which are held back by their label.
struct RowSets {
  std::vector<std::size_t> fitted, held;
};

RowSets row_sets(const Scenario& scenario, const std::string& label) {
  RowSets sets;
  std::set<std::string> labels;
  const ObservedPlan& plan = *scenario.observed;
  for (std::size_t r = 0; r < plan.rows.size(); ++r) {
    const ObservedRow& row = plan.rows[r];
    const std::string group =
        row.rock_group < 0 ? "" : scenario.rocks[static_cast<std::size_t>(row.rock_group)].name;
    for (const std::string& name : {row.group, group})
      if (!name.empty()) labels.insert(name);
    const bool is_held = !label.empty() && (row.group == label || group == label);
    (is_held ? sets.held : sets.fitted).push_back(r);
  }
  if (!label.empty() && sets.held.empty())
    throw UsageError(fmt::format("--hold: no row has the label `{}`{}, and it is no file .csv, .yaml or .lua",
                                 label, did_you_mean(label, {labels.begin(), labels.end()})));
  if (sets.fitted.empty()) throw UsageError("--hold: holds back all rows, and leaves none to fit");
  return sets;
}

/// Evaluates points, and stores what was simulated: a search that was interrupted asks for the same points
/// again.
class StoredEvaluations {
 public:
  StoredEvaluations(const CalibrationJob& job, const LoadedScenario& base, std::vector<std::size_t> rows)
      : job_(job), base_(base), rows_(std::move(rows)), folder_(job.folder / "evaluations") {
    make_folder(folder_);
    in_plane_ = base.plan.points.front().observed->of == ObservedNumber::place;
  }

  Evaluation evaluate(const LatticePoint& at) {
    if (was_interrupted()) throw Interrupted{};
    const auto [pool, observed] = fitted_at(at);
    Evaluation evaluation;
    evaluation.energy = evaluation.misfit = lost_everything;
    if (!pool.empty() && !observed.empty()) {
      evaluation.energy = pool.energy_of(observed);
      evaluation.misfit = job_.of_quantiles ? pool.quantiles_of(observed) : evaluation.energy;
      evaluation.noise_p90 = SortedSample(pool.energies_of_draws(observed.size(), seed())).quantile(0.9);
      evaluation.table = pool.table();
    }
    ++done_;
    if (!job_.quiet && done_ % 10 == 0) tell("{} points evaluated, {} of them anew\n", done_, new_);
    return evaluation;
  }

  std::vector<std::vector<Vec2>> draws(const LatticePoint& at) {
    const auto [pool, observed] = fitted_at(at);
    return pool.drawn(observed.size(), seed());
  }

  std::size_t done() const { return done_; }

  /// What was simulated at a point.
  SimulatedRows rows_at(const LatticePoint& at) {
    const std::string key = key_of(at);
    const fs::path path = folder_ / (sha256(key).substr(0, 24) + ".rows");
    if (fs::exists(path))
      if (auto rows = restored(read_file(path), key)) return std::move(*rows);
    const SimulatedScenario scenario{job_.scenario, overrides_at(job_, at)};
    const LoadedScenario loaded = load_at(scenario.path, scenario.overrides, &base_);
    SimulatedRows rows = simulate(scenario, loaded, job_.threads, was_interrupted);
    write_file(path, stored(rows, key), Sync::no);
    ++new_;
    return rows;
  }

 private:
  /// A misfit above that of any model [m].
  static constexpr double lost_everything = 1e9;

  std::uint64_t seed() const { return base_.plan.points.front().streams.seed; }

  /// All trials of the rows of the fit at a point, and what was measured of these.
  std::pair<MisfitPool, std::vector<Vec2>> fitted_at(const LatticePoint& at) {
    const ObservedPlan& plan = *base_.plan.points.front().observed;
    const SimulatedRows simulated = rows_at(at);
    std::vector<const SimulatedRow*> pool_rows;
    std::vector<Vec2> observed;
    const std::vector<Vec2> all = observed_values(plan, simulated);
    for (const std::size_t r : rows_) {
      if (plan.is_paired()) pool_rows.push_back(&simulated.rows[r]);
      if (all[r].allFinite()) observed.push_back(all[r]);
    }
    if (!plan.is_paired()) pool_rows = {&simulated.rows.front()};
    return {MisfitPool(pool_rows, in_plane_, Censored::at_their_end), std::move(observed)};
  }

  std::string key_of(const LatticePoint& at) const {
    std::string key = base_.hash;
    for (std::size_t k = 0; k < at.size(); ++k)
      key += fmt::format(" {}={}", job_.varied[k].path,
                         job_.varied[k].text_at(static_cast<double>(at[k]) / lattice));
    return key;
  }

  const CalibrationJob& job_;
  const LoadedScenario& base_;
  const std::vector<std::size_t> rows_;
  const fs::path folder_;
  bool in_plane_ = false;
  std::size_t done_ = 0, new_ = 0;
};

/// The best point on what was held back.
void judge_held(const CalibrationJob& job, const LoadedScenario& base, const RowSets& sets,
                StoredEvaluations& evaluations, FittedModel& model) {
  if (job.hold.empty()) return;
  model.held_name = job.hold;
  const SimulatedRows best = evaluations.rows_at(model.calibration.best.at);
  const auto skill_for = [&](const ObservedPlan& plan, const SimulatedRows& simulated,
                             const std::vector<std::size_t>& rows) {
    return skill_of(measured_ways(plan, simulated, rows), simulated_ways(plan, simulated, rows),
                    measured_ways(model.observed, best, sets.fitted), plan.of == ObservedNumber::place,
                    model.seed);
  };
  if (!sets.held.empty()) {
    model.held_plan = model.observed;
    model.held = compare(model.observed, best, sets.held, model.seed);
    model.skill = skill_for(model.observed, best, sets.held);
    return;
  }
  SimulatedScenario other{job.scenario, overrides_at(job, model.calibration.best.at)};
  if (is_file_of(job.hold, {".csv"}))
    other.overrides.set.push_back("observed.file=" + nlohmann::json(fs::absolute(job.hold).string()).dump());
  else
    other.path = job.hold;
  const LoadedScenario loaded =
      load_at(other.path, other.overrides, other.path == job.scenario ? &base : nullptr);
  require_comparable(loaded, other.path);
  const Scenario& scenario = loaded.plan.points.front();
  model.held_plan = scenario.observed;
  const SimulatedRows simulated = simulate(other, loaded, job.threads, was_interrupted);
  std::vector<std::size_t> rows(scenario.observed->rows.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  model.held = compare(*scenario.observed, simulated, rows, model.seed);
  model.skill = skill_for(*scenario.observed, simulated, rows);
}

/// Refuses a folder of something else; a calibration of the same scenario goes on.
void open_calibration(const CalibrationJob& job) {
  const fs::path& folder = job.folder;
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (error && status.type() != fs::file_type::not_found)
    throw InputError(fmt::format("{}: {}", folder.string(), error.message()));
  if (fs::exists(status) && !fs::is_directory(status))
    throw InputError(fmt::format("{} is no folder", folder.string()));
  try {
    make_folder(folder);
  } catch (const FileError& fault) {
    throw InputError(fault.what());
  }
  if (job.force) {
    for (const char* name : {"calibration.json", "calibration.html", "evaluations.csv", "fitted.yaml"})
      fs::remove(folder / name);
    fs::remove_all(folder / "evaluations");
  } else if (fs::exists(folder / "calibration.json")) {
    throw UsageError(fmt::format("{} holds a finished calibration; --force replaces it", folder.string()));
  } else if (!fs::is_empty(folder) && !fs::exists(folder / "evaluations")) {
    throw UsageError(
        fmt::format("{} is not empty and holds no calibration; --force writes into it", folder.string()));
  }
}

/// Fails early where an end of a range, or a file that is held back, cannot be used.
void check_ends(const CalibrationJob& job, const LoadedScenario& base) {
  for (const int place : {0, lattice}) {
    const LatticePoint corner(job.varied.size(), place);
    LoadedScenario loaded = load_at(job.scenario, overrides_at(job, corner), &base);
    Diagnostics diagnostics;
    constexpr std::uint64_t tried = 3;
    flyrock::try_runners(loaded, tried, diagnostics);
    if (diagnostics.has_errors()) throw InputError(diagnostics.to_text());
  }
  if (job.hold.empty() || !is_file_of(job.hold, {".csv", ".yaml", ".yml", ".lua"})) return;
  if (!fs::is_regular_file(job.hold)) throw UsageError(fmt::format("--hold: there is no file {}", job.hold));
  if (is_file_of(job.hold, {".csv"})) {
    Overrides overrides = job.overrides;
    overrides.set.push_back("observed.file=" + nlohmann::json(fs::absolute(job.hold).string()).dump());
    load_at(job.scenario, overrides, &base);
  } else {
    require_comparable(load_at(job.hold, overrides_at(job, LatticePoint(job.varied.size(), 0)), nullptr),
                       job.hold);
  }
}

void write_calibration(const CalibrationJob& job, const LoadedScenario& base, const FittedModel& model) {
  const LoadedScenario best = load_at(job.scenario, overrides_at(job, model.calibration.best.at), &base);
  const fs::path& folder = job.folder;
  write_file(folder / "evaluations.csv", evaluations_csv(model));
  write_file(folder / "fitted.yaml",
             fitted_scenario(model, best, fs::path(job.scenario).parent_path(), folder));
  write_file(folder / "calibration.html", calibration_page(model));
  write_file(folder / "calibration.json", calibration_data(model).dump(2) + "\n");
  fs::remove_all(folder / "evaluations");
}

int carry_out_calibration(const CalibrationJob& job, const LoadedScenario& base, const RowSets& sets) {
  catch_interrupt();
  const FolderLock lock(job.folder);
  StoredEvaluations evaluations(job, base, sets.fitted);
  FittedModel model;
  try {
    const Scenario& scenario = base.plan.points.front();
    model.varied = job.varied;
    model.statistic = job.of_quantiles ? "quantiles" : "energy";
    model.scenario = fs::path(job.scenario).filename().string();
    model.scenario_hash = base.hash;
    model.observed = *scenario.observed;
    model.trials = scenario.trials;
    model.seed = scenario.streams.seed;
    const CalibratedModel calibrated{
        .evaluate = [&](const LatticePoint& at) { return evaluations.evaluate(at); },
        .draws = [&](const LatticePoint& at) { return evaluations.draws(at); }};
    model.calibration = flyrock::calibrate(job.varied.size(), calibrated, job.search_evaluations);
    model.fitted = compare(model.observed, evaluations.rows_at(model.calibration.best.at), sets.fitted,
                           scenario.streams.seed);
    judge_held(job, base, sets, evaluations, model);
  } catch (const Interrupted&) {
    tell("interrupted after {} points, which are kept in {}; the same command goes on\n", evaluations.done(),
         job.folder.string());
    return interrupted;
  }
  write_calibration(job, base, model);
  if (!job.quiet) {
    for (const std::string& sentence : calibration_sentences(model)) fmt::print("{}\n", sentence);
    fmt::print("page: {}\n", (job.folder / "calibration.html").string());
  }
  return model.calibration.any_on_bound() ? expectation_failed : done;
}

}  // namespace

int calibrate(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, calibrate_options(), arguments, 1, 1);
  if (line.help) return done;
  const CalibrationJob job = read_calibration_job(line);
  const std::optional<LoadedScenario> base = load(job.scenario, job.overrides, false);
  if (!base) return bad_input;
  require_comparable(*base, job.scenario);
  const Scenario& scenario = base->plan.points.front();
  if (base->defines_plugins)
    throw InputError(
        fmt::format("{} defines plugins, which fitted.yaml cannot; move them to a file that "
                    "`plugins` names",
                    job.scenario));
  if (job.of_quantiles && scenario.observed->of == ObservedNumber::place)
    throw UsageError("--statistic quantiles compares numbers, expected `of: runout` or `of: distance`");
  const bool by_label = !job.hold.empty() && !is_file_of(job.hold, {".csv", ".yaml", ".yml", ".lua"});
  const RowSets sets = row_sets(scenario, by_label ? job.hold : "");
  try {
    check_ends(job, *base);
  } catch (const InputError& error) {
    tell("{}", error.what());
    return bad_input;
  }
  open_calibration(job);
  return carry_out_calibration(job, *base, sets);
}

}  // namespace flyrock::cli
