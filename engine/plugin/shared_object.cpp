#include "plugin/shared_object.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

/// The header of this program or module itself, whose processor is the one that runs; the linker defines it.
extern const ElfW(Ehdr) __ehdr_start __attribute__((visibility("hidden")));

namespace flyrock {

namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Section = ElfW(Shdr);

struct ObjectFile {
  std::ifstream bytes;
  std::uint64_t size = 0;

  bool contains(std::uint64_t offset, std::uint64_t length) const {
    return offset <= size && length <= size - offset;
  }

  /// `count` records from `offset` on; nothing if the file does not contain them.
  template <class Record>
  std::optional<std::vector<Record>> read(std::uint64_t offset, std::uint64_t count) {
    if (count > size || !contains(offset, count * sizeof(Record))) return std::nullopt;
    std::vector<Record> records(count);
    bytes.seekg(static_cast<std::streamoff>(offset));
    bytes.read(reinterpret_cast<char*>(records.data()), static_cast<std::streamsize>(count * sizeof(Record)));
    if (!bytes) return std::nullopt;
    return records;
  }
};

std::string kind_fault(const Header& header) {
  const Header& own = __ehdr_start;
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return "it is no shared object (ELF)";
  const auto &ident = header.e_ident, &expected = own.e_ident;
  if (ident[EI_CLASS] != expected[EI_CLASS] || ident[EI_DATA] != expected[EI_DATA] ||
      header.e_machine != own.e_machine)
    return fmt::format(
        "it was built for another processor: ELF class {}, byte order {}, machine {}; expected {}, {}, {}",
        ident[EI_CLASS], ident[EI_DATA], header.e_machine, expected[EI_CLASS], expected[EI_DATA],
        own.e_machine);
  if (header.e_type != ET_DYN)
    return fmt::format("it is no shared object: ELF type {}, expected {}", header.e_type, ET_DYN);
  return {};
}

}  // namespace

std::string shared_object_fault(const std::string& path) {
  std::error_code unreadable;
  ObjectFile file{std::ifstream(path, std::ios::binary), std::filesystem::file_size(path, unreadable)};
  if (unreadable || !file.bytes) return "it cannot be read";
  const auto headers = file.read<Header>(0, 1);
  if (!headers) return fmt::format("it is no shared object (ELF): it has {} bytes", file.size);
  const Header& header = headers->front();
  if (const std::string fault = kind_fault(header); !fault.empty()) return fault;
  const auto beyond = [&](const char* what) {
    return fmt::format("it is damaged: {} lie outside of its {} bytes; copy or build it again", what,
                       file.size);
  };
  const auto segments = file.read<Segment>(header.e_phoff, header.e_phnum);
  const auto sections = file.read<Section>(header.e_shoff, header.e_shnum);
  if (!segments || !sections) return beyond("the headers of its parts");
  for (const Segment& segment : *segments)
    if (!file.contains(segment.p_offset, segment.p_filesz)) return beyond("parts that it loads");
  for (const Section& section : *sections)
    if (section.sh_type != SHT_NOBITS && !file.contains(section.sh_offset, section.sh_size))
      return beyond("some of its parts");
  return {};
}

void* open_shared_object(const std::string& path, std::string& fault) {
  fault = shared_object_fault(path);
  if (!fault.empty()) return nullptr;
  void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle) return handle;
  const char* reason = ::dlerror();
  fault = reason ? reason : "unknown reason";
  return nullptr;
}

}  // namespace flyrock
