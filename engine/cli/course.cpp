// flyrock course: runs the labs of the course, all or one.

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "batch/safe_file.h"
#include "cli/labs.h"
#include "cli/loading.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

int run_lab(const Lab& lab, const fs::path& folder, const Arguments& more) {
  static const Command command = {"run", "run SCENARIO [options]", "", run};
  Arguments words = {lab.scenario().string(), "-o", folder.string()};
  words.insert(words.end(), more.begin(), more.end());
  return run(command, words);
}

/// Runs all labs into folders of their own, with a line for each.
int run_all(const std::vector<Lab>& list, const fs::path& folder, Arguments more) {
  more.push_back("--quiet");
  std::size_t passed = 0;
  for (const Lab& lab : list) {
    const auto begin = std::chrono::steady_clock::now();
    const int code = run_lab(lab, folder / lab.name, more);
    if (ended_without_results(code, folder / lab.name)) return code;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto [held, judged, not_judged] = verdicts_in(folder / lab.name);
    const bool good = code == done && held == judged && judged > 0;
    passed += good;
    fmt::print("{:<6} {:<24} {} of {} expectations, {:.1f} s\n", good ? "holds" : "FAILS", lab.name, held,
               judged + not_judged, seconds);
    std::fflush(stdout);
  }
  fmt::print("{} of {}\n", passed, list.size());
  return passed == list.size() ? done : expectation_failed;
}

/// Shows the page of a lab, runs it with more options, and says whether its expectations hold.
int run_one(const Lab& lab, const fs::path& folder, const Arguments& more) {
  fmt::print("{}\n", read_file(lab.page()));
  fmt::print("--- {}\n", lab.scenario().filename().string());
  std::fflush(stdout);
  const int code = run_lab(lab, folder, more);
  if (ended_without_results(code, folder)) return code;
  const auto [held, judged, not_judged] = verdicts_in(folder);
  fmt::print("question: {}\nverdict: {} of {} expectations hold", lab.question, held, judged);
  if (not_judged > 0) fmt::print(", {} need more trials and are not judged", not_judged);
  fmt::print("\n");
  fmt::print("to change it: flyrock course {} --set KEY=VALUE\n", lab.name);
  return code;
}

/// The options of the command line that a run takes too.
Arguments for_the_run(const CommandLine& line) {
  Arguments words;
  for (const char* option : {"set", "arg"})
    if (line.has(option))
      for (const std::string& value : line.options[option].as<Arguments>())
        words.insert(words.end(), {fmt::format("--{}", option), value});
  for (const char* option : {"seed", "trials"})
    if (line.has(option)) words.insert(words.end(), {fmt::format("--{}", option), line.text(option)});
  return words;
}

}  // namespace

int course(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("list", "lists the labs with their questions")(
      "output,o", po::value<std::string>()->value_name("DIR"),
      "result folder of the lab, or folder of the result folders of all labs; default out/course/LAB, where "
      "existing results are replaced");
  options.add_options()("force", "replaces the results in an existing folder")(
      "resume", "continues a run that was interrupted or killed");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  const std::vector<Lab> list = labs();
  if (line.has("list")) {
    for (const Lab& lab : list) fmt::print("{:>2}  {:<24} {}\n", lab.week, lab.name, lab.question);
    return done;
  }
  const fs::path usual = "out/course";
  Arguments more = for_the_run(line);
  if (line.words.empty() && !more.empty())
    throw UsageError(
        fmt::format("`{0}` needs the name of a lab: flyrock course LAB {0} {1}", more[0], more[1]));
  if (line.has("resume")) more.push_back("--resume");
  if (line.has("force") || (!line.has("output") && !line.has("resume"))) more.push_back("--force");
  if (line.words.empty())
    return run_all(list, line.has("output") ? fs::path(line.text("output")) : usual, more);
  const Lab& lab = lab_named(line.words[0], list);
  return run_one(lab, line.has("output") ? fs::path(line.text("output")) : usual / lab.name, more);
}

}  // namespace flyrock::cli
