// flyrock export --to hdf5: the tables of results.db as groups of data sets.

#include <catch2/catch.hpp>
#include <cmath>

#include "program.h"
#include "rows.h"
#include "solver/hdf5_file.h"

namespace flyrock::hdf5_export_test {

namespace {

using namespace flyrock::test;

std::vector<std::string> column(const Folder& folder, const std::string& table, const std::string& name) {
  return query(folder.path() / "r/results.db", "SELECT " + name + " FROM " + table + " ORDER BY rowid");
}

}  // namespace

TEST_CASE("HDF5 has each table as a group and each column as a data set, in the order of the rows") {
  const Folder folder;
  folder.write("s.yaml",
               bench_with("mu: 0.6", "mu: { sweep: [0.5, 0.7] }") + "gates: [{ name: road, x: 6 }]\n");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output exported = call(folder, "export r --to hdf5");
  if (!has_hdf5()) {
    CHECK(exported.code == 2);
    CHECK(exported.err.find("built without HDF5") != std::string::npos);
    return;
  }
  INFO(exported.err);
  REQUIRE(exported.code == 0);
  CHECK(exported.out == "r/hdf5/results.h5\n");
  const Hdf5File file = Hdf5File::open((folder.path() / "r/hdf5/results.h5").string());
  const auto rocks = query(folder.path() / "r/results.db", "SELECT count(*) FROM rocks");
  REQUIRE(std::stoul(rocks[0]) > 3);
  const auto trials = file.integers("/rocks/trial");
  const auto masses = file.doubles("/rocks/mass_kg");
  CHECK(trials.size() == std::stoul(rocks[0]));
  for (std::size_t i = 0; i < trials.size(); ++i) {
    CHECK(trials[i] == std::stoll(column(folder, "rocks", "trial")[i]));
    CHECK(masses[i] == Approx(std::stod(column(folder, "rocks", "mass_kg")[i])).epsilon(1e-12));
  }
  CHECK(file.has("/rocks/group"));
  CHECK(file.has("/gates/energy_J"));
  CHECK(file.count("/sweep/point") == column(folder, "sweep", "point").size());
  CHECK(file.has("/inputs/path"));
  REQUIRE(call(folder, "export r --to hdf5 -o again").code == 0);
  CHECK(read(folder.path() / "again/results.h5") == read(folder.path() / "r/hdf5/results.h5"));
}

}  // namespace flyrock::hdf5_export_test
