#include "report/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "math/round_step.h"
#include "report/html.h"
#include "report/rock_view.h"
#include "report/stored_contacts.h"
#include "report/stored_paths.h"

namespace flyrock {

namespace {

constexpr double most_wide = 760, most_high = 520, axis_high = 34, margin = 0.06;  // pixels; share
constexpr double frames_a_second = 25;

struct Actor {
  StoredPath path;
  std::vector<SurfaceCorner> corners;
  double extent = 0;  ///< m, of the farthest place from the centre of mass
};

std::vector<SurfaceCorner> read_corners(const SqliteReader& database, const StoredPath& path) {
  Query row(database, fmt::format("SELECT contactor, face, x_m, y_m, z_m, radius_m FROM shapes WHERE point = "
                                  "{} AND trial = {} AND rock = {} ORDER BY rowid",
                                  path.point, path.trial, path.rock));
  std::vector<SurfaceCorner> corners;
  while (row.next())
    corners.push_back({static_cast<int>(row.whole(0)), static_cast<int>(row.whole(1)),
                       Vec3(row.real(2), row.real(3), row.real(4)), row.real(5)});
  return corners;
}

std::vector<Actor> read_actors(const SqliteReader& database, std::int64_t point) {
  StoredPaths stored(database);
  std::vector<StoredPath> paths;
  do paths = stored.next_point();
  while (!paths.empty() && paths.front().point != point);
  std::vector<Actor> actors;
  for (StoredPath& path : paths) {
    actors.push_back({std::move(path), {}, 0});
    Actor& actor = actors.back();
    actor.corners = read_corners(database, actor.path);
    for (const SurfaceCorner& corner : actor.corners)
      actor.extent = std::max(actor.extent, corner.place.norm() + corner.radius);
  }
  return actors;
}

/// The stage: times of the frames, and where places are in the picture.
class Stage {
 public:
  Stage(const std::vector<Actor>& actors, int dimension) : view(view_of(dimension)) {
    double last = 0;
    first_ = actors.front().path.moments.front().time;
    Vec2 low = Vec2::Constant(1e300), high = -low;
    for (const Actor& actor : actors)
      for (const StoredMoment& moment : actor.path.moments) {
        first_ = std::min(first_, moment.time);
        last = std::max(last, moment.time);
        low = low.cwiseMin((view(moment.place).array() - actor.extent).matrix());
        high = high.cwiseMax((view(moment.place).array() + actor.extent).matrix());
      }
    length_ = std::max(last - first_, 1e-12);
    shown = std::clamp(length_, 4.0, 12.0);
    for (int i = 0, n = static_cast<int>(frames_a_second * shown); i <= n; ++i)
      times.push_back(first_ + length_ * i / n);
    const Vec2 room = (high - low) * margin + Vec2::Constant(1e-9);
    low_ = low - room;
    const Vec2 size = high - low + 2 * room;
    scale = std::min(most_wide / size.x(), most_high / size.y());
    width = std::max(240.0, scale * size.x());
    height = std::max(80.0, scale * size.y());
    low_.x() -= 0.5 * (width / scale - size.x());
  }

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
  std::string axis() const {
    const double left = 20, wide = width - 40, y = height + 12, step = round_step(length_ / 5);
    const auto x = [&](double t) { return left + wide * (t - first_) / length_; };
    std::string out = fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#777\"/>\n", left, y, wide);
    for (double t = step * std::ceil(first_ / step - 1e-9); t <= first_ + length_ * (1 + 1e-9); t += step)
      out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.6g} s</text>\n", x(t),
                         y + 16, std::abs(t) < 1e-9 * step ? 0.0 : t);
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#1f5fa8\">", left, y);
    return out +
           animate("animate attributeName=\"cx\"", false,
                   [&](double t) { return fmt::format("{:.1f}", x(t)); }) +
           "</circle>\n";
  }

  View view;
  std::vector<double> times;  ///< s, of the frames
  double shown = 0;           ///< s, how long the picture takes
  double scale = 1, width = 0, height = 0;

 private:
  double first_ = 0, length_ = 0;
  Vec2 low_ = Vec2::Zero();
};

std::string points_of(const std::vector<Vec2>& pixels) {
  std::string text;
  for (const Vec2& p : pixels) text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", p.x(), p.y());
  return text;
}

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
  std::string out;
  for (const bool edge : {true, false})
    out += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\" "
        "stroke-linecap=\"round\"/>",
        points_of(outline), edge ? "#444" : fill, 2 * radius + (edge ? 1 : -1));
  return out;
}

/// A rock that would be too small to see is a dot.
std::string dot(const Actor& actor, const Stage& stage) {
  std::string out = "<circle r=\"1.5\" fill=\"#444\" stroke=\"none\">";
  for (const int axis : {0, 1})
    out += stage.animate(
        axis == 0 ? "animate attributeName=\"cx\"" : "animate attributeName=\"cy\"", false,
        [&](double t) { return fmt::format("{:.1f}", stage.pixel(actor.path.at(t).place)[axis]); });
  return out + "</circle>\n";
}

std::string in_plane(const Actor& actor, const Stage& stage) {
  std::map<std::pair<int, int>, std::pair<std::vector<Vec2>, double>> contactors;
  for (const SurfaceCorner& corner : actor.corners) {
    auto& [outline, radius] = contactors[{corner.contactor, corner.face}];
    outline.emplace_back(stage.scale * corner.place.x(), -stage.scale * corner.place.y());
    radius = stage.scale * corner.radius;
  }
  std::string out = "<g>";
  out +=
      stage.animate("animateTransform attributeName=\"transform\" type=\"translate\"", false, [&](double t) {
        const Vec2 at = stage.pixel(actor.path.at(t).place);
        return fmt::format("{:.2f},{:.2f}", at.x(), at.y());
      });
  out += "<g>" +
         stage.animate("animateTransform attributeName=\"transform\" type=\"rotate\"", false,
                       [&](double t) { return fmt::format("{:.2f}", -actor.path.at(t).angle * 180 / pi); });
  for (const auto& [key, contactor] : contactors) out += still_contactor(contactor.first, contactor.second);
  return out + "</g></g>\n";
}

// ---- 3D: each face has its corners in each frame

std::string face_in_space(const Actor& actor, const std::vector<Vec3>& face, const Stage& stage) {
  const auto turned = [&](double t) {
    const StoredMoment now = actor.path.at(t);
    std::vector<Vec3> places;
    for (const Vec3& corner : face) places.push_back(now.place + now.turn * corner);
    return places;
  };
  std::string out = "<polygon>";
  out += stage.animate("animate attributeName=\"points\"", true, [&](double t) {
    const std::vector<Vec3> places = turned(t);
    if (area_of(places).dot(stage.view.near) <= 0) return points_of({stage.pixel(places[0])});
    std::vector<Vec2> pixels;
    for (const Vec3& place : places) pixels.push_back(stage.pixel(place));
    return points_of(pixels);
  });
  out += stage.animate("animate attributeName=\"fill\"", true,
                       [&](double t) { return colour_of(light_of(area_of(turned(t)))); });
  return out + "</polygon>\n";
}

/// A ball, with a dot where an axis of its body leaves it, so that its turning can be seen.
std::string ball_in_space(const Actor& actor, const SurfaceCorner& ball, const Stage& stage) {
  const auto place = [&](double t, const Vec3& from_centre) {
    const StoredMoment now = actor.path.at(t);
    return Vec3(now.place + now.turn * (ball.place + from_centre));
  };
  const auto circle = [&](const Vec3& from_centre, bool mark) {
    std::string out =
        mark ? "<circle fill=\"#1f5fa8\" stroke=\"none\">"
             : fmt::format("<circle r=\"{:.1f}\" fill=\"{}\">", stage.scale * ball.radius, colour_of(0.7));
    for (const int axis : {0, 1})
      out += stage.animate(
          fmt::format("animate attributeName=\"c{}\"", axis == 0 ? 'x' : 'y'), false,
          [&](double t) { return fmt::format("{:.2f}", stage.pixel(place(t, from_centre))[axis]); });
    if (mark)
      out += stage.animate("animate attributeName=\"r\"", true, [&](double t) {
        const bool front = (place(t, from_centre) - place(t, Vec3::Zero())).dot(stage.view.near) > 0;
        return fmt::format("{:.1f}", front ? 0.12 * stage.scale * ball.radius : 0.0);
      });
    return out + "</circle>\n";
  };
  std::string out = circle(Vec3::Zero(), false);
  for (const double side : {1.0, -1.0})
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
      out += circle(side * ball.radius * axis, true);
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
        out += fmt::format(
            "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.1f}\" stroke-linecap=\"round\">",
            edge ? "#444" : colour_of(0.7), width + (edge ? 1 : -1));
        out += stage.animate("animate attributeName=\"points\"", false, [&](double t) {
          const StoredMoment now = actor.path.at(t);
          std::vector<Vec2> pixels;
          for (const Vec3& place : places) pixels.push_back(stage.pixel(Vec3(now.place + now.turn * place)));
          return points_of(pixels);
        });
        out += "</polyline>\n";
      }
    }
  }
  return out + "</g>\n";
}

// ---- ground and forces

std::string ground_in_plane(const SqliteReader& database, std::int64_t point, const Stage& stage) {
  Query row(database, fmt::format("SELECT x_m, y_m FROM ground WHERE point = {} ORDER BY rowid", point));
  std::vector<Vec2> line;
  while (row.next()) line.push_back(stage.pixel(Vec2(row.real(0), row.real(1))));
  if (line.empty()) return "";
  std::vector<Vec2> filled = line;
  filled.emplace_back(line.back().x(), stage.height + 1e4);
  filled.emplace_back(line.front().x(), stage.height + 1e4);
  return fmt::format(
      "<polygon points=\"{}\" fill=\"#e4e0d8\" stroke=\"none\"/>\n<polyline points=\"{}\" fill=\"none\"/>\n",
      points_of(filled), points_of(line));
}

std::string ground_in_space(const SqliteReader& database, std::int64_t point, const Stage& stage) {
  Query vertex(database,
               fmt::format("SELECT x_m, y_m, z_m FROM ground_vertices JOIN points USING (ground) WHERE point "
                           "= {} ORDER BY vertex",
                           point));
  std::vector<Vec3> vertices;
  while (vertex.next()) vertices.emplace_back(vertex.real(0), vertex.real(1), vertex.real(2));
  Query triangle(database,
                 fmt::format("SELECT a, b, c FROM ground_triangles JOIN points USING (ground) WHERE "
                             "point = {} ORDER BY ground_triangles.rowid",
                             point));
  std::vector<std::pair<double, std::string>> drawn;
  while (triangle.next()) {
    std::vector<Vec3> places;
    std::vector<Vec2> pixels;
    for (const int k : {0, 1, 2}) {
      places.push_back(vertices[static_cast<std::size_t>(triangle.whole(k))]);
      pixels.push_back(stage.pixel(places.back()));
    }
    const double depth = stage.view.near.dot(places[0] + places[1] + places[2]);
    const int grey = 200 + static_cast<int>(50 * light_of(area_of(places)));
    drawn.emplace_back(depth, fmt::format("<polygon points=\"{0}\" fill=\"rgb({1},{1},{2})\"/>\n",
                                          points_of(pixels), grey, grey - 8));
  }
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string out = "<g stroke=\"#ccc\" stroke-width=\"0.5\">\n";
  for (const auto& [depth, text] : drawn) out += text;
  return out + "</g>\n";
}

/// An arrow from `tail` to `tip` as one line, in pixels.
std::string arrow(const Vec2& tail, const Vec2& tip) {
  const Vec2 along = tip - tail, across(-along.y(), along.x());
  const double head = std::min(0.25, 8 / std::max(along.norm(), 1e-9));
  const Vec2 back = tip - head * along;
  return points_of({tail, tip, Vec2(back + 0.5 * head * across), tip, Vec2(back - 0.5 * head * across)});
}

std::string forces(const SqliteReader& database, const Actor& actor, const Stage& stage) {
  const std::vector<StoredContact> contacts = stored_contacts(database, actor.path.point, actor.path.trial);
  double greatest = 0;
  for (const StoredContact& contact : contacts)
    for (const StoredForce& force : contact.forces) greatest = std::max(greatest, force.force.norm());
  if (greatest == 0) return "";
  constexpr double longest = 70;  // pixels
  std::string out = "<g fill=\"none\" stroke=\"#c4531b\" stroke-width=\"2\">\n";
  for (const StoredContact& contact : contacts) {
    out += "<polyline>" + stage.animate("animate attributeName=\"points\"", true, [&](double t) {
      const StoredForce* force = contact.at(t);
      if (!force) return std::string("-9,-9");
      const Vec2 foot = stage.pixel(force->place);
      const Vec2 seen = stage.view(force->force) * (longest / greatest);
      return arrow(foot, foot + Vec2(seen.x(), -seen.y()));
    }) + "</polyline>\n";
  }
  return out + "</g>\n";
}

}  // namespace

std::string animation_of(const SqliteReader& database, std::int64_t point, const std::string& title) {
  std::vector<Actor> actors = read_actors(database, point);
  if (actors.empty()) return "";
  Query ground(database, fmt::format("SELECT ground FROM points WHERE point = {}", point));
  const int dimension = ground.next() && ground.type(0) != SQLITE_NULL ? 3 : 2;
  const Stage stage(actors, dimension);
  std::stable_sort(actors.begin(), actors.end(), [&](const Actor& a, const Actor& b) {
    return stage.view.near.dot(a.path.moments.front().place) <
           stage.view.near.dot(b.path.moments.front().place);
  });
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n<title>{2}</title>\n<rect width=\"100%\" "
      "height=\"100%\" fill=\"#fff\"/>\n<svg width=\"{0:.0f}\" height=\"{3:.0f}\"><g stroke=\"#444\">\n",
      stage.width, stage.height + axis_high, escaped(title), stage.height);
  out += dimension == 2 ? ground_in_plane(database, point, stage) : ground_in_space(database, point, stage);
  for (const Actor& actor : actors)
    out += stage.scale * actor.extent < 1.5 ? dot(actor, stage)
           : dimension == 2                 ? in_plane(actor, stage)
                                            : in_space(actor, stage);
  out += forces(database, actors.front(), stage);
  return out + "</g></svg>\n" + stage.axis() + "</svg>\n";
}

}  // namespace flyrock
