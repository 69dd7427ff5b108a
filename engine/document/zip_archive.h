#pragma once
// Zip archives, read from memory: the form of workbooks (.xlsx, .ods).

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flyrock {

/// What is wrong with an archive, to follow "the file holes.xlsx".
struct ZipFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The members of an archive, stored or deflated (APPNOTE 6.3.10 without zip64, encryption and spanning).
class ZipArchive {
 public:
  /// No member is larger when it is unpacked [bytes].
  static constexpr std::size_t most_bytes = std::size_t{128} << 20;

  /// `bytes` must outlive the archive. Throws ZipFault if they are no complete archive.
  explicit ZipArchive(std::string_view bytes);

  bool has(std::string_view name) const { return members_.contains(name); }
  /// A member, unpacked. Throws ZipFault if it is not there, damaged, encrypted or too large.
  std::string read(std::string_view name) const;

 private:
  struct Member {
    unsigned flags = 0, method = 0, checksum = 0;
    std::size_t packed = 0, unpacked = 0, at = 0;  ///< `at`: of its own header
  };

  unsigned number(std::size_t at, int bytes) const;

  std::string_view bytes_;
  std::map<std::string, Member, std::less<>> members_;
};

}  // namespace flyrock
