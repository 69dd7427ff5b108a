// flyrock grade: a class whose files may be anything.

#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "program.h"

using namespace flyrock::test;

namespace grade_test {

namespace {

/// The lab's own scenario with one text replaced by another.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = read(FLYROCK_SOURCE_DIR "/scenarios/course/bouncing_ball.yaml");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A scenario with many bodies that bounce for long: it writes and computes without end.
std::string crowd(const std::string& output) {
  std::string text =
      "flyrock: 1\ndimension: 2\nmethod: nscd\n"
      "terrain: { type: profile, points: [[-500, 0], [500, 0]], material: floor }\n"
      "materials: { floor: { restitution: { type: newton, en: 0.99999 } } }\n"
      "body_contacts: off\nbodies:\n"
      "  - { name: ball, shape: { type: disk, radius: 0.1 m }, mass: 1 kg, position: [0, 1] }\n";
  for (int i = 1; i < 100; ++i)
    text += "  - { name: b" + std::to_string(i) +
            ", shape: { type: disk, radius: 0.1 m }, mass: 1 kg, position: [" + std::to_string(i) + ", " +
            std::to_string(1 + 0.01 * i) + "] }\n";
  return text + "solver: { flight: stepped, time_step: 10 us }\nstop: { time: 50 s }\n" + output;
}

struct Row {
  std::string result, failed;
};

std::map<std::string, Row> rows_of(const std::string& table) {
  std::map<std::string, Row> rows;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  CHECK(line == "file,result,failed");
  while (std::getline(lines, line)) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1);
    rows[line.substr(0, first)] = {line.substr(first + 1, second - first - 1), line.substr(second + 1)};
  }
  return rows;
}

}  // namespace

TEST_CASE("grade has a row for each file of a class, whatever the file does", "[slow]") {
  struct Student {
    const char* file;
    std::string text;
    const char* result;
    const char* failed;  ///< in this column
  };
  const Folder folder;
  const std::string wrong = changed("en: 0.5", "en: 0.4");
  const std::vector<Student> students = {
      {"right.yaml", changed("en: 0.5", "en: 0.5"), "passed", ""},
      {"wrong.yaml", wrong, "failed", "body.ball.impact[1].vn_after: expected 7.00357051795725 within 7.00"},
      {"names.yaml", changed("name: ball", "name: kugel"), "error",
       "the lab calls this body `ball`, here is `kugel`"},
      {"endless.yaml", crowd(""), "error", "it took more than 2 s of processor time"},
      {"trials.yaml", changed("dimension: 2", "dimension: 2\ntrials: 100000000"), "error",
       "1e+08 trials, expected at most 10: ten times those of the lab"},
      {"time.yaml", changed("time: 5 s", "time: 1e9 s"), "error", "must be at most 100000 s"},
      {"broken.yaml", "flyrock: 1\n  bodies: [\n", "error", "line 2:"},
      {"own.yaml", wrong.substr(0, wrong.find("expect:")) + "expect: []\n", "failed",
       "body.ball.impact[1].vn_after"},
      {"missing.yaml", "", "error", "No such file"},
      {"huge.yaml", crowd("output: { series: {} }\n"), "error", "it "},
      {"loop.lua", "local fr = require 'flyrock'\nwhile true do end\n", "error", "used more than its"},
      {"empty.yaml", "", "error", ""},
  };
  std::string words;
  for (const Student& student : students) {
    if (std::string(student.file) != "missing.yaml") folder.write(student.file, student.text);
    words += std::string(student.file) + " ";
  }
  const Output output = call(folder, "grade " + words + "--with bouncing_ball --seconds 2");
  INFO(output.out << output.err);
  CHECK(output.code == 1);
  const std::map<std::string, Row> rows = rows_of(output.out);
  CHECK(rows.size() == 12);
  for (const Student& student : students) {
    INFO(student.file);
    REQUIRE(rows.contains(student.file));
    const Row& row = rows.at(student.file);
    CHECK(row.result == student.result);
    CHECK(row.failed.find(student.failed) != std::string::npos);
    CHECK(row.failed.empty() == (row.result == "passed"));
    CHECK(output.err.find(std::string(student.file) + ": ") != std::string::npos);
  }
  CHECK_FALSE(folder.has("out/grade/10-huge"));
  CHECK(call(folder, "grade right.yaml --with bouncing_ball").code == 0);
}

TEST_CASE("the exit code of grade says whether all passed, some failed, or none could be run") {
  const Folder folder;
  REQUIRE(call(folder, "new course/bouncing_ball -o good").code == 0);
  folder.write("wrong.yaml", changed("en: 0.5", "en: 0.4"));
  folder.write("empty.yaml", "flyrock: 1\n");
  CHECK(call(folder, "grade good/bouncing_ball.yaml --with bouncing_ball").code == 0);
  CHECK(call(folder, "grade good/bouncing_ball.yaml wrong.yaml --with bouncing_ball").code == 1);
  CHECK(call(folder, "grade good/bouncing_ball.yaml empty.yaml --with bouncing_ball").code == 1);
  CHECK(call(folder, "grade empty.yaml --with bouncing_ball").code == 2);
  CHECK(call(folder, "grade good/bouncing_ball.yaml --with bouncing_bal").code == 2);
}

TEST_CASE("grade reads no file outside of the folder of a student, and no native plugin") {
  const Folder folder;
  folder.write("profile.csv", "x,y\n-5,0\n5,0\n");
  fs::create_directory(folder.path() / "student");
  const auto with_file = [&](const std::string& file) {
    folder.write("student/s.yaml", changed("{ type: profile, points: [[-5, 0], [5, 0]], material: floor }",
                                           "{ type: profile, file: \"" + file + "\", material: floor }"));
    return call(folder, "grade student/s.yaml --with bouncing_ball");
  };
  const std::string refused = "is outside of the scenario's folder";
  CHECK(with_file("../profile.csv").out.find(refused) != std::string::npos);
  CHECK(with_file((folder.path() / "profile.csv").string()).out.find(refused) != std::string::npos);
  fs::create_symlink("../profile.csv", folder.path() / "student/link.csv");
  CHECK(with_file("link.csv").out.find(refused) != std::string::npos);
  folder.write("student/own.csv", "x,y\n-5,0\n5,0\n");
  CHECK(with_file("own.csv").code == 0);

  folder.write("student/native.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "friction", name = "x", doc = "d", params = {}, native = "x" }
)");
  folder.write("student/s.yaml", changed("dimension: 2", "dimension: 2\nplugins: [native.lua]"));
  const Output native = call(folder, "grade student/s.yaml --with bouncing_ball");
  INFO(native.out);
  CHECK(native.out.find("a plugin in native code, which --confined refuses") != std::string::npos);
}

}  // namespace grade_test
