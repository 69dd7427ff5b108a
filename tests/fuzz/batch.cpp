#include "batch.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <new>
#include <stdexcept>
#include <thread>

#include "findings.h"

namespace flyrock::fuzz {

namespace fs = std::filesystem;

namespace {

constexpr double most_seconds = 20;  ///< of the processor, or asleep
constexpr rlim_t most_memory = rlim_t{4} << 30;
constexpr int child_failed = 99;

double seconds_of(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What the child of a batch shows its parent.
struct Shared {
  std::atomic<std::uint64_t> number;     ///< of the mutant under way
  std::atomic<bool> attempts;            ///< false as long as the child gets ready
  std::atomic<bool> is_listed;           ///< what is found of this mutant is no failure
  std::atomic<double> processor_before;  ///< the child's time of the processor when the mutant began
  Tally tally;
};

/// Memory that a fork shares.
class SharedMemory {
 public:
  SharedMemory() {
    void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("cannot share memory with a child");
    shared_ = new (memory) Shared();
  }
  ~SharedMemory() { ::munmap(shared_, sizeof(Shared)); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  Shared* operator->() const { return shared_; }

 private:
  Shared* shared_;
};

/// Where the scratch folder goes: in memory where there is room, since runs sync what they write.
fs::path scratch_place() {
  constexpr std::uintmax_t enough = std::uintmax_t{256} << 20;
  const fs::path memory = "/dev/shm";
  std::error_code none;
  const fs::space_info space = fs::space(memory, none);
  return !none && space.available >= enough && ::access(memory.c_str(), W_OK) == 0
             ? memory
             : fs::temp_directory_path();
}

/// A folder of its own for one mutant after the other, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (scratch_place() / "flyrock-fuzz-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make the folder " + name);
    path_ = name;
  }
  ~Scratch() {
    std::error_code code;
    fs::remove_all(path_, code);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const fs::path& path() const { return path_; }
  void clear() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
  }

 private:
  fs::path path_;
};

Dice dice_of(const KindEntry& kind, std::uint64_t seed, std::uint64_t number) {
  return {seed, "fuzz." + std::string(kind.name), number};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// Bounds what a mutant may ask for, so that a length that is none does not take the machine's memory.
/// Sanitizers need the room of addresses for themselves.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__
  const rlimit limit{most_memory, most_memory};
  ::setrlimit(RLIMIT_AS, &limit);
#endif
}

void judge(const Batch& batch, std::uint64_t number, const Calls& calls, const Capture& capture,
           bool is_listed, Tally& tally) {
  ++tally.mutants;
  ++tally.codes[std::clamp(calls.gravest(), 0, 3)];
  Finding finding{std::string(batch.kind.name), batch.seed,    number,   calls.fault(),
                  joined(calls.lines()),        capture.err(), is_listed};
  if (!calls.fault().empty()) {
    ++(is_listed ? tally.listed : tally.wrong);
    save(finding, fs::current_path(), batch.findings);
  } else if (!calls.rocks().empty()) {
    ++tally.rock_faults;
    finding.what = calls.rocks();
    note_rocks(finding, batch.findings);
  }
}

/// The child: mutants from `first` on, until the batch or its time is over.
void attempt_all(const Batch& batch, std::uint64_t first, double deadline, const Scratch& scratch,
                 const Capture& capture, const SharedMemory& shared) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM})
    std::signal(signal, SIG_DFL);  // not those of a test program
  limit_memory();
  fs::current_path(scratch.path());
  capture.redirect();
  const double before = seconds_of(CLOCK_MONOTONIC);
  const std::unique_ptr<Kind> kind = batch.kind.make();
  deadline += seconds_of(CLOCK_MONOTONIC) - before;  // with sanitizers a kind may take seconds to get ready
  for (std::uint64_t number = first; number < batch.first + batch.count; ++number) {
    shared->number = number;
    if (seconds_of(CLOCK_MONOTONIC) > deadline) return;
    shared->processor_before = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    shared->is_listed = false;
    shared->attempts = true;
    scratch.clear();
    Dice dice = dice_of(batch.kind, batch.seed, number);
    Calls calls(&capture, &shared->is_listed);
    kind->attempt(dice, calls);
    judge(batch, number, calls, capture, shared->is_listed, shared->tally);
  }
  shared->number = batch.first + batch.count;
}

/// Whether a process waits for something, and not only for its turn on a busy machine.
bool sleeps(pid_t child) {
  std::ifstream file(fmt::format("/proc/{}/stat", child));
  std::string id, name, state;
  file >> id >> name >> state;
  return state == "S" || state == "D";
}

/// Waits for a child; whether it had to be ended, because one mutant took too long.
bool ended_by_force(pid_t child, const SharedMemory& shared, int& status) {
  clockid_t clock{};
  ::clock_getcpuclockid(child, &clock);
  double last_awake = seconds_of(CLOCK_MONOTONIC);
  while (::waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double now = seconds_of(CLOCK_MONOTONIC);
    if (!shared->attempts || !sleeps(child)) last_awake = now;
    if (!shared->attempts) continue;
    if (seconds_of(clock) - shared->processor_before < most_seconds && now - last_awake < most_seconds)
      continue;
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    return true;
  }
  return false;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
  return fmt::format("ended with {}", WEXITSTATUS(status));  // as the sanitizers end a program
}

}  // namespace

std::uint64_t run_batch(const Batch& batch, Tally& tally) {
  const SharedMemory shared;
  const Scratch scratch;
  const Capture capture;
  shared->tally = tally;
  const double deadline = seconds_of(CLOCK_MONOTONIC) + batch.seconds;
  std::uint64_t next = batch.first;
  while (next < batch.first + batch.count && seconds_of(CLOCK_MONOTONIC) < deadline) {
    shared->number = next;
    shared->attempts = false;
    capture.clear();
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot start a child");
    if (child == 0) {
      try {
        attempt_all(batch, next, deadline, scratch, capture, shared);
      } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        std::fflush(stderr);
        ::_exit(child_failed);
      }
      ::_exit(0);
    }
    int status = 0;
    const bool hung = ended_by_force(child, shared, status);
    next = shared->number;
    if (!hung && WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    ++shared->tally.mutants;
    const bool is_listed = hung && shared->is_listed;
    ++(is_listed ? shared->tally.listed : hung ? shared->tally.hangs : shared->tally.signals);
    save({std::string(batch.kind.name), batch.seed, next, hung ? "hang" : how_it_ended(status), "",
          capture.err(), is_listed},
         scratch.path(), batch.findings);
    ++next;
  }
  tally = shared->tally;
  return next;
}

void run_one(const KindEntry& entry, std::uint64_t seed, std::uint64_t number) {
  const fs::path folder = fs::absolute(fmt::format("{}-{}-{}", entry.name, seed, number));
  fs::create_directories(folder);
  fs::current_path(folder);
  const std::unique_ptr<Kind> kind = entry.make();
  if (!kind) throw std::runtime_error(fmt::format("this build has no {}", entry.name));
  Dice dice = dice_of(entry, seed, number);
  Calls calls(nullptr);
  kind->attempt(dice, calls);
  fmt::print("the files are in {}\n", folder.string());
}

}  // namespace flyrock::fuzz
