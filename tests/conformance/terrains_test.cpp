// The native terrains: where their points, parts and faces lie, and what is wrong with a file.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <random>

#include "conformance/plugin_use.h"
#include "geometry/profile.h"
#include "plugin/models.h"
#include "temporary_file.h"

using namespace flyrock;

namespace terrains_test {

namespace {

const LuaSession& session() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

Profile build(const std::string& name, const std::map<std::string, Given>& given) {
  const auto made = make<TerrainModel>(session(), PluginKind::terrain, name, given);
  RandomStream rng(1, "terrain", {});
  return made.model->build(made.values, rng);
}

}  // namespace

TEST_CASE("benches begin 50 m behind the uppermost crest and end on the floor") {
  const double run = 12 / std::tan(70 * pi / 180);
  const Profile benches = build(
      "benches",
      {{"count", 3.0}, {"height", 12.0}, {"face_angle", 70 * pi / 180}, {"berm", 8.0}, {"floor", 400.0}});
  CHECK(benches.fault().empty());
  CHECK(benches.parts == std::vector<std::string>{"face", "berm", "floor"});
  CHECK(benches.part == std::vector<int>{1, 0, 1, 0, 1, 0, 2});
  CHECK(benches.points[0] == Vec2(-50, 36));
  CHECK(benches.points[1] == Vec2(0, 36));
  CHECK((benches.points[2] - Vec2(run, 24)).norm() < 1e-12);
  CHECK((benches.points.back() - Vec2(3 * run + 16 + 400, 0)).norm() < 1e-12);
  REQUIRE(benches.faces.size() == 3);
  CHECK(benches.faces[0].crest == benches.points[1]);
  CHECK(benches.faces[0].toe == benches.points[2]);
  CHECK((benches.faces[2].toe - Vec2(3 * run + 16, 0)).norm() < 1e-12);
}

TEST_CASE("benches may stand upright, or follow each other without a berm") {
  const Profile wall = build(
      "benches", {{"count", 2.0}, {"height", 5.0}, {"face_angle", pi / 2}, {"berm", 0.0}, {"floor", 10.0}});
  CHECK(wall.fault().empty());
  CHECK(wall.part == std::vector<int>{1, 0, 0, 2});
  CHECK(wall.faces[1].toe.x() < 1e-12);
}

TEST_CASE("a profile comes from points or from a file") {
  const std::vector<std::vector<double>> points{{0, 1}, {5, 0.5}, {10, 0}};
  CHECK(build("profile", {{"points", points}}).points.size() == 3);
  const TemporaryFile file("profile.txt", "# x y\n0, 1\n\n5 0.5   # a ledge\n  10,0\n");
  const Profile read = build("profile", {{"file", file.path.c_str()}});
  CHECK(read.points == build("profile", {{"points", points}}).points);
  CHECK(read.parts == std::vector<std::string>{""});
  CHECK_THROWS_WITH(build("profile", {}), "plugin profile: expected either `points` or a `file`");
  CHECK_THROWS_WITH(build("profile", {{"points", points}, {"file", file.path.c_str()}}),
                    "plugin profile: expected either `points` or a `file`");
}

TEST_CASE("a profile is the same with and without heads, in any order, with any separator") {
  std::mt19937 random(3);
  const auto one_of = [&](std::initializer_list<const char*> list) {
    return std::string(list.begin()[random() % list.size()]);
  };
  for (int sample = 0; sample < 300; ++sample) {
    const bool has_heads = random() % 3 > 0, is_feet = has_heads && random() % 4 == 0;
    const std::string separator = one_of({",", ";", "\t", " ", ", ", "; "}), end = one_of({"\n", "\r\n"});
    const bool decimal_comma = separator[0] != ',' && random() % 2 == 0;
    std::vector<std::string> heads = {
        one_of({"x", "X", "distance", "Station", "chainage", "dist"}) +
            (is_feet ? "_ft" : one_of({"", "_m"})),
        one_of({"y", "z", "Height", "elevation", "elev", "H"}) + (is_feet ? "_ft" : "")};
    std::vector<std::size_t> order = {0, 1};
    if (has_heads)
      for (std::size_t more = random() % 3; more > 0; --more) {
        order.push_back(heads.size());
        heads.push_back(one_of({"point", "code", "remark"}) + std::to_string(heads.size()));
      }
    if (has_heads) std::shuffle(order.begin(), order.end(), random);
    const auto line_of = [&](const std::vector<std::string>& fields) {
      std::string line;
      for (const std::size_t i : order) line += (line.empty() ? "" : separator) + fields[i];
      return line + end;
    };
    std::string text = one_of({"", "\xEF\xBB\xBF"}) + one_of({"", "# a survey\n"});
    if (has_heads) text += line_of(heads);
    std::vector<Vec2> points;
    double x = -3;
    for (std::size_t n = 2 + random() % 5; n > 0; --n) {
      points.emplace_back(x += 0.25 * static_cast<double>(1 + random() % 40), 0.125 * (random() % 100));
      std::vector<std::string> fields(heads.size(), "7");
      for (const int k : {0, 1}) {
        fields[k] = fmt::format("{:.4f}", points.back()[k]);
        if (decimal_comma) std::replace(fields[k].begin(), fields[k].end(), '.', ',');
      }
      text += line_of(fields) + one_of({"", "", end.c_str()});
    }
    INFO(text);
    const TemporaryFile file("profile.csv", text);
    const Profile read = build("profile", {{"file", file.path.c_str()}});
    REQUIRE(read.points.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK((read.points[i] - (is_feet ? 0.3048 : 1) * points[i]).norm() < 1e-12);
  }
}

TEST_CASE("a profile's file is read strictly") {
  const auto fault = [](const std::string& text) {
    const TemporaryFile file("profile.txt", text);
    try {
      build("profile", {{"file", file.path.c_str()}});
    } catch (const PluginError& error) {
      std::string message = error.what();
      if (const auto at = message.find(file.path); at != message.npos)
        message.replace(at, file.path.size(), "FILE");
      return message;
    }
    return std::string();
  };
  CHECK(fault("0 1\n1 x\n") == "plugin profile: FILE:2:3: `x` is not a number, expected `y`");
  CHECK(fault("0 1\n1 2 3\n") == "plugin profile: FILE:2:1: expected two numbers, x and y, found 3");
  CHECK(fault("0 1\n1,\n") == "plugin profile: FILE:2:1: expected two numbers, x and y, found 1");
  CHECK(fault("0 1\n,\n") ==
        "plugin profile: a profile has 1 points, at least 2 are needed");  // an empty row is none
  CHECK(fault("") == "plugin profile: the file FILE is empty");
  CHECK(fault("0,5,10,25\n") ==
        "plugin profile: FILE:1:1: expected two numbers, x and y, found 4: with commas in decimals, separate "
        "the numbers by semicolons");
  CHECK(fault("x,z\n0;1\n1;2\n")
            .find("FILE:2:1: the line has 1 value, the heads are 2: its values are "
                  "apart by semicolons, the heads by commas") != std::string::npos);
  CHECK(fault("east,north,height\n1,2,3\n").find("FILE:1:1: no column is `x`") != std::string::npos);
  CHECK(fault("x,y,z\n1,2,3\n").find("FILE:1:5: `z` is a second column of `y`") != std::string::npos);
  CHECK(fault("1 0\n0 0\n") ==
        "plugin profile: x decreases from (1, 0) to (0, 0); a profile goes from left to right: sort the "
        "points, or, if the wall overhangs there, "
        "run in `dimension: 3` with the section extruded as a `mesh`");
}

}  // namespace terrains_test
