// flyrock course: runs the labs of the course, all or one.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>

#include "cli/labs.h"
#include "cli/loading.h"
#include "cli/terminal.h"
#include "files/safe_file.h"

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

/// How the run of a lab ended.
struct LabEnd {
  int code = done;
  double seconds = 0;
};

/// In a child process; ends it.
[[noreturn]] void be_lab(const Lab& lab, const fs::path& folder, const Arguments& more) {
  int code = faults;
  try {
    code = run_lab(lab, folder, more);
  } catch (const std::exception& error) {
    tell("{}: error: {}\n", lab.name, error.what());
  }
  std::fflush(nullptr);
  ::_exit(code);
}

/// Runs the labs in `jobs` processes at a time. Calls see(i, end) in the order of the list; it says whether
/// to go on.
void run_together(const std::vector<Lab>& list, const fs::path& folder, Arguments more, int jobs,
                  const std::function<bool(std::size_t, const LabEnd&)>& see) {
  using Clock = std::chrono::steady_clock;
  more.insert(more.end(), {"--jobs", "1"});
  std::map<pid_t, std::pair<std::size_t, Clock::time_point>> running;
  std::vector<std::optional<LabEnd>> ends(list.size());
  std::size_t started = 0, seen = 0;
  for (bool goes_on = true; !running.empty() || (goes_on && started < list.size());) {
    while (goes_on && started < list.size() && running.size() < static_cast<std::size_t>(jobs)) {
      std::fflush(nullptr);  // a child must not write what waits here
      const pid_t child = ::fork();
      if (child == 0) be_lab(list[started], folder / list[started].name, more);
      if (child < 0) throw std::runtime_error("no process can be made");
      running[child] = {started++, Clock::now()};
    }
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    const auto found = running.find(child);
    if (found == running.end()) continue;
    const auto& [lab, begin] = found->second;
    ends[lab] = LabEnd{WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(faults),
                       std::chrono::duration<double>(Clock::now() - begin).count()};
    running.erase(found);
    for (; goes_on && seen < list.size() && ends[seen]; ++seen) goes_on = see(seen, *ends[seen]);
  }
}

/// Runs all labs into folders of their own, with a line for each.
int run_all(const std::vector<Lab>& list, const fs::path& folder, Arguments more, int jobs) {
  more.push_back("--quiet");
  std::size_t passed = 0;
  int ended = done;  // early
  const auto see = [&](std::size_t i, const LabEnd& end) {
    const Lab& lab = list[i];
    if (ended_without_results(end.code, folder / lab.name)) {
      ended = end.code == done ? static_cast<int>(faults) : end.code;
      return false;
    }
    const auto [held, judged, not_judged] = verdicts_in(folder / lab.name);
    const bool good = end.code == done && held == judged && judged > 0;
    passed += good;
    fmt::print("{:<6} {:<24} {} of {} expectations, {:.1f} s\n", good ? "holds" : "FAILS", lab.name, held,
               judged + not_judged, end.seconds);
    std::fflush(stdout);
    return true;
  };
  run_together(list, folder, more, jobs, see);
  if (ended != done) return ended;
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
  options.add_options()("jobs,j", po::value<std::string>()->value_name("N"),
                        "labs that run at a time, default 1; threads of one lab");
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
  const int jobs = line.has("jobs") ? threads_of(line) : 1;
  if (line.has("jobs") && !line.words.empty()) more.insert(more.end(), {"--jobs", line.text("jobs")});
  if (line.has("resume")) more.push_back("--resume");
  if (line.has("force") || (!line.has("output") && !line.has("resume"))) more.push_back("--force");
  if (line.words.empty())
    return run_all(list, line.has("output") ? fs::path(line.text("output")) : usual, more, jobs);
  const Lab& lab = lab_named(line.words[0], list);
  return run_one(lab, line.has("output") ? fs::path(line.text("output")) : usual / lab.name, more);
}

}  // namespace flyrock::cli
