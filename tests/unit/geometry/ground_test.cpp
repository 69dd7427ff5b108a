// The ground in 3D answers the same questions as a plane, as a mesh and as a grid.
#include "geometry/ground.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "geometry/grid_ground.h"
#include "samples.h"

using namespace flyrock;

namespace ground_test {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Heights of a bumpy surface at (x, y).
double bumps(double x, double y) { return std::sin(2 * x) * std::cos(1.3 * y) + 0.2 * x; }

HeightGrid grid(int columns = 41, int rows = 33, double cell = 0.25) {
  HeightGrid shape;
  shape.columns = columns;
  shape.rows = rows;
  shape.cell = cell;
  shape.corner = {-3, 2};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) shape.heights.push_back(bumps(-3 + c * cell, 2 + r * cell));
  return shape;
}

/// The same triangles as those of a grid; with its apron, they have the same ids.
Mesh mesh_of(const HeightGrid& grid, bool with_apron = false) {
  Mesh mesh;
  mesh.parts = {""};
  const int out = with_apron ? 1 : 0, columns = grid.columns + 2 * out, rows = grid.rows + 2 * out;
  const auto coordinate = [&](double corner, int k, int count) {
    return corner + std::clamp(k, 0, count - 1) * grid.cell +
           (k < 0       ? -GridGround::apron
            : k < count ? 0
                        : GridGround::apron);
  };
  for (int r = -out; r < grid.rows + out; ++r)
    for (int c = -out; c < grid.columns + out; ++c)
      mesh.vertices.push_back({coordinate(grid.corner.x(), c, grid.columns),
                               coordinate(grid.corner.y(), r, grid.rows),
                               grid.at(std::clamp(c, 0, grid.columns - 1), std::clamp(r, 0, grid.rows - 1))});
  for (int r = 0; r + 1 < rows; ++r)
    for (int c = 0; c + 1 < columns; ++c) {
      const int sw = r * columns + c, nw = sw + columns;
      mesh.triangles.push_back({sw, sw + 1, nw + 1});
      mesh.triangles.push_back({sw, nw + 1, nw});
    }
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

/// A cave: a floor at z = 0, and over its right half a block from z = 2 to z = 3.
Mesh cave() {
  Mesh mesh;
  mesh.parts = {""};
  const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& v : {a, b, c, d}) mesh.vertices.push_back(v);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  };
  quad({-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0});
  quad({0, -5, 3}, {5, -5, 3}, {5, 5, 3}, {0, 5, 3});
  quad({0, 5, 2}, {5, 5, 2}, {5, -5, 2}, {0, -5, 2});  // faces down
  quad({0, -5, 2}, {0, -5, 3}, {0, 5, 3}, {0, 5, 2});
  mesh.part.assign(mesh.triangles.size(), 0);
  return mesh;
}

}  // namespace

TEST_CASE("a grid and the mesh of its triangles give the same facets") {
  const auto of_grid = make_ground(grid()), of_mesh = make_ground(mesh_of(grid(), true));
  CHECK(of_grid->whole());
  CHECK(of_mesh->whole());
  CHECK(!of_mesh->overhangs());
  std::mt19937 rng(1);
  std::uniform_real_distribution<double> random(-4, 11);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a(random(rng), random(rng), random(rng) / 4 - 1),
        b = a + Vec3(random(rng), random(rng), 1) / 8;
    const Box3 box{a.cwiseMin(b), a.cwiseMax(b)};
    std::vector<Facet> x, y;
    of_grid->facets(box, x);
    of_mesh->facets(box, y);
    std::vector<Facet> triangles;
    of_grid->triangles(box, triangles);
    REQUIRE(x.size() == y.size());
    CHECK(of_grid->count(box, 5) == std::min<int>(5, static_cast<int>(x.size())));
    CHECK(of_mesh->count(box, 5) == std::min<int>(5, static_cast<int>(x.size())));
    for (std::size_t k = 0; k < x.size(); ++k) {
      CHECK(x[k].id == y[k].id);
      CHECK(x[k].rim == y[k].rim);
      CHECK(x[k].edge == y[k].edge);
      CHECK(x[k].vertex == y[k].vertex);
      CHECK((x[k].normal - y[k].normal).norm() < 1e-12);
      for (int rim = 0; rim < 3; ++rim)
        if (x[k].rim[rim] == Rim::convex) CHECK((x[k].beyond[rim] - y[k].beyond[rim]).norm() < 1e-12);
    }
    // Triangles are those without the apron.
    const Vec3 &low = of_grid->extent().low, &high = of_grid->extent().high;
    const auto is_outside = [&](const Facet& f) {
      const Vec3 middle = (f.corner[0] + f.corner[1] + f.corner[2]) / 3;
      return (middle.array() < low.array() - 1e-9).head<2>().any() ||
             (middle.array() > high.array() + 1e-9).head<2>().any();
    };
    std::erase_if(x, is_outside);
    REQUIRE(x.size() == triangles.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
      CHECK(triangles[k].id == x[k].id);
      CHECK(triangles[k].vertex == x[k].vertex);
      CHECK(triangles[k].corner == x[k].corner);
      CHECK(triangles[k].normal == x[k].normal);
    }
  }
  int peaks = 0;
  for (std::uint64_t v = 0; v < 43 * 35; ++v) {
    std::vector<Vec3> x, y;
    CHECK(of_grid->peak(v, x) == of_mesh->peak(v, y));
    CHECK(x.size() == y.size());
    peaks += !x.empty();
  }
  CHECK(peaks > 20);
}

TEST_CASE("a path in plan finds the facets under it") {
  const auto of_grid = make_ground(grid()), of_mesh = make_ground(mesh_of(grid(), true));
  std::mt19937 rng(2);
  std::uniform_real_distribution<double> random(0, 1);
  for (int i = 0; i < samples(100); ++i) {
    const Vec2 a(-3 + 10 * random(rng), 2 + 8 * random(rng)), b(-3 + 10 * random(rng), 2 + 8 * random(rng));
    std::vector<Facet> x, y;
    of_grid->triangles_under(a, b, x);
    of_mesh->triangles_under(a, b, y);
    for (double s = 0; s <= 1; s += 1.0 / 256) {
      const Vec2 p = a + s * (b - a);
      const double z = *of_grid->height(p.x(), p.y());
      const auto lies_on = [&](const Facet& triangle) {
        const Facet f = of_grid->facet(triangle.id);
        return (nearest_on(f, {p.x(), p.y(), z}) - Vec3(p.x(), p.y(), z)).norm() < 1e-9;
      };
      CHECK(std::any_of(x.begin(), x.end(), lies_on));
      CHECK(std::any_of(y.begin(), y.end(), lies_on));
    }
  }
}

TEST_CASE(
    "the height of the ground is that of its triangles, there is none beyond it or where data are missing") {
  HeightGrid holed = grid();
  holed.heights[10 * 41 + 12] = nothing;
  const auto ground = make_ground(holed), whole = make_ground(mesh_of(grid()));
  CHECK(!ground->whole());
  CHECK(*whole->height(-3, 2) == bumps(-3, 2));
  CHECK(*whole->height(-2.5, 3) == Approx(bumps(-2.5, 3)).epsilon(1e-14));
  CHECK(*whole->height(-2.375, 3.125) == Approx(0.5 * (bumps(-2.5, 3) + bumps(-2.25, 3.25))).epsilon(1e-12));
  CHECK(!whole->height(-3.001, 3));
  CHECK(!whole->height(0, 10.001));
  CHECK(!ground->height(-3 + 12 * 0.25 + 0.1, 2 + 10 * 0.25 - 0.1));
  CHECK(ground->height(-3 + 14 * 0.25, 2 + 10 * 0.25));
  CHECK(whole->depth({-2.5, 3, bumps(-2.5, 3) - 0.5}) == Approx(0.5));
  CHECK(whole->depth({-2.5, 3, bumps(-2.5, 3) + 0.5}) == 0);
}

TEST_CASE("a grid of one cell continues level beyond its border with its parts, but not beside a hole") {
  HeightGrid shape = grid(2, 2, 1);
  shape.parts = {"west", "east"};
  shape.part = {0, 1, 0, 1};
  const auto at_border = [](const Ground3& ground, double x, double y) {
    std::vector<Facet> found;
    ground.facets({{x - 0.1, y - 0.1, -9}, {x + 0.1, y + 0.1, 9}}, found);
    return found;
  };
  const auto ground = make_ground(shape);
  for (const double y : {1.5, 2.5, 3.5}) {
    const std::vector<Facet> west = at_border(*ground, -9, y), east = at_border(*ground, 9, y);
    REQUIRE(west.size() == 2);
    REQUIRE(east.size() == 2);
    for (const Facet& f : west) CHECK(f.normal.x() == 0);
    CHECK(ground->part(west[0].id) == 0);
    CHECK(ground->part(east[0].id) == 1);
  }
  CHECK(at_border(*ground, -2.5, 2.5).size() == 2);
  CHECK(!ground->height(-3.1, 2.5));
  CHECK(ground->extent().high.x() == -2);
  HeightGrid holed = grid(3, 2, 1);
  holed.heights[5] = nothing;
  const auto beside = make_ground(holed);
  CHECK(at_border(*beside, -9, 2.5).size() == 2);
  CHECK(at_border(*beside, 9, 2.5).empty());
  CHECK(at_border(*beside, -1.5, 1.5).empty());
}

TEST_CASE("under an overhang the ground is what lies below") {
  const auto ground = make_ground(cave());
  CHECK(ground->overhangs());
  CHECK(*ground->height(2, 0) == 3);
  CHECK(ground->crossing({2, 0, 1}, false)->z == 0);
  CHECK(ground->crossing({2, 0, 1}, true)->z == 2);
  CHECK(!ground->crossing({2, 0, 1}, true)->upward);
  CHECK(ground->depth({2, 0, 1}) == 0);
  CHECK(ground->depth({2, 0, 2.25}) == 0.75);
  CHECK(ground->depth({2, 0, 3.5}) == 0);
}

TEST_CASE("edges are flat, concave or convex, and peaks need three convex ones") {
  Mesh roof;
  roof.parts = {""};
  roof.vertices = {{-1, -1, 0}, {0, -1, 1}, {1, -1, 0}, {-1, 1, 0}, {0, 1, 1}, {1, 1, 0}};
  roof.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  roof.part = {0, 0, 0, 0};
  const auto ground = make_ground(roof);
  const Facet f = ground->facet(0);
  CHECK(f.rim == std::array{Rim::open, Rim::convex, Rim::flat});
  CHECK((f.beyond[1] - Vec3(1, 0, 1).normalized()).norm() < 1e-15);
  CHECK(f.names_edge(1));
  CHECK(!ground->facet(3).names_edge(2));
  CHECK(ground->facet(3).edge_feature(2) == f.edge_feature(1));
  for (Vec3& v : roof.vertices) v.z() = -v.z();
  CHECK(make_ground(roof)->facet(0).rim[1] == Rim::concave);
  std::vector<Vec3> edges;
  for (std::uint64_t v = 0; v < 6; ++v) CHECK(!ground->peak(v, edges));
}

TEST_CASE("the features of a grid of 10,000 x 10,000 cells have ids of their own") {
  const Facet last = [] {
    Facet f;
    f.id = 2 * 9999u * 9999u - 1;
    f.edge = {3 * std::uint64_t{f.id} + 2, 0, 0};
    return f;
  }();
  CHECK(ground_index(last.face_feature()) == 199'960'001);
  CHECK(ground_index(last.edge_feature(0)) == 599'880'005);
  CHECK(kind_of(last.edge_feature(0)) == FeatureKind::edge);
}

}  // namespace ground_test
