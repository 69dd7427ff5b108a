#include "trial/place_rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/place_text.h"
#include "plugin/turn.h"
#include "trial/blast_at.h"
#include "trial/extent.h"
#include "trial/random_place.h"
#include "trial/touch_ground.h"

namespace flyrock {

namespace {

const Profile::Face& face_of(int bench, const Profile& profile) {
  if (bench < 1 || bench > static_cast<int>(profile.faces.size()))
    throw StartError(
        fmt::format("bench {} does not exist, the terrain has {} bench faces", bench, profile.faces.size()));
  return profile.faces[bench - 1];
}

/// Whether the ground between toe and crest of a face is one straight line.
bool is_straight(const Terrain2& terrain, const Vec2& toe, const Vec2& crest) {
  const double tolerance = 1e-9 * (crest - toe).norm();
  const Vec2 along = (crest - toe).normalized();
  for (const Vec2& point : terrain.profile().points) {
    const double at = along.dot(point - toe);
    if (at > tolerance && at < (crest - toe).norm() - tolerance &&
        point.x() >= std::min(toe.x(), crest.x()) - tolerance &&
        point.x() <= std::max(toe.x(), crest.x()) + tolerance &&
        std::abs(cross(along, Vec2(point - toe))) > tolerance)
      return false;
  }
  return true;
}

Place<2> on_face(const Release& release, const Body<2>& rock, const Terrain2& terrain, RandomStream& rng) {
  const auto& [toe, crest, name] = face_of(release.bench, terrain.profile());
  const Vec2 up = (crest - toe).normalized();
  const Vec2 out(up.y(), -up.x());
  const auto [low, high] = extent_along<2>(rock, up);
  const double depth = extent_along<2>(rock, out).low;
  const double room = (crest - toe).norm() - (high - low);
  if (room < 0)
    throw StartError(fmt::format(
        "a rock {:.3g} m long does not fit on the face {}, {:.3g} m long", high - low,
        name.empty() ? fmt::format("of bench {}", release.bench) : "`" + name + "`", (crest - toe).norm()));
  Place<2> place;
  place.position = toe + (rng.uniform() * room - low) * up - depth * out;
  if (!is_straight(terrain, toe, crest)) {
    // The ground between the ends is no straight line: move the rock against it from outside.
    const double away = (crest - toe).norm();
    const Vec2 start = place.position + away * out;
    if (const auto distance = distance_to_ground<2>(rock, terrain, start, -out, 3 * away))
      place.position = start - *distance * out;
  }
  place.outward = {out.x() < 0 ? -1.0 : 1.0, 0, 0};
  place.face_angle = std::atan2(up.y(), std::abs(up.x()));
  return place;
}

/// How far [m] the ground between two x rises above its height at x.
double rise_above(const Profile& profile, double x, double from, double to) {
  from = std::max(from, profile.x_min());
  to = std::min(to, profile.x_max());
  double highest = std::max(profile.height(from), profile.height(to));
  for (const Vec2& point : profile.points)
    if (point.x() > from && point.x() < to) highest = std::max(highest, point.y());
  return highest - profile.height(x);
}

/// At rest at the place x, on the ground.
Place<2> on_ground_at(double x, const Body<2>& rock, const Terrain2& terrain) {
  const Profile& profile = terrain.profile();
  Place<2> place;
  const auto [low, high] = extent_along<2>(rock, Vec2::UnitY());
  const auto [left, right] = extent_along<2>(rock, Vec2::UnitX());
  place.position = {x, profile.height(x) - low};
  // On a bench that is not level the rock is lowered until it touches. A wall beside it is no bench.
  const double rise = rise_above(profile, x, x + left, x + right);
  if (rise > 0 && rise < high - low) {
    const Vec2 start = place.position + Vec2(0, rise);
    if (const auto fall = distance_to_ground<2>(rock, terrain, start, -Vec2::UnitY(), rise + rock.size))
      place.position = start - Vec2(0, *fall);
  }
  return place;
}

/// At the collar of a measured hole, which throws out of the face of the release if there is one.
Place<2> at_hole(const Release& release, const Hole& hole, const Body<2>& rock, const Terrain2& terrain) {
  const Profile& profile = terrain.profile();
  if (hole.x < profile.x_min() || hole.x > profile.x_max())
    throw StartError(fmt::format("hole {} at x = {} m lies beyond the terrain, from {} to {} m", hole.name,
                                 coordinate_text(hole.x), coordinate_text(profile.x_min()),
                                 coordinate_text(profile.x_max())));
  Place<2> place = on_ground_at(hole.x, rock, terrain);
  raise_to_collar(hole, profile.height(hole.x), 0, place.position.y());
  if (release.bench >= 1 && release.bench <= static_cast<int>(profile.faces.size())) {
    const Profile::Face& face = face_of(release.bench, profile);
    place.outward = {face.toe.x() < face.crest.x() ? -1.0 : 1.0, 0, 0};
  }
  return place;
}

/// A place at rest on the bench above a face: at the collar of the rock's hole, or anywhere up to the last
/// row.
Place<2> on_top(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                const Body<2>& rock, const Terrain2& terrain) {
  const Profile& profile = terrain.profile();
  const Profile::Face& face = face_of(release.bench, profile);
  const double back = depth_of_holes(release, scenario, key, blast_at(scenario, key));
  const double share = release.kind == ReleaseKind::collar ? 1 : rng.uniform();
  const double out = face.toe.x() < face.crest.x() ? -1 : 1;
  const double x = face.crest.x() - out * share * back;
  if (x < profile.x_min() || x > profile.x_max())
    throw StartError(fmt::format("a hole {:.6g} m behind the crest lies beyond the terrain", back));
  Place<2> place = on_ground_at(x, rock, terrain);
  place.outward = {out, 0, 0};
  return place;
}

}  // namespace

const Hole* measured_hole(const Scenario& scenario, const DrawKey& key) {
  if (!scenario.blast || !scenario.blast->has_holes()) return nullptr;
  return &scenario.blast->pattern.measured[static_cast<std::size_t>(hole_of(key))];
}

void raise_to_collar(const Hole& hole, double ground, double origin, double& height) {
  constexpr double most_below = 1;  // m: surveys of collars and of the ground differ by less
  if (std::isnan(hole.z)) return;
  const double above = hole.z - origin - ground;
  if (above < -most_below)
    throw StartError(fmt::format("the collar of hole {} lies {:.3g} m below the ground", hole.name, -above));
  height += std::max(0.0, above);
}

double depth_of_holes(const Release& release, const Scenario& scenario, const DrawKey& key,
                      const Blast& blast) {
  const double front = std::isnan(blast[BlastField::burden_crest]) ? blast[BlastField::burden]
                                                                   : blast[BlastField::burden_crest];
  if (std::isnan(front))
    throw StartError("the place of the holes needs blast.burden, or burden_crest and burden_toe");
  const Pattern& pattern = scenario.blast->pattern;
  const int row = release.kind == ReleaseKind::collar ? pattern.row(hole_of(key)) : pattern.rows - 1;
  if (row > 0 && pattern.row_distance <= 0)
    throw StartError("the place of a second row needs blast.rows.distance");
  return front + row * pattern.row_distance;
}

Place<2> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<2>& rock, const Terrain2& terrain) {
  const Profile& profile = terrain.profile();
  const auto number = [&](const Number& n) { return n.value(scenario.draws, scenario.streams, key); };
  Place<2> place;
  switch (release.kind) {
    case ReleaseKind::face:
      return on_face(release, rock, terrain, rng);
    case ReleaseKind::collar:
      if (const Hole* hole = measured_hole(scenario, key)) return at_hole(release, *hole, rock, terrain);
      [[fallthrough]];
    case ReleaseKind::bench_top:
      return on_top(release, scenario, key, rng, rock, terrain);
    case ReleaseKind::above_ground: {
      const double x = number(release.x);
      if (x < profile.x_min() || x > profile.x_max())
        throw StartError(fmt::format("x = {} m lies beyond the terrain, from {} to {} m", coordinate_text(x),
                                     coordinate_text(profile.x_min()), coordinate_text(profile.x_max())));
      place.position = {x, profile.height(x) + number(release.above_ground)};
      break;
    }
    case ReleaseKind::position:
      place.position = {number(release.position[0]), number(release.position[1])};
      break;
    case ReleaseKind::along:
      place.position = random_along(release.points, rng).head<2>();
      break;
    case ReleaseKind::inside:
      place.position = random_inside(release.points, rng).head<2>();
      break;
    case ReleaseKind::zone:
    case ReleaseKind::raster:
      throw StartError("a zone or raster is a place of dimension 3");
  }
  return place;
}

Rotation3 rotation_of(const TurnPlan& turn, const Scenario& scenario, const DrawKey& key) {
  std::array<double, 4> values{};
  for (std::size_t k = 0; k < 4; ++k)
    values[k] = turn.numbers[k].value(scenario.draws, scenario.streams, key);
  return turn_of(values, turn.about_axis);
}

/// Source: K. Shoemake, Uniform random rotations, Graphics Gems III, 1992.
Rotation3 random_rotation(RandomStream& rng) {
  const double u = rng.uniform(), a = 2 * pi * rng.uniform(), b = 2 * pi * rng.uniform();
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Rotation3(Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)));
}

}  // namespace flyrock
