#pragma once
// Judges the motion of a scene by the tables of its result, with geometry of its own.

#include <string>

#include "scene.h"

namespace flyrock::fuzz {

/// Why the result in a folder is wrong; empty if it is not. It reads the surfaces, series and stop reasons
/// from results.db as text and numbers, and calls nothing of the engine. At each stored instant:
///   - all numbers are finite;
///   - no corner of a body, place of a rim or centre of a ball lies in the ground or in another body deeper
///     than a share of the smaller one, or beyond the wall of a drum or tube that it is in;
///   - if nothing gives energy, the sum over the bodies is not above the one before.
/// No body has diverged, unless a driven one may press it where it cannot give way.
std::string fault_of_scene(const Scene& scene, const std::string& folder);

}  // namespace flyrock::fuzz
