#pragma once
// The process that a lock file names, and whether it still runs.

#include <string>

namespace flyrock {

struct LockOwner {
  std::string host;   ///< name of the machine
  std::string space;  ///< the processes among which `process` is a number: those of a machine or container
  long process = 0;
  std::string started;   ///< start of the process in ticks since the boot; another process may get its number
  bool by_file = false;  ///< the file itself is the lock, because its file system has no others

  /// This process.
  static LockOwner self(bool by_file);
  /// Reads what text() has written. `host` is empty if the text is another one.
  static LockOwner parse(const std::string& text);
  std::string text() const;

  /// Whether the process is known to have ended. Of a process on another machine, nothing is known.
  bool has_ended() const;
  /// "process 4711 on node7"
  std::string name() const;
};

}  // namespace flyrock
