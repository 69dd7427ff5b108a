// What `make validation` does at measured sites, at a site that flyrock made: the fit finds the truth, and
// its scores are noise.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/rows.h"

namespace flyrock::validation_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

/// A face of 26 m, a bench, a steep slope and a floor about the place from which the scenario releases its
/// blocks.
std::string quarry() {
  const std::vector<std::pair<double, double>> section = {{-30, 212}, {-3, 211}, {12, 187},
                                                          {20, 184},  {40, 166}, {260, 160}};
  std::string text;
  for (const auto& [x, z] : section)
    for (const double y : {-520.0, -220.0}) text += fmt::format("v {} {} {}\n", x, y, z);
  for (std::size_t i = 1; i < section.size(); ++i) {
    const std::size_t right = 2 * i - 1;  // vertices are counted from 1
    text += fmt::format("f {} {} {}\nf {} {} {}\n", right, right + 2, right + 3, right, right + 3, right + 1);
  }
  return text;
}

/// 41 blocks, and where each of them stopped (0 of none).
std::string blocks(const std::vector<std::string>& stops) {
  std::string text = "block,mass_kg,l1_m,l2_m,l3_m,stop_x_m,stop_y_m,stop_z_m\n";
  for (std::size_t i = 0; i < 41; ++i)
    text += fmt::format("s{},{},{},0.7,0.5,{}\n", i, 200 + 35 * i, 0.8 + 0.01 * static_cast<double>(i),
                        stops.empty() ? "0,0,0" : stops[i]);
  return text;
}

}  // namespace

TEST_CASE("validation finds the numbers of a site that flyrock made, with scores in their noise", "[heavy]") {
  const Folder folder;
  if (shell(folder, "python3 --version").code != 0) {
    WARN("SKIPPED: no python3");
    return;
  }
  const std::string validation = FLYROCK_SOURCE_DIR "/tests/validation/";
  fs::create_directories(folder.path() / "data/authume");
  folder.write("data/authume/terrain.obj", quarry());
  folder.write("data/authume/blocks_p1.csv", blocks({}));
  fs::copy_file(validation + "authume.yaml", folder.path() / "data/authume/truth.yaml");
  // The truth: one trial of the model, with another seed.
  const Output truth = call(folder,
                            "run data/authume/truth.yaml --trials 1 --seed 77 --quiet -o truth "
                            "--set materials.ground.friction.mu=0.4 "
                            "--set 'materials.ground.roughness.angle.normal.sd=8 deg'");
  INFO(truth.out << truth.err);
  REQUIRE(truth.code == 0);
  const std::vector<std::string> stops =
      query(folder.path() / "truth/results.db",
            "SELECT stop_x_m || ',' || stop_y_m || ',' || stop_z_m FROM rocks ORDER BY rock");
  REQUIRE(stops.size() == 41);
  folder.write("data/authume/blocks_p1.csv", blocks(stops));

  const Output made =
      shell(folder, "python3 '" + validation + "run.py' '" FLYROCK_BINARY "' data authume tschamut2014");
  INFO(made.out << made.err);
  REQUIRE(made.code == 0);
  CHECK(made.out.find("tschamut2014: SKIPPED, tschamut2014/terrain.asc is absent") != std::string::npos);
  CHECK(made.out.find("| authume | 41 | 0.") != std::string::npos);
  const Json found = Json::parse(read(folder.path() / "out/validation/authume/fit/calibration.json"));
  const Json &mu = found["parameters"][0], &roughness = found["parameters"][1], &fitted = found["fitted"];
  CHECK(found["agrees"] == true);
  CHECK(mu["low"].get<double>() < 0.4);
  CHECK(mu["high"].get<double>() > 0.4);
  constexpr double degree = 3.14159265358979 / 180;
  CHECK(roughness["low"].get<double>() < 8 * degree);
  CHECK(roughness["high"].get<double>() > 8 * degree);
  CHECK(std::abs(fitted["bias"].get<double>()) < 2 * fitted["bias_error"].get<double>());
  CHECK(fitted["energy_distance"].get<double>() < fitted["energy_noise_p90"].get<double>());
  CHECK(fitted["constant"]["energy_distance"].get<double>() > 5 * fitted["energy_distance"].get<double>());
  // The bands of the rows, with other random numbers than those of the fit.
  const Json other = Json::parse(read(folder.path() / "out/validation/authume/fit/run/summary.json"));
  const Json& inside = other["points"][0]["observed"]["inside_90"];
  CHECK(inside["of"] == 41);
  CHECK(inside["rows"].get<int>() >= 33);
}

}  // namespace flyrock::validation_test
