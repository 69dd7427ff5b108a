// Every solid shape against every kind of ground: contacts at random placements, against the lowest place of
// the shape over a level, and against its distance from each triangle of a hilly solid.

#include <catch2/catch.hpp>

#include "analytic/lab_ground.h"
#include "collision/outline/outline.h"
#include "collision/pairs.h"
#include "collision/smooth/gjk.h"
#include "geometry/ground.h"
#include "indexed.h"
#include "nearest_contact.h"
#include "placed_shapes.h"
#include "scratch.h"

using namespace flyrock;

namespace {

constexpr double within = 0.05;  // m, of which contacts are asked for

/// Places each shape so that its lowest place is up to 0.2 mm below or 3 cm above the level 0.
template <int D, class Ground>
void try_level(const Ground& ground, int placements) {
  Dice dice;
  const LuaSession session(FLYROCK_SHARE_DIR);
  const Vec<D> up = Vec<D>::Unit(D - 1);
  for (const Named<D>& shape : solid_shapes<D>(session)) {
    INFO(shape.name);
    int wrong = 0;
    for (int i = 0; i < placements; ++i) {
      Placed<D> placed{shape.contactor, {Vec<D>::Zero(), dice.flush_rotation<D>()}};
      const double gap = dice(-2e-4, 0.03), low = reach(shape.contactor, placed.pose.r.inverse(-up));
      for (int k = 0; k < D - 1; ++k) placed.pose.x[k] = dice(-3, 3);
      placed.pose.x[D - 1] = low + gap;
      std::vector<ContactPoint<D>> contacts;
      terrain_contacts(scratch(), indexed(placed, 1), ground, within, 0, contacts);
      if (contacts.empty()) {
        ++wrong;
        continue;
      }
      const ContactPoint<D>& c = nearest_of(contacts);
      const bool good =
          std::abs(c.gap - gap) < 1e-9 && (c.normal - up).norm() < 1e-12 &&
          std::abs(c.point[D - 1] - 0.5 * gap) < 1e-9 &&
          std::abs(feature_gap(scratch(), placed, c.feature, ground, c.against, c.normal) - gap) < 1e-9;
      wrong += !good;
    }
    CHECK(wrong == 0);
  }
}

void try_levels(int placements) {
  const lab::Height level = [](double, double) { return 0.0; };
  try_level<2>(Terrain2(lab::ground(5)), placements);
  try_level<2>(Terrain2(lab::ground(5, 0, 40)), placements);
  try_level<3>(Terrain3(Plane{}), placements);
  try_level<3>(Terrain3(lab::mesh_of(level, 5, 12, 0.3)), placements);
  try_level<3>(Terrain3(lab::grid_of(level, 5, 12)), placements);
}

/// A triangle as a core of three points.
Contactor3 triangle(const Mesh& mesh, const std::array<int, 3>& corners) {
  Contactor3 shape = Contactor3::sphere(0);
  shape.points = {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
  for (const Vec3& point : shape.points) shape.bound = std::max(shape.bound, point.norm());
  return shape;
}

/// The distance of a shape from the triangles of a mesh [m].
double distance_from(const Placed3& placed, const std::vector<Contactor3>& triangles) {
  double least = 1e300;
  for (const Contactor3& one : triangles) {
    const Placed3 other{one, {}};
    least = std::min(least, separation(placed, other).distance - placed.shape.radius);
  }
  return least;
}

/// Contacts with a hilly solid as terrain and as a surface that is turned. No contact is nearer than the
/// shape; of a round shape the nearest contact is as far as the shape. A polyhedron has none where a vertex
/// faces an edge or a peak.
void try_hills(int placements) {
  Dice dice;
  const LuaSession session(FLYROCK_SHARE_DIR);
  const Mesh mesh = lab::hilly_block();
  const Terrain3 terrain{TerrainShape3(mesh)};
  const Contactor3 solid = Contactor3::solid(mesh);
  std::vector<Contactor3> triangles;
  for (const auto& corners : mesh.triangles) triangles.push_back(triangle(mesh, corners));
  for (const Named<3>& shape : solid_shapes<3>(session)) {
    INFO(shape.name);
    int wrong = 0, judged = 0;
    for (int i = 0; i < placements; ++i) {
      Placed3 placed{shape.contactor, {Vec3(dice(-5, 5), dice(-5, 5), 0), dice.flush_rotation<3>()}};
      placed.pose.x.z() = 5;
      if (terrain.ground().depth(placed.pose.x) > 0) continue;
      // Down to a random distance of up to 4 cm
      const double wanted = dice(1e-4, 0.04);
      double distance = distance_from(placed, triangles);
      for (int k = 0; k < 60 && std::abs(distance - wanted) > 1e-6; ++k) {
        placed.pose.x.z() -= 0.9 * (distance - wanted);
        distance = distance_from(placed, triangles);
      }
      if (distance < 1e-5 || distance > within - 1e-3) continue;
      ++judged;
      std::vector<ContactPoint<3>> contacts, turned;
      terrain_contacts(scratch(), indexed(placed, 1), terrain, within, 0, contacts);
      const Pose3 frame{10 * dice.direction<3>(), dice.flush_rotation<3>()};
      const Placed3 there{shape.contactor, {frame * placed.pose.x, frame.r * placed.pose.r}};
      body_contacts(scratch(), indexed(there, 1), {solid, frame, 2}, within, turned);
      bool good = contacts.size() == turned.size();
      for (std::size_t c = 0; c < contacts.size() && good; ++c)
        good = contacts[c].gap > distance - 1e-9 && std::abs(contacts[c].gap - turned[c].gap) < 1e-9 &&
               (frame * contacts[c].point - turned[c].point).norm() < 1e-6 &&
               (frame.r * contacts[c].normal - turned[c].normal).norm() < 1e-6;
      if (shape.contactor.faces.empty())
        good = good && !contacts.empty() && nearest_of(contacts).gap < distance + 1e-6;
      wrong += !good;
    }
    CHECK(judged > 0.5 * placements);
    CHECK(wrong == 0);
  }
}

}  // namespace

TEST_CASE("over a level ground every solid shape has the gap of its lowest place") { try_levels(100); }

TEST_CASE("over a hilly solid no contact is nearer than the shape, as terrain and as a surface") {
  try_hills(12);
}

TEST_CASE("the same for 10,000 placements over level ground and 1000 over hills", "[heavy]") {
  try_levels(10000);
  try_hills(1000);
}
