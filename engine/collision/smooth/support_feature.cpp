#include "collision/smooth/support_feature.h"

#include <algorithm>
#include <cmath>

#include "collision/rules.h"

namespace flyrock {

namespace {

Patch cap_of(const Placed3& shape, int k) {
  const Contactor3::Circle& circle = shape.shape.circles[k];
  Patch patch;
  patch.kind = Patch::Kind::disc;
  patch.feature = {FeatureKind::face, k};
  patch.normal = shape.pose.r * circle.axis;
  patch.circle = k;
  patch.centre = shape.pose * circle.centre;
  patch.radius = circle.radius;
  return patch;
}

Patch face_of(const Placed3& shape, int f) {
  const Contactor3::Face& face = shape.shape.faces[f];
  Patch patch;
  patch.kind = Patch::Kind::polygon;
  patch.feature = {FeatureKind::face, f};
  patch.normal = shape.normal(f);
  patch.radius = shape.shape.bound;
  for (int i = 0; i < face.count; ++i)
    patch.places.push_back({shape.corner(f, i),
                            {FeatureKind::vertex, shape.shape.vertex(face, i)},
                            {FeatureKind::edge, shape.shape.loop_edge[face.first + i]}});
  return patch;
}

bool names_side(const Contactor3& shape, FeatureId feature) {
  return !shape.circles.empty() && kind_of(feature) == FeatureKind::face && index_of(feature) == side_face;
}

/// The place of a piece that is farthest along a direction in the contactor's frame.
Vec3 farthest(const Contactor3& shape, int piece, const Vec3& local) {
  const int points = static_cast<int>(shape.points.size());
  if (piece < points) return shape.points[piece];
  const Contactor3::Circle& circle = shape.circles[piece - points];
  return circle.centre + circle.radius * circle.towards(local);
}

ShapeFeature place_feature(const Contactor3& shape, int piece) {
  const int points = static_cast<int>(shape.points.size());
  if (piece < points) return {FeatureKind::vertex, piece};
  return {FeatureKind::edge, rim_index(piece - points, 0)};
}

}  // namespace

Vec3 place_on(const Patch& patch) {
  return patch.kind == Patch::Kind::disc ? patch.centre : patch.places.front().at;
}

Vec3 rim_place(const Placed3& shape, int index, const Vec3& direction) {
  const Contactor3::Circle& circle = shape.shape.circles[circle_of_rim(index)];
  const int place = place_of_rim(index);
  const Vec3 out = circle.towards(shape.pose.r.inverse(direction));
  static const double diagonal = std::sqrt(0.5);
  static const double cosine[] = {1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal};
  Vec3 turned = out;
  if (place > 0 && place < rim_places)
    turned = cosine[place] * out + cosine[(place + 6) % rim_places] * circle.axis.cross(out);
  return shape.pose * (circle.centre + circle.radius * turned);
}

bool contains_piece(const Contactor3& shape, const ShapeFeature& feature, int piece) {
  const int points = static_cast<int>(shape.points.size()), i = feature.index;
  if (!shape.circles.empty()) {
    if (feature.kind == FeatureKind::vertex) return piece == i;
    if (feature.kind == FeatureKind::edge) return piece == points + circle_of_rim(i);
    return i == side_face || piece == points + i;
  }
  if (feature.kind == FeatureKind::vertex) return piece == i;
  if (feature.kind == FeatureKind::edge) return shape.edges[i].start == piece || shape.edges[i].end == piece;
  if (shape.faces.empty()) return true;  // the plane of a half space
  const Contactor3::Face& face = shape.faces[i];
  const auto* loop = &shape.loop[face.first];
  return std::find(loop, loop + face.count, piece) != loop + face.count;
}

Patch support_feature(const Placed3& placed, const Vec3& direction, Planes planes) {
  const Contactor3& shape = placed.shape;
  const Vec3 local = placed.pose.r.inverse(direction);
  const auto is_flush = [&](const Vec3& normal) {
    return planes == Planes::with && (normal - local).squaredNorm() < flush_angle * flush_angle;
  };
  for (int k = 0; k < static_cast<int>(shape.circles.size()); ++k)
    if (is_flush(shape.circles[k].axis)) return cap_of(placed, k);
  for (int f = 0; f < placed.faces(); ++f)
    if (is_flush(shape.faces[f].normal)) return face_of(placed, f);
  // The farthest piece, and the one from which the line to it drops least.
  const int pieces = pieces_of(shape);
  int top = 0;
  double most = -1e300;
  for (int i = 0; i < pieces; ++i)
    if (const double along = local.dot(farthest(shape, i, local)); along > most) most = along, top = i;
  const Vec3 at = farthest(shape, top, local);
  Patch patch;
  patch.feature = place_feature(shape, top);
  patch.places.push_back({placed.pose * at, patch.feature, {}});
  int end = -1;
  ShapeFeature line;
  double least = flush_angle;
  const auto try_end = [&](int piece, const ShapeFeature& by) {
    const Vec3 away = farthest(shape, piece, local) - at;
    const double drop = -local.dot(away) / away.norm();
    if (drop < least) least = drop, end = piece, line = by;
  };
  if (!shape.circles.empty()) {
    for (int i = 0; i < pieces; ++i)
      if (i != top) try_end(i, {FeatureKind::face, side_face});
  } else {
    for (int e = 0; e < static_cast<int>(shape.edges.size()); ++e)
      if (shape.edges[e].start == top || shape.edges[e].end == top)
        try_end(shape.edges[e].start + shape.edges[e].end - top, {FeatureKind::edge, e});
  }
  if (end < 0) return patch;
  patch.kind = Patch::Kind::segment;
  patch.feature = line;
  patch.places.front().side = line;
  patch.places.push_back({placed.pose * farthest(shape, end, local), place_feature(shape, end), line});
  return patch;
}

std::optional<Patch> known_feature(const Placed3& placed, FeatureId id, const Vec3& direction) {
  const Contactor3& shape = placed.shape;
  const Vec3 local = placed.pose.r.inverse(direction);
  const ShapeFeature feature = feature_of(id);
  Patch patch;
  patch.feature = feature;
  const auto add_piece = [&](int piece) {
    patch.places.push_back(
        {placed.pose * farthest(shape, piece, local), place_feature(shape, piece), feature});
  };
  if (feature.kind == FeatureKind::vertex) {
    add_piece(feature.index);
  } else if (!shape.circles.empty()) {
    const bool is_side = names_side(shape, id);
    if (!is_side && (feature.kind == FeatureKind::face || place_of_rim(feature.index) > 0))
      return std::nullopt;
    if (is_side) {
      patch.kind = Patch::Kind::segment;
      for (int i = 0; i < pieces_of(shape); ++i) add_piece(i);
    } else {
      add_piece(static_cast<int>(shape.points.size()) + circle_of_rim(feature.index));
    }
  } else if (feature.kind == FeatureKind::edge) {
    patch.kind = Patch::Kind::segment;
    for (const int end : {shape.edges[feature.index].start, shape.edges[feature.index].end}) add_piece(end);
  } else {
    return std::nullopt;
  }
  return patch;
}

std::optional<Vec3> touching_line(const Placed3& shape, FeatureId feature, const Vec3& direction) {
  const int index = index_of(feature);
  if (names_side(shape.shape, feature)) {
    const auto side = known_feature(shape, feature, direction);
    return side->places[1].at - side->places[0].at;
  }
  if (kind_of(feature) == FeatureKind::face) return std::nullopt;
  if (kind_of(feature) == FeatureKind::vertex) return Vec3::Zero();
  if (!shape.shape.circles.empty())
    return (shape.pose.r * shape.shape.circles[circle_of_rim(index)].axis).cross(direction);
  const Contactor3::Edge& edge = shape.shape.edges[index];
  return shape.pose.r * (shape.shape.points[edge.end] - shape.shape.points[edge.start]);
}

std::optional<Vec3> touching_line(const Ground3& ground, FeatureId feature) {
  if (kind_of(feature) == FeatureKind::face) return std::nullopt;
  if (kind_of(feature) == FeatureKind::vertex) return Vec3::Zero();
  return ground.facet(ground.facet_of(feature)).along(static_cast<int>(ground_index(feature) % 3));
}

Vec3 lever_rate(const Placed3& shape, FeatureId feature, const Vec3& direction, const Vec3& spin,
                const Vec3& lever, const std::optional<Vec3>& other) {
  const int index = index_of(feature);
  if (shape.shape.form == Form::hollow) {
    // The place on the wall follows the other body. Of the wall, only the place on its axis turns.
    const Vec3 axis = shape.pose.r * shape.shape.circles[0].axis;
    return spin.cross(axis.dot(lever) * axis);
  }
  if (shape.shape.circles.empty() || kind_of(feature) != FeatureKind::edge || place_of_rim(index) > 0)
    return spin.cross(lever);
  const Contactor3::Circle& circle = shape.shape.circles[circle_of_rim(index)];
  // The place is c + R e with e = P/|P|, P = d - (d.k) k for the direction d and the axis k, which turns.
  const Vec3 axis = shape.pose.r * circle.axis, axis_rate = spin.cross(axis);
  const Vec3 out = direction - direction.dot(axis) * axis;
  const double length = out.norm();
  if (length < flush_angle) return spin.cross(lever);
  const Vec3 towards = out / length;
  // Where the axis is nearly along the direction, the farthest place is far from where a line crosses the
  // rim.
  if (other && axis.cross(towards).cross(*other).norm() >= length * other->norm()) return spin.cross(lever);
  const Vec3 rate = -direction.dot(axis_rate) * axis - direction.dot(axis) * axis_rate;
  return spin.cross(shape.pose.r * circle.centre) +
         circle.radius / length * (rate - towards.dot(rate) * towards);
}

}  // namespace flyrock
