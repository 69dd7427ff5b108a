#pragma once
// Allows only one writer in a result folder at a time.

#include <filesystem>
#include <string>

namespace flyrock {

/// Holds the file `lock` in a folder by flock(2). The lock is free when the holder ends, however it ends. The
/// file is removed with the lock.
///
/// On a file system without such locks, the file itself is the lock: it is made only if it does not exist,
/// and names its process. A file of a process of this machine that has ended is taken over. About a process
/// of another machine nothing is known, so its file must be removed by hand.
class FolderLock {
 public:
  /// Throws FileError if another process holds the lock, or if the folder cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// That the file system has no locks and what follows from it; empty if it has.
  const std::string& warning() const { return warning_; }

  /// Who holds the lock of a folder, for a message; empty if nobody does. Writes nothing.
  static std::string writer(const std::filesystem::path& folder);

 private:
  /// One attempt; false if the file was replaced meanwhile.
  bool acquire();

  std::filesystem::path path_;
  int file_ = -1;
  std::string warning_;
};

}  // namespace flyrock
