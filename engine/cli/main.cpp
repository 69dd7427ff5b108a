// flyrock: the program. One file a command; this one finds the command and turns exceptions into exit codes.

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <system_error>

#include "cli/command.h"
#include "solver/hdf5_file.h"
#include "units/units.h"

namespace flyrock::cli {

namespace {

constexpr std::array<Command, 10> commands = {{
    {"run", "run SCENARIO [options]", "runs a scenario and writes its tables and report", run},
    {"merge", "merge DIR... -o DIR", "puts the shards of a run together", merge},
    {"report", "report DIR", "builds report.html of a result folder again", report},
    {"export", "export DIR --to csv|vtk [-o PATH]", "writes a result as CSV tables or for ParaView", export_result},
    {"check", "check FILE [--strict]", "validates a scenario, or tries a plugin on sampled states", check},
    {"show", "show SCENARIO [--json]", "prints the resolved scenario: units converted, defaults filled in", show},
    {"plugins", "plugins [KIND[/NAME] | FILE] [--markdown | --json]", "lists what is registered, with its parameters", plugins},
    {"law", "law KIND/NAME|FILE [-o FILE] [--set PARAMETER=VALUE]...", "draws the graph of a contact law from solved contacts", law},
    {"verify", "verify [--data DIR] [--json]", "computes problems with known answers and compares", verify},
    {"solve", "solve PROBLEM.hdf5 [options]", "solves a friction problem in the layout of FCLIB", solve},
}};

void print_version() {
#ifdef NDEBUG
  const char* build = "release";
#else
  const char* build = "debug";
#endif
  fmt::print("flyrock {}\nbuild: {}, {}, C++{}\noptional parts: {}\n", FLYROCK_VERSION, build, "GCC " __VERSION__,
             __cplusplus / 100 % 100, has_hdf5() ? "HDF5" : "none");
}

void print_help() {
  fmt::print("flyrock simulates blast fly-rock and rockfall on quarry benches.\n\n");
  for (const Command& command : commands)
    fmt::print("  flyrock {}\n      {}\n", command.usage, command.summary);
  fmt::print("  flyrock --version\n      says version, build and optional parts\n\n");
  fmt::print(
      "flyrock COMMAND --help says more. Exit codes: 0 done, 1 an expectation failed,\n"
      "2 bad input (nothing was run), 3 faults while running, 130 interrupted.\n");
}

int usage_error(const std::string& text, const std::string& help) {
  fmt::print(stderr, "error: {}\nSee `{}`.\n", text, help);
  return bad_input;
}

int dispatch(const Arguments& arguments) {
  if (arguments.empty()) {
    print_help();
    return bad_input;
  }
  const std::string& word = arguments.front();
  if (word == "--version") {
    print_version();
    return done;
  }
  if (word == "--help" || word == "-h") {
    print_help();
    return done;
  }
  std::vector<std::string> names;
  for (const Command& command : commands) {
    names.emplace_back(command.name);
    if (word != command.name) continue;
    try {
      return command.call(command, Arguments(arguments.begin() + 1, arguments.end()));
    } catch (const InputError& error) {
      fmt::print(stderr, "error: {}\n", error.what());
      return bad_input;
    } catch (const UsageError& error) {
      return usage_error(error.what(), fmt::format("flyrock {} --help", command.name));
    }
  }
  const std::string near = nearest_name(word, names);
  return usage_error(fmt::format("unknown command `{}`{}", word, near.empty() ? "" : fmt::format(", did you mean `{}`?", near)),
                     "flyrock --help");
}

}  // namespace

}  // namespace flyrock::cli

int main(int count, char** words) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond a limit is an error like a full disk, not a sudden end
  try {
    const int code = flyrock::cli::dispatch({words + 1, words + count});
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
    return code;
  } catch (const std::exception& error) {
    // Bad input has been answered before: this is the machine (a full disk, no memory) or a fault of flyrock.
    std::cerr << "error: " << error.what() << '\n';
    return flyrock::cli::faults;
  }
}
