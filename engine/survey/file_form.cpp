#include "survey/file_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "units/units.h"

namespace flyrock {

namespace {

struct Form {
  std::string_view terrain, endings, what;
};

/// The endings stand between blanks.
constexpr Form forms[] = {
    {"raster", " .tif .tiff .img .vrt .hgt .dem .asc .grd ",
     "is a grid of heights: as ground, the terrain `raster` reads it"},
    {"mesh", " .obj .ply .stl .xml ", "is a surface of triangles: as ground, the terrain `mesh` reads it"},
    {"mesh", " .dxf ", "is a drawing of CAD: as ground, the terrain `mesh` reads its 3D faces"},
    {"points", " .las .laz .xyz .pts ", "is a cloud of points: as ground, the terrain `points` reads it"},
    {"", " .e57 .ptx ",
     "is a cloud of points in the form of a scanner: save it as LAS or XYZ, which the terrain `points` "
     "reads"},
    {"", " .dwg ",
     "is a drawing of CAD in a form of one program: save it as DXF, of which the terrain `mesh` reads the 3D "
     "faces, or export them as OBJ, with three decimals or more"},
};

}  // namespace

std::string ending_of(const std::string& path) {
  return lower(path.substr(std::min(path.rfind('.'), path.size())));
}

std::string other_form(const std::string& path, const std::string& terrain) {
  const std::string ending = fmt::format(" {} ", ending_of(path));
  for (const Form& form : forms)
    if (form.terrain != terrain && form.endings.find(ending) != std::string_view::npos)
      return std::string(form.what);
  return {};
}

}  // namespace flyrock
