#pragma once
// Files that are either whole or absent.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flyrock {

/// A file that could not be read or written; the text names it and says why.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes `bytes` under a temporary name beside `path`, syncs it and renames it: a reader (or the next run
/// after a power cut) meets the whole file or none. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a file. Throws FileError.
std::string read_file(const std::filesystem::path& path);

/// Makes a folder and those above it. Throws FileError.
void make_folder(const std::filesystem::path& path);

}  // namespace flyrock
