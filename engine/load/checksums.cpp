#include "load/checksums.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "files/safe_file.h"
#include "files/sha256.h"

namespace flyrock {

namespace {

/// "<64 hexadecimal digits>  results.db\n"
std::string line_of(const std::filesystem::path& folder, const char* name) {
  return fmt::format("{}  {}\n", sha256_of_file(folder / name), name);
}

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw UnreadableFile(fmt::format(
      "{} is damaged: its SHA-256 is not the one that the run wrote into {}; run the scenario again, with "
      "--force or -o DIR",
      file.string(), checksums_name));
}

}  // namespace

void write_checksums(const std::filesystem::path& folder) {
  std::string text;
  for (const char* name : summed_names) text += line_of(folder, name);
  write_file(folder / checksums_name, text);
}

void check_checksums(const std::filesystem::path& folder) {
  const std::string text = read_file(folder / checksums_name);
  std::string_view rest = text;
  for (const char* name : summed_names) {
    const std::string line = line_of(folder, name);
    if (!rest.starts_with(line)) refuse(folder / name);
    rest.remove_prefix(line.size());
  }
  if (!rest.empty())
    throw UnreadableFile(
        fmt::format("{} is damaged: it is longer than the run wrote it", (folder / checksums_name).string()));
}

void check_checksum(const std::filesystem::path& folder, const char* name) {
  const std::string text = read_file(folder / checksums_name);
  if (text.find(line_of(folder, name)) == std::string::npos) refuse(folder / name);
}

}  // namespace flyrock
