#include <fmt/format.h>

#include <algorithm>

#include "geometry/box.h"
#include "geometry/contactor.h"
#include "geometry/plan_line.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

using Chain = std::vector<Vec2>;

double diagonal_of(const Chain& line) { return Box2::around(line).size().norm(); }

/// The outline of a strip of a constant thickness on the right of a line; empty if the line bends too sharply
/// for it. At a bend between segments with the normals a and b, the back is at a distance t from both:
/// p - t (a + b) / (1 + a.b).
Chain strip(const Chain& line, double thickness) {
  std::vector<Vec2> normals;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    normals.push_back(perpendicular(Vec2((line[i + 1] - line[i]).normalized())));
  Chain back;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 &before = normals[i == 0 ? 0 : i - 1], &after = normals[std::min(i, normals.size() - 1)];
    const double opening = 1 + before.dot(after);
    if (opening < 1e-6) return {};
    back.push_back(line[i] - thickness / opening * (before + after));
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if ((back[i + 1] - back[i]).dot(line[i + 1] - line[i]) <= 0) return {};
  Chain outline = line;
  outline.insert(outline.end(), back.rbegin(), back.rend());
  Chain closed = outline;
  closed.push_back(closed.front());
  return line_fault(closed).empty() ? outline : Chain();
}

class Polyline : public ShapeModel {
 public:
  explicit Polyline(Params& params)
      : points_(params.points2("points")), thickness_(params.slot("thickness")) {
    params.require_dimension(2);
    if (const std::string wrong = line_fault(points_); !wrong.empty())
      throw PluginError("plugin polyline: " + wrong);
    is_closed_ = points_.size() > 3 && points_.front() == points_.back();
    if (is_closed_) points_.pop_back();
    if (is_closed_ && thickness_ >= 0)
      throw PluginError(
          "plugin polyline: `thickness` with a line that ends where it begins, expected a line with two "
          "ends");
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    return {Contactor2::outline(is_closed_ ? points_ : thick(values))};
  }

 private:
  Chain thick(Values values) const {
    if (thickness_ >= 0) {
      const double thickness = values[thickness_];
      if (!(thickness > 0))
        throw PluginError(fmt::format("plugin polyline: thickness is {:.6g} m, must be above 0", thickness));
      const Chain outline = strip(points_, thickness);
      if (outline.empty())
        throw PluginError(
            fmt::format("plugin polyline: thickness is {:.6g} m, too thick: the line would fold at its bends",
                        thickness));
      return outline;
    }
    double thickness = usual_thickness * diagonal_of(points_);
    for (int i = 0; i < most_tries; ++i, thickness /= 2)
      if (Chain outline = strip(points_, thickness); !outline.empty()) return outline;
    throw PluginError("plugin polyline: the line turns back on itself");
  }

  static constexpr double usual_thickness = 0.05;  // of the diagonal of the line's box
  static constexpr int most_tries = 20;

  Chain points_;
  int thickness_;
  bool is_closed_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_polyline(Params& params) { return std::make_unique<Polyline>(params); }

}  // namespace flyrock::plugins
