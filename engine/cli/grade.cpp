// flyrock grade: judges the scenarios of students by the expectations of a lab.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/labs.h"
#include "cli/limited_child.h"
#include "cli/loading.h"
#include "cli/terminal.h"
#include "document/printable.h"
#include "files/safe_file.h"
#include "report/tables/csv.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

constexpr double most_of_lab = 10;  // of its trials and of its time

/// What a lab asks for.
struct Task {
  std::string expect = "[]";  ///< the value of `--set expect=`
  std::vector<std::string> measures;
  double trials = 0;  ///< at all sweep points
  double time = 0;    ///< s, the greatest stop.time
};

double trials_asked(const Plan& plan) {
  return static_cast<double>(plan.points.front().trials_of_run()) * static_cast<double>(plan.points.size());
}

double time_asked(const Plan& plan) {
  double time = 0;
  for (const Scenario& point : plan.points) time = std::max(time, point.stop.time);
  return time;
}

/// Nothing if the lab cannot be read.
std::optional<Task> task_of(const Lab& lab) {
  const std::optional<LoadedScenario> loaded = load(lab.scenario().string(), {}, false);
  if (!loaded) return std::nullopt;
  Task task;
  task.trials = trials_asked(loaded->plan);
  task.time = time_asked(loaded->plan);
  const Value* expect = loaded->plan.resolved.find("expect");
  if (!expect) return task;
  task.expect = to_json(*expect, 0);
  for (const Value& one : *expect->list())
    if (const Value* measure = one.find("measure")) task.measures.push_back(*measure->text());
  return task;
}

/// The names of bodies and groups in a measure: "ball" of "body.ball.final.x", "a" and "b" of
/// "contact.a.b.gap".
std::vector<std::string> names_in(const std::string& measure) {
  std::istringstream text(measure);
  std::vector<std::string> steps;
  for (std::string step; std::getline(text, step, '.');) steps.push_back(step);
  const auto first = [&](std::size_t count) {
    return std::vector(steps.begin() + 1,
                       steps.begin() + 1 + static_cast<std::ptrdiff_t>(std::min(count, steps.size() - 1)));
  };
  if (steps.empty()) return {};
  if (steps[0] == "body" || steps[0] == "rocks") return first(1);
  return steps[0] == "contact" ? first(2) : std::vector<std::string>{};
}

/// What a student's scenario has that a run for this lab must not start with; empty: nothing.
std::string refusal_of(const Plan& plan, const Task& task) {
  std::vector<std::string> names = {"terrain"};
  for (const BodyPlan& body : plan.points.front().bodies) names.push_back(body.name);
  for (const RockGroup& group : plan.points.front().rocks) names.push_back(group.name);
  for (const std::string& measure : task.measures)
    for (const std::string& name : names_in(measure))
      if (std::find(names.begin(), names.end(), name) == names.end())
        return fmt::format("the lab calls this body `{}`, here is {}", name,
                           names.size() == 1
                               ? "no body"
                               : fmt::format("`{}`", fmt::join(names.begin() + 1, names.end(), "`, `")));
  if (trials_asked(plan) > most_of_lab * task.trials)
    return fmt::format("{:g} trials, expected at most {:g}: ten times those of the lab", trials_asked(plan),
                       most_of_lab * task.trials);
  if (time_asked(plan) > most_of_lab * task.time)
    return fmt::format("stop.time is {:g} s, expected at most {:g} s: ten times that of the lab",
                       time_asked(plan), most_of_lab * task.time);
  return "";
}

/// In the child: looks at a scenario before it runs it.
int judge_student(const std::string& student, const Task& task, const fs::path& folder) {
  static const Command command = {"run", "run SCENARIO [options]", "", run};
  {
    const Overrides without_expectations{.set = {"expect=[]"}, .confined = true};
    const std::optional<LoadedScenario> loaded = load(student, without_expectations, false);
    if (!loaded) return bad_input;
    if (const std::string refusal = refusal_of(loaded->plan, task); !refusal.empty()) {
      tell("{}: error: {}\n", student, refusal);
      return bad_input;
    }
  }
  return run(command, {student, "--confined", "--jobs", "1", "--set", "expect=" + task.expect, "-o",
                       folder.string(), "--force", "--quiet"});
}

struct Grade {
  std::string_view result;  ///< passed, failed or error
  std::string failed;       ///< the first reason, in words
};

/// The first line of a log that has an error, without the name of the file and the word.
std::string first_error(const fs::path& log) {
  std::istringstream text(read_file(log));
  for (std::string line; std::getline(text, line);) {
    const std::size_t at = line.find("error: ");
    if (at == std::string::npos) continue;
    std::string place = line.substr(0, at);  // "student.yaml:3:4: "
    const std::size_t colon = place.find(':');
    place = colon == std::string::npos || colon + 2 >= place.size() ? "" : "line " + place.substr(colon + 1);
    return printable(place + line.substr(at + 7), 300);
  }
  return "it could not be run";
}

/// "body.ball.final.x: expected 2 within 0.1, got 3"
std::string in_words(const nlohmann::json& verdict, bool has_points) {
  const auto& expected = verdict.at("expected");
  const std::string kind = verdict.at("kind");
  std::string wanted;
  if (kind == "between")
    wanted = fmt::format("from {} to {}", expected[0].dump(), expected[1].dump());
  else if (kind == "equals")
    wanted = fmt::format("{} within {}", expected.dump(), verdict.at("tolerance").dump());
  else
    wanted = kind + " " + expected.dump();
  const auto& point = verdict.at("point");
  std::string text =
      fmt::format("{}{}: expected {}, got {}", verdict.at("measure").get<std::string>(),
                  point.is_null() || !has_points ? "" : fmt::format(" at point {}", point.get<int>()), wanted,
                  verdict.at("computed").is_null() ? "nothing" : verdict.at("computed").dump());
  if (verdict.contains("reason")) text += " (" + verdict.at("reason").get<std::string>() + ")";
  return text;
}

/// The grade by the summary of a run.
Grade grade_of_results(const fs::path& folder) {
  const auto summary = nlohmann::json::parse(read_file(folder / "summary.json"));
  if (const auto& faults = summary.at("faults"); !faults.empty())
    return {"failed", printable(faults[0].at("text").get<std::string>(), 300)};
  const auto& verdicts = summary.at("expectations");
  for (const auto& verdict : verdicts)
    if (verdict.at("passed") != true) return {"failed", in_words(verdict, summary.at("points").size() > 1)};
  if (verdicts.empty()) return {"failed", "the lab expects nothing"};
  return {"passed", ""};
}

Grade grade_one(const std::string& student, const Task& task, const ChildLimits& limits,
                const fs::path& folder, double& seconds, bool& was_stopped) {
  fs::remove_all(folder);
  const fs::path log = folder.string() + ".txt";
  const ChildEnd end = run_limited(limits, log, folder, [&] { return judge_student(student, task, folder); });
  seconds = end.seconds;
  was_stopped = end.code == interrupted;
  if (!end.code) {
    fs::remove_all(folder);  // of no use, and large
    return {"error", end.why};
  }
  if (ended_without_results(*end.code, folder)) return {"error", first_error(log)};
  return grade_of_results(folder);
}

/// "3-an" of the third file, class/an.yaml: letters that every file system takes.
std::string own_folder_of(const std::string& student, std::size_t number) {
  constexpr std::size_t longest = 60;
  std::string stem = fs::path(student).stem().string().substr(0, longest);
  for (char& c : stem)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '.') c = '_';
  return fmt::format("{}-{}", number, stem);
}

}  // namespace

int grade(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("with", po::value<std::string>()->value_name("LAB"),
                        "the lab whose expectations are judged; `flyrock course --list` lists them")(
      "output,o", po::value<std::string>()->value_name("DIR"),
      "folder of the result folders, which are replaced; default out/grade")(
      "seconds", po::value<std::string>()->value_name("S"),
      "processor time that a file may take; default 60 s");
  const CommandLine line = parse(command, options, arguments, 1, 10000);
  if (line.help) return done;
  if (!line.has("with")) throw UsageError("expected --with LAB");
  ChildLimits limits;
  if (line.has("seconds"))
    limits.seconds = static_cast<unsigned>(
        std::min<std::uint64_t>(whole_number(line.text("seconds"), "--seconds", 1), 86400));
  const std::vector<Lab> list = labs();
  const std::optional<Task> task = task_of(lab_named(line.text("with"), list));
  if (!task) return bad_input;
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : fs::path("out/grade");
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) throw InputError(fmt::format("cannot make the folder {}: {}", folder.string(), fault.message()));
  fmt::print("file,result,failed\n");
  bool all_passed = true, any_ran = false;
  for (std::size_t i = 0; i < line.words.size(); ++i) {
    const std::string& student = line.words[i];
    const fs::path own = folder / own_folder_of(student, i + 1);
    double seconds = 0;
    bool was_stopped = false;
    const Grade found = grade_one(student, *task, limits, own, seconds, was_stopped);
    if (was_stopped) return interrupted;
    all_passed &= found.result == "passed";
    any_ran |= found.result != "error";
    fmt::print("{},{},{}\n", csv_text(student), found.result, csv_text(found.failed));
    std::fflush(stdout);
    const std::string name = printable(student, 200);
    if (found.result == "error") tell("{}: error: {}\n", name, found.failed);
    tell("{}: {:.1f} s of processor time\n", name, seconds);
  }
  if (all_passed) return done;
  return any_ran ? expectation_failed : bad_input;
}

}  // namespace flyrock::cli
