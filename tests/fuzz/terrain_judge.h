#pragma once
// Judges whether the ground that was read is the ground that a file means.

#include <string>

#include "terrain_file.h"

namespace flyrock::fuzz {

/// Reads the terrain and the trees of a scenario as a run does and compares them with those of `file`. Empty:
/// they are equal; else where they differ.
std::string fault_of_ground(const TerrainFile& file, const std::string& scenario);

/// What a refusal tells to write: all of the text in backticks that begins with `cure`; empty: it does not.
std::string told_cure(const std::string& message, const std::string& cure);

}  // namespace flyrock::fuzz
