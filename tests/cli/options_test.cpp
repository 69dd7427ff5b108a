// Every option of every command with values that are none, taken from the help that the program prints.

#include <catch2/catch.hpp>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

using namespace flyrock::test;

namespace options_test {

namespace {

/// So long that a text of it has memory of its own, whose double release ends the program.
const std::string scenario = "a_scenario_with_a_long_name.yaml";

/// How a command is called soundly: its words, and the options that it needs. Both are shell words.
struct Sound {
  std::string words;
  std::vector<std::pair<std::string, std::string>> needed = {};  ///< option without dashes, value
};

const std::map<std::string, Sound>& sound_calls() {
  static const std::map<std::string, Sound> calls = {
      {"run", {scenario + " --quiet", {{"set", "stop.time=20"}}}},
      {"merge", {"shard-1 shard-2 --quiet", {{"output", "merged"}}}},
      {"report", {"r"}},
      {"export", {"r", {{"to", "csv"}}}},
      {"animate", {"r"}},
      {"check", {scenario}},
      {"show", {scenario}},
      {"plugins", {""}},
      {"law", {"restitution/newton"}},
      {"course", {"signorini_coulomb"}},
      {"grade", {FLYROCK_SOURCE_DIR "/scenarios/course/bouncing_ball.yaml", {{"with", "bouncing_ball"}}}},
      {"new", {"restitution"}},
      {"submit", {scenario + " --slurm", {{"shards", "2"}}}},
      {"status", {"shard-1"}},
      {"schema", {""}},
      {"completion", {"bash"}},
      {"man", {"run"}},
      {"calibrate", {"fit.yaml --quiet --force", {{"vary", "rocks.r.launch.speed=5:15"}}}},
      {"verify", {""}},
      {"explain", {scenario, {{"impact", "1"}}}},
      {"solve", {"p.hdf5"}},
      {"sensitivity", {scenario + " --number 8 --quiet --force"}},
      {"joints", {"survey.csv"}},
  };
  return calls;
}

const std::vector<std::string>& bad_values() {
  static const std::vector<std::string> values = {
      "",
      "abc",
      "-2",
      "0",
      "1e9",
      "nan",
      "99999999999999999999",
      std::string(5000, 'x'),
      "no/such/path",
      "some_file",
      "/dev/null/x",
      "r\u00f6ck \u2744 \u2212 5",
      "\x01\xff\n",
      "a=b",
      "2/1",
      "=",
  };
  return values;
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The commands in the program's help: "  flyrock run SCENARIO [options]".
std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(help)) {
    if (!line.starts_with("  flyrock ") || line.starts_with("  flyrock --")) continue;
    commands.push_back(line.substr(10, line.find(' ', 10) - 10));
  }
  return commands;
}

/// The options that take a value, in the help of a command: "  -o [ --output ] DIR       result folder".
std::vector<std::string> options_with_value(const std::string& help) {
  const std::vector<std::string> lines = lines_of(help);
  std::size_t text_column = 0;
  for (const std::string& line : lines)
    if (line.starts_with("  -h [ --help ]")) text_column = line.find("this text");
  std::vector<std::string> options;
  for (const std::string& line : lines) {
    const std::string left = line.substr(0, text_column);
    const std::size_t dashes = left.find("--");
    if (!line.starts_with("  -") || dashes == std::string::npos) continue;
    const std::size_t end = left.find_first_of(" ", dashes);
    const std::size_t value = left.find_first_not_of(" ]", end);
    if (value != std::string::npos) options.push_back(left.substr(dashes + 2, end - dashes - 2));
  }
  return options;
}

/// The arguments of a sound call, except that `option` has the value.
std::string arguments_of(const std::string& command, const std::string& option, const std::string& value) {
  const Sound& sound = sound_calls().at(command);
  std::string arguments = command + " " + sound.words + " " + quoted("--" + option + "=" + value);
  for (const auto& [name, given] : sound.needed)
    if (name != option) arguments += " --" + name + "=" + given;
  return arguments;
}

/// Either the value has a meaning, or it is bad input that the message explains. A file that cannot be
/// written is a fault of the machine: exit code 3.
void check_answer(const Folder& folder, const std::string& arguments, bool names_output) {
  const Output output = shell(folder, "timeout 60 '" FLYROCK_BINARY "' " + arguments + " </dev/null");
  INFO(arguments.substr(0, 200) << "\nexit code " << output.code << "\n" << output.err.substr(0, 2000));
  const bool not_written = names_output && output.code == 3 && output.err.starts_with("error: cannot ");
  CHECK((output.code == 0 || output.code == 2 || not_written));
  CHECK((output.err.find("error: ") != std::string::npos) == (output.code != 0));
  CHECK(output.err.find("runtime error") == std::string::npos);  // a sanitizer's
  for (const char* word : {"std::", "basic_string", "json.exception", "boost", "stoi", "stod", "HDF5-DIAG"})
    CHECK(output.err.find(word) == std::string::npos);
}

/// A folder with what the sound calls read.
void fill(const Folder& folder) {
  folder.write("some_file", "neither a scenario nor a plugin\n");
  folder.write("survey.csv", "dip,dip_direction\n60,90\n62,95\n58,88\n30,200\n33,205\n28,196\n");
  folder.write(scenario, bench_with("trials: 4", "trials: 2"));
  REQUIRE(call(folder, "run " + scenario + " --quiet -o r").code == 0);
  for (const std::string shard : {"1", "2"})
    REQUIRE(
        call(folder, "run " + scenario + " --quiet -o shard-" + shard + " --shard " + shard + "/2").code ==
        0);
  folder.write("stops.csv", "distance\n9\n10\n11\n");
  folder.write(
      "fit.yaml",
      "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 2\n"
      "terrain: { type: profile, points: [[-10, 0], [500, 0]] }\n"
      "rocks: [{ name: r, mass: 1, shape: { type: disk, radius: 0.1 }, release: { position: [0, 0.1] }, "
      "launch: { type: fixed, speed: 9, elevation: 45 deg } }]\n"
      "observed: { file: stops.csv, of: distance }\nstop: { time: 30 s }\n");
  call(folder,
       "explain " + scenario + " --impact 1 --save p.hdf5");  // without HDF5 `solve` refuses every file
}

}  // namespace

TEST_CASE("Every option of every command takes or explains each of some bad values", "[heavy]") {
  const Folder folder;
  fill(folder);
  int tried = 0;
  for (const std::string& command : commands_of(call(folder, "--help").out)) {
    INFO(command);
    REQUIRE(sound_calls().count(command) == 1);  // a new command says here how it is called soundly
    for (const std::string& option : options_with_value(call(folder, command + " --help").out))
      for (const std::string& value : bad_values()) {
        if (command == "course" && option == "output" && value != "/dev/null/x") continue;  // runs the lab
        const bool names_output = option == "output" || option == "save" || option == "routh";
        check_answer(folder, arguments_of(command, option, value), names_output);
        ++tried;
      }
  }
  CHECK(tried > 400);
}

TEST_CASE("Every command takes or explains each of some bad values in place of its word", "[slow]") {
  const Folder folder;
  fill(folder);
  for (const std::string& command : commands_of(call(folder, "--help").out))
    for (const std::string& value : bad_values()) {
      std::string arguments = command + " -- " + quoted(value);
      for (const auto& [name, given] : sound_calls().at(command).needed)
        arguments.insert(command.size(), " --" + name + "=" + given);
      check_answer(folder, arguments, false);
    }
}

}  // namespace options_test
