#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "geometry/terrain_fault.h"
#include "plugin/ascii_grid.h"
#include "plugins/factories.h"
#include "plugins/terrain/raster/raster_file.h"

namespace flyrock::plugins {

HeightGrid read_with_gdal(const std::string& plugin, const std::string& path) {
  // The module stands beside the shared object that this function is in.
  Dl_info here{};
  ::dladdr(reinterpret_cast<void*>(&read_with_gdal), &here);
  const auto module =
      std::filesystem::path(here.dli_fname ? here.dli_fname : "").parent_path() / "flyrock_gdal.so";
  void* handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    if (!std::filesystem::exists(module))
      throw PluginError(
          fmt::format("plugin {}: {}: reading this format needs GDAL, which this build does not have: "
                      "install the Debian package "
                      "libgdal-dev and build again, or convert the file to an ESRI ASCII grid (.asc)",
                      plugin, path));
    const char* reason = ::dlerror();
    throw PluginError(fmt::format("plugin {}: {}: cannot load {}: {}", plugin, path, module.string(),
                                  reason ? reason : "unknown reason"));
  }
  const auto read = reinterpret_cast<GdalReader>(::dlsym(handle, gdal_entry));
  HeightGrid grid;
  std::string wrong = fmt::format("{} has no reader", module.string());
  if (read) read(path, grid, wrong);
  if (!wrong.empty()) throw PluginError(fmt::format("plugin {}: {}: {}", plugin, path, wrong));
  return grid;
}

HeightGrid read_raster(const std::string& plugin, const std::string& path) {
  std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool is_text = ending == ".asc" || ending == ".txt" || ending == ".grd";
  return is_text ? read_ascii_grid("plugin " + plugin, path) : read_with_gdal(plugin, path);
}

namespace {

class RasterTerrain : public TerrainModel {
 public:
  explicit RasterTerrain(Params& params) : file_(params.text("file")) { params.require_dimension(3); }

  TerrainShape3 build_3d(Values, RandomStream&) const override {
    HeightGrid grid = read_raster("raster", file_);
    if (const std::string wrong = fault(grid); !wrong.empty())
      throw PluginError(fmt::format("plugin raster: {}: {}", file_, wrong));
    return grid;
  }

 private:
  std::string file_;
};

}  // namespace

std::unique_ptr<TerrainModel> make_raster(Params& params) { return std::make_unique<RasterTerrain>(params); }

}  // namespace flyrock::plugins
