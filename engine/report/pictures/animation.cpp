#include "report/pictures/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/page/html.h"
#include "report/pictures/animated_rock.h"
#include "report/tables/stored_contacts.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

constexpr double legend_high = 52;    // pixels: axis of time, then the ruler
constexpr double longest_arrow = 70;  // pixels
constexpr double widest_line = 8;     // pixels, of the force network
constexpr const char* force_colour = "#c4531b";

std::vector<Actor> actors_of(const SqliteReader& database, const std::vector<StoredPath>& paths,
                             const std::vector<StoredFixture>& fixtures) {
  std::vector<Actor> actors;
  for (const StoredPath& path : paths) actors.push_back({path, stored_corners(database, path), 0});
  for (const StoredFixture& fixture : fixtures) actors.push_back({fixture.path, fixture.corners, 0});
  for (Actor& actor : actors)
    for (const SurfaceCorner& corner : actor.corners)
      actor.extent = std::max(actor.extent, corner.place.norm() + corner.radius);
  return actors;
}

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
    const int grey = 178 + static_cast<int>(50 * light_of(area_of(places)));
    drawn.emplace_back(depth, fmt::format("<polygon points=\"{0}\" fill=\"rgb({1},{1},{2})\"/>\n",
                                          points_of(pixels), grey, grey - 8));
  }
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string out = "<g stroke=\"#ccc\" stroke-width=\"0.5\">\n";
  for (const auto& [depth, text] : drawn) out += text;
  return out + "</g>\n";
}

constexpr std::size_t few = 12;  // bodies that have a name and a line of their way

/// The ways of the centres.
std::string ways(const std::vector<Actor>& actors, const Stage& stage) {
  if (actors.size() > few) return "";
  std::string out = "<g fill=\"none\" stroke=\"#1f5fa8\" stroke-opacity=\"0.35\">\n";
  for (const Actor& actor : actors) {
    std::vector<Vec2> way;
    for (const double t : stage.times) {
      const Vec2 pixel = stage.pixel(actor.path.at(t).place);
      if (way.empty() || (pixel - way.back()).norm() > 1) way.push_back(pixel);
    }
    if (way.size() > 1) out += fmt::format("<polyline points=\"{}\"/>\n", points_of(way));
  }
  return out + "</g>\n";
}

/// The names of few bodies, beside their centres; those of rocks of one group would all be the same.
std::string names(const std::vector<Actor>& actors, const Stage& stage) {
  constexpr double aside = 0.75, most = 14;  // of the extent; pixels
  std::set<std::string> different;
  for (const Actor& actor : actors) different.insert(actor.path.group);
  if (actors.size() > few || actors.size() < 2 || different.size() < actors.size()) return "";
  std::string out =
      "<g font-size=\"10\" fill=\"#222\" stroke=\"#fff\" stroke-width=\"2\" paint-order=\"stroke\">\n";
  for (const Actor& actor : actors) {
    const auto along = [&](int axis) {
      return stage.animate(axis == 0 ? "x" : "y", Stage::Pace::smooth, [&](double t) {
        const double distance = std::min(most, aside * stage.scale * actor.extent);
        const Vec2 corner = stage.pixel(actor.path.at(t).place) + distance * Vec2(1, -1);
        return fmt::format("{:.1f}", corner[axis] + (axis == 0 ? 2 : -2));
      });
    };
    out += element("text", {along(0), along(1)}, escaped(actor.path.group)) + "\n";
  }
  return out + "</g>\n";
}

/// The ends that links have on what does not move.
std::vector<Vec3> fixed_ends(const std::vector<StoredLink>& links) {
  std::vector<Vec3> places;
  for (const StoredLink& link : links)
    for (const StoredLink::End& end : {link.a, link.b})
      if (!end.path) places.push_back(end.place);
  return places;
}

/// Links are lines between their ends, a hinge is a dot. A rope is thin, a spring dashed.
std::string drawn_links(const std::vector<StoredLink>& links, const Stage& stage) {
  std::string out;
  for (const StoredLink& link : links) {
    const auto along = [&](const char* attribute, const StoredLink::End& end, int axis) {
      return stage.animate(attribute, Stage::Pace::smooth,
                           [&](double t) { return fmt::format("{:.1f}", stage.pixel(end.at(t))[axis]); });
    };
    if (link.type == "hinge")
      out += element("circle r=\"3\" fill=\"#fff\"", {along("cx", link.a, 0), along("cy", link.a, 1)});
    else
      out += element(
          fmt::format("line stroke-width=\"{}\"{}", link.type == "rod" ? 2.5 : 1.2,
                      link.type == "spring" ? " stroke-dasharray=\"5 3\"" : ""),
          {along("x1", link.a, 0), along("y1", link.a, 1), along("x2", link.b, 0), along("y2", link.b, 1)});
    out += "\n";
  }
  return out;
}

/// An arrow from `from` to `tip` as one line, in pixels.
std::string arrow(const Vec2& from, const Vec2& tip) {
  const Vec2 along = tip - from, across(-along.y(), along.x());
  const double head = std::min(0.25, 8 / std::max(along.norm(), 1e-9));
  const Vec2 back = tip - head * along;
  return points_of({from, tip, Vec2(back + 0.5 * head * across), tip, Vec2(back - 0.5 * head * across)});
}

/// What an arrow or a line of the greatest size is [N]; 0 without forces. Arrows have one scale for the run,
/// the network has one for the moments that are shown, because blows would hide the weight of a pile.
double greatest_force(const std::vector<StoredContact>& contacts, ForceStyle style, const Stage& stage) {
  double greatest = 0;
  for (const StoredContact& contact : contacts) {
    if (style == ForceStyle::arrows) {
      for (const StoredForce& force : contact.forces) greatest = std::max(greatest, force.force.norm());
      continue;
    }
    for (const double t : stage.moments())
      if (const StoredForce* force = contact.at(t)) greatest = std::max(greatest, force->along_normal());
  }
  return greatest;
}

std::string arrows(const std::vector<StoredContact>& contacts, double greatest, const Stage& stage) {
  std::string out = fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-width=\"2\">\n", force_colour);
  for (const StoredContact& contact : contacts)
    out += element("polyline", {stage.animate("points", Stage::Pace::discrete,
                                              [&](double t) {
                                                const StoredForce* force = contact.at(t);
                                                if (!force) return arrow(Vec2(-9, -9), Vec2(-9, -9));
                                                const Vec2 foot = stage.pixel(force->place);
                                                const Vec2 seen =
                                                    stage.view(force->force) * (longest_arrow / greatest);
                                                return arrow(foot, foot + Vec2(seen.x(), -seen.y()));
                                              })}) +
           "\n";
  return out + "</g>\n";
}

/// A line as a part of the path of an SVG picture.
std::string path_along(const std::vector<Vec3>& line, const Stage& stage) {
  std::string path;
  for (const Vec3& place : line) {
    const Vec2 pixel = stage.pixel(place);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', pixel.x(), pixel.y());
  }
  return path;
}

/// The force network. Lines of about one width are one path.
std::string network(const std::vector<StoredContact>& contacts, double greatest, const Stage& stage) {
  constexpr int widths = 8;
  std::string out = fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-linecap=\"round\">\n", force_colour);
  for (int width = 1; width <= widths; ++width)
    out += element(fmt::format("path stroke-width=\"{:g}\"", width * widest_line / widths),
                   {stage.animate("d", Stage::Pace::discrete,
                                  [&](double t) {
                                    std::string lines = "M-9 -9";  // some browsers refuse an empty path
                                    for (const StoredContact& contact : contacts) {
                                      const StoredForce* force = contact.at(t);
                                      if (!force) continue;
                                      const double share = force->along_normal() / greatest;
                                      if (std::lround(widths * share) == width)
                                        lines += path_along(contact.line(*force, t), stage);
                                    }
                                    return lines;
                                  })}) +
           "\n";
  return out + "</g>\n";
}

/// What a length in the picture is, and the greatest force.
std::string legend(const Stage& stage, ForceStyle style, double greatest) {
  double end = 0;
  std::string out = stage.ruler(end);
  if (greatest > 0)
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{} {:.3g} {}</text>\n", end + 12,
                       stage.height + 42, force_colour,
                       style == ForceStyle::arrows ? "longest arrow" : "widest line",
                       greatest < 1e3 ? greatest : greatest / 1e3, greatest < 1e3 ? "N" : "kN");
  return out;
}

/// What there is to draw, and where.
struct Scene {
  Scene(const SqliteReader& database, const std::vector<StoredPath>& paths,
        const std::optional<Region>& region, ForceStyle wanted)
      : fixtures(stored_fixtures(database, paths)),
        links(stored_links(database, paths, fixtures)),
        actors(actors_of(database, paths, fixtures)),
        point(paths.front().point),
        dimension(stored_ground(database, point) ? 3 : 2),
        stage(actors, fixed_ends(links), dimension, region),
        ground(dimension == 2 ? ground_in_plane(database, point, stage)
                              : ground_in_space(database, point, stage)),
        contacts(stored_contacts(database, point, paths.front().trial, paths)),
        style(wanted) {
    std::stable_sort(actors.begin(), actors.end(), [&](const Actor& a, const Actor& b) {
      return stage.view.near.dot(a.path.moments.front().place) <
             stage.view.near.dot(b.path.moments.front().place);
    });
  }

  std::vector<StoredFixture> fixtures;
  std::vector<StoredLink> links;  ///< of the paths that the scene was made of
  std::vector<Actor> actors;
  std::int64_t point;
  int dimension;
  Stage stage;
  std::string ground;
  std::vector<StoredContact> contacts;  ///< of the same paths
  ForceStyle style;
};

std::string drawn(const Scene& scene, const std::string& title) {
  const Stage& stage = scene.stage;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n<title>{2}</title>\n<rect width=\"100%\" "
      "height=\"100%\" fill=\"#fff\"/>\n<svg width=\"{0:.0f}\" height=\"{3:.0f}\"><g stroke=\"#444\">\n",
      stage.width, stage.height + legend_high, escaped(title), stage.height);
  out += scene.ground;
  out += ways(scene.actors, stage);
  for (const Actor& actor : scene.actors) out += animated_rock(actor, stage, scene.dimension);
  out += drawn_links(scene.links, stage);
  const double greatest = greatest_force(scene.contacts, scene.style, stage);
  out += names(scene.actors, stage);
  if (greatest > 0)
    out += (scene.style == ForceStyle::arrows ? arrows : network)(scene.contacts, greatest, stage);
  if (scene.dimension == 2) out += stage.heights();
  return out + "</g></svg>\n" + stage.axis() + legend(stage, scene.style, greatest) + "</svg>\n";
}

}  // namespace

std::string animation_of(const SqliteReader& database, const std::vector<StoredPath>& paths,
                         const std::string& title, const std::optional<Region>& region, ForceStyle style) {
  return paths.empty() ? "" : drawn(Scene(database, paths, region, style), title);
}

Frames frames_of(const SqliteReader& database, const std::vector<StoredPath>& paths, const std::string& title,
                 std::optional<double> time, const std::optional<Region>& region, ForceStyle style) {
  if (paths.empty()) return {};
  Scene scene(database, paths, region, style);
  const std::vector<double> all = scene.stage.times;
  Frames frames;
  frames.rate = static_cast<double>(all.size() - 1) / scene.stage.shown;
  for (const double moment : time ? std::vector{std::clamp(*time, all.front(), all.back())} : all) {
    scene.stage.still = moment;
    frames.pictures.push_back(drawn(scene, title));
  }
  return frames;
}

}  // namespace flyrock
