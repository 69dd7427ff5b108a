// A sweep that asks for its best point, from outside.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

namespace sweep_answer_test {

/// Rocks thrown over a road; `answer` is the end of the scenario.
std::string throws(const std::string& answer) {
  return R"(flyrock: 1
dimension: 2
method: ballistic
trials: 60
terrain: { type: profile, points: [[-100, 0], [900, 0]] }
rocks:
  - name: face
    density: 2700 kg/m3
    shape: { type: disk, radius: 0.1 m }
    release: { position: [0, 0.2] }
    launch: { type: fixed, speed: { sweep: [40 m/s, 20 m/s, 30 m/s] }, elevation: { uniform: [30 deg, 60 deg] } }
gates: [{ name: road, x: 85 m }]
stop: { time: 60 s }
)" + answer;
}

nlohmann::json summary_of(const Folder& folder, const std::string& answer, std::string& out) {
  folder.write("throws.yaml", throws(answer));
  const Output run = call(folder, "run throws.yaml -o out --force");
  INFO(run.out << run.err);
  REQUIRE(run.code == 0);
  out = run.out;
  return nlohmann::json::parse(read(folder.path() / "out/summary.json"));
}

}  // namespace sweep_answer_test

using sweep_answer_test::summary_of;

TEST_CASE("A sweep names the best point, those that fall short, and the differences from point 0") {
  const Folder folder;
  std::string out;
  const nlohmann::json summary = summary_of(folder, R"(answer:
  least: rocks.runout.mean
  such_that: [{ measure: gate.road.passed, above: 0.2 }]
)",
                                            out);
  const auto& best = summary.at("best_point");
  CHECK(best.at("best") == nlohmann::json{2});
  CHECK(best.at("points")[1].at("holds") == false);
  CHECK(best.at("points")[1].at("such_that")[0].at("short_by") == 0.2);
  CHECK(out.find(
            "Least rocks.runout.mean such that gate.road.passed above 20 %: point 2 (speed 30 m/s), with") !=
        std::string::npos);
  CHECK(out.find("point 1 falls short: gate.road.passed is 0 %") != std::string::npos);
  const auto& runout = summary.at("differences")[0].at("groups")[0].at("numbers").at("runout");
  CHECK(runout.at("pairs") == 60);
  const auto& points = summary.at("points");
  const auto mean = [&](int p) { return points[p].at("rocks")[0].at("runout").at("mean").get<double>(); };
  CHECK(runout.at("mean").get<double>() == Approx(mean(1) - mean(0)).epsilon(1e-12));
  CHECK(summary.at("differences")[0].at("groups")[0].at("numbers").at("gate.road.passed").at("mean") == -1);
}

TEST_CASE("Without an answer no point is called best, ties and none are said") {
  const Folder folder;
  std::string out;
  CHECK_FALSE(summary_of(folder, "", out).contains("best_point"));
  CHECK(summary_of(folder, "answer: { least: rocks.censored }\n", out).at("best_point").at("best").size() ==
        3);
  CHECK(out.find("Least rocks.censored: a tie of point 0 (speed 40 m/s), point 1") != std::string::npos);
  const auto none = summary_of(
      folder,
      "answer: { least: rocks.runout.p50, such_that: [{ measure: rocks.speed.max, below: 1 m/s }] }\n", out);
  CHECK(none.at("best_point").at("best").empty());
  CHECK(out.find("such that rocks.speed.max below 1 m/s: none of 3 points.") != std::string::npos);
}

TEST_CASE("Differences have the same bytes from one thread, from three, and from shards that are merged") {
  const Folder folder;
  folder.write("throws.yaml", sweep_answer_test::throws("answer: { least: rocks.runout.mean }\n"));
  REQUIRE(call(folder, "run throws.yaml -o one -j 1 --quiet").code == 0);
  REQUIRE(call(folder, "run throws.yaml -o three -j 3 --quiet").code == 0);
  for (const char* shard : {"1", "2"})
    REQUIRE(
        call(folder, std::string("run throws.yaml --quiet -o shards/") + shard + " --shard " + shard + "/2")
            .code == 0);
  const Output merged = call(folder, "merge shards/1 shards/2 --quiet -o merged");
  INFO(merged.err);
  REQUIRE(merged.code == 0);
  const std::string one = read(folder.path() / "one/summary.json");
  CHECK(read(folder.path() / "three/summary.json") == one);
  CHECK(read(folder.path() / "merged/summary.json") == one);
}
