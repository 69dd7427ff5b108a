// Places rocks in 3D. Scenarios give places in the coordinates of their files; the engine counts them from
// the origin of the terrain.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/ground.h"
#include "geometry/place_text.h"
#include "geometry/plan_zone.h"
#include "trial/blast_at.h"
#include "trial/extent.h"
#include "trial/make_ground.h"
#include "trial/place_rock.h"
#include "trial/random_place.h"
#include "trial/touch_ground.h"

namespace flyrock {

namespace {

/// How often a place in the box of a zone is drawn until it lies in the zone.
constexpr int most_draws = 1'000'000;

Vec3 horizontal_unit(const Vec3& direction) {
  const double length = direction.head<2>().norm();
  return length > 0 ? Vec3(direction.x() / length, direction.y() / length, 0) : Vec3(Vec3::UnitX());
}

/// A place on a crest, at the distance `at` from its begin: the points of crest and toe there, and the
/// direction of the crest.
struct OnCrest {
  Vec3 crest, toe, along;

  /// Out of the face: to the right of the crest and up.
  Vec3 out() const {
    const Vec3 normal = along.cross(crest - toe).normalized();
    return normal.z() < -1e-9 ? Vec3(-normal) : normal;
  }
};

double crest_length(const Mesh::Face& face) {
  double length = 0;
  for (std::size_t i = 1; i < face.crest.size(); ++i) length += (face.crest[i] - face.crest[i - 1]).norm();
  return length;
}

OnCrest on_crest(const Mesh::Face& face, double at) {
  std::size_t i = 1;
  for (; i + 1 < face.crest.size(); ++i) {
    const double piece = (face.crest[i] - face.crest[i - 1]).norm();
    if (at <= piece) break;
    at -= piece;
  }
  const Vec3 step = face.crest[i] - face.crest[i - 1];
  const double share = at / step.norm();
  return {face.crest[i - 1] + share * step, face.toe[i - 1] + share * (face.toe[i] - face.toe[i - 1]),
          step.normalized()};
}

class Placing {
 public:
  Placing(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
          const Body<3>& rock, const Terrain3& terrain)
      : release_(release), scenario_(scenario), key_(key), rng_(rng), rock_(rock), terrain_(terrain) {}

  Place<3> place() {
    switch (release_.kind) {
      case ReleaseKind::face:
        return zone_of_face() ? on_zone_face(*zone_of_face()) : on_face();
      case ReleaseKind::collar:
        if (const Hole* hole = measured_hole(scenario_, key_)) return at_measured(*hole);
        [[fallthrough]];
      case ReleaseKind::bench_top:
        return on_top();
      case ReleaseKind::position:
        return at(
            Vec3(number(release_.position[0]), number(release_.position[1]), number(release_.position[2])) -
            origin());
      case ReleaseKind::above_ground:
        return above(Vec2(number(release_.x), number(release_.y)) - origin().head<2>());
      case ReleaseKind::along: {
        const Vec3 drawn = random_along(points_of_release(), rng_);
        return release_.in_plan ? above(drawn.head<2>()) : at(drawn);
      }
      case ReleaseKind::inside:
        if (!release_.in_plan) return at(random_inside(points_of_release(), rng_));
        return above(random_in_polygon());
      case ReleaseKind::zone:
        return above(random_in(zone_named(release_.zone)));
      case ReleaseKind::raster:
        return above(random_in_cells());
    }
    return {};
  }

 private:
  double number(const Number& n) const { return n.value(scenario_.draws, scenario_.streams, key_); }
  const Vec3& origin() const { return scenario_.terrain.origin; }

  static Place<3> at(const Vec3& position) {
    Place<3> place;
    place.position = position;
    return place;
  }

  // Places are drawn in the coordinates of the engine, so that a scenario far from 0 draws the same ones.

  std::vector<Vec3> points_of_release() const {
    std::vector<Vec3> points = release_.points;
    const Vec3 from(origin().x(), origin().y(), release_.in_plan ? 0 : origin().z());
    for (Vec3& point : points) point -= from;
    return points;
  }

  /// Above a place in plan, or on the ground there.
  Place<3> above(const Vec2& p) const {
    if (release_.on_ground) return at(lowered(p));
    return at({p.x(), p.y(), ground_height(p) + number(release_.above_ground)});
  }

  double ground_height(const Vec2& p) const {
    if (const auto height = terrain_.ground().height(p.x(), p.y())) return *height;
    throw StartError(fmt::format("there is no ground at {} m", place_text(in_scenario(p))));
  }

  Vec3 lowered(const Vec2& p) const {
    ground_height(p);  // throws where there is none
    if (const auto position = lowered_to_ground(rock_, terrain_, p.x(), p.y())) return *position;
    // The centre of mass is above ground, but the rock may reach over its end only.
    throw StartError(fmt::format("the rock does not touch the ground at {} m", place_text(in_scenario(p))));
  }

  Vec2 in_scenario(const Vec2& p) const { return p + origin().head<2>(); }

  // Places in plan.

  Vec2 random_in_polygon() {
    std::vector<Vec2> polygon;
    for (const Vec3& corner : points_of_release()) polygon.emplace_back(corner.x(), corner.y());
    return random_in_polygon(polygon, "release");
  }

  Vec2 random_in_polygon(const std::vector<Vec2>& polygon, const std::string& name) {
    const Box2 box = Box2::around(polygon);
    return random_where(box.low, box.high, name, [&](const Vec2& p) { return is_inside(polygon, p); });
  }

  const Zone& zone_named(const std::string& name) const {
    const auto& zones = scenario_.terrain.zones;
    return *std::find_if(zones.begin(), zones.end(), [&](const Zone& zone) { return zone.name == name; });
  }

  /// Uniform in plan.
  Vec2 random_in(const Zone& zone) {
    const Vec2 from = origin().head<2>();
    if (!zone.polygon.empty()) {
      std::vector<Vec2> polygon = zone.polygon;
      for (Vec2& corner : polygon) corner -= from;
      return random_in_polygon(polygon, zone.name);
    }
    if (zone.raster) {
      const HeightGrid& grid = *zone.raster;
      const Vec2 low = grid.corner - from - Vec2::Constant(grid.cell / 2);
      const Vec2 high = low + grid.cell * Vec2(grid.columns, grid.rows);
      return random_where(low, high, zone.name, [&](const Vec2& p) { return covers(zone, p + from); });
    }
    const Box3& extent = terrain_.ground().extent();
    return random_where(extent.low.head<2>(), extent.high.head<2>(), zone.name,
                        [&](const Vec2& p) { return is_of_part(zone.name, p); });
  }

  /// Places in a box until one lies in the zone.
  template <class Lies>
  Vec2 random_where(const Vec2& low, const Vec2& high, const std::string& name, Lies&& lies) {
    if (!low.allFinite() || !high.allFinite())
      throw StartError(fmt::format("the zone `{}` has no end in plan, so no place in it can be drawn", name));
    for (int i = 0; i < most_draws; ++i) {
      const double x = rng_.uniform(low.x(), high.x()), y = rng_.uniform(low.y(), high.y());
      if (lies(Vec2(x, y))) return {x, y};
    }
    throw StartError(fmt::format("of a million places drawn, none lies in the zone `{}`", name));
  }

  /// Whether the ground at a place is of a part.
  bool is_of_part(const std::string& part, const Vec2& p) const {
    const auto top = terrain_.ground().top(p.x(), p.y());
    return top && terrain_.parts()[terrain_.ground().part(top->facet)] == part;
  }

  /// Uniform over the cells above 0.
  Vec2 random_in_cells() {
    const HeightGrid& grid = *release_.raster;
    const std::vector<std::size_t>& cells = *release_.raster_cells;
    if (cells.empty()) throw StartError("the raster of the release has no cell above 0");
    const std::size_t cell =
        cells[static_cast<std::size_t>(rng_.integer(0, static_cast<std::int64_t>(cells.size()) - 1))];
    const double column = static_cast<double>(cell % grid.columns) + rng_.uniform(-0.5, 0.5);
    const double row = static_cast<double>(cell / grid.columns) + rng_.uniform(-0.5, 0.5);
    return grid.corner - origin().head<2>() + grid.cell * Vec2(column, row);
  }

  // Faces.

  std::string face_text() const {
    return release_.face.empty() ? fmt::format("bench {}", release_.bench)
                                 : fmt::format("`{}`", release_.face);
  }

  /// The zone of a face that the scenario names; nullptr for a face of the terrain's plugin.
  const Zone* zone_of_face() const {
    const auto own = static_cast<int>(terrain_.faces().size());
    const auto& plans = scenario_.terrain.faces;
    const int index = release_.bench - 1 - own;
    if (index < 0 || index >= static_cast<int>(plans.size())) return nullptr;
    return &zone_named(plans[static_cast<std::size_t>(index)].zone);
  }

  const Mesh::Face& face() const {
    const auto& faces = terrain_.faces();
    if (zone_of_face())
      throw StartError(fmt::format("the face {} is a zone, which has no crest", face_text()));
    if (release_.bench < 1 || release_.bench > static_cast<int>(faces.size()))
      throw StartError(fmt::format("bench {} does not exist, the terrain has {} bench faces", release_.bench,
                                   faces.size()));
    return faces[static_cast<std::size_t>(release_.bench) - 1];
  }

  /// A distance along the crest, uniform as far as the rock fits between its ends.
  double along_crest(const Mesh::Face& face) {
    const double length = crest_length(face);
    const double begin = -extent_along(rock_, on_crest(face, 0).along).low;
    const double end = length - extent_along(rock_, on_crest(face, length).along).high;
    if (end < begin)
      throw StartError(fmt::format("a rock {:.3g} m wide does not fit on the face of {}, {:.3g} m wide",
                                   begin + length - end, face_text(), length));
    return begin + rng_.uniform() * (end - begin);
  }

  Place<3> on_face() {
    const double height = rng_.uniform();
    const Hole* hole = measured_hole(scenario_, key_);
    const OnCrest there = on_crest(face(), hole ? in_front_of(*hole, face()) : along_crest(face()));
    const Vec3 up = (there.crest - there.toe).normalized(), out = there.out();
    const Extent extent = extent_along(rock_, up);
    const double length = (there.crest - there.toe).norm(), room = length - (extent.high - extent.low);
    if (room < 0)
      throw StartError(fmt::format("a rock {:.3g} m long does not fit on the face of {}, {:.3g} m long",
                                   extent.high - extent.low, face_text(), length));
    const Vec3 nominal = there.toe + (height * room - extent.low) * up - extent_along(rock_, out).low * out;
    return touching(nominal, out, up);
  }

  /// Moves a rock that touches the plane of a face until it touches the face itself, which may be rough.
  Place<3> touching(const Vec3& nominal, const Vec3& out, const Vec3& up) const {
    const double away = 2 * rock_.size;
    const Vec3 start = nominal + away * out;
    Place<3> place = at(nominal);
    if (const auto distance = distance_to_ground<3>(rock_, terrain_, start, -out, 3 * away))
      place.position = start - *distance * out;
    place.outward = horizontal_unit(out);
    place.face_angle = std::atan2(up.z(), up.head<2>().norm());
    return place;
  }

  /// On a face that is a zone: at a random place in plan, against the ground there.
  Place<3> on_zone_face(const Zone& zone) {
    const Vec2 p = random_in(zone);
    const double height = ground_height(p);
    const Vec3 out = terrain_.ground().facet(terrain_.ground().top(p.x(), p.y())->facet).normal;
    const Vec3 side = out.cross(Vec3::UnitZ());
    const Vec3 up = side.norm() > 0 ? Vec3(side.cross(out).normalized()) : Vec3(Vec3::UnitX());
    return touching(Vec3(p.x(), p.y(), height) - extent_along(rock_, out).low * out, out, up);
  }

  /// At rest on the bench above a face: at the collar of the rock's hole, or anywhere as far as the last row.
  Place<3> on_top() {
    const Mesh::Face& here = face();
    const Blast blast = blast_at(scenario_, key_);
    const double share = release_.kind == ReleaseKind::collar ? 1 : rng_.uniform();
    const double back = share * depth_of_holes(release_, scenario_, key_, blast);
    const double at_crest = release_.kind == ReleaseKind::collar ? at_hole(here, blast) : along_crest(here);
    const OnCrest there = on_crest(here, at_crest);
    const Vec3 outward = horizontal_unit(there.out());
    const Vec3 p = there.crest - back * outward;
    Place<3> place = at(lowered(p.head<2>()));
    place.outward = outward;
    return place;
  }

  /// At the collar of a measured hole, which throws out of the face of the release if there is one.
  Place<3> at_measured(const Hole& hole) const {
    const Vec2 p = Vec2(hole.x, hole.y) - origin().head<2>();
    Place<3> place = at(lowered(p));
    raise_to_collar(hole, ground_height(p), origin().z(), place.position.z());
    const auto& faces = terrain_.faces();
    if (release_.bench >= 1 && release_.bench <= static_cast<int>(faces.size()) && !zone_of_face())
      place.outward = horizontal_unit(on_crest(face(), nearest_on_crest(face(), p)).out());
    return place;
  }

  /// The distance along a crest of its place nearest to p in plan.
  static double nearest_on_crest(const Mesh::Face& face, const Vec2& p) {
    double before = 0, nearest = 0, least = infinite;
    for (std::size_t i = 1; i < face.crest.size(); ++i) {
      const Vec3 step = face.crest[i] - face.crest[i - 1];
      const Vec2 flat = step.head<2>(), to = p - face.crest[i - 1].head<2>();
      const double share = std::clamp(to.dot(flat) / flat.squaredNorm(), 0.0, 1.0);
      const double distance = (to - share * flat).norm();
      if (distance < least) {
        least = distance;
        nearest = before + share * step.norm();
      }
      before += step.norm();
    }
    return nearest;
  }

  /// A place on the crest in front of a hole: uniform over half its spacing to either side, as far as the
  /// rock fits between the ends of the crest.
  double in_front_of(const Hole& hole, const Mesh::Face& here) {
    const double middle = nearest_on_crest(here, Vec2(hole.x, hole.y) - origin().head<2>());
    const double spacing = blast_at(scenario_, key_)[BlastField::spacing];
    const double drawn = rng_.uniform(-0.5, 0.5);
    const double begin = -extent_along(rock_, on_crest(here, 0).along).low;
    const double end =
        crest_length(here) - extent_along(rock_, on_crest(here, crest_length(here)).along).high;
    if (end < begin)
      throw StartError(fmt::format("a rock {:.3g} m wide does not fit on the face of {}, {:.3g} m wide",
                                   begin + crest_length(here) - end, face_text(), crest_length(here)));
    return std::clamp(middle + (std::isnan(spacing) ? 0 : drawn * spacing), begin, end);
  }

  /// The distance of the rock's hole along the crest: hole i of n at (i - (n - 1) / 2) spacings from the
  /// middle.
  double at_hole(const Mesh::Face& here, const Blast& blast) const {
    const int n = scenario_.blast->pattern.holes_per_row, i = hole_of(key_) % n;
    const double length = crest_length(here), spacing = blast[BlastField::spacing];
    if (n > 1 && std::isnan(spacing))
      throw StartError("the place of several holes of a row needs blast.spacing");
    const double at = length / 2 + (n > 1 ? (i - (n - 1) / 2.0) * spacing : 0);
    if (at < 0 || at > length)
      throw StartError(
          fmt::format("hole {} of {} lies {:.6g} m beyond the end of the crest of {}, {:.6g} m long", i + 1,
                      n, at < 0 ? -at : at - length, face_text(), length));
    return at;
  }

  const Release& release_;
  const Scenario& scenario_;
  const DrawKey& key_;
  RandomStream& rng_;
  const Body<3>& rock_;
  const Terrain3& terrain_;
};

}  // namespace

Place<3> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<3>& rock, const Terrain3& terrain) {
  return Placing(release, scenario, key, rng, rock, terrain).place();
}

}  // namespace flyrock
