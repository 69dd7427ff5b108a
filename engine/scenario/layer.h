#pragma once
// Layers of a GIS or of CAD in place of points: `{ layer: FILE, name: LAYER, where: { ATTRIBUTE: VALUE } }`.

#include <vector>

#include "geometry/plan_region.h"
#include "scenario/decode_context.h"

namespace flyrock {

/// Whether a value is a layer and no list of points.
bool is_layer(const Value& value);

/// A shapefile is several files: adds those beside `file` to the files of the scenario.
void add_files_beside(DecodeContext& context, const std::string& file);

/// Normalises a layer in place of the points of `spec`: in 3D places in plan, in 2D the points of a profile.
/// The layer itself is read when it is decoded, because it is transformed to the system of the terrain.
Value normalise_layer(DecodeContext& context, const Node& node, const ParamSpec& spec);

/// The points of a normalised layer in place of those of `spec`: of the only line, outline (`inside`) or
/// point that it has, or of its points in their order; in 2D distances along the line in plan, and heights.
/// Empty if something is wrong, which is reported.
std::vector<std::vector<double>> layer_points(DecodeContext& context, const Node& node,
                                              const ParamSpec& spec);

/// The values that an attribute has in a layer as it is written, after its `where`, each once in the order of
/// the file. Empty if something is wrong, which is reported.
std::vector<std::string> layer_values(DecodeContext& context, const Node& node, const std::string& attribute);

/// The regions of a normalised layer: polygons with holes, and the insides of closed lines.
std::vector<PlanPolygon> layer_region(DecodeContext& context, const Node& node);

}  // namespace flyrock
