#include "report/pictures/stress_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/round_step.h"

namespace flyrock {

namespace {

struct Frame {
  Vec2 low = Vec2::Constant(infinite), high = Vec2::Constant(-infinite);
  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

/// White without tension, dark red from `full` on.
std::string colour_of(double tension, double full) {
  const double share = full > 0 ? std::clamp(tension / full, 0.0, 1.0) : 0;
  const auto between = [&](int white, int red) {
    return white + static_cast<int>(std::lround(share * (red - white)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", between(250, 166), between(250, 25), between(250, 46));
}

}  // namespace

double drawn_displacement(const StressedBlock& block) {
  constexpr double seen = 0.05;  // of the body
  Frame frame;
  double greatest = 0;
  for (const SeriesNode& node : block.nodes) {
    frame.add((node.place - node.displacement).head<2>());
    greatest = std::max(greatest, node.displacement.norm());
  }
  if (!(greatest > 0)) return 1;
  return std::max(1.0, 1 / round_step(greatest / (seen * (frame.high - frame.low).maxCoeff())));
}

std::string stress_svg(const StressedBlock& block) {
  if (block.cells.empty() || block.cells.front().d >= 0) return {};
  const double times = drawn_displacement(block);
  std::vector<Vec2> places;
  Frame frame;
  for (const SeriesNode& node : block.nodes) {
    places.emplace_back((node.place + (times - 1) * node.displacement).head<2>());
    frame.add(places.back());
  }
  constexpr double width = 460, most_height = 460, margin = 10, legend = 44;
  const Vec2 extent = frame.high - frame.low;
  const double scale = std::min((width - 2 * margin) / extent.x(), (most_height - 2 * margin) / extent.y());
  const double height = scale * extent.y() + 2 * margin + legend;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n",
      width, height);
  for (const SeriesCell& cell : block.cells) {
    std::string points;
    for (const int node : {cell.a, cell.b, cell.c}) {
      const Vec2& p = places[static_cast<std::size_t>(node)];
      points += fmt::format("{:.1f},{:.1f} ", margin + scale * (p.x() - frame.low.x()),
                            margin + scale * (frame.high.y() - p.y()));
    }
    svg += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#888\" stroke-width=\"0.2\"/>\n", points,
                       colour_of(cell.tension, block.at.tension_1pct));
  }
  constexpr int steps = 20;
  constexpr double bar = 200;
  for (int i = 0; i < steps; ++i)
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"10\" fill=\"{}\"/>\n",
                       margin + bar * i / steps, height - legend + 6, bar / steps + 0.5,
                       colour_of(i + 0.5, steps));
  return svg + fmt::format(
                   "<text x=\"{:.0f}\" y=\"{:.1f}\">0 to {:.3g} MPa in tension</text>"
                   "<text x=\"{:.0f}\" y=\"{:.1f}\">displacements {:g} times</text>\n</svg>\n",
                   margin + bar + 8, height - legend + 15, 1e-6 * block.at.tension_1pct, margin,
                   height - legend + 34, times);
}

}  // namespace flyrock
