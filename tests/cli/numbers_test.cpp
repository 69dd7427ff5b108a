// Every number of the course's pages and solutions has a source, and is what the source gives, to its last
// digit.
//
// A page's file numbers/<page>.txt (solutions: numbers/solutions/<page>.txt) has, line by line,
//   = 4.2835 math.sqrt(20/9.81) * 3        a formula in Lua
//   run --set materials.floor.restitution.en=0.9    the page's scenario with options; below it, what it
//   gives:
//     27.129 body.ball.stop_time            a measure; a unit may follow the number: 2.79 ms
//     0.71 body.block.final.vx | at: { materials.rock.friction.mu: 0.2 }
//   run of waves --arg exponent=1          the same of another lab's scenario
//   given 0.9 20                            numbers that the page chooses, in the text of an exercise or an
//   estimate unchecked 1714 sweeps of a command      numbers that nothing here gives, and why
// Whole numbers up to 12 are counts and numerators. A number of the scenario, its expectations among them,
// needs no line: the scenario is run by other tests.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "program.h"

using namespace flyrock::test;

namespace numbers_test {

namespace {

constexpr const char* course = FLYROCK_SOURCE_DIR "/docs/course";
const std::regex number_text(R"((-?\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w]))");

/// Half a unit of the last digit of a number as it is written: 0.5e-3 of "4.123".
double half_digit(const std::string& text) {
  const std::size_t e = text.find('e'), dot = text.find('.');
  const int exponent = e == std::string::npos ? 0 : std::stoi(text.substr(e + 1));
  const std::size_t end = e == std::string::npos ? text.size() : e;
  const int decimals = dot == std::string::npos ? 0 : static_cast<int>(end - dot) - 1;
  return 0.5 * std::pow(10.0, exponent - decimals);
}

bool is_count(const std::string& text) {
  return text.find_first_of(".e") == std::string::npos && std::abs(std::stod(text)) <= 12;
}

/// Whether a value is written as this number, of either sign: pages say "comes back at 0.4".
bool is_written_as(double value, const std::string& text) {
  return std::abs(std::abs(value) - std::abs(std::stod(text))) <= half_digit(text) * (1 + 1e-6);
}

/// Without its sign: pages say "comes back at 0.4".
std::string unsigned_text(const std::string& number) { return number[0] == '-' ? number.substr(1) : number; }

std::vector<std::string> numbers_of(const std::string& text) {
  std::vector<std::string> numbers;
  for (std::sregex_iterator at(text.begin(), text.end(), number_text), end; at != end; ++at) {
    const auto before = at->position() == 0 ? ' ' : text[static_cast<std::size_t>(at->position()) - 1];
    if (std::isalnum(static_cast<unsigned char>(before)) || before == '.' || before == '_') continue;
    numbers.push_back((*at)[1]);
  }
  return numbers;
}

/// The text of a page without code, addresses of links and the numbers of its lists.
std::string prose_of(const std::string& page) {
  std::string text = std::regex_replace(page, std::regex("```[^]*?```"), "");
  text = std::regex_replace(text, std::regex("`[^`]*`"), "");
  text = std::regex_replace(text, std::regex(R"(\]\([^)]*\))"), "]");
  return std::regex_replace(text, std::regex("(^|\n)\\d+\\. "), "\n");
}

std::string scenario_of(const std::string& page) {
  const std::string stem = FLYROCK_SOURCE_DIR "/scenarios/course/" + page;
  for (const char* ending : {".yaml", ".lua"})
    if (fs::exists(stem + ending)) return stem + ending;
  return "";
}

struct Measured {
  std::string number, unit, measure, rest;
};
struct ScenarioRun {
  std::string lab;  ///< empty: that of the page
  std::string options;
  std::vector<Measured> measured;
};
struct Sources {
  std::vector<std::pair<std::string, std::string>> formulas;  ///< number, expression
  std::vector<ScenarioRun> runs;
  std::set<std::string> numbers;  ///< all of them, without signs

  void add(const std::string& number) { numbers.insert(unsigned_text(number)); }
};

Sources sources_in(const std::string& text) {
  Sources sources;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string first, word;
    words >> first;
    if (first == "=") {
      std::string number, formula;
      words >> number;
      std::getline(words, formula);
      sources.formulas.emplace_back(number, formula);
      sources.add(number);
    } else if (first == "run") {
      std::string lab, options = line.substr(3);
      if (options.starts_with(" of ")) {
        lab = options.substr(4, options.find(' ', 4) - 4);
        options = options.substr(4 + lab.size());
      }
      sources.runs.push_back({lab, options, {}});
    } else if (first == "given") {
      while (words >> word) sources.add(word);
    } else if (first == "unchecked") {
      for (const std::string& number : numbers_of(line)) sources.add(number);
    } else {
      Measured measured{first, "", "", ""};
      words >> word;
      const bool has_unit = word.find('.') == std::string::npos;
      if (has_unit) {
        measured.unit = " " + word;
        words >> word;
      }
      const std::size_t from = line.find(word, line.find(first) + first.size() + measured.unit.size());
      const std::size_t bar = line.find(" |");
      measured.measure = line.substr(from, bar == std::string::npos ? bar : bar - from);  // "...at[0.1 s]"
      if (bar != std::string::npos) measured.rest = "," + line.substr(bar + 2);
      REQUIRE(!sources.runs.empty());
      sources.runs.back().measured.push_back(measured);
      sources.add(first);
    }
  }
  return sources;
}

std::vector<std::string> pages() {
  std::vector<std::string> names;
  for (const char* folder : {"", "solutions/"})
    for (const auto& entry : fs::directory_iterator(course + std::string("/") + folder))
      if (entry.path().extension() == ".md") names.push_back(folder + entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string stem_of(const std::string& page) { return fs::path(page).filename().string(); }

std::string numbers_file(const std::string& page) {
  return FLYROCK_SOURCE_DIR "/tests/cli/numbers/" + page + ".txt";
}

}  // namespace

TEST_CASE("each number of the course has a source") {
  for (const std::string& page : pages()) {
    const Sources sources = sources_in(read(numbers_file(page)));
    std::vector<double> known;
    if (const std::string scenario = scenario_of(stem_of(page)); !scenario.empty()) {
      const std::string text = std::regex_replace(read(scenario), std::regex("(^|[ \n])(#|--)[^\n]*"), "");
      for (const std::string& number : numbers_of(text)) known.push_back(std::stod(number));
    }
    std::set<std::string> used;
    for (const std::string& number : numbers_of(prose_of(read(course + ("/" + page) + ".md")))) {
      used.insert(unsigned_text(number));
      const auto is_known = [&](double value) { return is_written_as(value, number); };
      INFO(page << ".md: " << number << " has no source: see tests/cli/numbers_test.cpp");
      CHECK((is_count(number) || sources.numbers.contains(unsigned_text(number)) ||
             std::any_of(known.begin(), known.end(), is_known)));
    }
    for (const std::string& number : sources.numbers) {
      INFO(page << ".md does not have " << number << ", of which numbers/" << page << ".txt has the source");
      CHECK((used.contains(number) || is_count(number)));
    }
  }
}

TEST_CASE("the formulas of the course give its numbers") {
  const Folder folder;
  for (const std::string& page : pages()) {
    const auto formulas = sources_in(read(numbers_file(page))).formulas;
    if (formulas.empty()) continue;
    std::string program = "local fr = require 'flyrock'\nlocal m = math\n";
    for (const auto& [number, formula] : formulas)
      program += "print(string.format('%.17g'," + formula + "))\n";
    folder.write("formulas.lua", program +
                                     "fr.plugin { kind = 'friction', name = 'none', doc = 'd', params = {}, "
                                     "friction = function(p) return 0 end }\n");
    const Output output = call(folder, "check formulas.lua");
    INFO(page << ".md\n" << output.err);
    REQUIRE(output.code == 0);
    std::istringstream lines(output.err);
    for (const auto& [number, formula] : formulas) {
      std::string line;
      std::getline(lines, line);
      INFO(number << " =" << formula << " gives " << line);
      REQUIRE(!line.empty());
      CHECK(is_written_as(std::stod(line), number));
    }
  }
}

TEST_CASE("the runs of the course give its numbers", "[slow]") {
  const Folder folder;
  for (const std::string& page : pages())
    for (const ScenarioRun& one : sources_in(read(numbers_file(page))).runs) {
      std::string expect;
      for (const Measured& m : one.measured)
        expect += fmt::format("{}{{ measure: \"{}\", equals: {}{}, tolerance: {}{}{} }}",
                              expect.empty() ? "" : ", ", m.measure, m.number, m.unit,
                              half_digit(m.number) * (1 + 1e-6), m.unit, m.rest);
      const Output output = call(folder, "run " + scenario_of(one.lab.empty() ? stem_of(page) : one.lab) +
                                             one.options + " --set 'expect=[" + expect + "]' -o out --force");
      INFO(page << ".md: run" << one.options << "\n" << output.out << output.err);
      CHECK(output.code == 0);
    }
}

}  // namespace numbers_test
