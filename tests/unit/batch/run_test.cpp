#include "batch/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "batch/chunk_files.h"
#include "files/safe_file.h"
#include "host/wording.h"

using namespace flyrock;
namespace fs = std::filesystem;

namespace {

/// A folder of its own, removed at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("flyrock_run_test_" + std::to_string(::getpid()));
  Folder() { make_folder(path); }
  ~Folder() { fs::remove_all(path); }
};

/// One rock a trial; it fails from trial `failing` on.
MakeWorker rocks_failing_from(std::uint64_t failing) {
  const RunTrial run_trial = [failing](int point, std::uint64_t trial, TrialRecords& out) {
    RockRecord rock;
    rock.trial = trial;
    rock.runout = 1000 * point + static_cast<double>(trial);
    rock.reason = trial < failing ? StopReason::stopped : StopReason::plugin_error;
    if (trial >= failing) rock.fault = "no law";
    out.rocks.push_back(rock);
    out.totals.quality.steps += 1;
    return PrintLog();
  };
  return [run_trial](int) { return run_trial; };
}

/// The rocks of each point, as the chunk files hold them.
std::vector<std::vector<RockRecord>> merged(const RunOutcome& outcome, int points, const Folder& folder) {
  std::vector<std::vector<RockRecord>> all;
  for (const Rows& rows : rows_in(chunk_files(outcome.chunks, folder.path), points, "h")) {
    auto& of_point = all.emplace_back();
    rows(Part::brief, [&](const TrialRecords& chunk) {
      of_point.insert(of_point.end(), chunk.rocks.begin(), chunk.rocks.end());
    });
  }
  return all;
}

constexpr std::uint64_t never = 1'000'000;

}  // namespace

TEST_CASE("Chunks merge to every trial of every point in order") {
  Folder folder;
  const auto plan = plan_chunks(2, 150);
  const RunOutcome outcome =
      run_chunks(plan, rocks_failing_from(never), {.folder = folder.path, .scenario_hash = "h"});
  CHECK(outcome.ending == RunEnding::complete);
  CHECK(outcome.progress.done == 300);
  const auto rocks = merged(outcome, 2, folder);
  REQUIRE(rocks.size() == 2);
  for (int point = 0; point < 2; ++point) {
    REQUIRE(rocks[point].size() == 150);
    for (int t = 0; t < 150; ++t) CHECK(rocks[point][t].runout == 1000 * point + t);
  }
  const auto foreign = rows_in(chunk_files(outcome.chunks, folder.path), 2, "other");
  CHECK_THROWS_AS(foreign[0](Part::brief, [](const TrialRecords&) {}), FileError);
  remove_chunks(folder.path);
  CHECK_FALSE(fs::exists(folder.path));
}

TEST_CASE("Each chunk is shown once, in order, as its file holds it, whatever thread ran it") {
  for (const std::uint64_t failing :
       {never, std::uint64_t{40}}) {  // to the end, and to a fault that ends the run
    for (const int threads : {1, 2, 5}) {
      Folder folder;
      const auto plan = plan_chunks(2, 300);
      std::vector<std::vector<RockRecord>> seen(2);
      RunOptions options{.folder = folder.path, .scenario_hash = "h", .threads = threads, .strict = true};
      options.see = [&](int point, const TrialRecords& chunk) {
        auto& of_point = seen.at(static_cast<std::size_t>(point));
        of_point.insert(of_point.end(), chunk.rocks.begin(), chunk.rocks.end());
      };
      const auto check = [&](const RunOutcome& outcome) {
        const auto files = merged(outcome, 2, folder);
        for (std::size_t point = 0; point < 2; ++point) {
          REQUIRE(seen[point].size() == files[point].size());
          for (std::size_t i = 0; i < files[point].size(); ++i)
            CHECK(seen[point][i].runout == files[point][i].runout);
        }
        CHECK(seen[0].size() == std::min<std::uint64_t>(failing + 1, 300));
      };
      check(run_chunks(plan, rocks_failing_from(failing), options));
      // Half of the chunks are there already.
      for (std::size_t i = 0; i < plan.size(); i += 2) fs::remove(folder.path / plan[i].file_name());
      seen.assign(2, {});
      options.resume = true;
      check(run_chunks(plan, rocks_failing_from(failing), options));
    }
  }
}

TEST_CASE(
    "What Lua code prints is told in the order of trials, ten lines of each place, for any number of "
    "threads") {
  const RunTrial chatter = [](int, std::uint64_t trial, TrialRecords& out) {
    RockRecord rock;
    rock.trial = trial;
    out.rocks.push_back(rock);
    PrintLog prints;
    prints.add("a.lua:1", fmt::format("trial {}", trial), wording.printable);
    if (trial > 100) prints.add("a.lua:2", "late\x1B[2J", wording.printable);
    return prints;
  };
  for (const int threads : {1, 3}) {
    Folder folder;
    std::vector<std::string> lines;
    RunOptions options{.folder = folder.path, .scenario_hash = "h", .threads = threads};
    options.print = [&](const std::vector<std::string>& more) {
      lines.insert(lines.end(), more.begin(), more.end());
    };
    run_chunks(
        plan_chunks(1, 200), [&](int) { return chatter; }, options);
    REQUIRE(lines.size() == 22);
    for (int i = 0; i < 10; ++i) CHECK(lines[i] == fmt::format("trial {}", i));
    CHECK(lines[10] == "a.lua:1: print: after 10 lines the others of this place are dropped");
    for (int i = 11; i < 21; ++i) CHECK(lines[i] == "late\\x1B[2J");
    CHECK(lines[21] == "a.lua:2: print: after 10 lines the others of this place are dropped");
  }
}

TEST_CASE("A run goes on after rocks that fail, unless all of the first 20 do") {
  Folder folder;
  const auto plan = plan_chunks(1, 100);
  const RunOutcome later =
      run_chunks(plan, rocks_failing_from(1), {.folder = folder.path, .scenario_hash = "h"});
  CHECK(later.ending == RunEnding::complete);
  CHECK(later.progress.done == 100);
  const RunOutcome all =
      run_chunks(plan, rocks_failing_from(0), {.folder = folder.path, .scenario_hash = "h"});
  CHECK(all.ending == RunEnding::faults);
  CHECK(all.progress.done == 20);
  CHECK(all.why == "the first 20 rocks all failed, the last with: no law");
  CHECK(merged(all, 1, folder)[0].size() == 20);
}

TEST_CASE("A strict run ends at its first fault, and keeps what was done") {
  Folder folder;
  const auto plan = plan_chunks(1, 1000);
  const RunOutcome outcome =
      run_chunks(plan, rocks_failing_from(15), {.folder = folder.path, .scenario_hash = "h", .strict = true});
  CHECK(outcome.ending == RunEnding::faults);
  CHECK(outcome.why == "trial 15, rock 0: plugin_error: no law");
  CHECK(merged(outcome, 1, folder)[0].size() == 16);
}

TEST_CASE("An interrupted run keeps the chunks that were whole") {
  Folder folder;
  int asked = 0;
  RunOptions options{.folder = folder.path, .scenario_hash = "h"};
  options.interrupted = [&] { return ++asked > 25; };
  const RunOutcome outcome = run_chunks(plan_chunks(1, 1000), rocks_failing_from(never), options);
  CHECK(outcome.ending == RunEnding::interrupted);
  CHECK(outcome.chunks.size() == 2);
  CHECK(fs::exists(folder.path / "p0-c1.chunk"));
  CHECK_FALSE(fs::exists(folder.path / "p0-c2.chunk"));
}

TEST_CASE("Any number of threads ends a failing run at the same trial, with the same files") {
  const auto plan = plan_chunks(2, 1000);
  const bool strict = GENERATE(false, true);
  const std::uint64_t failing = strict ? GENERATE(0u, 15u, 333u) : GENERATE(0u, 19u);
  std::vector<std::string> files;
  std::string why;
  for (const int threads : {1, 2, 3, 8}) {
    Folder folder;
    const RunOutcome outcome =
        run_chunks(plan, rocks_failing_from(failing),
                   {.folder = folder.path, .scenario_hash = "h", .threads = threads, .strict = strict});
    std::vector<std::string> written;
    for (const ChunkRange& chunk : outcome.chunks)
      written.push_back(read_file(folder.path / chunk.file_name()));
    CHECK(static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path), {})) == written.size());
    if (threads == 1) {
      files = written;
      why = outcome.why;
    }
    CHECK(written == files);
    CHECK(outcome.why == why);
  }
}

TEST_CASE("A run goes on from whole chunks, and runs broken and foreign ones again") {
  Folder folder;
  const auto plan = plan_chunks(1, 1000);
  const RunOptions options{.folder = folder.path, .scenario_hash = "h", .threads = 2, .resume = true};
  const RunOutcome first = run_chunks(plan, rocks_failing_from(900), options);
  CHECK(first.progress.kept == 0);
  std::vector<std::string> files;
  for (const ChunkRange& chunk : plan) files.push_back(read_file(folder.path / chunk.file_name()));

  fs::remove(folder.path / "p0-c0.chunk");
  fs::resize_file(folder.path / "p0-c7.chunk", 100);
  fs::copy_file(folder.path / "p0-c3.chunk", folder.path / "p0-c8.chunk",
                fs::copy_options::overwrite_existing);
  write_file(folder.path / "p0-c9.chunk", encode_chunk(plan[9], "another scenario", {}));
  const RunOutcome second = run_chunks(plan, rocks_failing_from(900), options);
  CHECK(second.progress.kept == 960);
  CHECK(second.progress.done == 1000);
  CHECK(second.failed == first.failed);
  for (std::size_t i = 0; i < plan.size(); ++i)
    CHECK(read_file(folder.path / plan[i].file_name()) == files[i]);

  RunOptions strict = options;
  strict.strict = true;
  const RunOutcome third = run_chunks(plan, rocks_failing_from(900), strict);
  CHECK(third.why == "trial 900, rock 0: plugin_error: no law");
  CHECK(third.chunks.back().count == 1);
}

TEST_CASE("What a worker throws ends the run") {
  Folder folder;
  const MakeWorker broken = [](int) -> RunTrial { throw std::runtime_error("no worker"); };
  CHECK_THROWS_WITH(
      run_chunks(plan_chunks(1, 10), broken, {.folder = folder.path, .scenario_hash = "h", .threads = 3}),
      "no worker");
}

TEST_CASE("A file that cannot be written is an error that names it, and leaves nothing") {
  Folder folder;
  CHECK_THROWS_WITH(write_file(folder.path / "no" / "where", "x"),
                    Catch::Contains("cannot write " + (folder.path / "no" / "where").string()));
  write_file(folder.path / "a", "one");
  write_file(folder.path / "a", "two");
  CHECK(read_file(folder.path / "a") == "two");
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
  CHECK_THROWS_AS(read_file(folder.path), FileError);
}
