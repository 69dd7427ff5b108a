#include <fmt/format.h>

#include <cmath>

#include "geometry/contactor.h"
#include "geometry/inset.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

constexpr int most_sides = 100;
constexpr double usual_irregularity = 0.3;
constexpr double least_gap = 20 * pi / 180;

/// The polygon with its corners rounded; 0: sharp.
Contactor2 with_corners(std::vector<Vec2> vertices, double rounding) {
  if (!(rounding >= 0 && std::isfinite(rounding)))
    throw PluginError(fmt::format("plugin polygon: rounding is {:.6g} m, must be 0 or more", rounding));
  if (rounding == 0) return Contactor2::polygon(std::move(vertices));
  const double limit = greatest_inset(vertices);
  if (!(rounding < limit))
    throw ParameterError(fmt::format(
        "plugin polygon: rounding is {:.6g} m, must be below {:.6g} m, where the first side of this "
        "polygon has no straight part",
        rounding, limit));
  return Contactor2::hull(inset(vertices, rounding), rounding);
}

/// A polygon with the vertices that the scenario gives.
class GivenPolygon : public ShapeModel {
 public:
  GivenPolygon(std::vector<Vec2> vertices, int rounding)
      : vertices_(std::move(vertices)), rounding_(rounding) {}
  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    return {with_corners(vertices_, rounding_ < 0 ? 0 : values[rounding_])};
  }

 private:
  std::vector<Vec2> vertices_;
  int rounding_;
};

/// Draws the angles between successive vertices [rad]. Each is a minimum angle plus a share of the rest. The
/// shares go from equal (irregularity 0) to those of random points on a circle, whose spacings are
/// exponential numbers divided by their sum.
std::vector<double> draw_gaps(int sides, double irregularity, RandomStream& rng) {
  const double least = sides * least_gap < 2 * pi ? least_gap : pi / sides;
  std::vector<double> gaps;
  double sum = 0;
  for (int k = 0; k < sides; ++k) {
    gaps.push_back(1 - irregularity - irregularity * std::log(rng.uniform()));
    sum += gaps.back();
  }
  for (double& gap : gaps) gap = least + (2 * pi - sides * least) * gap / sum;
  return gaps;
}

class DrawnPolygon : public ShapeModel {
 public:
  DrawnPolygon(int sides, int diameter, int irregularity, int rounding)
      : sides_(sides), diameter_(diameter), irregularity_(irregularity), rounding_(rounding) {}

  std::vector<Contactor2> build(Values values, RandomStream& rng) const override {
    const double sides = values[sides_], diameter = values[diameter_];
    const double irregularity = irregularity_ < 0 ? usual_irregularity : values[irregularity_];
    if (!(sides >= 3 && sides <= most_sides))
      throw PluginError(
          fmt::format("plugin polygon: sides is {:.6g}, must be from 3 to {}", sides, most_sides));
    if (!(diameter > 0))
      throw PluginError(fmt::format("plugin polygon: diameter is {:.6g} m, must be above 0", diameter));
    if (!(irregularity >= 0 && irregularity <= 1))
      throw PluginError(
          fmt::format("plugin polygon: irregularity is {:.6g}, must be from 0 to 1", irregularity));

    const auto gaps = draw_gaps(static_cast<int>(std::lround(sides)), irregularity, rng);
    double unit_area = 0;  // on the circle of radius 1
    for (double gap : gaps) unit_area += std::sin(gap) / 2;
    const double circumradius = diameter / 2 * std::sqrt(pi / unit_area);
    std::vector<Vec2> vertices;
    double angle = -pi / 2 + gaps.back() / 2;
    for (double gap : gaps) {
      vertices.push_back(circumradius * Vec2(std::cos(angle), std::sin(angle)));
      angle += gap;
    }
    return {with_corners(std::move(vertices), rounding_ < 0 ? 0 : values[rounding_])};
  }

 private:
  int sides_, diameter_, irregularity_, rounding_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_polygon(Params& params) {
  params.require_dimension(2);
  auto vertices = params.points2("vertices");
  const int sides = params.slot("sides"), diameter = params.slot("diameter");
  const int irregularity = params.slot("irregularity"), rounding = params.slot("rounding");
  const bool drawn = sides >= 0 && diameter >= 0;
  if (!params.given("vertices") && drawn)
    return std::make_unique<DrawnPolygon>(sides, diameter, irregularity, rounding);
  if (!params.given("vertices") || sides >= 0 || diameter >= 0)
    throw PluginError("plugin polygon: expected either `vertices`, or `sides` and `diameter`");
  if (irregularity >= 0)
    throw PluginError(
        "plugin polygon: `irregularity` is of a drawn polygon and says nothing beside `vertices`");
  if (std::string fault = make_convex(vertices); !fault.empty())
    throw PluginError("plugin polygon: " + fault);
  return std::make_unique<GivenPolygon>(std::move(vertices), rounding);
}

}  // namespace flyrock::plugins
