// A file that is no sound shared object is refused, and does not end the process.

#include "plugin/module_loader.h"

#include <elf.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <vector>

#include "plugin/in_child.h"
#include "plugin/shared_object.h"

namespace module_loader_test {

using namespace flyrock;
namespace fs = std::filesystem;

/// A copy of flyrock's own module, which is changed in its place.
class Module {
 public:
  Module() {
    std::string name = (fs::temp_directory_path() / "flyrock-module-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    fs::copy_file(fs::path(FLYROCK_MODULE_DIR) / "flyrock_plugins.so", path());
  }
  ~Module() { fs::remove_all(folder_); }
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  std::string path() const { return folder_ / "module.so"; }
  std::uintmax_t size() const { return fs::file_size(path()); }
  std::string fault() const { return shared_object_fault(path()); }
  void cut(std::uintmax_t size) const { fs::resize_file(path(), size); }
  void overwrite(std::uintmax_t at, const std::string& bytes) const {
    std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(at))
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

 private:
  fs::path folder_;
};

TEST_CASE("a shared object that is cut anywhere is refused before it is opened") {
  const Module module;
  CHECK(module.fault().empty());
  std::mt19937_64 random(1);
  // Shorter each time: by a byte, by random lengths, and through the headers.
  module.cut(module.size() - 1);
  for (std::uintmax_t size = module.size();; size -= size > 200 ? 1 + random() % (size / 20) : 1) {
    module.cut(size);
    INFO(size << " bytes");
    CHECK_FALSE(module.fault().empty());
    if (size == 0) break;
  }
  CHECK(module.fault() == "it is no shared object (ELF): it has 0 bytes");
}

TEST_CASE("the module of a plugin that is cut in half gives an error") {
  const Module module;
  const std::uintmax_t half = module.size() / 2;
  module.cut(half);
  FactoryTable table;
  CHECK(load_module(module.path(), table) ==
        "cannot open the module " + module.path() +
            ": it is damaged: the headers of its parts lie outside of its " + std::to_string(half) +
            " bytes; copy or build it again");
  CHECK(table.empty());
}

TEST_CASE("a file of another kind or for another processor is no module") {
  const Module module;
  module.overwrite(EI_CLASS, {ELFCLASS32});
  CHECK(
      module.fault().starts_with("it was built for another processor: ELF class 1, byte order 1, machine "));
  module.overwrite(EI_CLASS, {ELFCLASS64, ELFDATA2MSB});
  CHECK(
      module.fault().starts_with("it was built for another processor: ELF class 2, byte order 2, machine "));
  module.overwrite(EI_CLASS, {ELFCLASS64, ELFDATA2LSB});
  module.overwrite(offsetof(Elf64_Ehdr, e_type), {ET_REL});
  CHECK(module.fault() == "it is no shared object: ELF type 1, expected 3");
  module.overwrite(offsetof(Elf64_Ehdr, e_type), {ET_DYN});
  CHECK(module.fault().empty());
  module.overwrite(offsetof(Elf64_Ehdr, e_machine), {static_cast<char>(EM_ARM)});
  CHECK(module.fault().find("machine 40; expected ") != std::string::npos);
  module.overwrite(0, "version https://git-lfs.github.com/spec/v1\n");
  CHECK(module.fault() == "it is no shared object (ELF)");
  CHECK(shared_object_fault(module.path() + "x") == "it cannot be read");
}

TEST_CASE("a module whose table of symbols was never written does not end the process") {
  const Module module;
  // Zeros, as where a download reserves its file first. The headers are sound.
  std::ifstream file(module.path(), std::ios::binary);
  Elf64_Ehdr header{};
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  std::vector<Elf64_Phdr> segments(header.e_phnum);
  file.seekg(static_cast<std::streamoff>(header.e_phoff));
  file.read(reinterpret_cast<char*>(segments.data()),
            static_cast<std::streamsize>(segments.size() * sizeof segments[0]));
  for (const Elf64_Phdr& segment : segments)
    if (segment.p_type == PT_DYNAMIC) module.overwrite(segment.p_offset, std::string(segment.p_filesz, '\0'));
  CHECK(module.fault().empty());
  FactoryTable table;
  CHECK(load_module_guarded(module.path(), table) ==
        "cannot open the module " + module.path() +
            ": it is damaged: the loader fails on it; copy or build it again");
}

TEST_CASE("work in a child process succeeds only if it comes to its end") {
  CHECK(succeeds_in_child([] {}));
  CHECK_FALSE(succeeds_in_child([] { ::_exit(0); }));
  CHECK_FALSE(succeeds_in_child([] { throw std::runtime_error("wrong"); }));
  CHECK_FALSE(succeeds_in_child([] { std::raise(SIGBUS); }));
}

TEST_CASE("work in a child process that never ends is ended after its time", "[slow]") {
  const auto work = [] {
    for (volatile bool ends = false; !ends;) {
    }
  };
  CHECK_FALSE(succeeds_in_child(work, 1));
}

}  // namespace module_loader_test
