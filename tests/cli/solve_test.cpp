// flyrock solve, and the problems that a run leaves for it.

#include <catch2/catch.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace flyrock::test;

namespace {

constexpr const char* pile = R"(flyrock: 1
title: two boxes
dimension: 2
method: nscd
terrain: { type: profile, points: [[-5, 0], [5, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
bodies:
  - { name: lower, shape: { type: polygon, vertices: [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] },
      density: 2700, position: [0, 0.5], material: rock }
  - { name: upper, shape: { type: polygon, vertices: [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] },
      density: 2700, position: [0.2, 1.5], velocity: [1, 0], material: rock }
solver: { max_iterations: 1, tolerance: 1e-12 }
stop: { time: 0.02 s }
output: { hard_problems: true }
)";

bool without_hdf5(const Folder& folder) {
  if (call(folder, "--version").out.find("HDF5") != std::string::npos) return false;
  std::cout << "SKIPPED: built without HDF5\n";
  return true;
}

}  // namespace

TEST_CASE("A problem that did not converge is kept and solved alone") {
  const Folder folder;
  if (without_hdf5(folder)) return;
  folder.write("pile.yaml", pile);
  REQUIRE(call(folder, "run pile.yaml -o out --quiet").code == 0);
  const std::string problem = "out/hard_problems/point-0/trial-0-0.hdf5";
  REQUIRE(folder.has(problem));
  const Output again = call(folder, "solve " + problem + " --solver nlgs --max-iterations 1");
  CHECK(again.code == 1);
  CHECK(again.out.find("4 contacts in 2D: not converged after 1 sweeps of nlgs") == 0);
  const Output solved = call(folder, "solve " + problem + " --json");
  CHECK(solved.code == 0);
  const auto answer = nlohmann::json::parse(solved.out);
  CHECK(answer["converged"] == true);
  CHECK(answer["merit"]["rel"].get<double>() <= 1e-8);
  CHECK(answer["merit"].contains("fclib"));
  CHECK(answer["r"].size() == 8);
  CHECK(answer["solver"] == "nlgs");
  REQUIRE(call(folder, "run pile.yaml -o out --quiet --force --set output.hard_problems=false").code == 0);
  CHECK_FALSE(folder.has("out/hard_problems"));
}

TEST_CASE("A damaged file on which the HDF5 library crashes is no crash of flyrock") {
  const Folder folder;
  if (without_hdf5(folder)) return;
  folder.write("pile.yaml", pile);
  REQUIRE(call(folder, "run pile.yaml -o out --quiet").code == 0);
  const std::string sound = read(folder.path() / "out/hard_problems/point-0/trial-0-0.hdf5");
  std::size_t crashes = 0;
  // The addresses of the trees and heaps that hold the names of a group: the message of a symbol table.
  const std::string message("\x11\0\x10\0\0\0\0\0", 8);
  for (std::size_t at = sound.find(message); at != std::string::npos; at = sound.find(message, at + 1)) {
    std::string damaged = sound;
    damaged.replace(at + 8, 8, 8, '\xff');
    folder.write("damaged.hdf5", damaged);
    const Output output = call(folder, "solve damaged.hdf5");
    INFO(output.err);
    if (output.code == 0) continue;  // of a group from which nothing is read
    CHECK(output.code == 2);
    CHECK(output.err.find("error: damaged.hdf5: ") == 0);
    crashes += output.err == "error: damaged.hdf5: is damaged: the HDF5 library fails on it\n";
  }
  std::cout << crashes << " damaged files crash this HDF5 library\n";
}

TEST_CASE("What is no problem is exit code 2") {
  const Folder folder;
  const auto error = [&](const std::string& line) {
    const Output output = call(folder, line);
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(error("solve a.hdf5 --solver nlg").find("unknown solver `nlg`, did you mean `nlgs`?") !=
        std::string::npos);
  CHECK(error("solve a.hdf5 --tolerance -1").find("--tolerance is `-1`, expected a number above 0") !=
        std::string::npos);
  CHECK(error("solve a.hdf5 --max-iterations 0").find("not a whole number of at least 1") !=
        std::string::npos);
  if (without_hdf5(folder)) return;
  CHECK(error("solve absent.hdf5") == "error: absent.hdf5: cannot be opened as an HDF5 file\n");
  folder.write("text.hdf5", "no HDF5");
  CHECK(error("solve text.hdf5") == "error: text.hdf5: cannot be opened as an HDF5 file\n");
  const Output pipe = shell(folder, "mkfifo pipe.hdf5 && timeout 20 '" FLYROCK_BINARY "' solve pipe.hdf5");
  CHECK(pipe.code == 2);
  CHECK(pipe.err == "error: pipe.hdf5: cannot be opened as an HDF5 file\n");
}

TEST_CASE("explain shows a contact problem, and solve solves the one that it saves") {
  const Folder folder;
  const std::string cradle = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/cradle.yaml";
  const Output shown = call(folder, "explain " + cradle + " --impact 1");
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  CHECK(shown.out.find("impact 1 of trial 0 of cradle.yaml, at 0.8 s: 3 contacts in 2D") == 0);
  CHECK(shown.out.find("rank of W: 6 of 6") != std::string::npos);
  CHECK(shown.out.find("energy: the contacts take 0.4375 J") != std::string::npos);
  CHECK_FALSE(folder.has("out"));
  const Output saved = call(folder, "explain " + cradle + " --impact 1 --point 1 --json --save p.hdf5");
  REQUIRE(saved.code == 0);
  const auto tree = nlohmann::json::parse(saved.out);
  CHECK(tree["W"].size() == 6);
  const auto solved = nlohmann::json::parse(call(folder, "solve p.hdf5 --json").out);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(solved["r"][i].get<double>() == Approx(tree["phases"][0]["r"][i].get<double>()).margin(1e-7));
  // Two contacts in a row: a sweep of Gauss-Seidel leaves a quarter of the error of the sweep before.
  const auto residuals =
      nlohmann::json::parse(call(folder, "solve p.hdf5 --json --sweeps 6").out)["residuals"];
  REQUIRE(residuals.size() == 6);
  for (std::size_t i = 1; i < 6; ++i)
    CHECK(residuals[i].get<double>() == Approx(residuals[i - 1].get<double>() / 4).epsilon(1e-6));
}

TEST_CASE("explain draws the path of an impact in impulse space") {
  const Folder folder;
  const std::string course = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/";
  REQUIRE(call(folder, "explain " + course + "routh.yaml --impact 2 --routh path.svg").code == 0);
  CHECK(read(folder.path() / "path.svg").starts_with("<svg xmlns="));
  REQUIRE(call(folder, "explain " + course + "routh.yaml --impact 2 --routh path.csv").code == 0);
  const std::string csv = read(folder.path() / "path.csv");
  CHECK(csv.starts_with("at,pn_N_s,pt_N_s,vn_m_s,vt_m_s\npath,0,0,"));
  CHECK(csv.find("\nend of slip,0.109") != std::string::npos);
  CHECK(csv.find("\npoisson,0.4796") != std::string::npos);
  CHECK(call(folder, "explain " + course + "cradle.yaml --impact 1 --routh x.svg").code == 2);
  CHECK(call(folder, "explain " + course + "rolling.yaml --step 1 --routh x.svg").code == 2);
}

TEST_CASE("explain tries all states of a problem, and follows Lemke's path") {
  const Folder folder;
  const std::string lab = FLYROCK_SOURCE_DIR "/scenarios/course/many_answers.yaml --step 1 --solutions";
  const Output shown = call(folder, "explain " + lab);
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  const auto after = [&](const std::string& heading) { return shown.out.substr(shown.out.find(heading)); };
  CHECK(after("all states of contacts 1, 2: impulses")
            .find("5 states are feasible, with 2 different motions: the "
                  "problem has several solutions") != std::string::npos);
  CHECK(after("all states of contact 3: forces")
            .find("No state is feasible: the problem has no solution in forces.\n") != std::string::npos);
  CHECK(after("all states of contact 3: forces").find("The path ends on a ray: f_n of 3 grows") !=
        std::string::npos);
  CHECK(after("all states of contact 4: forces").find("2 states are feasible") < 400);

  const auto islands = nlohmann::json::parse(call(folder, "explain " + lab + " --json").out)["solutions"];
  REQUIRE(islands.size() == 3);
  CHECK(islands[0]["contacts"] == nlohmann::json::array({1, 2}));
  CHECK(islands[0]["impulses"]["motions"].size() == 2);
  CHECK(islands[1]["impulses"]["feasible"] == 1);
  CHECK(islands[1]["forces"]["feasible"] == 0);
  CHECK(islands[1]["forces"]["lemke"]["end"] == "ray");
  CHECK(islands[2]["impulses"]["feasible"] == 3);
  CHECK(islands[2]["forces"]["states"][1]["f"][0].get<double>() == Approx(122.625).epsilon(1e-4));

  const auto refused = [&](const std::string& line) {
    const Output output =
        call(folder, "explain " FLYROCK_SOURCE_DIR "/scenarios/course/" + line + " --solutions");
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(refused("rolling.yaml --step 1").find("friction in 3D") != std::string::npos);
  CHECK(refused("arch.lua --step 1")
            .find("tries the states of 12 contacts that act on each other at most; here are") !=
        std::string::npos);
  CHECK(refused("penalty_or_signorini.yaml --step 1").find("expected contacts with Coulomb's friction") !=
        std::string::npos);
}

TEST_CASE("explain follows the law of Liu, Zhao and Brogliato through a cradle") {
  const Folder folder;
  const std::string cradle =
      FLYROCK_SOURCE_DIR "/scenarios/course/cradle.yaml --impact 1 --point 1 --distributing ";
  const Output shown = call(folder, "explain " + cradle + "1.5");
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  // 1 kg: ball 3 leaves with the impulse of contact 2, ball 1 with 1 - that of contact 1
  CHECK(shown.out.find("P = 1.07095 N s, v_n = 0.147355 m/s; the run (newton): P = 1.33333 N s") !=
        std::string::npos);
  CHECK(shown.out.find("P = 0.994549 N s") != std::string::npos);
  const auto islands =
      nlohmann::json::parse(call(folder, "explain " + cradle + "1 --json").out)["distributing"];
  REQUIRE(islands.size() == 2);
  CHECK(islands[0]["path"].back()["P_N_s"][1].get<double>() == Approx(0.980032).margin(1e-5));
  CHECK(call(folder, "explain " + cradle + "0.5")
            .err.find("--distributing is `0.5`, expected an exponent from 1 to 10") != std::string::npos);
  const std::string course = FLYROCK_SOURCE_DIR "/scenarios/course/";
  CHECK(call(folder, "explain " + course + "routh.yaml --impact 1 --distributing 1.5")
            .err.find("has friction") != std::string::npos);
  CHECK(call(folder, "explain " + course + "gauss_seidel.yaml --step 1 --distributing 1.5")
            .err.find("expected --impact N") != std::string::npos);
}

TEST_CASE("explain says what is wrong with what it is asked") {
  const Folder folder;
  const std::string course = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/";
  const auto error = [&](const std::string& words) {
    const Output output = call(folder, "explain " + course + words);
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(error("cradle.yaml").find("expected one of --impact N and --step N") != std::string::npos);
  CHECK(error("cradle.yaml --impact 1 --step 1").find("expected one of") != std::string::npos);
  CHECK(error("cradle.yaml --impact 0").find("not a whole number of at least 1") != std::string::npos);
  CHECK(error("cradle.yaml --impact 9").find("--impact is 9, but trial 0 has 3 of them") !=
        std::string::npos);
  CHECK(error("cradle.yaml --impact 1 --point 2").find("--point is 2, expected 0 to 1") != std::string::npos);
  CHECK(error("projectile.yaml --impact 1").find("only `nscd` solves them") != std::string::npos);
  CHECK(error("none.yaml --impact 1").find("none.yaml") != std::string::npos);
}
