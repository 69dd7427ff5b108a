#pragma once
// SHA-256 (FIPS 180-4): identifies a scenario, a plugin source or a file by its content.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace flyrock {

/// The digest of bytes that are added piece by piece.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The digest of all added bytes, as 64 hexadecimal digits. Nothing may be added after it.
  std::string digest();

 private:
  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::string rest_;  ///< bytes that do not fill a block yet
  std::uint64_t length_ = 0;
};

/// The digest of `bytes` as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);
/// That of a file, which is read in blocks: a raster may have gigabytes. Throws UnreadableFile.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace flyrock
