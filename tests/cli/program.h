#pragma once
// Runs the built program as a user does.

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

namespace flyrock::test {

namespace fs = std::filesystem;

inline std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A separate working folder, removed at the end. No other process gets its name, not even one of the same
/// number in a container that shares the folder of temporary files.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "flyrock_cli_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }
  /// Writes a file and returns its name.
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return name;
  }
  bool has(const std::string& name) const { return fs::exists(path_ / name); }

 private:
  fs::path path_;
};

/// Whether the program reads and writes the formats of GDAL.
inline bool has_gdal() {
  return fs::exists(fs::path(FLYROCK_BINARY).parent_path().parent_path() / "lib/flyrock/flyrock_gdal.so");
}

/// The same, and says SKIPPED where it does not.
inline bool skips_without_gdal() {
  if (!has_gdal()) std::cout << "SKIPPED: built without GDAL\n";
  return !has_gdal();
}

struct Output {
  int code = -1;
  std::string out, err;
};

/// Runs a shell command line in a folder.
inline Output shell(const Folder& folder, const std::string& line) {
  const fs::path out = folder.path() / ".out", err = folder.path() / ".err";
  const std::string whole = "cd '" + folder.path().string() + "' && { " + line + "; } >'" + out.string() +
                            "' 2>'" + err.string() + "'";
  const int status = std::system(whole.c_str());
  if (status == -1) throw std::runtime_error("no shell could be started: " + whole);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

inline bool one_line(const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

/// Runs `flyrock ARGUMENTS` in a folder. The arguments are shell words.
inline Output call(const Folder& folder, const std::string& arguments) {
  return shell(folder, "'" FLYROCK_BINARY "' " + arguments);
}

/// Runs it and expects exit code 0; else throws with what it said.
inline Output call_well(const Folder& folder, const std::string& arguments) {
  Output done = call(folder, arguments);
  if (done.code != 0)
    throw std::runtime_error("flyrock " + arguments + ": exit code " + std::to_string(done.code) + ": " +
                             done.err);
  return done;
}

/// Runs `flyrock run SCENARIO` with more trials than it can finish, and interrupts it, like Ctrl-C unless
/// `signal` is another one, when `until` exists (after 20 s in any case).
inline Output call_and_interrupt(const Folder& folder, const std::string& scenario, const std::string& until,
                                 int signal = SIGINT) {
  const fs::path err = folder.path() / ".err";
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder.path().c_str()) != 0 || !std::freopen(err.c_str(), "w", stderr)) ::_exit(99);
    ::execl(FLYROCK_BINARY, "flyrock", "run", scenario.c_str(), "--trials", "100000", nullptr);
    ::_exit(99);
  }
  for (int i = 0; i < 400 && !folder.has(until); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", read(err)};
}

/// Runs `flyrock run SCENARIO --quiet ARGUMENTS...` and kills it (SIGKILL) after a time, unless it has ended
/// before.
inline void call_and_kill(const Folder& folder, const std::string& arguments,
                          std::chrono::milliseconds after) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string line = "cd '" + folder.path().string() + "' && exec '" FLYROCK_BINARY "' run " +
                             arguments + " --quiet 2>/dev/null";
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(99);
  }
  std::this_thread::sleep_for(after);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

/// A small scenario without errors: rocks thrown from a bench onto a floor, where they come to rest.
inline const char* const bench = R"(flyrock: 1
title: A small bench
dimension: 2
method: nscd
seed: 3
trials: 4
terrain: { type: profile, points: [[-20, 10], [0, 10], [3, 0], [300, 0]], material: rock }
materials:
  rock:
    restitution: { type: newton, en: 0.3 }
    friction: { type: coulomb, mu: 0.6 }
    rolling: { type: rolling_resistance, mu_r: 0.1 m }
rocks:
  - name: blocks
    density: 2700
    shape: { type: polygon, sides: { integer: [5, 8] }, diameter: 0.5 }
    release: { position: [0, 12] }
    launch: { type: fixed, speed: { uniform: [5, 15] }, elevation: 20 deg }
stop: { time: 60 s }
)";

/// `bench` with a piece of its text replaced.
inline std::string bench_with(const std::string& from, const std::string& to) {
  std::string text = bench;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "";
  return text.replace(at, from.size(), to);
}

}  // namespace flyrock::test
