#pragma once
// Holes that are not upright: where they lean, and whether they lean to their face.

#include <optional>
#include <string>
#include <vector>

#include "scenario/decode_sections.h"

namespace flyrock {

/// "; holes lean to the north-west, 80 deg from horizontal"; empty if no hole gives dip and direction.
std::string leaning_text(const std::vector<Hole>& holes, double north);

/// The direction in plan to which a completed hole leans; nothing if it is upright, to a degree, or does not
/// say.
std::optional<Vec2> lean_of(const Blast& hole);

/// Warns of holes of the front row that lean away from the bench face whose crest is nearest: most often
/// their direction counts in another way. Without faces of the terrain there is no warning.
void warn_of_holes_away_from_faces(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                                   const DecodedTerrain& terrain);

/// The same for holes that are known to lean away.
void warn_of_holes_away(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                        const std::vector<std::size_t>& away);

}  // namespace flyrock
