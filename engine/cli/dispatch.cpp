#include "cli/dispatch.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "cli/terminal.h"
#include "document/odd_characters.h"
#include "document/printable.h"
#include "document/wording.h"
#include "files/safe_file.h"
#include "report/commit.h"
#include "solver/hdf5_file.h"
#include "survey/gdal_module.h"

namespace flyrock::cli {

namespace {

constexpr std::array<Command, 23> command_table = {{
    {"run", "run SCENARIO [options]", "runs a scenario and writes its tables and report", run},
    {"merge", "merge DIR... -o DIR", "puts the shards of a run together", merge},
    {"submit", "submit SCENARIO --slurm -n N [-j CORES] [-o DIR]",
     "writes the scripts that run a scenario in shards on a cluster, and merge them", submit},
    {"status", "status DIR", "says how far the shards of a folder are, and what runs the lost ones again",
     status},
    {"report", "report DIR [--against DIR] [--pdf]",
     "builds report.html of a result folder again, beside another run or as a PDF", report},
    {"calibrate", "calibrate SCENARIO --vary PATH=LOW:HIGH [options]",
     "fits numbers of a scenario to what was measured (`observed`)", calibrate},
    {"joints", "joints SURVEY.csv [--face DIP/DIRECTION --friction ANGLE] [options]",
     "finds the sets of a survey of joints, and which planes could let a face fail", joints},
    {"sensitivity", "sensitivity SCENARIO [--of MEASURE] [--inputs STREAM,...] [options]",
     "says which inputs explain the variance of a number (Sobol indices)", sensitivity},
    {"export", "export DIR --to csv|hdf5|vtk|gltf|obj|dxf|geojson|gpkg|asc|tif [-o PATH]",
     "writes a result as CSV tables, for ParaView, or as layers and maps for a GIS", export_result},
    {"animate", "animate DIR [-o FILE.svg|.mp4|.gif|.png] [--at TIME]",
     "draws the motion of the stored rocks as an animated picture, a film, or frame by frame", animate},
    {"check", "check FILE [--strict]", "validates a scenario, or tries a plugin on sampled states", check},
    {"show", "show SCENARIO [--json]", "prints the resolved scenario: units converted, defaults filled in",
     show},
    {"plugins", "plugins [KIND[/NAME] | FILE] [--markdown | --json | --svg]",
     "lists the plugins, or shows the parameters of one", plugins},
    {"law", "law KIND/NAME|FILE [-o FILE] [--set PARAMETER=VALUE]...",
     "draws the graph of a contact law from solved contacts", law},
    {"course", "course [LAB | --list] [options]", "runs the labs of the course on contact mechanics", course},
    {"grade", "grade STUDENT... --with LAB", "judges scenarios by the expectations of a lab", grade},
    {"new", "new [PATH] [-o DIR]", "copies a scenario, a lab or the template of a plugin to start from",
     new_file},
    {"verify", "verify [--data DIR] [--json]", "computes problems with known answers and compares", verify},
    {"explain", "explain SCENARIO --impact N | --step N [options]",
     "shows the contact problem of an impact or a step, and its solution sweep by sweep", explain},
    {"solve", "solve PROBLEM.hdf5 [options]", "solves a friction problem in the layout of FCLIB", solve},
    {"schema", "schema [--lua]", "prints the JSON Schema of scenarios, for editors", schema},
    {"completion", "completion bash|zsh", "prints the completion of commands for a shell", completion},
    {"man", "man [COMMAND]", "prints the manual page of flyrock or of a command", man},
}};

std::string optional_parts() {
  std::string parts;
  for (const auto& [is_there, name] : {std::pair{has_hdf5(), "HDF5"}, std::pair{has_gdal(), "GDAL"}})
    if (is_there) parts += (parts.empty() ? "" : ", ") + std::string(name);
  return parts.empty() ? "none" : parts;
}

void print_version() {
#ifdef NDEBUG
  const char* build = "release";
#else
  const char* build = "debug";
#endif
  const std::string commit = source_commit();
  fmt::print("flyrock {}{}\nbuild: {}, {}, C++{}\noptional parts: {}\n", FLYROCK_VERSION,
             commit.empty() ? "" : fmt::format(" (commit {})", commit), build, "GCC " __VERSION__,
             __cplusplus / 100 % 100, optional_parts());
}

void print_help() {
  fmt::print("flyrock simulates blast fly-rock and rockfall on quarry benches.\n\n");
  for (const Command& command : command_table)
    fmt::print("  flyrock {}\n      {}\n", command.usage, command.summary);
  fmt::print("  flyrock --version\n      says version, build and optional parts\n\n");
  fmt::print(
      "flyrock COMMAND --help says more. Exit codes: 0 done, 1 an expectation failed,\n"
      "2 bad input (nothing was run), 3 faults while running, 130 interrupted.\n");
}

/// In one line. The text may contain user input with line feeds, odd characters and bytes that are not UTF-8.
void print_error(const std::string& text) {
  const std::string hint = odd_character_hint(text);
  tell("error: {}{}\n", with_codes(printable(text, 2000)), hint.empty() ? hint : fmt::format(" ({})", hint));
}

int usage_error(const std::string& text, const std::string& help) {
  print_error(text);
  tell("See `{}`.\n", help);
  return bad_input;
}

/// What ended the program, without the wording of the library that threw it.
std::string said_by(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "not enough memory";
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return fmt::format("{}: {}", file->path1().string(), file->code().message());
  return error.what();
}

int call(const Arguments& arguments) {
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
  for (const Command& command : command_table) {
    names.emplace_back(command.name);
    if (word != command.name) continue;
    try {
      return command.call(command, Arguments(arguments.begin() + 1, arguments.end()));
    } catch (const InputError& error) {
      print_error(error.what());
      return bad_input;
    } catch (const UnreadableFile& error) {
      print_error(error.what());
      return bad_input;
    } catch (const UsageError& error) {
      return usage_error(error.what(), fmt::format("flyrock {} --help", command.name));
    }
  }
  return usage_error(fmt::format("unknown command `{}`{}", word, did_you_mean(word, names)),
                     "flyrock --help");
}

}  // namespace

std::span<const Command> all_commands() { return command_table; }

int dispatch(const Arguments& arguments) {
  try {
    const int code = call(arguments);
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
    return code;
  } catch (const std::exception& error) {
    // Bad input is handled above. This is a problem of the machine (a full disk, no memory) or a bug of
    // flyrock.
    print_error(said_by(error));
    return faults;
  }
}

}  // namespace flyrock::cli
