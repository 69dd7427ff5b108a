#pragma once
// Files that are either complete or absent.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flyrock {

/// A file that cannot be read or written. The text names it and says why.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read, or that flyrock did not write. For the command that got it, this is bad input.
struct UnreadableFile : FileError {
  using FileError::FileError;
};

/// Whether a file must also survive a power cut.
enum class Sync {
  yes,
  no  ///< it may then be damaged: for files with a checksum that can be made again, because a sync takes some
      ///< milliseconds
};

/// Writes a file piece by piece under a temporary name in the same folder as `path`. commit() syncs and
/// renames it, so a reader (or the next run after a power cut) finds the complete file or none. Without
/// commit() the temporary file is removed.
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
  void put(std::string_view bytes);  ///< bypasses the buffer

  std::string buffer_;
  std::filesystem::path path_, temporary_;
  Sync sync_;
  int file_ = -1;
};

/// The temporary name of the file `path`.
std::filesystem::path temporary_name(const std::filesystem::path& path);
/// Renames what was written under the temporary name of `path` to `path`. Throws FileError.
void commit_file(const std::filesystem::path& path, Sync sync = Sync::yes);

/// Writes a whole file with a FileWriter. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes, Sync sync = Sync::yes);

/// A file that is read from its beginning.
class FileReader {
 public:
  /// Throws UnreadableFile.
  explicit FileReader(std::filesystem::path path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  /// Appends the next `count` bytes, or fewer at the end of the file. Throws UnreadableFile.
  void append_to(std::string& bytes, std::uint64_t count);

 private:
  std::filesystem::path path_;
  int file_ = -1;
};

/// The bytes of a file. Throws UnreadableFile.
std::string read_file(const std::filesystem::path& path);

/// Makes a folder and its parents. Throws FileError.
void make_folder(const std::filesystem::path& path);

}  // namespace flyrock
