#include "plugin/raster_file.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "plugin/params.h"
#include "plugin/shared_object.h"
#include "units/units.h"

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

RasterFile read_with_gdal(const std::string& who, const std::string& path, std::optional<double> no_data) {
  const std::filesystem::path module = gdal_module();
  if (!std::filesystem::exists(module))
    throw PluginError(fmt::format(
        "{}: {}: reading this format needs GDAL, which this flyrock does not have: install its package "
        "flyrock-gdal, or libgdal-dev and build flyrock again, or convert the file to an ESRI ASCII grid "
        "(.asc)",
        who, path));
  std::string fault;
  void* handle = open_shared_object(module.string(), fault);
  if (!handle)
    throw PluginError(fmt::format("{}: {}: cannot load {}: {}", who, path, module.string(), fault));
  const auto read = reinterpret_cast<GdalReader>(::dlsym(handle, gdal_entry));
  RasterFile file;
  std::string wrong = fmt::format("{} has no reader", module.string());
  if (read) read(path, no_data, file, wrong);
  if (!wrong.empty()) throw PluginError(fmt::format("{}: {}: {}", who, path, wrong));
  return file;
}

}  // namespace

RasterFile read_raster_file(const std::string& who, const std::string& path, std::optional<double> no_data) {
  const std::string ending = lower(path.substr(std::min(path.rfind('.'), path.size())));
  const bool is_text = ending == ".asc" || ending == ".txt" || ending == ".grd";
  return is_text ? read_ascii_grid(who, path, no_data) : read_with_gdal(who, path, no_data);
}

double metres_in(const std::string& unit) {
  if (unit == "us_ft") return 1200.0 / 3937.0;
  const auto known = parse_unit(unit);
  return known && known->dimension == dimension::length ? known->factor : 0;
}

}  // namespace flyrock
