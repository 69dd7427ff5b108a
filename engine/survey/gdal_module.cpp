#include "survey/gdal_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "plugin/params.h"
#include "plugin/shared_object.h"

namespace flyrock {

namespace {

/// Beside the shared object that this code is in; in a program, in the folder lib/flyrock beside that of the
/// program.
std::filesystem::path gdal_module() {
  constexpr const char* name = "flyrock_gdal.so";
  Dl_info here{};
  ::dladdr(reinterpret_cast<void*>(&gdal_module), &here);
  const auto beside = std::filesystem::path(here.dli_fname ? here.dli_fname : "").parent_path() / name;
  if (std::filesystem::exists(beside)) return beside;
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "lib" / "flyrock" / name;
}

}  // namespace

bool has_gdal() { return std::filesystem::exists(gdal_module()); }

void* gdal_entry_point(const std::string& where, const char* entry, const std::string& conversion) {
  const std::filesystem::path module = gdal_module();
  if (!std::filesystem::exists(module))
    throw PluginError(fmt::format(
        "{}: reading this format needs GDAL, which this flyrock does not have: install its package "
        "flyrock-gdal, take the archive with GDAL, or build flyrock again with libgdal-dev, or {}",
        where, conversion));
  std::string fault;
  void* handle = open_shared_object(module.string(), fault);
  if (!handle) throw PluginError(fmt::format("{}: cannot load {}: {}", where, module.string(), fault));
  void* found = ::dlsym(handle, entry);
  if (!found) throw PluginError(fmt::format("{}: {} has no reader of it", where, module.string()));
  return found;
}

}  // namespace flyrock
