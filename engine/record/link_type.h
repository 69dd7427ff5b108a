#pragma once
// The types of links between bodies (world/links.h).

namespace flyrock {

enum class LinkType {
  hinge,   ///< both have a place in common, in 3D an axis
  rod,     ///< two places keep their distance
  spring,  ///< two places pull or push each other
  rope     ///< two places are apart by no more than a length
};

inline constexpr const char* link_type_names[] = {"hinge", "rod", "spring", "rope"};
inline const char* name_of(LinkType type) { return link_type_names[static_cast<int>(type)]; }

}  // namespace flyrock
