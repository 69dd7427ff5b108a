// Tasks of a cluster: which shard they make, and the scripts that send them.

#include <catch2/catch.hpp>

#include "cli/program.h"

namespace flyrock::cluster_test {

using namespace flyrock::test;

const std::string slope = R"(flyrock: 1
dimension: 2
method: lumped_mass
trials: 40
terrain: { type: profile, points: [[-5, 20], [0, 20], [20, 0], [100, 0]], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.6 } } }
rocks: [{ name: r, density: 2700, shape: { type: disk, radius: 0.2 }, release: { x: 1, above_ground: { uniform: [1, 5] } } }]
stop: { time: 60 s }
)";

Output as_task(const Folder& folder, const std::string& environment, const std::string& arguments) {
  return shell(folder, "env " + environment + " '" FLYROCK_BINARY "' " + arguments);
}

TEST_CASE("tasks of a cluster know their shard, and together make the bytes of one run") {
  const Folder folder;
  folder.write("s.yaml", slope);
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  const std::string run = "run s.yaml --quiet --shard auto -o parts";
  // An array of Slurm, a rank of MPI, a process of srun.
  CHECK(as_task(folder, "SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=1 FLYROCK_SHARDS=3", run).code == 0);
  CHECK(as_task(folder, "OMPI_COMM_WORLD_RANK=1 OMPI_COMM_WORLD_SIZE=3", run).code == 0);
  CHECK(as_task(folder, "SLURM_PROCID=2 SLURM_NTASKS=3", run).code == 0);
  REQUIRE(call(folder, "merge parts/shard-1 parts/shard-2 parts/shard-3 --quiet -o merged").code == 0);
  for (const char* file : {"summary.json", "rocks.csv", "results.db"})
    CHECK(read(folder.path() / "whole" / file) == read(folder.path() / "merged" / file));
}

TEST_CASE("a task without its shard says what is missing") {
  const Folder folder;
  folder.write("s.yaml", slope);
  const std::string run = "run s.yaml --quiet --shard auto -o parts";
  for (const auto& [environment, says] : std::vector<std::pair<std::string, std::string>>{
           {"A=1", "no task of a cluster"},
           {"SLURM_PROCID=0 SLURM_NTASKS=1", "no task of a cluster"},
           {"SLURM_ARRAY_TASK_ID=1", "FLYROCK_SHARDS is not"},
           {"SLURM_ARRAY_TASK_ID=4 FLYROCK_SHARDS=3", "has only 3"},
           {"SLURM_ARRAY_TASK_ID=0 FLYROCK_SHARDS=3", "SLURM_ARRAY_TASK_ID"}}) {
    INFO(environment);
    const Output output = as_task(folder, environment, run);
    CHECK(output.code == 2);
    CHECK(output.err.find(says) != std::string::npos);
  }
}

TEST_CASE("the scripts of submit make the bytes of one run") {
  const Folder folder;
  folder.write("s.yaml", slope);
  REQUIRE(call(folder, "run s.yaml --seed 7 --quiet -o whole").code == 0);
  const Output made = call(folder, "submit s.yaml --slurm -n 2 --seed 7 -o \"it's here\"");
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(made.out.find("sbatch --dependency=afterany:$job") != std::string::npos);
  for (const char* task : {"1", "2"})
    CHECK(
        shell(folder, std::string("SLURM_ARRAY_TASK_ID=") + task + " bash \"it's here/array.sbatch\"").code ==
        0);
  REQUIRE(shell(folder, "bash \"it's here/merge.sbatch\"").code == 0);
  CHECK(read(folder.path() / "whole/rocks.csv") == read(folder.path() / "it's here/merged/rocks.csv"));
  CHECK(call(folder, "submit s.yaml -n 2").code == 2);
  CHECK(call(folder, "submit s.yaml --slurm").code == 2);
  CHECK(call(folder, "submit none.yaml --slurm -n 2").code == 2);
}

TEST_CASE("status says which shards are done, lost or not begun, and the command that runs them again") {
  const Folder folder;
  folder.write("s.yaml", slope);
  const std::string run = "run s.yaml --quiet --seed 7 --shard auto -o parts";
  for (const char* task : {"1", "2"})
    REQUIRE(as_task(folder, std::string("FLYROCK_SHARDS=4 SLURM_ARRAY_TASK_ID=") + task, run).code == 0);
  fs::remove(folder.path() / "parts/shard-2/chunks/p0-c5.chunk");
  const Output status = call(folder, "status parts");
  INFO(status.out << status.err);
  REQUIRE(status.code == 0);
  CHECK(status.out.find("parts: 19 of 40 chunks are done (47 %)\n") == 0);
  CHECK(status.out.find("shard 1 of 4") == std::string::npos);
  CHECK(call(folder, "status parts --all").out.find("shard 1 of 4: done") != std::string::npos);
  CHECK(status.out.find("shard 2 of 4: 9 of 10 chunks, the last one 0:") != std::string::npos);
  CHECK(status.out.find("shard 3 of 4: not begun") != std::string::npos);
  // The commands that it prints complete the run.
  const std::string flyrock = "PATH=\"$(dirname '" FLYROCK_BINARY "')\":$PATH; ";
  CHECK(shell(folder, flyrock + "flyrock status parts | grep '^  flyrock run' | sh -e").code == 0);
  CHECK(call(folder, "status parts").out.find("all shards are done") != std::string::npos);
  REQUIRE(call(folder, "merge parts/* --quiet -o merged").code == 0);
  REQUIRE(call(folder, "run s.yaml --seed 7 --quiet -o whole").code == 0);
  CHECK(read(folder.path() / "whole/rocks.csv") == read(folder.path() / "merged/rocks.csv"));
  CHECK(call(folder, "status whole").out.find("done") != std::string::npos);
  CHECK(call(folder, "status s.yaml").code == 2);
  CHECK(call(folder, "status nowhere").code == 2);
}

TEST_CASE("rocks and their statistics do not depend on the size of chunks") {
  const Folder folder;
  folder.write("s.yaml", slope);
  for (const char* size : {"1", "7", "40", "1000"}) {
    REQUIRE(
        call(folder, std::string("run s.yaml --quiet --set output.chunk=") + size + " -o c" + size).code ==
        0);
    CHECK(read(folder.path() / "c1/rocks.csv") ==
          read(folder.path() / ("c" + std::string(size)) / "rocks.csv"));
    CHECK(read(folder.path() / "c1/summary.json") ==
          read(folder.path() / ("c" + std::string(size)) / "summary.json"));
  }
  CHECK(call(folder, "run s.yaml --quiet --set output.chunk=0 -o none").code == 2);
}

}  // namespace flyrock::cluster_test
