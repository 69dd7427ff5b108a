// What may go wrong around a run: one clear line, nothing lost, the right exit code.

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "same_result.h"

using namespace flyrock::test;

namespace {

void check_refused(const Folder& folder, const std::string& arguments, const std::string& text) {
  const Output output = call(folder, arguments);
  INFO(arguments << ": " << output.err);
  CHECK(output.code == 2);
  CHECK(output.err.find(text) != std::string::npos);
}

/// The program in a folder of the test, which a user without rights can enter. The build may lie below a
/// folder that only its owner, or only root, can enter.
std::string copied_program(const Folder& folder) {
  const fs::path program = folder.path() / "program";
  fs::create_directories(program / "bin");
  fs::copy_file(FLYROCK_BINARY, program / "bin/flyrock");
  for (const char* part : {"lib/flyrock", "share/flyrock"}) {
    fs::create_directories((program / part).parent_path());
    fs::copy(fs::path(FLYROCK_BINARY).parent_path().parent_path() / part, program / part,
             fs::copy_options::recursive);
  }
  return (program / "bin/flyrock").string();
}

/// The line as its user would run it without the right of root to enter and write every folder. The user
/// stays the same, because another one may not be able to enter the folder of the test. Where root cannot
/// give that right away, a container has taken it already.
std::string without_rights(const Folder& folder, const std::string& line) {
  if (::geteuid() != 0) return line;
  const std::string drop = "setpriv --bounding-set=-dac_override,-dac_read_search ";
  return shell(folder, drop + "true").code == 0 ? drop + line : line;
}

std::string many_trials() {
  std::string text = bench;
  return text.replace(text.find("trials: 4"), 9, "trials: 400");
}

}  // namespace

TEST_CASE("A full disk is one line, and --resume goes on with what was done") {
  const Folder folder;
  folder.write("s.yaml", many_trials());
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  // Files may not grow beyond so many blocks of 512 bytes: too few for a chunk, then too few for the
  // database.
  for (const int blocks : {40, 300}) {
    const Output full = shell(folder, "ulimit -f " + std::to_string(blocks) +
                                          "; '" FLYROCK_BINARY "' run s.yaml --quiet -o full --resume");
    INFO(full.err);
    CHECK(full.code == 3);
    CHECK(one_line(full.err));
    CHECK(full.err.find("error: cannot write full/") == 0);
    CHECK(full.err.find("; what was done is kept in full/chunks, --resume goes on") != std::string::npos);
    CHECK_FALSE(folder.has("full/run.log"));
  }
  REQUIRE(call(folder, "run s.yaml --quiet -o full --resume").code == 0);
  check_same(folder, "whole", "full");
}

TEST_CASE("A folder that cannot be written is told before anything runs") {
  const Folder folder;
  folder.write("s.yaml", bench);
  folder.write("file", "not a folder");
  check_refused(folder, "run s.yaml -o file", "file is a file, expected a folder");
  check_refused(folder, "run s.yaml -o file/below", "cannot make the folder file/below: Not a directory");
  fs::create_directories(folder.path() / "closed");
  fs::permissions(folder.path() / "closed", fs::perms::owner_read | fs::perms::owner_exec |
                                                fs::perms::others_exec | fs::perms::others_read);
  const std::string program = "'" + copied_program(folder) + "'";
  for (const char* path : {"closed", "closed/r"}) {
    const Output output =
        shell(folder, without_rights(folder, program + " run s.yaml --quiet -o " + std::string(path)));
    INFO(output.err);
    CHECK(output.code == 2);
    CHECK(one_line(output.err));
    CHECK(output.err.find("Permission denied") != std::string::npos);
  }
  CHECK(fs::is_empty(folder.path() / "closed"));
}

TEST_CASE("A name that is too long for a folder is bad input") {
  const Folder folder;
  check_refused(folder, "merge " + std::string(300, 'x') + " -o merged", "is not a result folder");
  check_refused(folder, "merge shard -o " + std::string(300, 'x'), "is not a result folder");
  check_refused(folder, "export " + std::string(300, 'x') + " --to csv", "is not a result folder");
}

TEST_CASE("A result of an older format is neither read nor gone on with") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  std::string manifest = read(folder.path() / "r/manifest.json");
  const std::string format = "\"format\": 18";
  const std::size_t at = manifest.find(format);
  REQUIRE(at != std::string::npos);
  folder.write("r/manifest.json", manifest.replace(at, format.size(), "\"format\": 2"));
  for (const char* command : {"report r", "export r --to csv", "merge r -o m", "run s.yaml --resume -o r"})
    check_refused(folder, command,
                  "error: r was written by flyrock 0.1.0 in format 2, this one has format 18: run the "
                  "scenario again, with --force or -o DIR\n");
  CHECK(folder.has("r/results.db"));
  CHECK(call(folder, "run s.yaml --force --quiet -o r").code == 0);
  CHECK(call(folder, "report r").code == 0);
}

TEST_CASE("Nobody reads or writes a folder in which a run is writing") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  CHECK_FALSE(folder.has("r/lock"));
  folder.write("r/lock", "");
  const int lock = ::open((folder.path() / "r/lock").c_str(), O_RDWR);
  REQUIRE(::flock(lock, LOCK_EX | LOCK_NB) == 0);
  for (const char* command : {"report r", "export r --to vtk", "merge r -o m", "run s.yaml --resume -o r",
                              "run s.yaml --force -o r", "run s.yaml -o r"})
    check_refused(folder, command, "error: r: another flyrock is writing there\n");
  ::close(lock);  // as when that run is killed: the file stays, the lock does not
  CHECK(call(folder, "report r").code == 0);
  CHECK(call(folder, "run s.yaml --force --quiet -o r").code == 0);
  CHECK_FALSE(folder.has("r/lock"));
}

TEST_CASE("A report is refused while its run is writing, and the run goes on") {
  const Folder folder;
  folder.write("s.yaml", many_trials());
  const Output both =
      shell(folder, "'" FLYROCK_BINARY
                    "' run s.yaml --quiet -o r & run=$!; n=0; "
                    "while [ ! -e r/chunks/p0-c0.chunk ] && [ $n -lt 400 ]; do sleep 0.02; n=$((n+1)); done; "
                    "kill -STOP $run; '" FLYROCK_BINARY
                    "' report r; echo report $?; "
                    "'" FLYROCK_BINARY
                    "' run s.yaml --force -o r; echo second run $?; "
                    "kill -CONT $run; wait $run; echo run $?");
  INFO(both.err);
  CHECK(both.out == "report 2\nsecond run 2\nrun 0\n");
  CHECK(both.err ==
        "error: r: another flyrock is writing there\nerror: r: another flyrock is writing there\n");
  CHECK(call(folder, "report r").code == 0);
}

TEST_CASE(
    "A rock that a law throws beyond all numbers is a row that diverged, and no nan or inf is printed") {
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "huge", form = "newton", may_gain = true, doc = "Throws heavy rocks back.", source = "a test",
  params = { en = fr.number { default = 1e300, min = 0, doc = "of a heavy rock" } },
  impact = function(p, contact)
    if contact.time > 0 and contact.mass > 250 then return p.en, 0 end
    return 0.4, 0
  end,
}
)");
  std::string text = "plugins: [law.lua]\n" + bench_with("{ type: newton, en: 0.3 }", "{ type: huge }");
  text.replace(text.find("diameter: 0.5"), 13, "diameter: { uniform: [0.4, 0.6] }");
  folder.write("s.yaml", text.replace(text.find("trials: 4"), 9, "trials: 30"));
  const Output run = call(folder, "run s.yaml -o r");
  CHECK(run.code == 3);
  CHECK(run.err.find("error: point 0, trial 3, rock 0: diverged: its state is not finite, or it is faster "
                     "than 100 km/s\n") == 0);
  CHECK(run.out.find("24 stopped, 6 diverged\n") != std::string::npos);
  // 1000 km/s, which is a number still.
  const Output fast = call(folder, "run s.yaml -o fast --set materials.rock.restitution.en=1e5");
  CHECK(fast.code == 3);
  CHECK(fast.out.find("24 stopped, 6 diverged\n") != std::string::npos);
  for (const char* result : {"r", "fast"}) {
    REQUIRE(call(folder, std::string("export ") + result + " --to csv").code == 0);
    const std::regex no_number("\\b(nan|inf)\\b", std::regex::icase);
    for (const char* file :
         {"rocks.csv", "summary.json", "csv/rocks.csv", "csv/impacts.csv", "csv/trajectories.csv"})
      CHECK_FALSE(std::regex_search(read(folder.path() / result / file), no_number));
    CHECK_FALSE(std::regex_search(run.out + run.err + fast.out + fast.err, no_number));
  }
}

TEST_CASE("A damaged chunk is found before a merge makes anything") {
  const Folder folder;
  folder.write("s.yaml", bench);
  for (const char* shard : {"1", "2"})
    REQUIRE(call(folder, std::string("run s.yaml --quiet --shard ") + shard + "/2 -o s" + shard).code == 0);
  const fs::path chunk = folder.path() / "s2/chunks/p0-c3.chunk";
  const std::string whole = read(chunk);
  std::string damaged = whole;
  damaged[damaged.size() / 2] ^= 1;
  folder.write("s2/chunks/p0-c3.chunk", damaged);
  check_refused(folder, "merge s1 s2 -o m",
                "error: s2/chunks/p0-c3.chunk is not what a run wrote: damaged: its checksum is wrong; "
                "run its shard again with --resume\n");
  CHECK_FALSE(folder.has("m"));
  REQUIRE(call(folder, "run s.yaml --quiet --shard 2/2 -o s2 --resume").code == 0);
  CHECK(read(chunk) == whole);
  CHECK(call(folder, "merge s1 s2 -o m --quiet").code == 0);
}

TEST_CASE(
    "A rock that would start deep in the ground, or with a speed beyond all rocks, is refused before "
    "anything runs") {
  const Folder folder;
  folder.write("deep.yaml", bench_with("position: [0, 12]", "position: [1, -25]"));
  check_refused(folder, "run deep.yaml -o r",
                "deep.yaml:17:5: error: rocks.0.release: trial 0, rock 0: `blocks` starts at (1, -25) m, "
                "31.7 m inside the terrain: "
                "its centre of mass is below the ground, where no radius fits\n"
                "      release: { position: [1, -25] }\n      ^\n");
  folder.write("fast.yaml", bench_with("{ uniform: [5, 15] }", "1e155"));
  check_refused(folder, "run fast.yaml -o r",
                "fast.yaml:18:5: error: rocks.0.launch: trial 0, rock 0: `blocks` starts with inf m/s and 0 "
                "rad/s, expected at most "
                "1e+05 m/s and 1e+06 rad/s\n"
                "      launch: { type: fixed, speed: 1e155, elevation: 20 deg }\n      ^\n");
  CHECK_FALSE(folder.has("r"));
}

TEST_CASE("A fault for which no plugin is to blame has its own reason") {
  const Folder folder;
  const auto scenario = [](const std::string& restitution, const std::string& rock,
                           const std::string& height) {
    return "flyrock: 1\ndimension: 2\nmethod: nscd\ntrials: 300\n"
           "terrain: { type: profile, points: [[-50, 0], [50, 0]], material: rock }\n"
           "materials: { rock: { restitution: " +
           restitution +
           ", friction: { type: coulomb, mu: 0.5 } } }\n"
           "rocks: [{ name: stones, density: 2700, shape: " +
           rock +
           ", orientation: 0 deg,\n"
           "  release: { position: [0, " +
           height + "] } }]\nstop: { time: 20 }\n";
  };
  // The 200 trials that are tried start well, so that the scenario is sound; trial 795 does not.
  folder.write("start.yaml", scenario("{ type: newton, en: 0.5 }", "{ type: disk, radius: 0.5 }",
                                      "{ uniform: [0.498, 5] }"));
  const Output start = call(folder, "run start.yaml -o start --seed 4 --trials 1000 --set stop.time=0.01");
  INFO(start.err);
  CHECK(start.code == 3);
  CHECK(start.err.find("not_started: rocks.0.release: `stones` starts at (0, 0.") != std::string::npos);
  CHECK(start.err.find("plugin_error") == std::string::npos);
  CHECK(read(folder.path() / "start/rocks.csv").find(",not_started,") != std::string::npos);
}

TEST_CASE("A law of form velocity is refused for shapes with corners, at every point of a sweep") {
  const Folder folder;
  const auto scenario = [](const std::string& method, const std::string& shape) {
    return "flyrock: 1\ndimension: 2\nmethod: " + method +
           "\ntrials: 20\n"
           "terrain: { type: profile, points: [[-50, 20], [0, 0], [10, 1], [50, 0]], material: rock }\n"
           "materials: { rock: { restitution: { type: normal_tangential, rn: 0.35, rt: 0.85 }, friction: { "
           "type: "
           "coulomb, mu: 0.5 }, rolling: { type: rolling_resistance, mu_r: 0.05 m } } }\n"
           "rocks: [{ name: stones, density: 2700, shape: " +
           shape + ", release: { position: [-40, 20] } }]\nstop: { time: 60 }\n";
  };
  const std::string square = "{ type: polygon, sides: 4, diameter: 0.5 }",
                    disk = "{ type: disk, radius: 0.25 }";
  folder.write("square.yaml", scenario("nscd", square));
  folder.write("swept.yaml", scenario("{ sweep: [lumped_mass, nscd] }", square));
  folder.write("point.yaml", scenario("lumped_mass", square));
  folder.write("disk.yaml", scenario("nscd", disk));
  for (const std::string command : {"check square.yaml", "check swept.yaml", "run square.yaml -o s"}) {
    const Output refused = call(folder, command);
    INFO(command << '\n' << refused.err);
    CHECK(refused.code == 2);
    CHECK(refused.err.find(
              "error: materials.rock.restitution: `stones` has corners, of which several can touch at "
              "once") != std::string::npos);
    CHECK(refused.out.find("a sound scenario") == std::string::npos);
  }
  CHECK(call(folder, "check point.yaml").code == 0);
  const Output round = call(folder, "run disk.yaml -o d");
  INFO(round.err);
  CHECK(round.code == 0);
}

TEST_CASE("A point that lost more than 5 % of its rocks has no percentiles, shares and clearances") {
  const Folder folder;
  folder.write("picky.lua", R"(local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "picky", doc = "Fails beyond x = limit.", reads = { "contact.place" },
  params = { limit = fr.number { unit = "m" } },
  impact = function(p, contact)
    if contact.place[1] > p.limit then error("beyond") end
    return 0.3
  end }
)");
  folder.write("lost.yaml", R"(flyrock: 1
dimension: 2
method: nscd
trials: 200
plugins: [picky.lua]
terrain: { type: profile, points: [[-50, 0], [50, 0]], material: rock }
materials: { rock: { restitution: { type: picky, limit: { sweep: [100 m, 9 m, 3 m] } }, friction: { type: coulomb, mu: 0.5 }, rolling: { type: rolling_resistance, mu_r: 0.05 m } } }
rocks: [{ name: stones, density: 2700, shape: { type: disk, radius: 0.2 }, release: { position: [0, 1] }, launch: { type: fixed, speed: { uniform: [1, 10] }, elevation: 45 deg } }]
gates: [{ name: road, x: 2 m }]
stop: { time: 60 }
expect:
  - { measure: rocks.runout.p50, above: 0 }
  - { measure: gate.road.passed, above: 0 }
  - { measure: rocks.count, equals: 200 }
)");
  const Output run = call(folder, "run lost.yaml -o r");
  INFO(run.out << run.err);
  CHECK(run.code == 3);
  CHECK(run.out.find("and above 5 % nothing is said of the others") != std::string::npos);
  const auto points = nlohmann::json::parse(read(folder.path() / "r/summary.json")).at("points");
  const auto& kept = points[0];
  CHECK(kept["rocks"][0]["runout"]["p50"].is_number());
  CHECK(kept["gates"][0]["passed"].is_number());
  CHECK_FALSE(kept["rocks"][0].contains("reason"));
  const auto& lost = points[2];
  CHECK(lost["rocks"][0]["count"] == 200);
  CHECK(lost["rocks"][0]["faults"] > 20);
  CHECK(lost["rocks"][0]["runout"]["p50"].is_null());
  CHECK(lost["rocks"][0]["runout"]["intervals"]["p95"][0].is_null());
  CHECK(lost["rocks"][0]["reason"] == "lost");
  CHECK(lost["gates"][0]["passed"].is_null());
  CHECK(lost["gates"][0]["reason"] == "lost");
  CHECK(lost["gates"][0]["rocks"].is_number());
  CHECK(lost["gates"][0]["speed"]["p50"].is_null());
  CHECK(lost["gates"][0]["speed"]["design_effect"]["p50"].is_null());
  CHECK(lost["gates"][0]["shares"]["passed"]["per_trial"]["upper"].is_null());
  const auto verdicts = nlohmann::json::parse(read(folder.path() / "r/summary.json")).at("expectations");
  for (const auto& verdict : verdicts)
    if (verdict["point"] == 2) CHECK(verdict["passed"] == (verdict["measure"] == "rocks.count"));
}

TEST_CASE("A driven body that presses another into the ground ends the trial, and says which") {
  const Folder folder;
  folder.write("press.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: plane, material: rock }
materials: { rock: {} }
bodies:
  - { name: block, shape: &box { type: polygon, vertices: [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] }, mass: 1, position: [0, 0.5], material: rock }
  - { name: press, shape: *box, mass: 1, position: [0, 1.6], material: rock, driven: { velocity: [0, -1] } }
solver: { max_iterations: 110 }
stop: { time: 0.2 s }
)");
  for (const std::string aside : {"0", "1e-9", "1e-6", "1e-3"}) {
    const Output run = call(folder, "run press.yaml --force -o r --set bodies.1.position.0=" + aside);
    INFO(run.err);
    CHECK(run.code == 3);
    CHECK(run.err.find("diverged: a driven body presses `block` and leaves no way out: not all contacts can "
                       "hold") != std::string::npos);
  }
}

TEST_CASE("A result whose files are gone is made again by --resume, and no export replaces them") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  const std::string rocks = read(folder.path() / "r/rocks.csv");
  check_refused(folder, "export r --to csv -o r",
                "error: -o r: it holds results, whose files would be replaced; expected another folder, or "
                "--force\n"
                "See `flyrock export --help`.\n");
  for (const char* file : {"report.html", "rocks.csv", "results.db"}) {
    fs::remove(folder.path() / "r" / file);
    CHECK(call(folder, "run s.yaml --resume --quiet -o r").code == 0);
    CHECK(fs::exists(folder.path() / "r" / file));
  }
  CHECK(read(folder.path() / "r/rocks.csv") == rocks);
}

TEST_CASE("A scenario, or a file that it names, that is a pipe, a device or a folder is an error at once") {
  const Folder folder;
  REQUIRE(shell(folder,
                "mkfifo pipe.yaml && ln -s /dev/zero zero.yaml && mkdir folder.yaml && ln -s /dev/zero "
                "zero.txt && mkfifo "
                "pipe.txt && mkdir folder.txt")
              .code == 0);
  check_refused(folder, "run pipe.yaml -o r",
                "pipe.yaml: error: cannot read pipe.yaml: a pipe or a device, expected a file\n");
  check_refused(folder, "run zero.yaml -o r",
                "zero.yaml: error: cannot read zero.yaml: a pipe or a device, expected a file\n");
  check_refused(folder, "run folder.yaml -o r",
                "folder.yaml: error: cannot read folder.yaml: Is a directory\n");
  for (const char* file : {"zero.txt", "pipe.txt", "folder.txt"}) {
    folder.write("s.yaml",
                 bench_with("points: [[-20, 10], [0, 10], [3, 0], [300, 0]]", "file: " + std::string(file)));
    const Output run = call(folder, "run s.yaml -o r");
    CHECK(run.code == 2);
    CHECK(run.err.find(std::string("s.yaml:7:33: error: terrain.file: `") + file +
                       "` is a folder, a pipe or a device, expected a file\n") == 0);
  }
  for (const char* plugin : {"zero.txt", "pipe.txt", "folder.txt"}) {
    folder.write("s.yaml", "plugins: [" + std::string(plugin) + "]\n" + bench);
    CHECK(call(folder, "check s.yaml").code == 2);
  }
}
