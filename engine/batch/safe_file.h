#pragma once
// Files that are either whole or absent.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flyrock {

/// A file that could not be read or written; the text names it and says why.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read, or holds what flyrock did not write: bad input to a command that is given it.
struct UnreadableFile : FileError {
  using FileError::FileError;
};

/// Whether a file must also outlast a power cut.
enum class Sync {
  yes,
  no  ///< it may then be broken: for files with a checksum that can be made again. A sync takes some
      ///< milliseconds
};

/// A file that is written piece by piece under a temporary name beside `path`. commit() syncs and renames it:
/// a reader (or the next run after a power cut) meets the whole file or none. Without commit() it goes away.
class FileWriter {
 public:
  /// Throws FileError.
  explicit FileWriter(std::filesystem::path path, Sync sync = Sync::yes);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Throws FileError.
  void write(std::string_view bytes);
  void commit();

 private:
  void flush();
  void put(std::string_view bytes);  ///< past the buffer

  std::string buffer_;
  std::filesystem::path path_, temporary_;
  Sync sync_;
  int file_ = -1;
};

/// The name under which the file `path` is written.
std::filesystem::path temporary_name(const std::filesystem::path& path);
/// Gives its name to what was written under the temporary name of `path`. Throws FileError.
void commit_file(const std::filesystem::path& path, Sync sync = Sync::yes);

/// A FileWriter at once. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes, Sync sync = Sync::yes);

/// A file that is read from its beginning on.
class FileReader {
 public:
  /// Throws UnreadableFile.
  explicit FileReader(std::filesystem::path path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  /// The next `count` bytes, fewer where the file ends before. Throws UnreadableFile.
  void append_to(std::string& bytes, std::uint64_t count);

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

/// The bytes of a file. Throws UnreadableFile.
std::string read_file(const std::filesystem::path& path);

/// Makes a folder and those above it. Throws FileError.
void make_folder(const std::filesystem::path& path);

}  // namespace flyrock
