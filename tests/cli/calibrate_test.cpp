// Numbers that are fitted to what was measured, as a user does it. What is measured is made by flyrock.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/rows.h"

namespace flyrock::calibrate_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

/// 24 points that slide and jump down a slope and out onto a floor, each from a place of its own.
std::string slope(const std::string& mu, const std::string& more = "") {
  return "flyrock: 1\ndimension: 2\nmethod: lumped_mass\ntrials: 12\n"
         "terrain: { type: profile, points: [[-5, 30], [0, 30], [35, 0], [400, 0]], material: rock }\n"
         "materials:\n  rock:\n    restitution: { type: newton, en: 0.3 }\n    friction: { type: coulomb, "
         "mu: " +
         mu +
         " }\n    roughness: { angle: { normal: { mean: 0 deg, sd: 6 deg } } }\n"
         "rocks: [{ name: blocks, table: blocks.csv, density: 2600, "
         "shape: { type: from_lengths, form: cut } }]\n" +
         more + "stop: { time: 120 s }\n";
}

const std::string compared = "observed: { file: stops.csv, of: runout }\n";

/// The blocks, and where they stop in one trial with mu 0.45 and another seed; the last eight are "late".
void write_measurements(const Folder& folder) {
  std::string blocks = "name,group,mass_kg,l1_m,l2_m,l3_m,x_m,z_m\n";
  for (int i = 0; i < 24; ++i)
    blocks += fmt::format("b{},{},{},{},0.5,0.4,{},{}\n", i, i < 16 ? "early" : "late", 200 + 10 * i,
                          0.6 + 0.01 * i, 0.5 + 0.05 * i, 31 + 0.1 * i);
  folder.write("blocks.csv", blocks);
  folder.write("truth.yaml", slope("0.45"));
  REQUIRE(call(folder, "run truth.yaml --seed 77 --trials 1 --quiet -o truth").code == 0);
  std::string stops = "name,distance_m\n";
  int i = 0;
  for (const std::string& runout :
       query(folder.path() / "truth/results.db", "SELECT runout_m FROM rocks ORDER BY rock"))
    stops += fmt::format("b{},{}\n", i++, runout);
  REQUIRE(i == 24);
  folder.write("stops.csv", stops);
}

Json calibration_of(const Folder& folder, const std::string& out) {
  return Json::parse(read(folder.path() / out / "calibration.json"));
}

const std::string vary_mu = " --vary materials.rock.friction.mu=0.2:0.8 --evaluations 12";

}  // namespace

TEST_CASE("a number is found again, is judged on what was held back, and its scenario runs", "[slow]") {
  const Folder folder;
  write_measurements(folder);
  folder.write("site.yaml", slope("0.3", compared));
  const Output fit = call(folder, "calibrate site.yaml" + vary_mu + " --hold late -j 2 -o fit");
  INFO(fit.out << fit.err);
  REQUIRE(fit.code == 0);
  CHECK(fit.out.find("which judges the fit") != std::string::npos);
  const Json found = calibration_of(folder, "fit");
  const Json& mu = found["parameters"][0];
  CHECK(mu["path"] == "materials.rock.friction.mu");
  CHECK(mu["value"].get<double>() == Approx(0.45).margin(0.1));
  CHECK(mu["low"].get<double>() < mu["value"].get<double>());
  CHECK(mu["high"].get<double>() > mu["value"].get<double>());
  CHECK(mu["determined"] == true);
  CHECK(found["agrees"] == true);
  CHECK(found["fitted"]["rows"] == 16);
  CHECK(found["held"]["rows"] == 8);
  CHECK(found["held_name"] == "late");
  const Json& skill = found["skill"];
  CHECK(skill["verdict"] == (skill["interval"][1].get<double>() < 0 ? "skill" : "no skill"));
  CHECK(fit.out.starts_with("No skill") == (skill["verdict"] == "no skill"));
  const std::string page = read(folder.path() / "fit/calibration.html");
  for (const char* heading : {"Misfit and region", "no judgement", "What was held back: late"})
    CHECK(page.find(heading) != std::string::npos);
  CHECK_FALSE(folder.has("fit/evaluations"));
  // The fitted scenario is one of its own, in another folder, and gives what the page says.
  const std::string fitted = read(folder.path() / "fit/fitted.yaml");
  CHECK(fitted.starts_with("# site.yaml with 1 number fitted"));
  REQUIRE(call(folder, "run fit/fitted.yaml --quiet -o again").code == 0);
  const Json again = Json::parse(read(folder.path() / "again/summary.json"))["points"][0]["observed"];
  CHECK(again["rows"] == 24);
  // The same bytes by any number of threads, and by the wish to go on.
  REQUIRE(call(folder, "calibrate site.yaml" + vary_mu + " --hold late -j 1 --quiet -o one").code == 0);
  for (const char* name : {"calibration.json", "calibration.html", "evaluations.csv"})
    CHECK(read(folder.path() / "fit" / name) == read(folder.path() / "one" / name));
  CHECK(call(folder, "calibrate site.yaml" + vary_mu + " -o one").code == 2);  // it is finished
}

TEST_CASE("what was held back may be a table, or another scenario", "[slow]") {
  const Folder folder;
  write_measurements(folder);
  folder.write("site.yaml", slope("0.3", compared));
  folder.write("other.yaml", slope("0.7", compared));
  std::string stops = read(folder.path() / "stops.csv");
  folder.write("again.csv", stops);
  REQUIRE(call(folder, "calibrate site.yaml" + vary_mu + " --hold again.csv --quiet -o a").code == 0);
  REQUIRE(call(folder, "calibrate site.yaml" + vary_mu + " --hold other.yaml --quiet -o b").code == 0);
  const Json table = calibration_of(folder, "a"), scenario = calibration_of(folder, "b");
  // Both are here what was fitted: the scores are the same.
  for (const Json& found : {table, scenario}) {
    CHECK(found["held"]["rows"] == 24);
    CHECK(found["held"]["energy_distance"] == found["fitted"]["energy_distance"]);
  }
}

TEST_CASE("the best point at the end of its way is exit code 1, a number that does nothing is not determined",
          "[slow]") {
  const Folder folder;
  write_measurements(folder);
  folder.write("site.yaml", slope("0.3", compared));
  const Output bound =
      call(folder, "calibrate site.yaml --vary materials.rock.friction.mu=0.65:0.8 --evaluations 6 -o bound");
  INFO(bound.out << bound.err);
  CHECK(bound.code == 1);
  CHECK(bound.out.find("at the end of its way") != std::string::npos);
  CHECK(calibration_of(folder, "bound")["parameters"][0]["bound"] == "low");
  const Output idle = call(folder,
                           "calibrate site.yaml --set materials.rock.friction.mu=0.45 --vary "
                           "rocks.0.density=2500:2700 --evaluations 6 -o idle");
  INFO(idle.out << idle.err);
  CHECK(idle.out.find("do not determine rocks.0.density") != std::string::npos);
  CHECK(calibration_of(folder, "idle")["parameters"][0]["determined"] == false);
}

TEST_CASE("an interrupted calibration goes on and ends in the same bytes", "[slow]") {
  const Folder folder;
  write_measurements(folder);
  folder.write("site.yaml", slope("0.3", compared));
  const std::string line = "'" FLYROCK_BINARY "' calibrate site.yaml" + vary_mu + " --quiet -j 1 -o ";
  REQUIRE(shell(folder, line + "whole").code == 0);
  // Interrupted when the first points are stored.
  const Output cut = shell(folder, line +
                                       "cut & p=$!; n=0; while [ $(ls cut/evaluations 2>/dev/null | wc -l) "
                                       "-lt 3 ] && [ $n -lt 400 ]; do sleep 0.02; n=$((n+1)); done; "
                                       "kill -INT $p; wait $p");
  INFO(cut.out << cut.err);
  if (cut.code == 0) WARN("SKIPPED: it had ended before it could be interrupted");
  if (cut.code != 0) {
    CHECK(cut.code == 130);
    CHECK_FALSE(folder.has("cut/calibration.json"));
    REQUIRE(shell(folder, line + "cut").code == 0);
  }
  CHECK(read(folder.path() / "whole/calibration.json") == read(folder.path() / "cut/calibration.json"));
}

TEST_CASE("what cannot be fitted is refused with the reason") {
  const Folder folder;
  write_measurements(folder);
  folder.write("site.yaml", slope("0.3", compared));
  folder.write("unmeasured.yaml", slope("0.3"));
  struct Refused {
    std::string arguments, says;
  };
  for (const Refused& refused : std::vector<Refused>{
           {"site.yaml", "expected --vary PATH=LOW:HIGH"},
           {"site.yaml --vary materials.rock.friction.mu=0.7:0.2", "below the greatest"},
           {"site.yaml --vary materials.rock.friction.mu=0.2:0.7 --vary materials.rock.friction.mu=0.2:0.7",
            "is given twice"},
           {"site.yaml --vary a=1:2 --vary b=1:2 --vary c=1:2 --vary d=1:2", "at most 3"},
           {"site.yaml --vary materials.rock.friction.mo=0.2:0.7", "mu"},
           {"site.yaml --vary materials.rock.friction.mu=-1:0.7", "mu"},
           {"site.yaml --vary materials.rock.friction.mu=0.2:0.7 --hold lat", "did you mean `late`"},
           {"site.yaml --vary materials.rock.friction.mu=0.2:0.7 --hold none.csv",
            "there is no file none.csv"},
           {"site.yaml --vary materials.rock.friction.mu=0.2:0.7 --statistic mean", "energy or quantiles"},
           {"unmeasured.yaml --vary materials.rock.friction.mu=0.2:0.7", "has no `observed`"}}) {
    INFO(refused.arguments);
    const Output output = call(folder, "calibrate " + refused.arguments + " -o never");
    INFO(output.err);
    CHECK(output.code == 2);
    CHECK(output.err.find(refused.says) != std::string::npos);
    CHECK_FALSE(folder.has("never"));
  }
}

}  // namespace flyrock::calibrate_test
