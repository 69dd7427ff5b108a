#include "report/shape_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "math/round_step.h"
#include "report/html.h"

namespace flyrock {

namespace {

constexpr double cell = 180, drawn = 130, foot = 44;  // pixels: of one rock, of its drawing, below it

/// The directions of the picture: right, up, and towards the eye.
struct View {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), near = Vec3::UnitZ();
};

View view_of(int dimension) {
  if (dimension == 2) return {};
  const double azimuth = -55 * pi / 180, elevation = 25 * pi / 180;  // of the eye
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  return {{-s, c, 0}, {-se * c, -se * s, ce}, {ce * c, ce * s, se}};
}

/// One face, or a ball, in the picture.
struct Piece {
  std::vector<Vec2> outline;  ///< m; right and up
  double radius = 0;          ///< m, by which the outline is grown
  double part_depth = 0;      ///< of its contactor, m towards the eye
  double light = 0;           ///< from 0 to 1
};

Vec3 middle_of(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& place : places) sum += place;
  return sum / static_cast<double>(places.size());
}

/// Twice the area of a face times its normal; 0 for a ball.
Vec3 area_of(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    sum += (places[i] - places[0]).cross(places[i + 1] - places[0]);
  return sum;
}

/// What can be seen, the farthest contactor first. The faces of a convex contactor that look towards the eye
/// do not hide each other.
std::vector<Piece> pieces_of(const PicturedRock& rock, const View& view) {
  std::map<std::pair<int, int>, std::vector<Vec3>> faces;
  std::map<std::pair<int, int>, double> radius;
  std::map<int, std::vector<Vec3>> contactors;
  for (const SurfaceCorner& corner : rock.corners) {
    faces[{corner.contactor, corner.face}].push_back(corner.place);
    radius[{corner.contactor, corner.face}] = corner.radius;
    contactors[corner.contactor].push_back(corner.place);
  }
  std::vector<Piece> pieces;
  for (const auto& [key, places] : faces) {
    const Vec3 area = area_of(places);
    Piece piece;
    piece.radius = radius[key];
    if (piece.radius <= 0 && area.dot(view.near) <= 0) continue;
    for (const Vec3& place : places) piece.outline.emplace_back(view.right.dot(place), view.up.dot(place));
    piece.part_depth = view.near.dot(middle_of(contactors[key.first]));
    piece.light = piece.radius > 0 || area.isZero() ? 0.7 : 0.5 + 0.5 * area.normalized().z();
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.part_depth < b.part_depth; });
  return pieces;
}

std::string colour_of(double light) {
  const auto mix = [&](int dark, int bright) {
    return static_cast<int>(std::lround(dark + light * (bright - dark)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0x8a, 0xf2), mix(0x80, 0xee), mix(0x70, 0xe4));
}

/// A rock in the cell that begins at `left` [pixels].
std::string drawing(const PicturedRock& rock, const View& view, double left) {
  const std::vector<Piece> pieces = pieces_of(rock, view);
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Piece& piece : pieces)
    for (const Vec2& place : piece.outline) {
      low = low.cwiseMin((place.array() - piece.radius).matrix());
      high = high.cwiseMax((place.array() + piece.radius).matrix());
    }
  const double scale = drawn / (high - low).maxCoeff();
  const Vec2 middle = (low + high) / 2;
  const auto x = [&](const Vec2& place) { return left + cell / 2 + scale * (place.x() - middle.x()); };
  const auto y = [&](const Vec2& place) { return cell / 2 - scale * (place.y() - middle.y()); };
  std::string out;
  for (const Piece& piece : pieces) {
    const std::string fill = colour_of(piece.light);
    if (piece.outline.size() == 1) {
      out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" stroke=\"#444\"/>\n",
                         x(piece.outline[0]), y(piece.outline[0]), scale * piece.radius, fill);
      continue;
    }
    std::string points;
    for (const Vec2& place : piece.outline)
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", x(place), y(place));
    // A line with round ends draws what the outline is grown by: first its edge, then its inside.
    for (const bool edge : {true, false}) {
      if (piece.radius <= 0 && !edge) continue;
      const double width = 2 * scale * piece.radius + (edge ? 1 : -1);
      out += fmt::format(
          "<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
          "stroke-linejoin=\"round\"/>\n",
          points, fill, edge ? "#444" : fill, width);
    }
  }
  const double length = round_step((high - low).maxCoeff() / 4), from = left + (cell - scale * length) / 2;
  out += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#444\" stroke-width=\"3\"/>\n", from,
                     cell + 4, scale * length);
  for (const auto& [row, text] : {std::pair(18.0, fmt::format("{:g} m", length)), std::pair(36.0, rock.name)})
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left + cell / 2,
                       cell + row, escaped(text));
  return out;
}

}  // namespace

std::string svg_of_rocks(const std::string& title, const std::vector<PicturedRock>& rocks, int dimension) {
  const View view = view_of(dimension);
  const double width = cell * static_cast<double>(rocks.size()), height = cell + foot;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n<title>{2}</title>\n",
      width, height, escaped(title));
  for (std::size_t i = 0; i < rocks.size(); ++i)
    out += drawing(rocks[i], view, cell * static_cast<double>(i));
  return out + "</svg>\n";
}

}  // namespace flyrock
