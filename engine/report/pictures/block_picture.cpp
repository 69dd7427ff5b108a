#include "report/pictures/block_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/page/html.h"

namespace flyrock {

namespace {

constexpr std::array<BlockColour, 7> block_colours = {{{"falls", "#a6192e"},
                                                       {"factor below 1", "#d55e00"},
                                                       {"below 1.3", "#e69f00"},
                                                       {"from 1.3 on", "#009e73"},
                                                       {"no factor", "#cc79a7"},
                                                       {"held", "#9ecae1"},
                                                       {"locked", "#d5dae0"}}};

/// A face on the picture.
struct DrawnFace {
  int block = 0;
  double depth = 0;  ///< of its middle, towards the viewer
  double light = 1;
  std::vector<Vec2> corners;
};

/// The axes of the picture, to the right and up, and the direction to the viewer: from the front right,
/// above.
struct BlockView {
  Vec3 right, up, viewer;
};

BlockView view_of_blocks(int dimension) {
  if (dimension == 2) return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const Vec3 viewer = Vec3(1, -0.55, 0.45).normalized();
  const Vec3 right = Vec3::UnitZ().cross(viewer).normalized();
  return {right, viewer.cross(right), viewer};
}

std::vector<DrawnFace> faces_towards(const BlockView& view, const std::vector<BlockCorner>& corners,
                                     bool flat) {
  std::vector<DrawnFace> faces;
  for (std::size_t begin = 0; begin < corners.size();) {
    std::size_t end = begin;
    while (end < corners.size() && corners[end].block == corners[begin].block &&
           corners[end].face == corners[begin].face)
      ++end;
    DrawnFace face{corners[begin].block, 0, 1, {}};
    Vec3 area = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& p = corners[i].place;
      const Vec3& next = corners[i + 1 < end ? i + 1 : begin].place;
      area += (p - corners[begin].place).cross(next - corners[begin].place);
      face.corners.emplace_back(view.right.dot(p), view.up.dot(p));
      face.depth += view.viewer.dot(p) / static_cast<double>(end - begin);
    }
    begin = end;
    const double towards = flat || area.norm() == 0 ? 1 : area.normalized().dot(view.viewer);
    if (towards <= 0) continue;
    face.light = 0.65 + 0.35 * towards;
    faces.push_back(std::move(face));
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const DrawnFace& a, const DrawnFace& b) { return a.depth < b.depth; });
  return faces;
}

std::string title_of_block(const BlockRow& block) {
  std::string text = fmt::format("block {}: {:.3g} m3, {}", block.block, block.volume, name_of(block.mode));
  if (!block.joints.empty()) text += " on " + block.joints;
  if (std::isfinite(block.factor)) text += fmt::format(", factor {:.2f}", block.factor);
  return text;
}

}  // namespace

const BlockColour& block_colour(const BlockRow& block) {
  switch (block.mode) {
    case BlockMode::falls:
      return block_colours[0];
    case BlockMode::held:
      return block_colours[5];
    case BlockMode::locked:
      return block_colours[6];
    default:
      return block_colours[!std::isfinite(block.factor) ? 4
                           : block.factor < 1           ? 1
                           : block.factor < 1.3         ? 2
                                                        : 3];
  }
}

std::string blocks_svg(const FirstBlocks& blocks, int dimension) {
  if (blocks.corners.empty()) return {};
  const std::vector<DrawnFace> faces =
      faces_towards(view_of_blocks(dimension), blocks.corners, dimension == 2);
  Vec2 low = Vec2::Constant(infinite), high = -low;
  for (const DrawnFace& face : faces)
    for (const Vec2& p : face.corners) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  constexpr double width = 640, most_height = 520, margin = 10, legend = 26;
  const double scale = std::min((width - 2 * margin) / (high.x() - low.x()),
                                (most_height - 2 * margin) / (high.y() - low.y()));
  const double height = scale * (high.y() - low.y()) + 2 * margin + legend;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n",
      width, height);
  for (const DrawnFace& face : faces) {
    const BlockRow& block = blocks.blocks[static_cast<std::size_t>(face.block)];
    std::string points;
    for (const Vec2& p : face.corners)
      points += fmt::format("{:.1f},{:.1f} ", margin + scale * (p.x() - low.x()),
                            margin + scale * (high.y() - p.y()));
    svg += fmt::format(
        "<polygon points=\"{}\" fill=\"{}\" stroke=\"#222\" stroke-width=\"0.7\" "
        "style=\"filter:brightness({:.2f})\"><title>{}</title></polygon>\n",
        points, block_colour(block).colour, face.light, escaped(title_of_block(block)));
  }
  double x = margin;
  for (const BlockColour& one : block_colours) {
    svg += fmt::format(
        "<rect x=\"{:.0f}\" y=\"{:.1f}\" width=\"11\" height=\"11\" fill=\"{}\" stroke=\"#222\"/>"
        "<text x=\"{:.0f}\" y=\"{:.1f}\">{}</text>\n",
        x, height - legend + 6, one.colour, x + 15, height - legend + 16, one.name);
    x += 30 + 6.5 * static_cast<double>(std::string_view(one.name).size());
  }
  return svg + "</svg>\n";
}

}  // namespace flyrock
