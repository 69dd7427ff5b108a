#pragma once
// Allows only one writer in a result folder at a time.

#include <filesystem>

namespace flyrock {

/// Holds the file `lock` in a folder by flock(2). The lock is free when the holder ends, however it ends. The
/// file is removed with the lock.
class FolderLock {
 public:
  /// Throws FileError if another process holds the lock, or if the folder cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether a process holds the lock of a folder. Writes nothing.
  static bool held(const std::filesystem::path& folder);

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace flyrock
