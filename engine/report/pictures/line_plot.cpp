#include "report/pictures/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/page/html.h"

namespace flyrock {

namespace {

constexpr double plot_width = 420, least_height = 358, left = 76, right = 14, first_top = 82, bottom = 48;
constexpr std::array<const char*, 8> colours = {"#1f5fa8", "#c4531b", "#2f7d3b", "#7a3f92",
                                                "#8a6d00", "#00838f", "#333333", "#b3261e"};

/// An axis somewhat longer than its values, so that corners of curves are not on the frame, with ticks at
/// round numbers. If all values are equal, the axis is widened.
struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = -low, step = 1;

  void include(const std::vector<double>& values) {
    for (const double v : values)
      if (!std::isnan(v)) low = std::min(low, v), high = std::max(high, v);
  }
  void close() {
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-9 * size || size == 0)
      low -= 0.5 * size + (size == 0), high += 0.5 * size + (size == 0);
    constexpr double margin = 0.06;
    const double beyond = margin * (high - low);
    low -= beyond, high += beyond;
    const double rough = (high - low) / 5, power = std::pow(10, std::floor(std::log10(rough)));
    step = (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10) * power;
  }
  double share(double v) const { return (v - low) / (high - low); }
  double first() const { return step * std::ceil(low / step - 1e-9); }
  int ticks() const { return static_cast<int>(std::floor((high - first()) / step + 1e-9)); }
  double at(int i) const { return first() + i * step; }
  std::string tick(int i) const { return fmt::format("{:.6g}", std::abs(at(i)) < 1e-9 * step ? 0.0 : at(i)); }
};

std::string text(double x, double y, const std::string& anchor, int size, const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y,
                     anchor, size, escaped(content));
}

/// Where the names of the curves stand: from the left end of the axes, and in which row above them.
struct NamePlace {
  double x = 0;
  int row = 0;
};

/// Names in rows no wider than the axes.
std::vector<NamePlace> name_places(const Plot& plot) {
  constexpr double letter = 6.4, between = 14;  // widths, about
  std::vector<NamePlace> places;
  if (plot.curves.size() < 2) return places;
  NamePlace next;
  for (const Curve& curve : plot.curves) {
    const double wide = letter * static_cast<double>(curve.name.size());
    if (next.x > 0 && next.x + wide > plot_width - left - right) next = {0, next.row + 1};
    places.push_back(next);
    next.x += wide + between;
  }
  return places;
}

constexpr double row_high = 16;

/// By how much the axes are lower, because names need more rows than one.
double height_of_names(const std::vector<Plot>& plots) {
  int rows = 0;
  for (const Plot& plot : plots)
    for (const NamePlace& place : name_places(plot)) rows = std::max(rows, place.row);
  return rows * row_high;
}

std::string panel(const Plot& plot, double offset, double lower) {
  const double top = first_top + lower, height = least_height + lower;
  Axis ax, ay;
  for (const Curve& curve : plot.curves) {
    ax.include(curve.x);
    for (const auto* values : {&curve.y, &curve.low, &curve.high}) ay.include(*values);
  }
  ax.close(), ay.close();
  const auto px = [&](double x) { return offset + left + ax.share(x) * (plot_width - left - right); };
  const auto py = [&](double y) { return height - bottom - ay.share(y) * (height - top - bottom); };
  std::string out = text(offset + left, first_top - 28, "start", 13, plot.title);
  const auto line = [&](double x1, double y1, double x2, double y2, const char* colour) {
    out += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1,
                       y1, x2, y2, colour);
  };
  for (int i = 0; i <= ax.ticks(); ++i) {
    const double x = px(ax.at(i));
    line(x, top, x, height - bottom, "#e4e4e4");
    out += text(x, height - bottom + 15, "middle", 11, ax.tick(i));
  }
  for (int i = 0; i <= ay.ticks(); ++i) {
    const double y = py(ay.at(i));
    line(offset + left, y, offset + plot_width - right, y, "#e4e4e4");
    out += text(offset + left - 6, y + 4, "end", 11, ay.tick(i));
  }
  if (ay.low <= 0 && ay.high >= 0) line(offset + left, py(0), offset + plot_width - right, py(0), "#777");
  if (ax.low <= 0 && ax.high >= 0) line(px(0), top, px(0), height - bottom, "#777");
  out += text(offset + (left + plot_width - right) / 2, height - 12, "middle", 12, plot.x_label);
  out += fmt::format("<g transform=\"translate({:.1f},{:.1f}) rotate(-90)\">{}</g>\n", offset + 14,
                     (top + height - bottom) / 2, text(0, 0, "middle", 12, plot.y_label));
  const std::vector<NamePlace> names = name_places(plot);
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    const Curve& curve = plot.curves[c];
    const char* colour = colours[c % colours.size()];
    std::string there, back;  // along the low ends of the band, and back along the high ones
    for (std::size_t i = 0; i < curve.low.size(); ++i) {
      if (std::isnan(curve.low[i]) || std::isnan(curve.high[i])) continue;
      there += fmt::format("{:.2f},{:.2f} ", px(curve.x[i]), py(curve.low[i]));
      back = fmt::format("{:.2f},{:.2f} ", px(curve.x[i]), py(curve.high[i])) + back;
    }
    if (!there.empty())
      out +=
          fmt::format("<polygon fill=\"{}\" fill-opacity=\"0.15\" points=\"{}{}\"/>\n", colour, there, back);
    out += fmt::format(
        "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\" points=\"", colour,
        curve.dashed ? "8 6" : "none");
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      out += fmt::format("{:.2f},{:.2f} ", px(curve.x[i]), py(curve.y[i]));
    out += "\"/>\n";
    if (names.empty()) continue;
    out += fmt::format(
        "<g fill=\"{}\">{}</g>", colour,
        text(offset + left + names[c].x, first_top - 9 + names[c].row * row_high, "start", 12, curve.name));
  }
  return out;
}

}  // namespace

std::string svg_of(const std::string& heading, const std::vector<Plot>& plots) {
  const double all = plot_width * static_cast<double>(plots.size()), lower = height_of_names(plots);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" fill=\"#222\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      all, least_height + lower);
  constexpr double margin = 14, letter = 0.61;  // pixels; width of a letter by its size
  const double fitting = (all - 2 * margin) / (letter * static_cast<double>(heading.size()));
  out += text(margin, 24, "start", std::clamp(static_cast<int>(fitting), 10, 16), heading);
  for (std::size_t i = 0; i < plots.size(); ++i)
    out += panel(plots[i], plot_width * static_cast<double>(i), lower);
  return out + "</svg>\n";
}

}  // namespace flyrock
