#pragma once
// The Lua files that a session has read.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document/location.h"

namespace flyrock {

struct LuaFile {
  std::string path;                      ///< to open
  std::string folder;                    ///< the folder of the file
  std::string text;                      ///< exactly as in the file
  std::shared_ptr<const Source> source;  ///< its name as shown, and its lines

  /// The text for Lua: without a byte order mark and without a first line that begins with `#`.
  std::string_view code() const;
};

/// The bytes of a file; nothing if it cannot be read.
std::optional<std::string> read_bytes(const std::string& path);

class SourceFiles {
 public:
  /// Reads a file of at most 4 MiB. If it cannot be read, returns null and `fault` says why. The pointer is
  /// valid as long as this object exists.
  const LuaFile* read(const std::string& path, const std::string& shown, std::string& fault);
  /// The file that Lua calls `chunk` ("@my_law.lua"); null if there is none.
  const LuaFile* of_chunk(const std::string& chunk) const;
  /// Splits "my_law.lua:16: what is wrong" into place and text. Nothing if there is no place in a known file.
  std::optional<std::pair<Location, std::string>> split_message(const std::string& message) const;

 private:
  std::vector<std::unique_ptr<LuaFile>> files_;
};

}  // namespace flyrock
