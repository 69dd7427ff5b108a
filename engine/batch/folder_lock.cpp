#include "batch/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "batch/safe_file.h"

namespace flyrock {

namespace {

std::filesystem::path lock_in(const std::filesystem::path& folder) { return folder / "lock"; }

/// Whether the open file still has that name. The holder before us may have removed it.
bool is_named(int file, const std::filesystem::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(lock_in(folder)) {
  while (true) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0)
      throw FileError(fmt::format("cannot write in {}: {}", folder.string(), std::strerror(errno)));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      ::close(file_);
      throw FileError(fmt::format("{}: another flyrock is writing there", folder.string()));
    }
    if (is_named(file_, path_)) return;
    ::close(file_);
  }
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());
  ::close(file_);
}

bool FolderLock::held(const std::filesystem::path& folder) {
  const int file = ::open(lock_in(folder).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool free = ::flock(file, LOCK_SH | LOCK_NB) == 0;
  ::close(file);
  return !free;
}

}  // namespace flyrock
