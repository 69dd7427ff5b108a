// flyrock grade: judges the scenarios of students by the expectations of a lab.

#include <fmt/format.h>

#include <filesystem>

#include "cli/labs.h"
#include "cli/loading.h"
#include "report/csv.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

/// The expectations of a lab as the value of `--set expect=`; nothing if the lab cannot be read.
std::optional<std::string> expectations_of(const Lab& lab) {
  const std::optional<LoadedScenario> loaded = load(lab.scenario().string(), {}, false);
  if (!loaded) return std::nullopt;
  const Value* expect = loaded->plan.resolved.find("expect");
  return expect ? to_json(*expect, 0) : "[]";
}

struct Grade {
  Verdicts verdicts;
  int code = done;  ///< of the run

  bool passed() const {
    return code == done && verdicts.judged > 0 && verdicts.held == verdicts.judged &&
           verdicts.not_judged == 0;
  }
  std::string_view result() const {
    if (code == bad_input) return "error";
    if (passed()) return "passed";
    return code == faults ? "faults" : "failed";
  }
};

Grade grade_one(const std::string& student, const std::string& expect, const fs::path& folder, bool quiet) {
  static const Command command = {"run", "run SCENARIO [options]", "", run};
  Arguments words = {student, "--set", "expect=" + expect, "-o", folder.string(), "--force"};
  if (quiet) words.push_back("--quiet");
  Grade grade;
  grade.code = run(command, words);
  if (!ended_without_results(grade.code, folder)) grade.verdicts = verdicts_in(folder);
  return grade;
}

}  // namespace

int grade(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("with", po::value<std::string>()->value_name("LAB"),
                        "the lab whose expectations are judged; `flyrock course --list` lists them")(
      "output,o", po::value<std::string>()->value_name("DIR"),
      "folder of the result folders, which are replaced; default out/grade");
  const CommandLine line = parse(command, options, arguments, 1, 10000);
  if (line.help) return done;
  if (!line.has("with")) throw UsageError("expected --with LAB");
  const std::vector<Lab> list = labs();
  const std::optional<std::string> expect = expectations_of(lab_named(line.text("with"), list));
  if (!expect) return bad_input;
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : fs::path("out/grade");
  const bool several = line.words.size() > 1;
  if (several) fmt::print("student,result,held,expectations\n");
  bool all_passed = true, any_read = false;
  for (std::size_t i = 0; i < line.words.size(); ++i) {
    const std::string& student = line.words[i];
    const fs::path own = folder / fmt::format("{}-{}", i + 1, fs::path(student).stem().string());
    const Grade found = grade_one(student, *expect, own, several);
    if (found.code == interrupted) return interrupted;
    all_passed &= found.passed();
    any_read |= found.code != bad_input;
    const std::size_t expectations = found.verdicts.judged + found.verdicts.not_judged;
    if (several)
      fmt::print("{},{},{},{}\n", csv_text(student), found.result(), found.verdicts.held, expectations);
    else if (found.code != bad_input)
      fmt::print("{}: {} of {} expectations of {} hold\n", found.result(), found.verdicts.held, expectations,
                 line.text("with"));
    std::fflush(stdout);
  }
  if (all_passed) return done;
  return any_read ? expectation_failed : bad_input;
}

}  // namespace flyrock::cli
