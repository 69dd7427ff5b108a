// Every shape against every shape: contacts of the shapes of the examples at random placements, against
// bounds of the distance that do not use the contact search.
//
// A gap g with the normal n: no direction separates two convex shapes by more than their distance, so the
// supports of both along n, g apart, bound it from below; a place of each, g apart, bounds it from above.
// Where they overlap, the supports along n overlap by -g, and no sampled direction overlaps by less. Two
// polytopes are measured along a face or a pair of edges: a lower bound of the distance, exact where they
// overlap.

#include <catch2/catch.hpp>

#include "collision/pairs.h"
#include "indexed.h"
#include "placed_shapes.h"
#include "scratch.h"

using namespace flyrock;

namespace shape_pairs_test {

namespace {

/// How far a place is out of a contactor along the directions that bound it: faces, caps, and for what is
/// round the distance from the core. 0 or less on or in it [m].
template <class Contactor, class Place>
double out_of_core(const Contactor& shape, const Place& p) {
  const Place along = shape.points.back() - shape.points.front(), away = p - shape.points.front();
  const double square = along.squaredNorm();
  return (away - (square > 0 ? std::clamp(away.dot(along) / square, 0.0, 1.0) : 0) * along).norm() -
         shape.radius;
}
double outside(const Contactor2& shape, const Vec2& p) {
  if (shape.points.size() <= 2) return out_of_core(shape, p);
  double most = -1e300, nearest = 1e300;
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const Vec2 along = shape.points[(i + 1) % shape.points.size()] - shape.points[i],
               away = p - shape.points[i];
    most = std::max(most, shape.normals[i].dot(away));
    nearest = std::min(nearest,
                       (away - std::clamp(away.dot(along) / along.squaredNorm(), 0.0, 1.0) * along).norm());
  }
  return most > 0 && shape.radius > 0 ? nearest - shape.radius : most - shape.radius;
}
double outside(const Contactor3& shape, const Vec3& p) {
  if (!shape.circles.empty()) {
    const Contactor3::Circle& base = shape.circles.front();
    double most = base.axis.dot(p - base.centre);
    if (shape.circles.size() == 2) {
      most = std::max({most, shape.circles[1].axis.dot(p - shape.circles[1].centre),
                       base.across(p - base.centre).norm() - base.radius});
    } else {  // along the normal of the side of a cone
      const Vec3 up = shape.points[0] - base.centre;
      const double height = up.norm(), slant = std::hypot(height, base.radius);
      most = std::max(most, (height * base.across(p - base.centre).norm() +
                             base.radius * (up.dot(p - base.centre) / height - height)) /
                                slant);
    }
    return most;
  }
  if (shape.points.size() <= 2) return out_of_core(shape, p);
  double most = -1e300;
  for (const Contactor3::Face& face : shape.faces)
    most = std::max(most, face.normal.dot(p - shape.points[shape.vertex(face, 0)]));
  return most;
}

bool is_polytope(const Contactor2& shape) { return shape.points.size() > 2 && shape.radius == 0; }
bool is_polytope(const Contactor3& shape) { return !shape.faces.empty(); }

/// Whether the contacts of a placement are true; `tight`: their bounds meet to 1e-9.
struct Verdict {
  bool good = true, tight = true;
};

template <int D>
Verdict judge(Dice& dice, const Placed<D>& a, const Placed<D>& b) {
  std::vector<ContactPoint<D>> contacts;
  body_contacts(scratch(), indexed(a, 1), indexed(b, 2), 10, contacts);
  if (contacts.size() > 4) return {false, false};
  const auto along = [&](const Vec<D>& n) {  // separation of b from a along n, from b to a
    return n.dot(a.pose.x - b.pose.x) - reach(a.shape, a.pose.r.inverse(-n)) -
           reach(b.shape, b.pose.r.inverse(n));
  };
  const bool polytopes = is_polytope(a.shape) && is_polytope(b.shape);
  if (contacts
          .empty()) {  // faces that look past each other have no contact, but then the polytopes are apart
    bool apart = false;
    for (int i = 0; i < 5000 && !apart; ++i) apart = along(dice.direction<D>()) > 0;
    return {polytopes && apart, true};
  }
  const ContactPoint<D>& c = *std::min_element(contacts.begin(), contacts.end(),
                                               [](const auto& p, const auto& q) { return p.gap < q.gap; });
  constexpr double deepest = 0.02, far_apart = 0.3;  // m
  constexpr double flush =
      3e-4;  // 1 m x 1e-4 rad and more: a plane gives its normal to what is flush to this angle
  Verdict verdict;
  if (std::min(c.gap, along(c.normal)) < -deepest) {  // steps leave no such overlap: that there is one counts
    for (int i = 0; i < 20; ++i) verdict.good = verdict.good && along(dice.direction<D>()) < flush;
    return verdict;
  }
  verdict.good = std::abs(c.normal.norm() - 1) < 1e-12 && along(c.normal) < c.gap + 1e-9 &&
                 (polytopes || along(c.normal) > c.gap - flush);
  const double again = feature_gap(scratch(), a, c.feature, b, c.against, c.normal);
  verdict.good = verdict.good && (polytopes || std::abs(again - c.gap) < flush);
  // Two polytopes are measured along the face or edge pair that separates most: less than their distance.
  for (int i = 0; i < 20 && (c.gap <= 0 || !polytopes); ++i)
    verdict.good = verdict.good && along(dice.direction<D>()) <= c.gap + flush;
  if (c.gap > 0 && !polytopes) {
    const auto local = [](const auto& placed, const Vec<D>& at) {
      return placed.pose.r.inverse(at - placed.pose.x);
    };
    const double error = std::max({std::abs(along(c.normal) - c.gap),
                                   outside(a.shape, local(a, c.point + 0.5 * c.gap * c.normal)),
                                   outside(b.shape, local(b, c.point - 0.5 * c.gap * c.normal))});
    // Of shapes that are far apart, 1 place in 10,000 is some millimetres off; contacts are asked for within
    // 1 mm.
    verdict.good = verdict.good && (error < flush || c.gap > far_apart);
    verdict.tight = error < 1e-9;
  }
  return verdict;
}

template <int D>
void try_pairs(int placements) {
  Dice dice;
  const LuaSession session(FLYROCK_SHARE_DIR);
  const auto shapes = solid_shapes<D>(session);
  for (const Named<D>& first : shapes)
    for (const Named<D>& second : shapes) {
      INFO(first.name << " against " << second.name);
      int wrong = 0, tight = 0;
      for (int i = 0; i < placements; ++i) {
        const Placed<D> a{first.contactor, {dice(0.3, 1.6) * dice.direction<D>(), dice.flush_rotation<D>()}};
        const Placed<D> b{second.contactor, {Vec<D>::Zero(), dice.flush_rotation<D>()}};
        const Verdict verdict = judge<D>(dice, a, b);
        wrong += !verdict.good;
        tight += verdict.tight;
      }
      CHECK(wrong == 0);
      CHECK(tight >= 0.97 * placements);
    }
}

}  // namespace

TEST_CASE(
    "every pair of solid shapes has the gap, the normal and the places that bounds of the distance allow") {
  try_pairs<2>(40);
  try_pairs<3>(25);
}

TEST_CASE("the same for 10,000 placements of each pair", "[heavy]") {
  try_pairs<2>(10000);
  try_pairs<3>(10000);
}

}  // namespace shape_pairs_test
