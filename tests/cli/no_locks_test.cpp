// Result folders on file systems without locks, as some clusters mount them.

#include <signal.h>
#include <sys/file.h>

#include <cerrno>

#include "same_result.h"

using namespace flyrock::test;

namespace no_locks_test {

namespace {

/// The environment of a program whose flock(2) and fcntl(2) locks fail with these error numbers.
std::string without_locks(int flock_error, int fcntl_error) {
  return "FLYROCK_TEST_NO_FLOCK=" + std::to_string(flock_error) +
         " FLYROCK_TEST_NO_FCNTL=" + std::to_string(fcntl_error) +
         " ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" FLYROCK_NO_LOCKS "' ";
}

Output call_without_locks(const Folder& folder, const std::string& arguments, int error = ENOLCK) {
  return shell(folder, without_locks(error, error) + "'" FLYROCK_BINARY "' " + arguments);
}

std::string warning_of(const std::string& result) {
  return "warning: " + result + ": this file system has no locks: only the file " + result +
         "/lock keeps other runs out; remove it if a run on another machine was killed\n";
}

std::string host() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// A run without an end, in the background; its process. It ends with the object.
class Background {
 public:
  Background(const Folder& folder, const std::string& result) {
    child_ = ::fork();
    if (child_ == 0) {
      const std::string line = "cd '" + folder.path().string() + "' && exec env " +
                               without_locks(ENOSYS, ENOSYS) + "'" FLYROCK_BINARY "' run s.yaml -o " +
                               result + " --quiet --trials 1000000 2>/dev/null";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(99);
    }
    for (int i = 0; i < 400 && read(folder.path() / result / "manifest.json").empty(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ~Background() { kill(); }

  pid_t process() const { return child_; }
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_ = 0;
};

}  // namespace

TEST_CASE("Without locks run, resume, merge, report and export work, with one warning", "[slow]") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o whole").code == 0);
  for (const int error : {ENOSYS, ENOLCK, EOPNOTSUPP}) {
    INFO(error);
    const Output run = call_without_locks(folder, "run s.yaml --quiet --force -o r", error);
    CHECK(run.code == 0);
    CHECK(run.err == warning_of("r"));
    CHECK_FALSE(folder.has("r/lock"));
    check_same(folder, "whole", "r");
    for (const char* command : {"report r", "export r --to csv", "export r --to vtk", "animate r"}) {
      const Output output = call_without_locks(folder, command, error);
      INFO(command);
      CHECK(output.code == 0);
      CHECK(output.err.empty());
    }
    for (const std::string shard : {"1", "2"})
      CHECK(
          call_without_locks(folder, "run s.yaml --quiet --force --shard " + shard + "/2 -o s" + shard, error)
              .code == 0);
    const Output merged = call_without_locks(folder, "merge s1 s2 --quiet --force -o m", error);
    CHECK(merged.code == 0);
    CHECK(merged.err == warning_of("m"));
    check_same(folder, "whole", "m");
  }
  // Only one kind of lock is missing.
  CHECK(shell(folder,
              "FLYROCK_TEST_NO_FCNTL=37 ASAN_OPTIONS=verify_asan_link_order=0 "
              "LD_PRELOAD='" FLYROCK_NO_LOCKS "' '" FLYROCK_BINARY "' run s.yaml --quiet --force -o r")
            .err.empty());
  check_same(folder, "whole", "r");
}

TEST_CASE(
    "Without locks the lock file keeps out others while its process lives, and is taken over after it") {
  const Folder folder;
  folder.write("s.yaml", bench);
  Background run(folder, "r");
  const std::string holder = "error: r: another flyrock is writing there: process " +
                             std::to_string(run.process()) + " on " + host() + ", for ";
  for (const char* command :
       {"report r", "export r --to vtk", "run s.yaml --resume -o r", "run s.yaml --force -o r"}) {
    const Output output = call_without_locks(folder, command);
    INFO(command << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.err.find(holder) == 0);
    CHECK(output.err.find("remove r/lock if that process has ended") != std::string::npos);
    // A process that has locks, as on another mount of the folder, sees it too.
    CHECK(call(folder, command).err.find(holder) == 0);
  }
  run.kill();
  REQUIRE(folder.has("r/lock"));
  const Output resumed = call_without_locks(folder, "run s.yaml --force --quiet -o r");
  INFO(resumed.err);
  CHECK(resumed.code == 0);
  CHECK(resumed.err == warning_of("r"));
  CHECK_FALSE(folder.has("r/lock"));
  CHECK_FALSE(folder.has("r/lock.left"));
}

TEST_CASE("The lock file of another machine is never taken over, and says what to do") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  folder.write("r/lock", "node7 pid:[4026531836] 4711 12345 file\n");
  const auto three_hours_ago = fs::file_time_type::clock::now() - std::chrono::minutes(3 * 60 + 12);
  fs::last_write_time(folder.path() / "r/lock", three_hours_ago);
  const std::string told =
      "error: r: another flyrock is writing there: process 4711 on node7, for 3 h 12 min; this file system "
      "has "
      "no locks, so remove r/lock if that process has ended\n";
  for (const char* command : {"report r", "run s.yaml --force -o r", "run s.yaml --resume -o r"}) {
    CHECK(call_without_locks(folder, command).err.find(told) == 0);
    CHECK(call(folder, command).err.find(told) == 0);
  }
  // A number that another process has now, a container of the same machine, a text that is none.
  const std::string same_number = host() + " pid:[1] " + std::to_string(::getpid()) + " 1 file\n";
  for (const std::string& text : {same_number, std::string("half a na"), std::string()}) {
    folder.write("r/lock", text);
    INFO(text);
    CHECK(call_without_locks(folder, "report r").code == 2);
  }
  fs::remove(folder.path() / "r/lock");
  CHECK(call_without_locks(folder, "report r").code == 0);
}

TEST_CASE("Of two runs that start at once without locks, one writes") {
  const Folder folder;
  folder.write("s.yaml", bench_with("trials: 4", "trials: 40"));
  for (int round = 0; round < 5; ++round) {
    fs::remove_all(folder.path() / "r");
    const std::string run = without_locks(ENOSYS, ENOSYS) + "'" FLYROCK_BINARY "' run s.yaml --quiet -o r";
    const Output both =
        shell(folder, "(" + run + " 2>a; echo $? >a.code) & (" + run + " 2>b; echo $? >b.code); wait");
    const std::string codes = read(folder.path() / "a.code") + read(folder.path() / "b.code");
    INFO(codes << read(folder.path() / "a") << read(folder.path() / "b"));
    CHECK((codes == "0\n2\n" || codes == "2\n0\n"));
    CHECK(folder.has("r/report.html"));
  }
}

}  // namespace no_locks_test
