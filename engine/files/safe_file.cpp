#include "files/safe_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <utility>

namespace flyrock {

namespace {

[[noreturn]] void fail(const char* what, const std::filesystem::path& path, int code) {
  throw FileError(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(code)));
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, int code) {
  throw UnreadableFile(fmt::format("cannot read {}: {}", path.string(), std::strerror(code)));
}

}  // namespace

std::filesystem::path temporary_name(const std::filesystem::path& path) { return path.string() + ".partial"; }

FileWriter::FileWriter(std::filesystem::path path, Sync sync)
    : path_(std::move(path)), temporary_(temporary_name(path_)), sync_(sync) {
  file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) fail("write", path_, errno);
}

FileWriter::~FileWriter() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary_.c_str());
}

void FileWriter::write(std::string_view bytes) {
  constexpr std::size_t at_once = 1 << 16;
  if (buffer_.size() + bytes.size() < at_once) {
    buffer_ += bytes;
  } else {
    flush();
    put(bytes);
  }
}

void FileWriter::flush() {
  put(buffer_);
  buffer_.clear();
}

void FileWriter::put(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write", path_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void FileWriter::commit() {
  flush();
  ::close(std::exchange(file_, -1));
  commit_file(path_, sync_);
}

void commit_file(const std::filesystem::path& path, Sync sync) {
  const std::filesystem::path temporary = temporary_name(path);
  int failure = 0;
  if (sync == Sync::yes) {
    const int file = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) fail("write", path, errno);
    if (::fsync(file) != 0) failure = errno;
    ::close(file);
  }
  if (failure == 0 && ::rename(temporary.c_str(), path.c_str()) == 0) return;
  const int code = failure != 0 ? failure : errno;
  ::unlink(temporary.c_str());
  fail("write", path, code);
}

void write_file(const std::filesystem::path& path, std::string_view bytes, Sync sync) {
  FileWriter file(path, sync);
  file.write(bytes);
  file.commit();
}

FileReader::FileReader(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path_, code);
  if (std::filesystem::is_directory(status)) fail_to_read(path_, EISDIR);
  if (std::filesystem::exists(status) &&
      !std::filesystem::is_regular_file(status))  // reading another kind of file may never end
    throw UnreadableFile(fmt::format("cannot read {}: a pipe or a device, expected a file", path_.string()));
  file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) fail_to_read(path_, errno);
}

FileReader::~FileReader() { ::close(file_); }

void FileReader::append_to(std::string& bytes, std::uint64_t count) {
  // A damaged count must not reserve memory for bytes that do not exist, and most files are small.
  constexpr std::uint64_t most_at_once = 1 << 20;
  for (std::uint64_t at_once = 1 << 14; count > 0; at_once = std::min(2 * at_once, most_at_once)) {
    const std::size_t size = bytes.size();
    const auto wanted = static_cast<std::size_t>(std::min(count, at_once));
    bytes.resize(size + wanted);
    const ssize_t read = ::read(file_, bytes.data() + size, wanted);
    const int failure = errno;
    bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(read, 0)));
    if (read == 0) return;
    if (read > 0)
      count -= static_cast<std::uint64_t>(read);
    else if (failure != EINTR)
      fail_to_read(path_, failure);
  }
}

std::string read_file(const std::filesystem::path& path) {
  std::string bytes;
  FileReader(path).append_to(bytes, std::numeric_limits<std::uint64_t>::max());
  return bytes;
}

void make_folder(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code) fail("make the folder", path, code.value());
}

}  // namespace flyrock
