#include "report/pictures/stereonet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/plan_field.h"

namespace flyrock {

namespace {

constexpr double net_radius = 250, net_x = 290, net_y = 290;  // px
constexpr std::array<const char*, 6> set_colours = {"#0072b2", "#d55e00", "#009e73",
                                                    "#cc79a7", "#e69f00", "#56b4e9"};

std::string net_px(const Vec2& p) {
  return fmt::format("{:.1f} {:.1f}", net_x + net_radius * p.x(), net_y - net_radius * p.y());
}

std::string path_of(const std::vector<Vec2>& points, const char* style, bool closed = false) {
  std::string d;
  for (const Vec2& p : points) d += (d.empty() ? "M" : "L") + net_px(p);
  return fmt::format("<path d=\"{}{}\" {}/>\n", d, closed ? "Z" : "", style);
}

/// The lines of a plane, from one horizontal end to the other.
std::vector<Vec2> great_circle(double dip, double direction) {
  constexpr int steps = 60;
  const Vec3 strike = line_of(direction - pi / 2, 0), down = line_of(direction, dip);
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * i / steps;
    points.push_back(on_net(std::cos(angle) * strike + std::sin(angle) * down));
  }
  return points;
}

/// A circle about a line at an angle, in pieces where it leaves the lower hemisphere.
std::string small_circle(const Vec3& centre, double angle, const char* style) {
  constexpr int steps = 120;
  const Eigen::Matrix3d frame = contact_frame(centre);
  std::string svg;
  std::vector<Vec2> piece;
  for (int i = 0; i <= steps; ++i) {
    const double around = 2 * pi * i / steps;
    const Vec3 line = std::cos(angle) * frame.col(0) +
                      std::sin(angle) * (std::cos(around) * frame.col(1) + std::sin(around) * frame.col(2));
    const Vec2 place = on_net(line);
    if (!piece.empty() && (place - piece.back()).norm() > 0.5) {  // it goes on at the opposite side
      svg += path_of(piece, style);
      piece.clear();
    }
    piece.push_back(place);
  }
  return svg + path_of(piece, style);
}

/// Shaded regions where poles are a few times as dense as if they had any direction: each counts in a circle
/// of 4 % of the net (Epanechnikov's kernel), and beside the rim on the opposite side too.
std::string contours(const Poles& poles) {
  constexpr double cell_of_net = 0.01, reach = 0.2;
  const Vec2 corner = Vec2::Constant(1 + reach);
  PlanField field(-corner, corner, cell_of_net);
  for (std::size_t i = 0; i < poles.poles.size(); ++i) {
    const Vec2 place = on_net(poles.poles[i]);
    field.add_kernel(place, reach, poles.weights[i]);
    if (place.norm() > 1 - reach)
      field.add_kernel(-std::sqrt(2 - place.squaredNorm()) * place.normalized(), reach, poles.weights[i]);
  }
  const double uniform = 0.5 * static_cast<double>(poles.poles.size()) * reach * reach;
  std::string svg = fmt::format(
      "<clipPath id=\"net\"><circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\"/></clipPath><g "
      "clip-path=\"url(#net)\">\n",
      net_x, net_y, net_radius);
  int shade = 235;
  for (const double level : {2.0, 4.0, 8.0, 16.0}) {
    const std::string fill = fmt::format("fill=\"rgb({0},{0},{1})\" stroke=\"none\"", shade, shade + 8);
    for (const PlanRing& ring : field.region_above(level * uniform)) svg += path_of(ring, fill.c_str(), true);
    shade -= 22;
  }
  return svg + "</g>\n";
}

std::string net_frame() {
  std::string svg = fmt::format("<circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" fill=\"none\" stroke=\"#444\"/>\n",
                                net_x, net_y, net_radius);
  constexpr std::pair<const char*, Vec2 (*)()> sides[] = {{"N", [] { return Vec2(0, 1); }},
                                                          {"E", [] { return Vec2(1, 0); }},
                                                          {"S", [] { return Vec2(0, -1); }},
                                                          {"W", [] { return Vec2(-1, 0); }}};
  for (const auto& [name, place] : sides) {
    const Vec2 at = 1.06 * place();
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                       net_x + net_radius * at.x(), net_y - net_radius * at.y() + 4, name);
  }
  return svg;
}

}  // namespace

Vec2 on_net(const Vec3& line) {
  const Vec3 down = (line.z() > 0 ? Vec3(-line) : line).normalized();
  const double level = down.head<2>().norm();
  if (level == 0) return Vec2::Zero();
  return std::sqrt(1 + down.z()) / level * down.head<2>();  // sqrt(2) sin(theta/2), z = -cos(theta)
}

std::string stereonet_svg(const JointSurvey& survey, const SlopeFace* face) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n",
      2 * net_x, 2 * net_y);
  svg += contours(survey.poles);
  svg += net_frame();
  for (std::size_t i = 0; i < survey.poles.poles.size(); ++i) {
    const Vec2 at = on_net(survey.poles.poles[i]);
    const int set = survey.set_of[i];
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.4\" fill=\"{}\"/>\n",
                       net_x + net_radius * at.x(), net_y - net_radius * at.y(),
                       set < 0 ? "#999" : set_colours[static_cast<std::size_t>(set) % set_colours.size()]);
  }
  for (std::size_t s = 0; s < survey.sets.size(); ++s) {
    const SurveyedSet& set = survey.sets[s];
    const std::string line =
        fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", set_colours[s % set_colours.size()]);
    svg += path_of(great_circle(set.dip, set.direction), line.c_str());
    svg += small_circle(set.fit.mean, set.cone, line.c_str());
    const Vec2 at = on_net(set.fit.mean);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n",
                       net_x + net_radius * at.x() + 8, net_y - net_radius * at.y() - 8, s + 1);
  }
  if (face) {
    svg +=
        path_of(great_circle(face->dip, face->direction), "fill=\"none\" stroke=\"#000\" stroke-width=\"3\"");
    // A pole of a plane steeper than the friction angle lies outside of this circle.
    svg += small_circle(-Vec3::UnitZ(), face->friction,
                        "fill=\"none\" stroke=\"#000\" stroke-dasharray=\"5 4\"");
  }
  return svg + "</svg>\n";
}

}  // namespace flyrock
