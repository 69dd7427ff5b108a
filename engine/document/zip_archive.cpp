#include "document/zip_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

namespace flyrock {

namespace {

constexpr unsigned signature_of_end = 0x06054b50, signature_of_entry = 0x02014b50,
                   signature_of_member = 0x04034b50;
constexpr std::size_t bytes_of_end = 22, bytes_of_entry = 46, bytes_of_member = 30;
constexpr unsigned is_stored = 0, is_deflated = 8, encrypted_flag = 1;

/// Inflates a stream without a head of its own.
std::string inflated(std::string_view packed, std::size_t size) {
  std::string result(size, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw ZipFault("cannot be unpacked");
  const int code = inflate(&stream, Z_FINISH);
  const bool is_whole = code == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  if (!is_whole) throw ZipFault("is damaged: a part of it does not unpack, copy or save it again");
  return result;
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes) : bytes_(bytes) {
  constexpr std::size_t longest_comment = 0xffff;
  std::size_t end = bytes.npos;
  for (std::size_t back = bytes_of_end; back <= std::min(bytes.size(), bytes_of_end + longest_comment);
       ++back)
    if (number(bytes.size() - back, 4) == signature_of_end) {
      end = bytes.size() - back;
      break;
    }
  if (end == bytes.npos) throw ZipFault("is cut: the list of its parts at its end is missing, copy it again");
  const unsigned count = number(end + 10, 2);
  std::size_t at = number(end + 16, 4);
  for (unsigned i = 0; i < count; ++i) {
    if (at + bytes_of_entry > bytes.size() || number(at, 4) != signature_of_entry)
      throw ZipFault("is damaged: the list of its parts is not whole, copy or save it again");
    const std::size_t name = number(at + 28, 2), extra = number(at + 30, 2), comment = number(at + 32, 2);
    if (at + bytes_of_entry + name > bytes.size())
      throw ZipFault("is damaged: the list of its parts is not whole, copy or save it again");
    members_[std::string(bytes.substr(at + bytes_of_entry, name))] = {.flags = number(at + 8, 2),
                                                                      .method = number(at + 10, 2),
                                                                      .checksum = number(at + 16, 4),
                                                                      .packed = number(at + 20, 4),
                                                                      .unpacked = number(at + 24, 4),
                                                                      .at = number(at + 42, 4)};
    at += bytes_of_entry + name + extra + comment;
  }
}

unsigned ZipArchive::number(std::size_t at, int bytes) const {
  unsigned result = 0;
  for (int k = bytes; k-- > 0;)
    result = result << 8 | static_cast<unsigned char>(at + k < bytes_.size() ? bytes_[at + k] : 0);
  return result;
}

std::string ZipArchive::read(std::string_view name) const {
  const auto found = members_.find(name);
  if (found == members_.end()) throw ZipFault(fmt::format("has no part `{}`: it is no workbook", name));
  const Member& member = found->second;
  if ((member.flags & encrypted_flag) != 0) throw ZipFault("is protected by a password: save it without one");
  if (member.unpacked > most_bytes)
    throw ZipFault(
        fmt::format("has a part of {} MiB when it is unpacked, expected at most {}: save the sheet "
                    "as CSV UTF-8",
                    member.unpacked >> 20, most_bytes >> 20));
  const std::size_t begin =
      member.at + bytes_of_member + number(member.at + 26, 2) + number(member.at + 28, 2);
  if (number(member.at, 4) != signature_of_member || begin > bytes_.size() ||
      member.packed > bytes_.size() - begin)
    throw ZipFault("is cut or damaged: a part of it is missing, copy or save it again");
  if (member.method != is_stored && member.method != is_deflated)
    throw ZipFault(
        fmt::format("is packed by method {} of zip, expected deflate: save it again", member.method));
  const std::string_view packed = bytes_.substr(begin, member.packed);
  std::string content = member.method == is_stored ? std::string(packed) : inflated(packed, member.unpacked);
  const auto checksum =
      crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
  if (checksum != member.checksum) throw ZipFault("is damaged: a checksum is wrong, copy or save it again");
  return content;
}

}  // namespace flyrock
