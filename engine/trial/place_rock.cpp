#include "trial/place_rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trial/blast_at.h"

namespace flyrock {

namespace {

const Profile::Face& face_of(int bench, const Profile& profile) {
  if (bench < 1 || bench > static_cast<int>(profile.faces.size()))
    throw StartError(
        fmt::format("bench {} does not exist, the terrain has {} bench faces", bench, profile.faces.size()));
  return profile.faces[bench - 1];
}

Place<2> on_face(int bench, const Body<2>& rock, const Profile& profile, RandomStream& rng) {
  const auto& [toe, crest] = face_of(bench, profile);
  const Vec2 up = (crest - toe).normalized();
  const Vec2 out(up.y(), -up.x());
  double low = 1e300, high = -1e300, depth = 1e300;
  for (const Contactor2& contactor : rock.contactors) {
    for (const Vec2& local : contactor.points) {
      const Vec2 p = rock.attitude.rotation * local;
      low = std::min(low, p.dot(up) - contactor.radius);
      high = std::max(high, p.dot(up) + contactor.radius);
      depth = std::min(depth, p.dot(out) - contactor.radius);
    }
  }
  const double room = (crest - toe).norm() - (high - low);
  if (room < 0)
    throw StartError(fmt::format("a rock {:.3g} m long does not fit on the face of bench {}, {:.3g} m long",
                                 high - low, bench, (crest - toe).norm()));
  Place<2> place;
  place.position = toe + (rng.uniform() * room - low) * up - depth * out;
  place.outward = {out.x() < 0 ? -1.0 : 1.0, 0, 0};
  place.face_angle = std::atan2(up.y(), std::abs(up.x()));
  return place;
}

/// A place at rest on the bench above a face: at the collar of the rock's hole, or anywhere up to the last
/// row.
Place<2> on_top(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                const Body<2>& rock, const Profile& profile) {
  const Profile::Face& face = face_of(release.bench, profile);
  const Blast blast = blast_at(scenario, key);
  const double front = std::isnan(blast[BlastField::burden_crest]) ? blast[BlastField::burden]
                                                                   : blast[BlastField::burden_crest];
  if (std::isnan(front))
    throw StartError("the place of the holes needs blast.burden, or burden_crest and burden_toe");
  const Pattern& pattern = scenario.blast->pattern;
  const int row = release.kind == ReleaseKind::collar ? pattern.row(hole_of(key)) : pattern.rows - 1;
  if (row > 0 && pattern.row_distance <= 0)
    throw StartError("the place of a second row needs blast.rows.distance");
  const double back = front + row * pattern.row_distance;
  const double share = release.kind == ReleaseKind::collar ? 1 : rng.uniform();
  const double out = face.toe.x() < face.crest.x() ? -1 : 1;
  const double x = face.crest.x() - out * share * back;
  if (x < profile.x_min() || x > profile.x_max())
    throw StartError(fmt::format("a hole {:.6g} m behind the crest lies beyond the terrain", back));
  double low = 1e300;
  for (const Contactor2& contactor : rock.contactors)
    for (const Vec2& local : contactor.points)
      low = std::min(low, (rock.attitude.rotation * local).y() - contactor.radius);
  Place<2> place;
  place.position = {x, profile.height(x) - low};
  place.outward = {out, 0, 0};
  return place;
}

Vec3 along(const std::vector<Vec3>& points, RandomStream& rng) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  double left = rng.uniform() * length;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double part = (points[i] - points[i - 1]).norm();
    if (left <= part || i + 1 == points.size())
      return points[i - 1] + std::min(1.0, left / part) * (points[i] - points[i - 1]);
    left -= part;
  }
  return points.front();
}

/// A uniform place in a flat convex polygon: first a triangle of its fan, chosen by area, then a point in it.
Vec3 inside(const std::vector<Vec3>& points, RandomStream& rng) {
  const auto area = [&](std::size_t i) {
    return (points[i] - points[0]).cross(points[i + 1] - points[0]).norm();
  };
  double total = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) total += area(i);
  double left = rng.uniform() * total;
  std::size_t triangle = 1;
  while (triangle + 2 < points.size() && left > area(triangle)) left -= area(triangle++);
  double u = rng.uniform(), v = rng.uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return points[0] + u * (points[triangle] - points[0]) + v * (points[triangle + 1] - points[0]);
}

}  // namespace

Place<2> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<2>& rock, const Profile& profile) {
  const auto number = [&](const Number& n) { return n.value(scenario.draws, scenario.seed, key); };
  Place<2> place;
  switch (release.kind) {
    case ReleaseKind::face:
      return on_face(release.bench, rock, profile, rng);
    case ReleaseKind::collar:
    case ReleaseKind::bench_top:
      return on_top(release, scenario, key, rng, rock, profile);
    case ReleaseKind::above_ground: {
      const double x = number(release.x);
      if (x < profile.x_min() || x > profile.x_max())
        throw StartError(fmt::format("x = {:.6g} m lies beyond the terrain, from {:.6g} to {:.6g} m", x,
                                     profile.x_min(), profile.x_max()));
      place.position = {x, profile.height(x) + number(release.above_ground)};
      break;
    }
    case ReleaseKind::position:
      place.position = {number(release.position[0]), number(release.position[1])};
      break;
    case ReleaseKind::along:
      place.position = along(release.points, rng).head<2>();
      break;
    case ReleaseKind::inside:
      place.position = inside(release.points, rng).head<2>();
      break;
  }
  return place;
}

Place<3> place_rock(const Release& release, const Scenario& scenario, const DrawKey& key, RandomStream& rng,
                    const Body<3>&, const Ground3& ground) {
  const auto number = [&](const Number& n) { return n.value(scenario.draws, scenario.seed, key); };
  Place<3> place;
  switch (release.kind) {
    case ReleaseKind::above_ground: {
      const double x = number(release.x), y = number(release.y);
      const auto top = ground.height(x, y);
      if (!top) throw StartError(fmt::format("there is no ground at ({:.6g}, {:.6g}) m", x, y));
      place.position = {x, y, *top + number(release.above_ground)};
      break;
    }
    case ReleaseKind::position:
      for (int i = 0; i < 3; ++i) place.position[i] = number(release.position[i]);
      break;
    case ReleaseKind::along:
      place.position = along(release.points, rng);
      break;
    case ReleaseKind::inside:
      place.position = inside(release.points, rng);
      break;
    case ReleaseKind::face:
    case ReleaseKind::collar:
    case ReleaseKind::bench_top:
      throw StartError("dimension 3 has no bench faces");
  }
  return place;
}

Rotation3 rotation_of(const TurnPlan& turn, const Scenario& scenario, const DrawKey& key) {
  const auto number = [&](const Number& n) { return n.value(scenario.draws, scenario.seed, key); };
  Eigen::Quaterniond q(1, 0, 0, 0);
  double length = 0;
  if (turn.axis.empty()) {
    q = {number(turn.quaternion[0]), number(turn.quaternion[1]), number(turn.quaternion[2]),
         number(turn.quaternion[3])};
    length = q.norm();
  } else {
    const Vec3 axis(number(turn.axis[0]), number(turn.axis[1]), number(turn.axis[2]));
    length = axis.norm();
    if (length > 0) q = Eigen::AngleAxisd(number(turn.angle), axis / length);
  }
  if (!(length > 0)) throw StartError("its axis or quaternion was drawn as zero, which is no rotation");
  return Rotation3(q);
}

/// Source: K. Shoemake, Uniform random rotations, Graphics Gems III, 1992.
Rotation3 random_rotation(RandomStream& rng) {
  const double u = rng.uniform(), a = 2 * pi * rng.uniform(), b = 2 * pi * rng.uniform();
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Rotation3(Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)));
}

Profile with_zones(Profile profile, const std::vector<Zone>& zones) {
  for (const Zone& zone : zones) {
    const int part = static_cast<int>(profile.parts.size());
    profile.parts.push_back(zone.name);
    for (const double x : {zone.from, zone.to}) {
      for (int i = 0; i < profile.segments(); ++i) {
        const Vec2 a = profile.points[i], b = profile.points[i + 1];
        if (x <= a.x() || x >= b.x()) continue;
        profile.points.insert(profile.points.begin() + i + 1, a + (x - a.x()) / (b.x() - a.x()) * (b - a));
        profile.part.insert(profile.part.begin() + i, profile.part[i]);
        break;
      }
    }
    for (int i = 0; i < profile.segments(); ++i) {
      const double middle = 0.5 * (profile.points[i].x() + profile.points[i + 1].x());
      if (middle > zone.from && middle < zone.to) profile.part[i] = part;
    }
  }
  return profile;
}

}  // namespace flyrock
