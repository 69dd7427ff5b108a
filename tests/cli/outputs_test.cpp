// What a run writes on stdout and stderr that are no terminal: a log, a closed file, a full disk.

#include <algorithm>
#include <chrono>

#include "same_result.h"

using namespace flyrock::test;

namespace outputs_test {

TEST_CASE("Outputs that are closed or full end no command with a signal, and no run without its result",
          "[slow]") {
  const Folder folder;
  folder.write("s.yaml", bench);
  folder.write("bad.yaml", "flyrock: 2\n");
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  struct Outputs {
    const char* redirections;
    bool lost;  ///< what the command prints on stdout
  };
  const Outputs all[] = {
      {"<&- >&- 2>&-", true},    {">&- 2>&-", true},     {">/dev/full 2>/dev/full", true},
      {">&- 2>/dev/full", true}, {">&-", true},          {">/dev/full", true},
      {"2>&-", false},           {"2>/dev/full", false},
  };
  for (const auto& [redirections, lost] : all) {
    INFO(redirections);
    const int printed = lost ? 3 : 0;
    const auto code_of = [&, redirections = redirections](const std::string& arguments) {
      return shell(folder, "'" FLYROCK_BINARY "' " + arguments + " " + redirections).code;
    };
    CHECK(code_of("run s.yaml --force -o r") == printed);
    check_same(folder, "whole", "r");
    CHECK(read(folder.path() / "r/report.html") == read(folder.path() / "whole/report.html"));
    CHECK(code_of("run s.yaml --force --quiet -o r") == 0);
    CHECK(code_of("check s.yaml") == printed);
    CHECK(code_of("show s.yaml") == printed);
    CHECK(code_of("--help") == printed);
    CHECK(code_of("check bad.yaml") == 2);
    CHECK(code_of("run nowhere.yaml") == 2);
    CHECK(code_of("run s.yaml -j abc") == 2);
    CHECK(code_of("nothing") == 2);
  }
}

TEST_CASE("In a log, a run writes its progress at tenths of the trials, at most once a second", "[slow]") {
  const Folder folder;
  folder.write("s.yaml", bench);
  CHECK(call(folder, "run s.yaml -o short").err.empty());
  double seconds = 0;
  for (int trials = 1000; seconds < 3; trials *= 2) {
    const auto start = std::chrono::steady_clock::now();
    const std::string all = std::to_string(trials);
    const Output run = call(folder, "run s.yaml --force -o r -j1 --trials " + all);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    INFO(run.err);
    REQUIRE(run.code == 0);
    CHECK(run.err.find_first_of("\r\033") == std::string::npos);
    const auto lines = std::count(run.err.begin(), run.err.end(), '\n');
    CHECK(lines <= std::min(10., seconds));
    if (seconds < 3) continue;
    CHECK(lines > 0);
    CHECK(run.err.find(" of " + all + " trials, ") != std::string::npos);
    CHECK(run.err.find(" left\n") != std::string::npos);
    CHECK(call(folder, "run s.yaml --force --quiet -o r -j1 --trials " + all).err.empty());
  }
}

TEST_CASE("SIGTERM interrupts a run as Ctrl-C does, and --resume goes on") {
  const Folder folder;
  folder.write("bench.yaml", bench);
  const Output ended = call_and_interrupt(folder, "bench.yaml", "out/bench/chunks/p0-c0.chunk", SIGTERM);
  CHECK(ended.code == 130);
  CHECK(ended.err.find("interrupted after ") != std::string::npos);
  CHECK(ended.err.find("what was done is kept in out/bench/chunks, --resume goes on\n") != std::string::npos);
  CHECK(folder.has("out/bench/chunks/p0-c0.chunk"));
  CHECK_FALSE(folder.has("out/bench/lock"));
}

}  // namespace outputs_test
