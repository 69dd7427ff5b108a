// The tree of balls finds what trying all parts finds, with a few of them.

#include "collision/part_tree.h"

#include <catch2/catch.hpp>

#include "collision/pairs.h"
#include "placed_shapes.h"
#include "scratch.h"

using namespace flyrock;

namespace {

void place(Contactor2& part, const Vec2& at) { part.translate(at); }
void place(Contactor3& part, const Vec3& at) { part.change_frame(-at, {}); }

/// A part of 3 to 10 cm: a polytope or a ball, in 3D also a pill or a cylinder.
Contactor2 some_part(Dice& dice, Vec2) {
  const double a = dice(0.03, 0.1), b = dice(0.03, 0.1);
  if (dice(0, 2) < 1) return Contactor2::disk(a);
  return Contactor2::polygon({{-a, -b}, {a, -b}, {a, b}, {-a, b}});
}
Contactor3 some_part(Dice& dice, Vec3) {
  const double a = dice(0.03, 0.1), b = dice(0.03, 0.1), c = dice(0.03, 0.1);
  switch (static_cast<int>(dice(0, 4))) {
    case 0:
      return Contactor3::sphere(a);
    case 1:
      return Contactor3::pill({-b, 0, 0}, {b, 0, 0}, a);
    case 2:
      return Contactor3::cylinder(a, b);
    default:
      return Contactor3::box({a, b, c});
  }
}

/// Parts at random places of a ball of 1 m.
template <int D>
std::vector<typename Geometry<D>::Contactor> many_parts(Dice& dice, int count) {
  std::vector<typename Geometry<D>::Contactor> parts;
  for (int i = 0; i < count; ++i) {
    parts.push_back(some_part(dice, Vec<D>()));
    place(parts.back(), dice(0, 1) * dice.template direction<D>());
  }
  return parts;
}

template <int D>
bool same(const std::vector<ContactPoint<D>>& a, const std::vector<ContactPoint<D>>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ContactPoint<D>& p, const ContactPoint<D>& q) {
                      return p.feature == q.feature && p.against == q.against && p.gap == q.gap;
                    });
}

template <int D>
void compare_bodies(int placements) {
  Dice dice;
  const auto parts_a = many_parts<D>(dice, 60), parts_b = many_parts<D>(dice, 25);
  const PartTree<D> a(parts_a), b(parts_b);
  std::vector<std::pair<int, int>> pairs;
  std::size_t tried = 0, met = 0;
  for (int i = 0; i < placements; ++i) {
    const typename Geometry<D>::Pose pose_a{Vec<D>::Zero(), dice.flush_rotation<D>()};
    const typename Geometry<D>::Pose pose_b{dice(0.8, 2.1) * dice.template direction<D>(),
                                            dice.flush_rotation<D>()};
    const double reach = dice(0, 0.05);
    std::vector<ContactPoint<D>> all, near;
    const auto add = [&](int k, int l, auto& list) {
      body_contacts(scratch(), Placed<D>{parts_a[k], pose_a, k}, Placed<D>{parts_b[l], pose_b, l}, reach,
                    list);
    };
    for (int k = 0; k < a.parts(); ++k)
      for (int l = 0; l < b.parts(); ++l) add(k, l, all);
    near_parts(scratch(), a, pose_a, b, pose_b, reach, pairs);
    for (const auto& [k, l] : pairs) add(k, l, near);
    REQUIRE(same<D>(all, near));
    tried += pairs.size();
    met += !all.empty();
  }
  CHECK(met > 0.2 * placements);
  CHECK(tried < 0.05 * placements * a.parts() * b.parts());
}

template <int D>
void compare_ground(const typename Geometry<D>::Terrain& ground, int placements) {
  Dice dice;
  const auto parts = many_parts<D>(dice, 60);
  const PartTree<D> tree(parts);
  std::vector<int> found;
  std::size_t tried = 0, met = 0;
  for (int i = 0; i < placements; ++i) {
    typename Geometry<D>::Pose pose{Vec<D>::Zero(), dice.flush_rotation<D>()};
    pose.x[0] = dice(-4, 4);
    pose.x[D - 1] = dice(0.5, 2);
    const double reach = dice(0, 0.05);
    std::vector<ContactPoint<D>> all, near;
    const auto add = [&](int k, auto& list) {
      terrain_contacts(scratch(), Placed<D>{parts[k], pose, k}, ground, reach, 0, list);
    };
    for (int k = 0; k < tree.parts(); ++k) add(k, all);
    near_parts(scratch(), tree, pose, ground, reach, found);
    for (const int k : found) add(k, near);
    REQUIRE(same<D>(all, near));
    tried += found.size();
    met += !all.empty();
  }
  CHECK(met > 0.2 * placements);
  CHECK(tried < 0.3 * placements * tree.parts());
}

}  // namespace

TEST_CASE("The tree of parts finds all contacts of two bodies") {
  compare_bodies<2>(300);
  compare_bodies<3>(100);
}

TEST_CASE("The tree of parts finds all contacts with the ground") {
  const std::vector<Vec2> line{{-10, 0.5}, {-1, 0}, {0.2, 0.6}, {0.3, -0.4}, {3, 0}, {10, 1}};
  compare_ground<2>(Terrain2(Profile{line, {0, 0, 0, 0, 0}, {"line"}, {}}), 300);
  compare_ground<3>(Terrain3(Plane{Vec3::Zero(), Vec3(0.1, 0, 1).normalized()}), 100);
  Mesh hills;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double x = i - 10, y = j - 10;
      hills.vertices.push_back({x, y, 0.4 * std::sin(2 * x) * std::cos(y)});
    }
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const int at = 21 * i + j;
      hills.triangles.push_back({at, at + 21, at + 22});
      hills.triangles.push_back({at, at + 22, at + 1});
    }
  hills.part.assign(hills.triangles.size(), 0);
  hills.parts = {"hills"};
  compare_ground<3>(Terrain3(std::move(hills)), 100);
}

TEST_CASE("Of a body of few parts, all are tried") {
  Dice dice;
  std::vector<std::pair<int, int>> pairs;
  const PartTree<2> a(many_parts<2>(dice, 3)), b(many_parts<2>(dice, 2));
  near_parts(scratch(), a, {}, b, {{100, 0}, {}}, 0, pairs);
  CHECK(pairs == std::vector<std::pair<int, int>>{{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}});
}
