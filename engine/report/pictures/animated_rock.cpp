#include "report/pictures/animated_rock.h"

#include <map>

namespace flyrock {

namespace {

// ---- 2D: each rock is drawn once, and moves by transformations

/// A contactor about the origin, in pixels.
std::string still_contactor(const std::vector<Vec2>& outline, double radius) {
  const std::string fill = colour_of(0.7);
  if (outline.size() == 1)
    return fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\" fill=\"{3}\"/><path d=\"M{0:.1f} "
        "{1:.1f}h{2:.1f}\"/>",
        outline[0].x(), outline[0].y(), radius, fill);
  if (radius <= 0) return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>", points_of(outline), fill);
  // A line with round corners draws what the outline is grown by: first its edge, then its inside.
  std::string out;
  for (const bool edge : {true, false})
    out += fmt::format(
        "<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
        "stroke-linejoin=\"round\"/>",
        points_of(outline), fill, edge ? "#444" : fill, 2 * radius + (edge ? 1 : -1));
  return out;
}

/// A rock that would be too small to see is a dot.
std::string dot(const Actor& actor, const Stage& stage) {
  const auto along = [&](int axis) {
    return stage.animate(axis == 0 ? "cx" : "cy", Stage::Pace::smooth, [&](double t) {
      return fmt::format("{:.1f}", stage.pixel(actor.path.at(t).place)[axis]);
    });
  };
  return element("circle r=\"1.5\" fill=\"#444\" stroke=\"none\"", {along(0), along(1)}) + "\n";
}

std::string in_plane(const Actor& actor, const Stage& stage) {
  std::map<std::pair<int, int>, std::pair<std::vector<Vec2>, double>> contactors;
  for (const SurfaceCorner& corner : actor.corners) {
    auto& [outline, radius] = contactors[{corner.contactor, corner.face}];
    outline.emplace_back(stage.scale * corner.place.x(), -stage.scale * corner.place.y());
    radius = stage.scale * corner.radius;
  }
  const Animated moves = stage.animate_transform("translate", [&](double t) {
    const Vec2 at = stage.pixel(actor.path.at(t).place);
    return fmt::format("{:.2f},{:.2f}", at.x(), at.y());
  });
  const Animated turns = stage.animate_transform(
      "rotate", [&](double t) { return fmt::format("{:.2f}", 0.0 - actor.path.at(t).angle * 180 / pi); });
  std::string outlines;
  for (const auto& [key, contactor] : contactors)
    outlines += still_contactor(contactor.first, contactor.second);
  return element("g", {moves}, element("g", {turns}, outlines)) + "\n";
}

// ---- 3D: each face has its corners in each frame

std::string face_in_space(const Actor& actor, const std::vector<Vec3>& face, const Stage& stage) {
  const auto turned = [&](double t) {
    const StoredMoment now = actor.path.at(t);
    std::vector<Vec3> places;
    for (const Vec3& corner : face) places.push_back(now.place + now.turn * corner);
    return places;
  };
  const Animated outline = stage.animate("points", Stage::Pace::discrete, [&](double t) {
    const std::vector<Vec3> places = turned(t);
    // A hidden face is a point, but with as many corners: some browsers mix lists of different lengths.
    if (area_of(places).dot(stage.view.near) <= 0)
      return points_of(std::vector<Vec2>(places.size(), stage.pixel(places[0])));
    std::vector<Vec2> pixels;
    for (const Vec3& place : places) pixels.push_back(stage.pixel(place));
    return points_of(pixels);
  });
  const Animated fill = stage.animate("fill", Stage::Pace::discrete,
                                      [&](double t) { return colour_of(light_of(area_of(turned(t)))); });
  return element("polygon", {outline, fill}) + "\n";
}

/// A ball, with a dot where an axis of its body leaves it, so that its turning can be seen.
std::string ball_in_space(const Actor& actor, const SurfaceCorner& ball, const Stage& stage) {
  const auto place = [&](double t, const Vec3& from_centre) {
    const StoredMoment now = actor.path.at(t);
    return Vec3(now.place + now.turn * (ball.place + from_centre));
  };
  const auto along = [&](const Vec3& from_centre, int axis) {
    return stage.animate(axis == 0 ? "cx" : "cy", Stage::Pace::smooth, [&](double t) {
      return fmt::format("{:.2f}", stage.pixel(place(t, from_centre))[axis]);
    });
  };
  const auto size_of_mark = [&](const Vec3& from_centre) {
    return stage.animate("r", Stage::Pace::discrete, [&](double t) {
      const bool front = (place(t, from_centre) - place(t, Vec3::Zero())).dot(stage.view.near) > 0;
      return fmt::format("{:.1f}", front ? 0.12 * stage.scale * ball.radius : 0.0);
    });
  };
  const Vec3 centre = Vec3::Zero();
  std::string out =
      element(fmt::format("circle r=\"{:.1f}\" fill=\"{}\"", stage.scale * ball.radius, colour_of(0.7)),
              {along(centre, 0), along(centre, 1)}) +
      "\n";
  for (const double side : {1.0, -1.0})
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
      const Vec3 mark = side * ball.radius * axis;
      out += element("circle fill=\"#1f5fa8\" stroke=\"none\"",
                     {along(mark, 0), along(mark, 1), size_of_mark(mark)}) +
             "\n";
    }
  return out;
}

std::string in_space(const Actor& actor, const Stage& stage) {
  std::map<std::pair<int, int>, std::vector<SurfaceCorner>> faces;
  for (const SurfaceCorner& corner : actor.corners) faces[{corner.contactor, corner.face}].push_back(corner);
  std::string out = "<g>\n";
  for (const auto& [key, corners] : faces) {
    std::vector<Vec3> places;
    for (const SurfaceCorner& corner : corners) places.push_back(corner.place);
    if (corners.front().radius <= 0) {
      out += face_in_space(actor, places, stage);
    } else if (corners.size() == 1) {
      out += ball_in_space(actor, corners.front(), stage);
    } else {
      const double width = 2 * stage.scale * corners.front().radius;
      for (const bool edge : {true, false}) {
        const Animated line = stage.animate("points", Stage::Pace::smooth, [&](double t) {
          const StoredMoment now = actor.path.at(t);
          std::vector<Vec2> pixels;
          for (const Vec3& place : places) pixels.push_back(stage.pixel(Vec3(now.place + now.turn * place)));
          return points_of(pixels);
        });
        out += element(fmt::format("polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
                                   "stroke-linecap=\"round\"",
                                   edge ? "#444" : colour_of(0.7), width + (edge ? 1 : -1)),
                       {line}) +
               "\n";
      }
    }
  }
  return out + "</g>\n";
}

}  // namespace

std::string animated_rock(const Actor& actor, const Stage& stage, int dimension) {
  if (stage.scale * actor.extent < 1.5) return dot(actor, stage);
  return dimension == 2 ? in_plane(actor, stage) : in_space(actor, stage);
}

}  // namespace flyrock
