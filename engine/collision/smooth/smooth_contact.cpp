// Contacts of a contactor with circles with a ball, a pill, a polyhedron or another one.

#include <algorithm>
#include <cmath>

#include "collision/manifold_reduction.h"
#include "collision/pill/closest.h"
#include "collision/rules.h"
#include "collision/smooth/facing_pair.h"

namespace flyrock {

namespace {

// Of the size of a patch: how far beyond its sides a place still is in it.
constexpr double beside = 1e-9;

/// A place on one of the two patches, with the features that meet there.
struct Meeting {
  Vec3 at;
  bool of_a;  ///< the place is on the patch of a; else on that of b
  ShapeFeature a, b;
};
using Meetings = boost::container::static_vector<Meeting, 160>;

/// Finds where two patches meet, seen along the normal.
class MeetingPatches {
 public:
  MeetingPatches(const Placed3& a, const Patch& of_a, const Placed3& b, const Patch& of_b, const Vec3& normal,
                 const Vec3& nearest)
      : a_(a), b_(b), of_a_(of_a), of_b_(of_b), n_(normal), nearest_(nearest) {}

  /// How high a patch is along the normal where the line through `at` along the normal meets it.
  double height_at(const Patch& patch, const Vec3& at) const {
    const Vec3& on = patch.kind == Patch::Kind::disc ? patch.centre : patch.places[0].at;
    const double height = n_.dot(on);
    if (patch.is_plane()) return height - patch.normal.dot(flat(at - on)) / patch.normal.dot(n_);
    if (patch.kind == Patch::Kind::point) return height;
    const Vec3 along = patch.places[1].at - on, across = flat(along);
    return height + n_.dot(along) * std::clamp(across.dot(at - on) / across.squaredNorm(), 0.0, 1.0);
  }

  const Meetings& find() {
    using enum Patch::Kind;
    if (of_a_.kind == point || of_b_.kind == point) {
      single();
    } else if (of_a_.kind == segment && of_b_.kind == segment) {
      two_segments();
    } else if (of_a_.kind == segment || of_b_.kind == segment) {
      segment_on_plane(of_a_.kind == segment);
    } else {
      places_inside(true);
      places_inside(false);
      if (of_a_.kind == disc && of_b_.kind == disc)
        two_discs();
      else
        sides_of_polygon(of_a_.kind == polygon);
    }
    if (found_.empty()) single();
    return found_;
  }

 private:
  Vec3 flat(const Vec3& v) const { return v - n_.dot(v) * n_; }

  void add(bool of_a, const Vec3& at, const ShapeFeature& own, const ShapeFeature& others) {
    if (found_.size() < found_.capacity())
      found_.push_back({at, of_a, of_a ? own : others, of_a ? others : own});
  }

  /// One contact, at a vertex or a place of a rim if there is one.
  void single() {
    using enum Patch::Kind;
    const bool b_is_point = of_b_.kind == point && of_a_.kind != point;
    const Vec3 at = b_is_point ? of_b_.places[0].at : of_a_.kind == point ? of_a_.places[0].at : nearest_;
    add(!b_is_point, at, b_is_point ? of_b_.feature : of_a_.feature,
        b_is_point ? of_a_.feature : of_b_.feature);
  }

  void two_segments() {
    const Vec3 p = of_a_.places[0].at, along = flat(of_a_.places[1].at - p);
    const Vec3 q = of_b_.places[0].at, other = flat(of_b_.places[1].at - q);
    const double square = along.squaredNorm();
    if (along.cross(other).norm() > flush_angle * along.norm() * other.norm()) {
      const NearestOfSegments crossing = nearest_of_segments(flat(p), along, flat(q), other);
      return add(true, p + crossing.s * (of_a_.places[1].at - p), of_a_.feature, of_b_.feature);
    }
    for (int end = 0; end < 2; ++end) {
      const double s = along.dot(of_b_.places[end].at - p) / square;
      if (s >= -beside && s <= 1 + beside)
        add(false, of_b_.places[end].at, of_b_.places[end].feature, of_a_.feature);
      const double t = other.dot(of_a_.places[end].at - q) / other.squaredNorm();
      if (t > beside && t < 1 - beside)
        add(true, of_a_.places[end].at, of_a_.places[end].feature, of_b_.feature);
    }
  }

  /// The line of a patch inside a polygon or a disc.
  void segment_on_plane(bool a_is_segment) {
    const Patch &line = a_is_segment ? of_a_ : of_b_, &plane = a_is_segment ? of_b_ : of_a_;
    const Vec3 start = line.places[0].at, along = line.places[1].at - start;
    double low = 0, high = 1;
    ShapeFeature at_low = line.places[0].feature, at_high = line.places[1].feature;
    ShapeFeature by_low = plane.feature, by_high = plane.feature;
    const auto cut = [&](bool is_high, double s, const ShapeFeature& by) {
      if (is_high ? s >= high - beside : s <= low + beside) return;
      (is_high ? high : low) = s;
      (is_high ? at_high : at_low) = line.feature;
      (is_high ? by_high : by_low) = by;
    };
    if (plane.kind == Patch::Kind::disc) {
      const Vec3 away = flat(start - plane.centre), across = flat(along);
      const double square = across.squaredNorm(), half = across.dot(away);
      const double rest = half * half - square * (away.squaredNorm() - plane.radius * plane.radius);
      if (rest <= 0) return;
      cut(false, (-half - std::sqrt(rest)) / square, {FeatureKind::edge, rim_index(plane.circle, 8)});
      cut(true, (-half + std::sqrt(rest)) / square, {FeatureKind::edge, rim_index(plane.circle, 9)});
    } else {
      for (std::size_t k = 0; k < plane.places.size(); ++k) {
        const Vec3 outward = outward_of(plane, k);
        const double above = outward.dot(start - plane.places[k].at), rise = outward.dot(along);
        if (std::abs(rise) < 1e-12 * along.norm()) {
          if (above > beside * along.norm()) return;
          continue;
        }
        cut(rise > 0, -above / rise, plane.places[k].side);
      }
    }
    if (low > high) return;
    add(a_is_segment, start + low * along, at_low, by_low);
    if (high - low > 1e-6) add(a_is_segment, start + high * along, at_high, by_high);
  }

  /// Unit, out of a polygon across its side k, along the plane.
  Vec3 outward_of(const Patch& polygon, std::size_t k) const {
    const Vec3 along = polygon.places[(k + 1) % polygon.places.size()].at - polygon.places[k].at;
    return along.cross(polygon.normal).normalized();
  }

  bool is_inside(const Patch& plane, const Vec3& at) const {
    if (plane.kind == Patch::Kind::disc) return flat(at - plane.centre).norm() <= plane.radius * (1 + beside);
    for (std::size_t k = 0; k < plane.places.size(); ++k)
      if (outward_of(plane, k).dot(at - plane.places[k].at) > beside * plane.radius) return false;
    return true;
  }

  /// Vertices, and places of a rim, that lie inside of the other patch.
  void places_inside(bool of_a) {
    const Patch &own = of_a ? of_a_ : of_b_, &other = of_a ? of_b_ : of_a_;
    if (own.kind == Patch::Kind::disc) {
      // The places count from the one that is lowest over the other plane. The normal of the pair may be that
      // of this cap, over which no place of its rim is lowest.
      for (int i = 0; i < rim_places; ++i) {
        const int index = rim_index(own.circle, i);
        const Vec3 at = rim_place(of_a ? a_ : b_, index, -other.normal);
        if (is_inside(other, at)) add(of_a, at, {FeatureKind::edge, index}, other.feature);
      }
    } else {
      for (const Patch::Place& place : own.places)
        if (is_inside(other, place.at)) add(of_a, place.at, place.feature, other.feature);
    }
  }

  /// Where the sides of a polygon cross a rim. The place is on the polygon.
  void sides_of_polygon(bool a_is_polygon) {
    const Patch &polygon = a_is_polygon ? of_a_ : of_b_, &disc = a_is_polygon ? of_b_ : of_a_;
    for (std::size_t k = 0; k < polygon.places.size(); ++k) {
      const Vec3& start = polygon.places[k].at;
      const Vec3 along = polygon.places[(k + 1) % polygon.places.size()].at - start;
      const Vec3 away = flat(start - disc.centre), across = flat(along);
      const double square = across.squaredNorm(), half = across.dot(away);
      const double rest = half * half - square * (away.squaredNorm() - disc.radius * disc.radius);
      if (rest <= 0) continue;
      for (int side = 0; side < 2; ++side) {
        const double s = (-half + (side ? 1 : -1) * std::sqrt(rest)) / square;
        if (s > 0 && s < 1)
          add(a_is_polygon, start + s * along, polygon.places[k].side,
              {FeatureKind::edge, rim_index(disc.circle, 8 + side)});
      }
    }
  }

  void two_discs() {
    const Vec3 between = flat(of_b_.centre - of_a_.centre);
    const double away = between.norm(), ra = of_a_.radius, rb = of_b_.radius;
    if (away >= ra + rb || away <= std::abs(ra - rb) || away == 0) return;
    const double along = (away * away + ra * ra - rb * rb) / (2 * away);
    const double half = std::sqrt(std::max(0.0, ra * ra - along * along));
    const Vec3 towards = between / away, across = n_.cross(towards);
    for (int side = 0; side < 2; ++side)
      add(true, of_a_.centre + along * towards + (side ? half : -half) * across,
          {FeatureKind::edge, rim_index(of_a_.circle, 8 + side)},
          {FeatureKind::edge, rim_index(of_b_.circle, 8 + side)});
  }

  const Placed3& a_;
  const Placed3& b_;
  const Patch& of_a_;
  const Patch& of_b_;
  Vec3 n_, nearest_;
  Meetings found_;
};

}  // namespace

void smooth_contacts(Workspace&, const Placed3& a, const Placed3& b, double reach, double, Contacts<3>& out) {
  const double radii = a.shape.radius + b.shape.radius;
  const FacingPair pair = facing_pair(a, b);
  if (pair.apart.distance - radii > reach) return;
  const Patch &of_a = pair.of_a, &of_b = pair.of_b;
  const Vec3& n = pair.normal;
  MeetingPatches meetings(a, of_a, b, of_b, n, pair.apart.on_a);
  const std::size_t begin = out.size();
  const bool planes = of_a.is_plane() && of_b.is_plane();
  for (const Meeting& m : meetings.find()) {
    const double distance =
        m.of_a ? n.dot(m.at) - meetings.height_at(of_b, m.at) : meetings.height_at(of_a, m.at) - n.dot(m.at);
    const double gap = distance - radii;
    if (gap > reach) continue;
    const Vec3 on_a = m.of_a ? m.at : m.at + distance * n;
    out.push_back({on_a - (a.shape.radius + 0.5 * gap) * n, n, gap, a.id(m.a), b.id(m.b)});
  }
  if (planes) keep_four(out, begin);
}

}  // namespace flyrock
