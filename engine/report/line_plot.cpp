#include "report/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/html.h"

namespace flyrock {

namespace {

constexpr double width = 420, height = 358, left = 64, right = 14, top = 82, bottom = 48;
constexpr std::array<const char*, 8> colours = {"#1f5fa8", "#c4531b", "#2f7d3b", "#7a3f92",
                                                "#8a6d00", "#00838f", "#333333", "#b3261e"};

/// An axis somewhat longer than its values, so that corners of curves are not on the frame, with ticks at
/// round numbers. If all values are equal, the axis is widened.
struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = -low, step = 1;

  void include(const std::vector<double>& values) {
    for (const double v : values) low = std::min(low, v), high = std::max(high, v);
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

std::string panel(const Plot& plot, double offset) {
  Axis ax, ay;
  for (const Curve& curve : plot.curves) ax.include(curve.x), ay.include(curve.y);
  ax.close(), ay.close();
  const auto px = [&](double x) { return offset + left + ax.share(x) * (width - left - right); };
  const auto py = [&](double y) { return height - bottom - ay.share(y) * (height - top - bottom); };
  std::string out = text(offset + left, top - 28, "start", 13, plot.title);
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
    line(offset + left, y, offset + width - right, y, "#e4e4e4");
    out += text(offset + left - 6, y + 4, "end", 11, ay.tick(i));
  }
  if (ay.low <= 0 && ay.high >= 0) line(offset + left, py(0), offset + width - right, py(0), "#777");
  if (ax.low <= 0 && ax.high >= 0) line(px(0), top, px(0), height - bottom, "#777");
  out += text(offset + (left + width - right) / 2, height - 12, "middle", 12, plot.x_label);
  out += fmt::format("<g transform=\"translate({:.1f},{:.1f}) rotate(-90)\">{}</g>\n", offset + 14,
                     (top + height - bottom) / 2, text(0, 0, "middle", 12, plot.y_label));
  double name_at = offset + left;  // the names of the curves stand in a row above the axes
  for (std::size_t c = 0; c < plot.curves.size(); ++c) {
    const Curve& curve = plot.curves[c];
    const char* colour = colours[c % colours.size()];
    out += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\" points=\"", colour);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      out += fmt::format("{:.2f},{:.2f} ", px(curve.x[i]), py(curve.y[i]));
    out += "\"/>\n";
    if (plot.curves.size() < 2) continue;
    constexpr double letter = 6.4, between = 14;  // widths, about
    out += fmt::format("<g fill=\"{}\">{}</g>", colour, text(name_at, top - 9, "start", 12, curve.name));
    name_at += letter * static_cast<double>(curve.name.size()) + between;
  }
  return out;
}

}  // namespace

std::string svg_of(const std::string& heading, const std::vector<Plot>& plots) {
  const double all = width * static_cast<double>(plots.size());
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" fill=\"#222\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      all, height);
  out += text(left, 24, "start", 16, heading);
  for (std::size_t i = 0; i < plots.size(); ++i) out += panel(plots[i], width * static_cast<double>(i));
  return out + "</svg>\n";
}

}  // namespace flyrock
