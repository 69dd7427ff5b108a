#pragma once
// One writer in a result folder at a time.

#include <filesystem>

namespace flyrock {

/// Holds the file `lock` in a folder, by flock(2): it is free again when the holder ends, however it ends.
/// The file goes away with the lock.
class FolderLock {
 public:
  /// Throws FileError where somebody else holds it, or where the folder cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether somebody holds the lock of a folder. Writes nothing.
  static bool held(const std::filesystem::path& folder);

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace flyrock
