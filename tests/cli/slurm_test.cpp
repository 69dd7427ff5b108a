// One node of Slurm on the loopback: an array of 8 shards, one requeued in the middle, one killed and sent
// again by the command that `status` prints, gives the bytes of one run. Needs slurm-wlm and munge and the
// right to start them (root); says SKIPPED without.

#include <unistd.h>

#include <catch2/catch.hpp>

#include "cli/program.h"

namespace flyrock::slurm_test {

using namespace flyrock::test;

const std::string configuration = R"(ClusterName=flyrock
SlurmctldHost=HOST(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=DIR/munge/sock
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
StateSaveLocation=DIR/state
SlurmdSpoolDir=DIR/spool
SlurmctldPidFile=DIR/slurmctld.pid
SlurmdPidFile=DIR/slurmd.pid
SlurmctldLogFile=DIR/ctld.log
SlurmdLogFile=DIR/d.log
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
JobRequeue=1
NodeName=HOST NodeAddr=127.0.0.1 CPUs=CORES State=UNKNOWN
PartitionName=main Nodes=HOST Default=YES MaxTime=INFINITE State=UP
)";

const std::string slope = R"(flyrock: 1
dimension: 2
method: nscd
trials: 800
terrain: { type: profile, points: [[-5, 20], [0, 20], [20, 0], [100, 0]], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.4 }, friction: { type: coulomb, mu: 0.6 } } }
rocks:
  - name: r
    per_trial: 3
    density: 2700
    shape: { type: polygon, sides: { integer: [5, 9] }, diameter: { uniform: [0.3, 0.8] } }
    release: { x: 1, above_ground: { uniform: [1, 5] } }
stop: { time: 60 s }
)";

/// Starts the daemons in `slurm` of the folder and ends them with it.
const std::string start = R"(set -eu
host=$(hostname -s)
mkdir -p slurm/munge slurm/state slurm/spool
chmod 711 slurm/munge
(umask 077; head -c 128 /dev/urandom > slurm/munge/key)
sed -i -e "s|DIR|$PWD/slurm|g" -e "s/HOST/$host/g" -e "s/CORES/$(nproc)/" slurm.conf
munge=$PWD/slurm/munge
munged -F --force --key-file=$munge/key --socket=$munge/sock --pid-file=$munge/pid --log-file=$munge/log \
  --seed-file=$munge/seed >/dev/null 2>&1 & echo $! > pids
sleep 1
slurmctld -D >/dev/null 2>&1 & echo $! >> pids
slurmd -D >/dev/null 2>&1 & echo $! >> pids
for i in $(seq 60); do sinfo -h 2>/dev/null | grep -q idle && exit 0; sleep 0.5; done
exit 1
)";

class Slurm {
 public:
  explicit Slurm(const Folder& folder) : folder_(folder) {
    folder.write("slurm.conf", configuration);
    folder.write("start.sh", start);
    runs_ = run("bash start.sh").code == 0;
  }
  ~Slurm() { shell(folder_, "kill $(tac pids); sleep 1; kill -KILL $(tac pids) 2>/dev/null"); }
  Slurm(const Slurm&) = delete;
  Slurm& operator=(const Slurm&) = delete;

  bool runs() const { return runs_; }
  Output run(const std::string& line) const {
    return shell(folder_, "export SLURM_CONF=\"$PWD/slurm.conf\"; " + line);
  }
  void wait() const { run("while [ -n \"$(squeue -h)\" ]; do sleep 0.5; done"); }

 private:
  const Folder& folder_;
  bool runs_ = false;
};

bool has_slurm() {
  const Folder folder;
  return ::geteuid() == 0 && shell(folder, "command -v slurmctld slurmd munged sbatch").code == 0;
}

TEST_CASE("an array of Slurm with a requeued and a killed task gives the bytes of one run", "[heavy]") {
  if (!has_slurm()) {
    WARN("SKIPPED: no slurm-wlm and munge, or not root");
    return;
  }
  const Folder folder;
  folder.write("s.yaml", slope);
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  const Slurm slurm(folder);
  INFO(read(folder.path() / "slurm/ctld.log"));
  REQUIRE(slurm.runs());
  REQUIRE(call(folder, "submit s.yaml --slurm -n 8 -o job").code == 0);
  const Output sent = slurm.run("sbatch --parsable job/array.sbatch");
  INFO(sent.err);
  REQUIRE(sent.code == 0);
  const std::string job = sent.out.substr(0, sent.out.find('\n'));
  // In the middle of their work the first task is sent back to the queue, the second loses its process.
  slurm.run(
      "for i in $(seq 300); do ls job/shard-1/chunks/*.chunk job/shard-2/chunks/*.chunk && break; sleep 0.1; "
      "done");
  CHECK(slurm.run("scontrol requeue " + job + "_1").code == 0);
  const Output killed = slurm.run(
      "for p in $(pgrep -f 'shard auto'); do "
      "if tr '\\0' '\\n' < /proc/$p/environ | grep -q '^SLURM_ARRAY_TASK_ID=2$'; then kill -KILL $p; echo "
      "killed; fi; done");
  CHECK(killed.out.find("killed") != std::string::npos);
  slurm.wait();

  const Output status = call(folder, "status job");
  INFO(status.out);
  CHECK(status.out.find("shard 2 of 8") != std::string::npos);
  CHECK(status.out.find("shard 1 of 8") == std::string::npos);  // done, although it was requeued
  // The merge of what there is says what is missing.
  CHECK(call(folder, "merge job/shard-* --quiet -o incomplete").code == 3);
  CHECK(call(folder, "merge job/shard-* --quiet --partial -o partial").code == 0);
  const std::size_t at = status.out.find("sbatch --array=2 ");
  REQUIRE(at != std::string::npos);
  REQUIRE(slurm.run(status.out.substr(at, status.out.find('\n', at) - at)).code == 0);
  slurm.wait();
  REQUIRE(slurm.run("sbatch job/merge.sbatch").code == 0);
  slurm.wait();
  INFO(read(folder.path() / "job/log-merge.txt"));
  for (const char* file : {"manifest.json", "summary.json", "rocks.csv", "results.db", "report.html"}) {
    INFO(file);
    CHECK(read(folder.path() / "whole" / file) == read(folder.path() / "job/merged" / file));
  }
  CHECK(call(folder, "status job").out.find("all shards are done") != std::string::npos);
}

}  // namespace flyrock::slurm_test
