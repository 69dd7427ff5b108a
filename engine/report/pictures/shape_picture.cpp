#include "report/pictures/shape_picture.h"

#include <fmt/format.h>

#include "geometry/box.h"
#include "math/round_step.h"
#include "report/page/html.h"
#include "report/pictures/rock_view.h"

namespace flyrock {

namespace {

constexpr double cell = 180, rock_width = 130, foot = 44;  // pixels: of one rock, of its drawing, below it

/// A rock in the cell that begins at `x0` [pixels].
std::string drawing(const PicturedRock& rock, const PictureView& view, double x0) {
  const std::vector<Piece> pieces = pieces_of(rock.corners, view);
  Box2 box = Box2::empty();
  for (const Piece& piece : pieces) box.add(Box2::around(piece.outline).grown(piece.radius));
  const double size = box.size().maxCoeff(), scale = rock_width / size;
  const Vec2 middle = (box.low + box.high) / 2;
  const auto x = [&](const Vec2& place) { return x0 + cell / 2 + scale * (place.x() - middle.x()); };
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
  const double length = round_step(size / 4), from = x0 + (cell - scale * length) / 2;
  out += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#444\" stroke-width=\"3\"/>\n", from,
                     cell + 4, scale * length);
  for (const auto& [row, text] : {std::pair(18.0, fmt::format("{:g} m", length)), std::pair(36.0, rock.name)})
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x0 + cell / 2,
                       cell + row, escaped(text));
  return out;
}

}  // namespace

std::string svg_of_rocks(const std::string& title, const std::vector<PicturedRock>& rocks, int dimension) {
  const PictureView view = view_of(dimension);
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
