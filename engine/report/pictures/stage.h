#pragma once
// Where and when the rocks of an animation are.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "document/value.h"
#include "geometry/box.h"
#include "report/pictures/rock_view.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

/// A rock with its stored path.
struct Actor {
  StoredPath path;
  std::vector<SurfaceCorner> corners;
  double extent = 0;  ///< m, of the farthest place from the centre of mass
};

/// What of a scene is seen, in m: in 2D x and y, in 3D the plan, from the lowest to the highest place of a
/// rock there.
using Region = Box2;

/// An attribute that changes: `first`, its value in programs that do not animate pictures, and the element
/// with its values frame by frame.
struct Animated {
  std::string attribute, first, frames;
};

/// `<tag ...>` with attributes that change, and its content.
std::string element(const std::string& tag, const std::vector<Animated>& changes,
                    const std::string& content = "");

/// The stage: times of the frames, and where places are in the picture.
class Stage {
 public:
  /// Shows all that the actors pass and the other `places`, or a region that they pass.
  Stage(const std::vector<Actor>& actors, const std::vector<Vec3>& places, int dimension,
        const std::optional<Region>& region);

  Vec2 pixel(const Vec2& seen) const {
    return {scale * (seen.x() - low_.x()), height - scale * (seen.y() - low_.y())};
  }
  Vec2 pixel(const Vec3& place) const { return pixel(view(place)); }

  /// How a value of an attribute changes from frame to frame.
  enum class Pace { smooth, discrete };

  /// An attribute of an element, with one value a frame.
  template <class Value>
  Animated animate(const std::string& attribute, Pace pace, Value value) const {
    return animated("animate", attribute, pace, value);
  }
  /// The attribute `transform` of an element: `type` is "translate" or "rotate".
  template <class Value>
  Animated animate_transform(const std::string& type, Value value) const {
    Animated change =
        animated(fmt::format("animateTransform type=\"{}\"", type), "transform", Pace::smooth, value);
    change.first = fmt::format("{}({})", type, change.first);
    return change;
  }

  /// The axis of time with a mark that moves, below the stage.
  std::string axis() const;
  /// A line of round length with that length, 42 pixels below the stage; `end`: where it ends in the picture.
  std::string ruler(double& end) const;
  /// Heights at the left edge, of a scene in 2D.
  std::string heights() const;

  PictureView view;
  std::vector<double> times;    ///< s, of the frames
  double shown = 0;             ///< s, how long the picture takes
  std::optional<double> still;  ///< s, of the only frame, for a picture that does not move
  /// The times of the frames that are shown [s].
  std::vector<double> moments() const { return still ? std::vector{*still} : times; }
  double scale = 1, width = 0, height = 0;

 private:
  void frame(const Box2& box);
  template <class Value>
  Animated animated(const std::string& tag, const std::string& attribute, Pace pace, Value value) const {
    if (still) return {attribute, value(*still), ""};
    std::string values, first;
    bool same = true;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::string text = value(times[i]);
      if (i == 0) first = text;
      same = same && text == first;
      values += (i ? ";" : "") + text;
    }
    return {attribute, first,
            fmt::format("<{} attributeName=\"{}\" dur=\"{:g}s\" repeatCount=\"indefinite\"{} values=\"{}\"/>",
                        tag, attribute, shown, pace == Pace::discrete ? " calcMode=\"discrete\"" : "",
                        same ? first + ";" + first : values)};
  }

  double first_ = 0, length_ = 0;
  Vec2 low_ = Vec2::Zero();
};

/// "x,y x,y ..."
std::string points_of(const std::vector<Vec2>& pixels);

}  // namespace flyrock
