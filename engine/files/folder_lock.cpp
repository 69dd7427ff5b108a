#include "files/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "files/lock_owner.h"
#include "files/safe_file.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

constexpr const char* busy = "another flyrock is writing there";

fs::path lock_in(const fs::path& folder) { return folder / "lock"; }

/// A file that is closed at the end of its scope.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags) { open(path, flags); }
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Opens the file in place of one that could not be opened.
  void open(const fs::path& path, int flags) { number_ = ::open(path.c_str(), flags | O_CLOEXEC, 0666); }
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

enum class Answer { granted, held, no_locks };

/// Asks for the lock of an open file. Throws FileError if the file system refuses for another reason.
Answer ask(int file, int operation, const fs::path& path) {
  if (::flock(file, operation | LOCK_NB) == 0) return Answer::granted;
  switch (errno) {
    case EWOULDBLOCK:
      return Answer::held;
    case ENOSYS:
    case ENOLCK:
    case EOPNOTSUPP:
      return Answer::no_locks;
    default:
      throw FileError(fmt::format("cannot lock {}: {}", path.string(), std::strerror(errno)));
  }
}

/// Whether the open file still has that name. The holder before us may have removed it.
bool is_named(int file, const fs::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

LockOwner owner_in(int file) {
  std::array<char, 1024> text{};
  const ssize_t count = ::pread(file, text.data(), text.size(), 0);
  return LockOwner::parse(std::string(text.data(), count > 0 ? static_cast<std::size_t>(count) : 0));
}

void write_owner(int file, bool by_file) {
  const std::string text = LockOwner::self(by_file).text();
  // A text that is cut short names no owner. The file is then removed by hand after a crash.
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, text.data(), text.size(), 0) < 0) return;
}

/// "3 h 12 min"
std::string duration_text(double seconds) {
  const auto minutes = static_cast<long>(seconds / 60);
  if (minutes < 1) return fmt::format("{:.0f} s", std::max(seconds, 0.0));
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string age_of(int file) {
  struct stat made {};
  if (::fstat(file, &made) != 0) return "unknown time";
  return duration_text(std::difftime(std::time(nullptr), made.st_mtime));
}

/// Who holds a lock file without a lock; empty if that process has ended.
std::string holder_by_file(int file, const fs::path& path) {
  const LockOwner owner = owner_in(file);
  if (owner.has_ended()) return {};
  return fmt::format("{}: {}, for {}; this file system has no locks, so remove {} if that process has ended",
                     busy, owner.host.empty() ? "an unknown process" : owner.name(), age_of(file),
                     path.string());
}

/// Removes the lock file of a process that has ended. Of several processes that find it, only one does:
/// another file keeps the others out, and that one looks again.
void remove_left(const fs::path& path, const LockOwner& ended) {
  const fs::path guard = path.string() + ".left";
  const OpenFile held(guard, O_RDWR | O_CREAT | O_EXCL);
  if (!held.is_open()) {
    const OpenFile other(guard, O_RDONLY);
    if (other.is_open() && owner_in(other.number()).has_ended()) ::unlink(guard.c_str());
    throw FileError(fmt::format("{}: {}", path.parent_path().string(), busy));
  }
  write_owner(held.number(), true);
  if (const OpenFile left(path, O_RDONLY); left.is_open() && owner_in(left.number()).text() == ended.text())
    ::unlink(path.c_str());
  ::unlink(guard.c_str());
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder) : path_(lock_in(folder)) {
  while (!acquire()) {
  }
}

bool FolderLock::acquire() {
  const std::string folder = path_.parent_path().string();
  OpenFile file(path_, O_RDWR | O_CREAT | O_EXCL);
  const bool is_new = file.is_open();
  if (!is_new && errno == EEXIST) {
    file.open(path_, O_RDWR);
    if (!file.is_open() && errno == ENOENT) return false;
  }
  if (!file.is_open()) throw FileError(fmt::format("cannot write in {}: {}", folder, std::strerror(errno)));
  const Answer answer = ask(file.number(), LOCK_EX, path_);
  if (answer == Answer::held) throw FileError(fmt::format("{}: {}", folder, busy));
  if (answer == Answer::granted && !is_named(file.number(), path_)) return false;
  const LockOwner before = owner_in(file.number());
  if (!is_new && (answer == Answer::no_locks || before.by_file)) {
    if (const std::string holder = holder_by_file(file.number(), path_); !holder.empty())
      throw FileError(fmt::format("{}: {}", folder, holder));
    if (answer == Answer::no_locks) {
      remove_left(path_, before);
      return false;
    }
  }
  if (answer == Answer::no_locks)
    warning_ = fmt::format(
        "{}: this file system has no locks: only the file {} keeps other runs out; remove it if a run on "
        "another machine was killed",
        folder, path_.string());
  write_owner(file.number(), answer == Answer::no_locks);
  file_ = file.release();
  return true;
}

FolderLock::~FolderLock() {
  if (is_named(file_, path_)) ::unlink(path_.c_str());
  ::close(file_);
}

std::string FolderLock::writer(const fs::path& folder) {
  const fs::path path = lock_in(folder);
  const OpenFile file(path, O_RDONLY);
  if (!file.is_open()) return {};
  const Answer answer = ask(file.number(), LOCK_SH, path);
  if (answer == Answer::held) return busy;
  if (answer == Answer::granted && !owner_in(file.number()).by_file) return {};
  return holder_by_file(file.number(), path);
}

}  // namespace flyrock
