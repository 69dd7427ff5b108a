// flyrock course: runs the labs of the course, all or one.

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "batch/safe_file.h"
#include "cli/command.h"
#include "document/wording.h"
#include "host/share.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct Lab {
  std::string week, name, question;

  fs::path page() const { return fs::path(share_folder()) / "course" / (name + ".md"); }
  fs::path scenario() const {
    const fs::path stem = fs::path(share_folder()) / "scenarios" / "course" / name;
    return fs::exists(stem.string() + ".lua") ? stem.string() + ".lua" : stem.string() + ".yaml";
  }
};

/// The rows of the table in the course's README: `| 1 | [name](name.md) | question |`.
std::vector<Lab> labs() {
  static const std::regex row(R"(\| *(\d+) *\| *\[[^\]]*\]\((\w+)\.md\) *\| *(.*?) *\|)");
  std::istringstream text(read_file(fs::path(share_folder()) / "course" / "README.md"));
  std::vector<Lab> list;
  std::smatch found;
  for (std::string line; std::getline(text, line);)
    if (std::regex_match(line, found, row)) list.push_back({found[1], found[2], found[3]});
  return list;
}

/// How many expectations of a result passed, and how many it has.
std::pair<std::size_t, std::size_t> judged(const fs::path& folder) {
  const auto summary = nlohmann::json::parse(read_file(folder / "summary.json"));
  std::size_t held = 0, all = 0;
  for (const auto& expectation : summary.at("expectations")) {
    ++all;
    held += expectation.at("passed").get<bool>();
  }
  return {held, all};
}

int run_lab(const Lab& lab, const fs::path& folder, const Arguments& more) {
  static const Command command = {"run", "run SCENARIO [options]", "", run};
  Arguments words = {lab.scenario().string(), "-o", folder.string(), "--force"};
  words.insert(words.end(), more.begin(), more.end());
  return run(command, words);
}

/// Runs all labs, with a line for each.
int run_all(const std::vector<Lab>& list, const fs::path& folder) {
  std::size_t passed = 0;
  for (const Lab& lab : list) {
    const auto begin = std::chrono::steady_clock::now();
    const int code = run_lab(lab, folder / lab.name, {"--quiet"});
    if (code == bad_input || code == interrupted) return code;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto [held, all] = judged(folder / lab.name);
    const bool good = code == done && held == all && all > 0;
    passed += good;
    fmt::print("{:<6} {:<24} {} of {} expectations, {:.1f} s\n", good ? "holds" : "FAILS", lab.name, held,
               all, seconds);
    std::fflush(stdout);
  }
  fmt::print("{} of {}\n", passed, list.size());
  return passed == list.size() ? done : expectation_failed;
}

/// Shows the page of a lab, runs it with `changes` (path=value), and says whether its expectations hold.
int run_one(const Lab& lab, const fs::path& folder, const Arguments& changes) {
  fmt::print("{}\n", read_file(lab.page()));
  fmt::print("--- {}\n", lab.scenario().filename().string());
  std::fflush(stdout);
  Arguments sets;
  for (const std::string& change : changes) sets.insert(sets.end(), {"--set", change});
  const int code = run_lab(lab, folder / lab.name, sets);
  if (code == bad_input || code == interrupted) return code;
  const auto [held, all] = judged(folder / lab.name);
  fmt::print("question: {}\nverdict: {} of {} expectations hold\n", lab.question, held, all);
  fmt::print("to change it: flyrock course {} --set KEY=VALUE\n", lab.name);
  return code;
}

}  // namespace

int course(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("list", "lists the labs with their questions")(
      "output,o", po::value<std::string>()->default_value("out/course")->value_name("DIR"),
      "folder of the results, a folder for each lab; existing results are replaced")(
      "set", po::value<Arguments>()->composing()->value_name("path=value"),
      "sets a value of the lab's scenario; may be given several times");
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  const std::vector<Lab> list = labs();
  if (line.has("list")) {
    for (const Lab& lab : list) fmt::print("{:>2}  {:<24} {}\n", lab.week, lab.name, lab.question);
    return done;
  }
  const fs::path folder = line.text("output");
  const Arguments changes = line.has("set") ? line.options["set"].as<Arguments>() : Arguments{};
  if (line.words.empty()) {
    if (!changes.empty())
      throw UsageError("`--set` needs the name of a lab: flyrock course LAB --set path=value");
    return run_all(list, folder);
  }
  std::vector<std::string> names;
  for (const Lab& lab : list) {
    if (lab.name == line.words[0]) return run_one(lab, folder, changes);
    names.push_back(lab.name);
  }
  throw UsageError(fmt::format("unknown lab `{}`{}", line.words[0], suggestion(line.words[0], names)));
}

}  // namespace flyrock::cli
