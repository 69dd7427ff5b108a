// flyrock course: every lab holds, and none of its expectations holds by chance.

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>
#include <vector>

#include "program.h"

using namespace flyrock::test;

namespace {

const fs::path course_pages = FLYROCK_SOURCE_DIR "/docs/course";

std::vector<std::string> labs(const Folder& folder) {
  std::istringstream list(call(folder, "course --list").out);
  std::vector<std::string> names;
  std::string week, name;
  for (std::string line; std::getline(list, line);)
    if (std::istringstream(line) >> week >> name) names.push_back(name);
  return names;
}

fs::path scenario_of(const std::string& lab) {
  const std::string stem = FLYROCK_SOURCE_DIR "/scenarios/course/" + lab;
  return fs::exists(stem + ".lua") ? stem + ".lua" : stem + ".yaml";
}

/// `--set` options that move each expected number by 20 tolerances.
std::string moved(const nlohmann::json& shown) {
  std::string options;
  int i = 0;
  for (const auto& expectation : shown.at("expect")) {
    const std::string path = " --set expect." + std::to_string(i++);
    const auto add = [&](const char* key, double by) {
      std::ostringstream number;
      number.precision(17);
      number << expectation.at(key).get<double>() + by;
      options += path + "." + key + "=" + number.str();
    };
    if (expectation.contains("equals")) {
      const double equals = expectation.at("equals");
      const double tolerance = expectation.contains("tolerance")
                                   ? expectation.at("tolerance").get<double>()
                                   : expectation.value("relative", 0.0) * std::abs(equals);
      add("equals", tolerance > 0 ? 20 * tolerance : 1);
    } else if (expectation.contains("below")) {
      add("below", -1e9);
    } else if (expectation.contains("above")) {
      add("above", 1e9);
    } else {
      options += path + ".between='[1e9, 2e9]'";
    }
  }
  return options;
}

}  // namespace

TEST_CASE("all labs of the course hold, and each has its page, picture and solutions", "[slow]") {
  const Folder folder;
  const std::vector<std::string> names = labs(folder);
  CHECK(names.size() >= 14);
  const Output all = call(folder, "course -o labs");
  INFO(all.out << all.err);
  CHECK(all.code == 0);
  const std::string count = std::to_string(names.size());
  CHECK(all.out.ends_with(count + " of " + count + "\n"));
  for (const std::string& name : names) {
    INFO(name);
    CHECK(fs::exists(folder.path() / "labs" / name / "report.html"));
    CHECK(read(course_pages / (name + ".md")).find("](images/" + name + ".svg)") != std::string::npos);
    // `make course` writes the pictures; a hundred turns in twelve seconds could not be seen.
    const std::string until = name == "dzhanibekov" ? " --until 12s" : "";
    CHECK(call(folder, "animate labs/" + name + until + " -o picture.svg").code == 0);
    CHECK((read(course_pages / "images" / (name + ".svg")) == read(folder.path() / "picture.svg")));
    CHECK(fs::exists(course_pages / "solutions" / (name + ".md")));
  }
}

TEST_CASE("a lab fails as soon as an expected number moves by 20 tolerances", "[slow]") {
  const Folder folder;
  for (const std::string& name : labs(folder)) {
    INFO(name);
    const std::string path = scenario_of(name).string();
    const auto shown = nlohmann::json::parse(call(folder, "show --json " + path).out);
    const Output output = call(folder, "run " + path + " -o out --force --quiet" + moved(shown));
    INFO(output.err);
    CHECK(output.code == 1);
    const auto summary = nlohmann::json::parse(read(folder.path() / "out" / "summary.json"));
    CHECK_FALSE(summary.at("expectations").empty());
    for (const auto& expectation : summary.at("expectations")) {
      INFO(expectation.dump());
      CHECK_FALSE(expectation.at("passed").get<bool>());
    }
  }
}

TEST_CASE("labs that run at a time give the lines of labs that run one after the other", "[slow]") {
  const Folder folder;
  const Output output = call(folder, "course -j 4 -o labs");
  INFO(output.out << output.err);
  CHECK(output.code == 0);
  std::size_t at = 0;
  for (const std::string& name : labs(folder)) {
    at = output.out.find("holds  " + name + " ", at);
    REQUIRE(at != std::string::npos);
  }
}

TEST_CASE("course shows one lab with its page, question and verdict") {
  const Folder folder;
  const Output one = call(folder, "course bouncing_ball");
  CHECK(one.code == 0);
  CHECK(one.out.starts_with("# Zeno's ball\n"));
  CHECK(one.out.find("verdict: 10 of 10 expectations hold\n") != std::string::npos);
  const Output changed = call(folder, "course bouncing_ball --set materials.floor.restitution.en=0.9");
  CHECK(changed.code == 1);
  CHECK(changed.out.find("impact[1].vn_after = 12.60642693") != std::string::npos);
  for (const char* option : {"--set stop.time=1s", "--trials 5", "--seed 3", "--arg voussoirs=41"})
    CHECK(call(folder, std::string("course ") + option).err.find("needs the name of a lab") !=
          std::string::npos);
  CHECK(one.out.find("to change it: flyrock course bouncing_ball --set ") != std::string::npos);
  const Output wrong = call(folder, "course bouncing_bal");
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("did you mean `bouncing_ball`?") != std::string::npos);
}

TEST_CASE("the forces of Painleve's rod follow from the equation that its page gives") {
  const std::string equation = "W r = (g - 1.8 y, -1.8 x)";
  const std::string scenario = read(scenario_of("painleve"));
  CHECK(read(course_pages / "painleve.md").find(equation) != std::string::npos);
  CHECK(scenario.find(equation) != std::string::npos);
  const double wnn = 1.6, wtt = 3.4, wnt = 1.2, x = -0.2236068, y = 0.4472136;
  const double n = 9.81 - 1.8 * y, t = -1.8 * x, determinant = wnn * wtt - wnt * wnt;
  const double rn = (wtt * n - wnt * t) / determinant, rt = (wnn * t - wnt * n) / determinant;
  CHECK(rn == Approx(7.5335).epsilon(1e-4));  // as the scenario expects of its series
  CHECK(rt == Approx(-2.5405).epsilon(1e-4));
  CHECK(scenario.find("rn.at[5e-6 s]\", equals: 7.5335") != std::string::npos);
  CHECK(scenario.find("rt.at[5e-6 s]\", equals: -2.5405") != std::string::npos);
}

TEST_CASE("a lab with fewer trials says which expectations it does not judge") {
  const Folder folder;
  for (const char* few : {"--trials 50", "--set trials=50", "--trials 50 --seed 3"}) {
    INFO(few);
    const Output output = call(folder, std::string("course clearance ") + few);
    INFO(output.err);
    CHECK(output.code == 0);
    CHECK(output.out.find("verdict: 0 of 0 expectations hold, 4 need more trials and are not judged\n") !=
          std::string::npos);
    CHECK(output.err.find("json") == std::string::npos);
  }
}

TEST_CASE("course -o DIR is the result folder, as that of run, and is not replaced unasked") {
  const Folder folder;
  REQUIRE(call(folder, "course oblique_impact -o mine").code == 0);
  CHECK(folder.has("mine/report.html"));
  CHECK_FALSE(folder.has("mine/oblique_impact"));
  const Output again = call(folder, "course oblique_impact -o mine"),
               as_run = call(folder, "run " + scenario_of("oblique_impact").string() + " -o mine");
  CHECK(again.code == 2);
  CHECK(again.err.substr(0, again.err.find('\n')) == as_run.err.substr(0, as_run.err.find('\n')));
  CHECK(call(folder, "course oblique_impact -o mine --force").code == 0);
  // The folder of the course itself is replaced by each run.
  CHECK(call(folder, "course oblique_impact").code == 0);
  CHECK(call(folder, "course oblique_impact").code == 0);
  CHECK(folder.has("out/course/oblique_impact/report.html"));
}

TEST_CASE("the arch takes the number of its stones and its thicknesses as arguments", "[slow]") {
  const Folder folder;
  const Output more = call(folder, "course arch --arg voussoirs=31 --arg thick=0.112 --arg thin=0.1");
  INFO(more.out << more.err);
  CHECK(more.code == 0);
  CHECK(more.out.find("verdict: 4 of 4 expectations hold\n") != std::string::npos);
  CHECK(more.out.find("thick_1, thick_2, thick_3 and 28 more bodies stood for 0.1 s.") != std::string::npos);
  CHECK(more.out.find(" 31 of 62 bodies moved;") != std::string::npos);  // those of the thin one
  CHECK(more.out.find("thin_1 ") == std::string::npos);
}

TEST_CASE("bodies of one picture start close to each other") {
  const Folder folder;
  // In radii about the centre, of the boxes of 0.4 x 0.3 x 0.1 m, and of the balls, which start 1 m from the
  // others.
  for (const auto& [lab, radius, most] :
       {std::tuple("dzhanibekov", 0.255, 5.0), std::tuple("cradle", 0.1, 13.0)}) {
    INFO(lab);
    const auto bodies =
        nlohmann::json::parse(call(folder, "show --json " + scenario_of(lab).string()).out).at("bodies");
    for (const auto& a : bodies)
      for (const auto& b : bodies) {
        double squared = 0;
        for (std::size_t i = 0; i < a.at("position").size(); ++i)
          squared += std::pow(a.at("position").at(i).get<double>() - b.at("position").at(i).get<double>(), 2);
        CHECK(std::sqrt(squared) <= most * radius);
      }
  }
}

TEST_CASE("every scenario of the course is named by a page of the course") {
  std::string pages;
  for (const auto& entry : fs::directory_iterator(course_pages))
    if (entry.path().extension() == ".md") pages += read(entry.path());
  int scenarios = 0;
  for (const auto& entry : fs::directory_iterator(FLYROCK_SOURCE_DIR "/scenarios/course")) {
    const std::string file = entry.path().filename().string();
    INFO(file);
    CHECK((pages.find("/" + file) != std::string::npos ||
           pages.find("flyrock course " + entry.path().stem().string() + "\n") != std::string::npos));
    ++scenarios;
  }
  CHECK(scenarios >= 22);
}
