// Where rocks start.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scenario/decode_sections.h"
#include "scenario/normalise.h"

namespace flyrock {

namespace {

const std::map<std::string, ReleaseKind> release_kinds{
    {"from", ReleaseKind::face},    {"x", ReleaseKind::above_ground}, {"position", ReleaseKind::position},
    {"along", ReleaseKind::along},  {"inside", ReleaseKind::inside},  {"zone", ReleaseKind::zone},
    {"raster", ReleaseKind::raster}};

/// Listed once for all rocks, because a raster may have many cells.
std::shared_ptr<const std::vector<std::size_t>> cells_above_zero(const HeightGrid& grid) {
  auto cells = std::make_shared<std::vector<std::size_t>>();
  for (std::size_t i = 0; i < grid.heights.size(); ++i)
    if (grid.heights[i] > 0) cells->push_back(i);
  return cells;
}

/// The face: `bench: k` or `face: NAME`.
void read_face(DecodeContext& context, const Node& node, const Section& section,
               const DecodedTerrain& terrain, Release& release) {
  if (section.text("from") == "collar") release.kind = ReleaseKind::collar;
  if (section.text("from") == "bench_top") release.kind = ReleaseKind::bench_top;
  release.bench = section.integer("bench");
  release.face = section.text("face");
  const bool is_built = !terrain.parts.empty();
  if (!release.face.empty()) {
    const auto found = std::find(terrain.faces.begin(), terrain.faces.end(), release.face);
    if (is_built && found == terrain.faces.end())
      node.find("face")->error(context.diagnostics,
                               fmt::format("the terrain has no face `{}`{}", release.face,
                                           suggestion(release.face, terrain.faces)));
    release.bench = static_cast<int>(found - terrain.faces.begin()) + 1;
    return;
  }
  const int faces = static_cast<int>(terrain.faces.size());
  if (!is_built || release.bench < 1 || release.bench <= faces) return;
  if (context.has_holes && release.kind == ReleaseKind::collar && !section.given("bench")) return;
  const std::string found =
      faces == 0 ? "the terrain has no bench faces" : fmt::format("the terrain has {}", faces);
  node.error(context.diagnostics, fmt::format("there is no bench {}, {}", release.bench, found));
}

/// `above_ground` or `on_ground` of a place in plan.
void read_height(DecodeContext& context, const Node& node, const Section& section, Release& release) {
  release.in_plan = true;
  release.on_ground = section.constant("on_ground") != 0;
  if (const auto height = section.optional_number("above_ground")) release.above_ground = *height;
  const bool both = release.on_ground && section.given("above_ground");
  const bool neither = !release.on_ground && !section.given("above_ground");
  if (both) node.error(context.diagnostics, "has both `above_ground` and `on_ground`, expected one of them");
  if (neither)
    context.diagnostics.error(node.key_at, node.path,
                              "`above_ground` is missing, expected a number in m, or `on_ground: true`");
}

}  // namespace

std::optional<Release> decode_release(DecodeContext& context, const Node& node,
                                      const DecodedTerrain& terrain) {
  const std::optional<Node> key = key_of_release(node, context.dimension);
  if (!key) return std::nullopt;  // already reported
  const bool space = context.dimension == 3;
  Release release;
  release.kind = release_kinds.at(key->key);
  const std::string name = section_of_release(*key, context.dimension);
  const Section section = decode_section(context, node, name);
  switch (release.kind) {
    case ReleaseKind::face:
    case ReleaseKind::collar:
    case ReleaseKind::bench_top:
      read_face(context, node, section, terrain, release);
      return release;
    case ReleaseKind::above_ground:
      release.x = section.number("x");
      if (space) release.y = section.number("y");
      if (!space) release.above_ground = section.number("above_ground");
      break;
    case ReleaseKind::position:
      release.position = section.vector("position");
      break;
    case ReleaseKind::along:
      release.points = section.points("along");
      // A layer has told of its own fault.
      if (release.points.size() < 2 && key->is_list())
        node.error(context.diagnostics, "`along` needs at least two points");
      break;
    case ReleaseKind::inside:
      release.points = section.points("inside");
      break;
    case ReleaseKind::zone: {
      release.zone = section.text("zone");
      std::vector<std::string> zones;
      for (const Zone& zone : terrain.plan.zones) zones.push_back(zone.name);
      if (!release.zone.empty() && std::find(zones.begin(), zones.end(), release.zone) == zones.end())
        node.find("zone")->error(context.diagnostics, fmt::format("there is no zone `{}`{}", release.zone,
                                                                  suggestion(release.zone, zones)));
      break;
    }
    case ReleaseKind::raster:
      release.raster = read_raster(context, *node.find("raster"), section, "raster");
      if (release.raster) release.raster_cells = cells_above_zero(*release.raster);
      break;
  }
  const bool takes_height = space && (release.kind == ReleaseKind::above_ground || name.ends_with(" 3D"));
  if (takes_height) read_height(context, node, section, release);
  return release;
}

}  // namespace flyrock
