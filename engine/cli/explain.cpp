// flyrock explain: the contact problem of one impact or step, as one would solve it by hand.

#include <fmt/format.h>

#include <filesystem>

#include "cli/explain_text.h"
#include "cli/loading.h"
#include "cli/runners.h"
#include "solver/hdf5_file.h"

namespace flyrock::cli {

namespace po = boost::program_options;

namespace {

ExplainRequest request_of(const CommandLine& line) {
  if (line.has("impact") == line.has("step")) throw UsageError("expected one of --impact N and --step N");
  const char* which = line.has("impact") ? "impact" : "step";
  return {line.has("impact"), whole_number(line.text(which), fmt::format("--{}", which), 1)};
}

/// An index below `count`.
std::uint64_t index_of(const CommandLine& line, const std::string& option, std::uint64_t count) {
  const std::uint64_t index = whole_number(line.text(option), "--" + option, 0);
  if (index >= count) throw UsageError(fmt::format("--{} is {}, expected 0 to {}", option, index, count - 1));
  return index;
}

void save(const Explanation& explanation, const std::string& file, const std::string& title) {
  if (explanation.contacts.empty()) throw InputError("there is no problem to save: nothing is in contact");
  std::visit([&](const auto& stored) { write_fclib(file, stored.problem, stored.start, title); },
             explanation.problem);
}

}  // namespace

int explain(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("impact", po::value<std::string>()->value_name("N"),
                        "the N-th impact of the trial, from 1")(
      "step", po::value<std::string>()->value_name("N"), "the N-th step of the trial, from 1")(
      "point", po::value<std::string>()->default_value("0")->value_name("P"), "sweep point")(
      "trial", po::value<std::string>()->default_value("0")->value_name("T"), "trial")(
      "json", "as JSON, with all sweeps")("save", po::value<std::string>()->value_name("FILE.hdf5"),
                                          "writes the problem in the layout of FCLIB, for `flyrock solve`");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const ExplainRequest request = request_of(line);
  if (line.has("save") && !has_hdf5())
    throw InputError("--save needs a flyrock that was built with HDF5 (Debian: libhdf5-dev)");
  std::optional<LoadedScenario> loaded = load(line.words[0], overrides_of(line), false);
  if (!loaded) return bad_input;
  const std::uint64_t point = index_of(line, "point", loaded->plan.points.size());
  const Scenario& scenario = loaded->plan.points[point];
  const std::uint64_t trial = index_of(line, "trial", scenario.trials);
  if (scenario.method != Method::nscd)
    throw InputError("its method has no contact problems: only `nscd` solves them");
  std::optional<Runners> runners = try_runners(*loaded, 1);
  if (!runners) return bad_input;

  Explainer explainer(request);
  (*runners)[point]->explain(trial, explainer);
  const char* kind = request.impact ? "impact" : "step";
  if (!explainer.found())
    throw UsageError(fmt::format(
        "--{} is {}, but trial {} has {}", kind, request.number, trial,
        explainer.seen() == 0 ? fmt::format("no {}", kind) : fmt::format("{} of them", explainer.seen())));
  const std::string title = fmt::format("{} {} of trial {} of {}", kind, request.number, trial,
                                        std::filesystem::path(line.words[0]).filename().string());
  if (line.has("save")) save(*explainer.found(), line.text("save"), title);
  if (line.has("json"))
    fmt::print("{}\n", json_of(*explainer.found()).dump(1));
  else
    fmt::print("{}", text_of(*explainer.found(), title));
  return done;
}

}  // namespace flyrock::cli
