// flyrock_fuzz: tries mutants of every kind of input against the commands that read it. CONTRIBUTING.md says
// how to read what it prints.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "fuzz.h"
#include "units/units.h"

namespace {

namespace po = boost::program_options;
using namespace flyrock;
using namespace flyrock::fuzz;

constexpr cli::Command self = {"fuzz", "fuzz [options]", "tries mutants of every kind of input", nullptr};

po::options_description fuzz_options() {
  po::options_description options("options");
  options.add_options()("seconds", po::value<std::string>()->default_value("60")->value_name("S"),
                        "for all kinds together")("mutants", po::value<std::string>()->value_name("N"),
                                                  "so many, in place of --seconds")(
      "seed", po::value<std::string>()->default_value("1")->value_name("S"), "of the mutants")(
      "kind", po::value<std::string>()->value_name("K"),
      "only yaml, lua, plugin, chunk, hdf5, result, arguments, scenes, terrain, tables, sheets or layers")(
      "number", po::value<std::string>()->value_name("N"),
      "with --kind: one mutant, in this process; its files stay")(
      "output,o", po::value<std::string>()->default_value("out/fuzz")->value_name("DIR"), "what was found");
  return options;
}

const KindEntry& kind_of(const std::string& name) {
  for (const KindEntry& kind : kinds)
    if (kind.name == name) return kind;
  throw cli::UsageError("--kind: unknown kind " + name);
}

FuzzSettings settings_of(const cli::CommandLine& line) {
  FuzzSettings settings;
  settings.seed = cli::whole_number(line.text("seed"), "--seed", 0);
  settings.seconds = static_cast<double>(cli::whole_number(line.text("seconds"), "--seconds", 1));
  if (line.has("mutants")) settings.mutants = cli::whole_number(line.text("mutants"), "--mutants", 1);
  if (line.has("kind")) settings.kind = kind_of(line.text("kind")).name;
  settings.findings = std::filesystem::absolute(line.text("output"));
  return settings;
}

int run(const cli::CommandLine& line) {
  const FuzzSettings settings = settings_of(line);
  if (line.has("number")) {
    if (settings.kind.empty()) throw cli::UsageError("--number: expected --kind, too");
    run_one(kind_of(settings.kind), settings.seed, cli::whole_number(line.text("number"), "--number", 0));
    return 0;
  }
  const std::vector<KindTally> tallies = flyrock::fuzz::fuzz(settings);
  fmt::print("seed {}\n{}", settings.seed, table_of(tallies));
  if (sum_of(tallies).findings() == 0) return 0;
  fmt::print("{} lists what was found, the mutants are beside it\n",
             (settings.findings / "findings.txt").string());
  return 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    const cli::CommandLine line = cli::parse(self, fuzz_options(), {words + 1, words + count}, 0, 0);
    return line.help ? 0 : run(line);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
