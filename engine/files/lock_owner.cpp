#include "files/lock_owner.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace flyrock {

namespace {

constexpr const char* by_file_word = "file";
constexpr const char* by_lock_word = "lock";

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 && name[0] ? name : "unknown";
}

std::string process_space() {
  std::error_code code;
  const std::filesystem::path space = std::filesystem::read_symlink("/proc/self/ns/pid", code);
  return code ? "unknown" : space.string();
}

/// Field 22 of /proc/<process>/stat; "unknown" if it cannot be read. The second field, the name of the
/// program in parentheses, may contain blanks.
std::string start_of(long process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  std::getline(file, line);
  const std::size_t end_of_name = line.rfind(')');
  if (end_of_name == std::string::npos) return "unknown";
  std::istringstream fields(line.substr(end_of_name + 1));
  std::string field;
  for (int number = 3; number <= 22; ++number)
    if (!(fields >> field)) return "unknown";
  return field;
}

}  // namespace

LockOwner LockOwner::self(bool by_file) {
  LockOwner owner;
  owner.host = host_name();
  owner.space = process_space();
  owner.process = ::getpid();
  owner.started = start_of(owner.process);
  owner.by_file = by_file;
  return owner;
}

LockOwner LockOwner::parse(const std::string& text) {
  std::istringstream words(text);
  LockOwner owner;
  std::string by;
  if (!(words >> owner.host >> owner.space >> owner.process >> owner.started >> by)) return {};
  owner.by_file = by == by_file_word;
  return owner;
}

std::string LockOwner::text() const {
  return fmt::format("{} {} {} {} {}\n", host, space, process, started,
                     by_file ? by_file_word : by_lock_word);
}

bool LockOwner::has_ended() const {
  if (host != host_name() || space != process_space() || process <= 0) return false;
  if (::kill(static_cast<pid_t>(process), 0) != 0) return errno == ESRCH;
  return start_of(process) != started;
}

std::string LockOwner::name() const { return fmt::format("process {} on {}", process, host); }

}  // namespace flyrock
