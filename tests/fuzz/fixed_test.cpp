// The same mutants each time: whoever makes one of them crash, hang or fail without a line finds out before a
// long fuzzing does.

#include <unistd.h>

#include <catch2/catch.hpp>

#include "fuzz.h"

using namespace flyrock::fuzz;

TEST_CASE("2000 fixed mutants give no signal, no hang, documented exit codes and errors that say where",
          "[slow]") {
  FuzzSettings settings;
  settings.mutants = 2000;
  settings.findings =
      std::filesystem::temp_directory_path() / ("flyrock_fuzz_findings_" + std::to_string(::getpid()));
  const std::vector<KindTally> tallies = fuzz(settings);
  INFO(table_of(tallies) << settings.findings << " has the mutants");
  CHECK(sum_of(tallies).mutants >= 1800);  // without HDF5 there are fewer
  REQUIRE(sum_of(tallies).findings() == 0);
  std::filesystem::remove_all(settings.findings);
}

TEST_CASE("100 fixed scenes of bodies on the ground and on each other move as bodies do", "[slow]") {
  FuzzSettings settings;
  settings.mutants = 100;
  settings.kind = "scenes";
  settings.seed = 1;
  settings.findings =
      std::filesystem::temp_directory_path() / ("flyrock_scene_findings_" + std::to_string(::getpid()));
  const std::vector<KindTally> tallies = fuzz(settings);
  INFO(table_of(tallies) << settings.findings << " has the scenes");
  CHECK(sum_of(tallies).mutants == 100);
  REQUIRE(sum_of(tallies).findings() == 0);
  std::filesystem::remove_all(settings.findings);
}

TEST_CASE("100 fixed files of ground are read as they are meant, or refused with what helps") {
  FuzzSettings settings;
  settings.mutants = 100;
  settings.kind = "terrain";
  settings.seed = 1;
  settings.findings =
      std::filesystem::temp_directory_path() / ("flyrock_terrain_findings_" + std::to_string(::getpid()));
  const std::vector<KindTally> tallies = fuzz(settings);
  INFO(table_of(tallies) << settings.findings << " has the files");
  CHECK(sum_of(tallies).mutants == 100);
  REQUIRE(sum_of(tallies).findings() == 0);
  std::filesystem::remove_all(settings.findings);
}

TEST_CASE("200 fixed tables of holes are read as they are meant, or refused") {
  FuzzSettings settings;
  settings.mutants = 200;
  settings.kind = "tables";
  settings.seed = 1;
  settings.findings =
      std::filesystem::temp_directory_path() / ("flyrock_table_findings_" + std::to_string(::getpid()));
  const std::vector<KindTally> tallies = fuzz(settings);
  INFO(table_of(tallies) << settings.findings << " has the tables");
  CHECK(sum_of(tallies).mutants == 200);
  REQUIRE(sum_of(tallies).findings() == 0);
  std::filesystem::remove_all(settings.findings);
}

TEST_CASE("200 damaged workbooks, layers and clouds each are read, or refused in lines with a place",
          "[slow]") {
  for (const char* kind : {"sheets", "layers"}) {
    FuzzSettings settings;
    settings.mutants = 200;
    settings.kind = kind;
    settings.seed = 1;
    settings.findings =
        std::filesystem::temp_directory_path() / ("flyrock_survey_findings_" + std::to_string(::getpid()));
    const std::vector<KindTally> tallies = fuzz(settings);
    INFO(table_of(tallies) << settings.findings << " has the files");
    CHECK(sum_of(tallies).mutants == 200);
    REQUIRE(sum_of(tallies).findings() == 0);
    std::filesystem::remove_all(settings.findings);
  }
}
