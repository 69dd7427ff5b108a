#pragma once
// Where and when the rocks of an animation are.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "report/rock_view.h"
#include "report/stored_paths.h"

namespace flyrock {

/// A rock with its stored path.
struct Actor {
  StoredPath path;
  std::vector<SurfaceCorner> corners;
  double extent = 0;  ///< m, of the farthest place from the centre of mass
};

/// The stage: times of the frames, and where places are in the picture.
class Stage {
 public:
  Stage(const std::vector<Actor>& actors, int dimension);

  Vec2 pixel(const Vec2& seen) const {
    return {scale * (seen.x() - low_.x()), height - scale * (seen.y() - low_.y())};
  }
  Vec2 pixel(const Vec3& place) const { return pixel(view(place)); }

  /// `<animate...>` with one value a frame; `discrete`: without values in between.
  template <class Value>
  std::string animate(const std::string& what, bool discrete, Value value) const {
    std::string values, first;
    bool still = true;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::string text = value(times[i]);
      if (i == 0) first = text;
      still = still && text == first;
      values += (i ? ";" : "") + text;
    }
    return fmt::format("<{} dur=\"{:g}s\" repeatCount=\"indefinite\"{} values=\"{}\"/>", what, shown,
                       discrete ? " calcMode=\"discrete\"" : "", still ? first + ";" + first : values);
  }

  /// The axis of time with a mark that moves.
  std::string axis() const;

  View view;
  std::vector<double> times;  ///< s, of the frames
  double shown = 0;           ///< s, how long the picture takes
  double scale = 1, width = 0, height = 0;

 private:
  double first_ = 0, length_ = 0;
  Vec2 low_ = Vec2::Zero();
};

/// "x,y x,y ..."
std::string points_of(const std::vector<Vec2>& pixels);

}  // namespace flyrock
