#pragma once
// Sweeps the section through benches along a line in plan, and roughens profiles and surfaces.

#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/profile.h"
#include "plugins/terrain/benches/section.h"
#include "random/gaussian_field.h"
#include "random/stream.h"

namespace flyrock::plugins {

struct Roughness {
  double sd = 0;  ///< m
  RoughSpectrum spectrum;
};

/// The profile of a section; rough faces and berms are cut into pieces of about a cell. Where a rough profile
/// would hang over, it stands upright.
Profile profile_of(const Section& section, const std::optional<Roughness>& roughness, RandomStream& rng);

/// The surface of a section along `line`, the uppermost crest in plan: the faces look to the right of its
/// direction, the lower edges are parallel, with mitred corners. Throws ParameterError if a corner leaves no
/// room for an edge, or if edges cross. Heights of roughness have the places of the uppermost crest: at a
/// corner they are stretched with the edges.
Mesh mesh_of(const Section& section, const std::vector<Vec2>& line, const std::optional<Roughness>& roughness,
             RandomStream& rng);

/// The same with the notch of a straight section between `from` and `to` along the crest, counted from its
/// middle. Its ends stand upright.
Mesh mesh_with_notch(const Section& section, const Vec2& begin, const Vec2& end, double from, double to);

}  // namespace flyrock::plugins
