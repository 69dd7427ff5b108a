#pragma once
// What a file of the ground is by the ending of its name.

#include <string>

namespace flyrock {

/// The ending of a name with its point, in lower case: ".tif" of "Pit.TIF"; empty without a point.
std::string ending_of(const std::string& path);

/// What a file is that another terrain than `terrain` reads, and which: "is a surface of triangles: as
/// ground, the terrain `mesh` reads it". Empty where the ending is none of those, or `terrain`'s own.
std::string other_form(const std::string& path, const std::string& terrain);

}  // namespace flyrock
