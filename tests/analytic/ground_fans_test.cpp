// Bodies on apexes, saddles and pits of 3 to 9 facets.
#include <catch2/catch.hpp>
#include <map>

#include "analytic/lab_ground.h"
#include "collision/pairs.h"
#include "geometry/ground.h"
#include "scratch.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

/// A fan of n facets about the origin, 10 m wide: an apex (rise < 0), a pit (rise > 0) or, with `saddle`, one
/// that rises and falls in turn. Each facet is cut into `parts` x `parts` facets of its own plane.
Mesh fan(int n, double rise, bool saddle, int parts) {
  constexpr double radius = 10;
  std::vector<Vec3> rim;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + 0.3) / n;
    const double z = saddle && i % 2 == 1 ? -rise : rise;
    rim.push_back({radius * std::cos(angle), radius * std::sin(angle), radius * z});
  }
  Mesh mesh;
  mesh.parts = {""};
  std::map<std::array<int, 3>, int> known;  // by ray, share along it, share towards the next ray
  const auto vertex = [&](int ray, int out, int across) {
    if (across == out && out > 0) ray = (ray + 1) % n, across = 0;
    if (out == 0) ray = across = 0;
    const auto [at, fresh] = known.insert({{ray, out, across}, static_cast<int>(mesh.vertices.size())});
    if (fresh) {
      const Vec3 &a = rim[ray], &b = rim[(ray + 1) % n];
      mesh.vertices.push_back(static_cast<double>(out - across) / parts * a +
                              static_cast<double>(across) / parts * b);
    }
    return at->second;
  };
  for (int ray = 0; ray < n; ++ray)
    for (int out = 0; out < parts; ++out)
      for (int across = 0; across <= out; ++across) {
        mesh.triangles.push_back(
            {vertex(ray, out, across), vertex(ray, out + 1, across), vertex(ray, out + 1, across + 1)});
        if (across < out)
          mesh.triangles.push_back(
              {vertex(ray, out, across), vertex(ray, out + 1, across + 1), vertex(ray, out, across + 1)});
      }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// Where a body comes to that slides over the middle of a fan within 2 s.
Vec3 slides_over(const Mesh& mesh, int kind) {
  const Terrain3 terrain(mesh);
  Material material(0, 0.1);
  Bench3 bench(mesh, material);
  Body<3> body = body_of_kind(kind, 0.3);
  body.x = {-3, 0.05, terrain.ground().height(-3, 0.05).value() + 0.45};
  body.v = {4, 0, 0};
  bench.add(body);
  bench.run_settings.stop_speed = 0;
  const BodyHistory& history = bench.run(2);
  CHECK(history.reason == StopReason::timed_out);
  CHECK(bench.world.quality().energy_gained <= 1e-4 * body.mass * 9.81 * body.size);
  CHECK(terrain.ground().depth(bench.world.bodies[0].x) <= 0);
  return bench.world.bodies[0].x;
}

}  // namespace

TEST_CASE("facets cut into smaller ones of their planes change nothing, also over the middle of a fan",
          "[slow]") {
  const int kind = GENERATE(0, 1, 2), facets = GENERATE(range(3, 10));
  const int form = GENERATE(0, 1, 2);  // apex, pit, saddle
  CAPTURE(kind, facets, form);
  const double rise = form == 0 ? -0.1 : 0.05;
  const Vec3 whole = slides_over(fan(facets, rise, form == 2, 1), kind);
  const Vec3 cut = slides_over(fan(facets, rise, form == 2, 3), kind);
  // Boxes and polyhedra tumble over 8 m: what rounding changes grows with each of their impacts.
  CHECK((whole - cut).norm() < (kind == 0 ? 1e-8 : 2e-2));
}

TEST_CASE("a sphere on an apex has one contact, whose normal lies in the fan") {
  const int facets = GENERATE(range(3, 10));
  CAPTURE(facets);
  const Terrain3 terrain(fan(facets, -0.5, false, 1));
  const Contactor3 ball = Contactor3::sphere(0.3);
  std::vector<ContactPoint<3>> contacts;
  const Vec3 away = Vec3(0.05, -0.02, 1).normalized();
  terrain_contacts<3>(scratch(), {ball, {0.3 * away, {}}}, terrain, 1e-6, 0, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK((contacts[0].normal - away).norm() < 1e-12);
  CHECK(std::abs(contacts[0].gap) < 1e-12);
  CHECK(kind_of(contacts[0].against) == FeatureKind::vertex);
}

TEST_CASE("a box that stands on an apex has one contact there") {
  const int facets = GENERATE(range(3, 10));
  CAPTURE(facets);
  const Terrain3 terrain(fan(facets, -0.5, false, 1));
  const Contactor3 cube = Contactor3::box({1, 1, 1});
  std::vector<ContactPoint<3>> contacts;
  terrain_contacts<3>(scratch(), {cube, {{0.1, 0.05, 0.5}, {}}}, terrain, 1e-6, 0, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK((contacts[0].normal - Vec3::UnitZ()).norm() < 1e-12);
  CHECK(kind_of(contacts[0].feature) == FeatureKind::face);
  CHECK(kind_of(contacts[0].against) == FeatureKind::vertex);
}

TEST_CASE("a face that lies on two peaks has a contact with each") {
  Mesh mesh = mesh_of([](double, double) { return 0.0; }, 2, 8);
  for (Vec3& v : mesh.vertices)
    if (std::abs(v.y()) < 0.1 && std::abs(std::abs(v.x()) - 0.5) < 0.1) v.z() = 0.3;
  const Terrain3 terrain(mesh);
  std::vector<ContactPoint<3>> contacts;
  terrain_contacts<3>(scratch(), {Contactor3::box({2, 1, 1}), {{0.1, 0.05, 0.8}, {}}}, terrain, 1e-6, 0,
                      contacts);
  REQUIRE(contacts.size() == 2);
  for (const ContactPoint<3>& contact : contacts) CHECK(std::abs(contact.gap) < 1e-12);
}

TEST_CASE("a box that hangs over a crest is held by its two edges there") {
  Profile crest;
  crest.points = {{-10, 0}, {0, 0}, {1, -3}, {10, -3}};
  crest.part = {0, 0, 0};
  crest.parts = {""};
  const Terrain3 terrain(extruded(crest, 5, 3));
  const Contactor3 cube = Contactor3::box({1, 1, 1});
  std::vector<ContactPoint<3>> contacts;
  terrain_contacts<3>(scratch(), {cube, {{-0.1, 0.2, 0.5}, {}}}, terrain, 1e-6, 0, contacts);
  REQUIRE(contacts.size() == 4);
  int on_crest = 0;
  for (const ContactPoint<3>& contact : contacts) {
    CHECK((contact.normal - Vec3::UnitZ()).norm() < 1e-9);
    on_crest += std::abs(contact.point.x()) < 1e-9;
  }
  CHECK(on_crest == 2);
}
