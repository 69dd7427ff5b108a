// What the meshes of exporters become, compared with the ground that they were made from.

#include "survey/mesh_repair.h"

#include <catch2/catch.hpp>

#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "samples.h"
#include "survey/mesh_gaps.h"
#include "surveyed_meshes.h"

using namespace flyrock;

namespace mesh_repair_test {

using namespace surveyed_meshes;

namespace {

std::vector<MeshFault> all_faults(const Mesh& mesh) {
  std::vector<MeshFault> found = faults(mesh);
  for (MeshFault& gap : gap_faults(mesh)) found.push_back(std::move(gap));
  return found;
}

std::string texts(const std::vector<MeshFault>& found) {
  std::string text;
  for (const MeshFault& fault : found) text += fault.text + "\n";
  return text;
}

bool has(const std::vector<MeshFault>& found, MeshFault::Kind kind) {
  return std::any_of(found.begin(), found.end(), [&](const MeshFault& fault) { return fault.kind == kind; });
}

/// The mesh after its mending, which must be ground.
Mesh mended(Mesh mesh, const MeshRepair& repair = {}) {
  mesh = welded(std::move(mesh));
  std::vector<int> lines;
  mend(mesh, lines, repair);
  CHECK(texts(all_faults(mesh)) == "");
  return mesh;
}

/// Both meshes have one surface, at the same heights to `tolerance`.
void check_same_ground(const Mesh& read, const Mesh& made, const Sheet& sheet, double tolerance,
                       RandomStream& rng) {
  for (int i = 0; i < 20; ++i) {
    const Vec2 place = place_on(sheet, rng);
    const auto is = heights_at(read, place), was = heights_at(made, place);
    REQUIRE(was.size() == 1);
    REQUIRE(is.size() == 1);
    CHECK(std::abs(is[0] - was[0]) <= tolerance);
  }
}

/// Adds a triangle without an area on the edge of a triangle: two equal corners, or three on a line, with the
/// neighbour across the edge.
void add_flat(Mesh& mesh, RandomStream& rng) {
  const auto t =
      static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(mesh.triangles.size()) - 1));
  const auto c = mesh.triangles[t];
  mesh.part.push_back(0);
  if (rng.uniform() < 0.5) {
    mesh.triangles.push_back({c[0], c[0], c[1]});
    return;
  }
  // The corner between splits this triangle; the flat one closes the step to its neighbour.
  const auto middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(0.5 * (mesh.vertices[c[0]] + mesh.vertices[c[1]]));
  mesh.triangles[t] = {c[0], middle, c[2]};
  mesh.triangles.push_back({middle, c[1], c[2]});
  mesh.part.push_back(0);
  mesh.triangles.push_back({c[0], c[1], middle});
}

}  // namespace

TEST_CASE(
    "clockwise sheets, doubled triangles and triangles without area give the ground that was surveyed") {
  for (int seed = 0; seed < samples(300); ++seed) {
    CAPTURE(seed);
    RandomStream rng = dice(seed);
    const Sheet sheet = random_sheet(rng);
    const Mesh made = sheet.mesh();
    Mesh mesh = made;
    if (rng.uniform() < 0.6)
      for (int i = 0; i < 3; ++i) add_flat(mesh, rng);
    if (rng.uniform() < 0.5)
      for (int i = 0; i < 2; ++i) {
        mesh.triangles.push_back(mesh.triangles[static_cast<std::size_t>(rng.integer(0, 9))]);
        mesh.part.push_back(0);
      }
    if (rng.uniform() < 0.5) turn_over(mesh);
    check_same_ground(mended(mesh), made, sheet, 1e-6, rng);
  }
}

TEST_CASE("a sheet with every triangle twice, facing up and down, is one that faces up") {
  RandomStream rng = dice(1);
  const Sheet sheet = random_sheet(rng);
  const Mesh made = sheet.mesh();
  Mesh down = made;
  turn_over(down);
  Mesh both = down;
  append(both, made);
  check_same_ground(mended(both), made, sheet, 1e-9, rng);
}

TEST_CASE("pieces that miss each other are refused, and weld joins them to what was surveyed") {
  for (int seed = 0; seed < samples(300); ++seed) {
    CAPTURE(seed);
    RandomStream rng = dice(1000 + seed);
    Sheet whole = random_sheet(rng);
    whole.columns = 8;
    Sheet west = whole, east = whole;
    west.columns = 4;
    east.columns = 4;
    east.corner.x() += 4 * whole.cell;
    const bool is_finer = rng.uniform() < 0.4;  // its vertices lie between those of the other
    if (is_finer) {
      whole.hill = west.hill = east.hill = 0;
      east.cell /= 2;
      east.columns *= 2;
      east.rows *= 2;
    }
    const double gap = std::pow(10.0, rng.uniform(-4, -2));  // m
    const Vec3 away = Vec3(rng.uniform(), rng.uniform(-0.3, 0.3), rng.uniform(-1, 1)).normalized() * gap;
    Mesh moved = east.mesh();
    for (Vec3& vertex : moved.vertices) vertex += away;
    Mesh mesh = west.mesh();
    append(mesh, moved);
    if (rng.uniform() < 0.3) turn_over(mesh);

    Mesh unwelded = welded(mesh);
    std::vector<int> lines;
    mend(unwelded, lines, {});
    const std::vector<MeshFault> found = all_faults(unwelded);
    REQUIRE(has(found, MeshFault::Kind::gap));
    double width = 0;
    for (const MeshFault& fault : found) width = std::max(width, fault.size);
    CHECK(width <= gap * 1.000001);
    CHECK(width >= 0.05 * gap);

    const Mesh joined = mended(mesh, {.weld = 1.1 * gap});
    check_same_ground(joined, whole.mesh(), whole, 3 * gap, rng);
  }
}

TEST_CASE("a slit inside of one piece is refused") {
  Mesh mesh = Sheet{}.mesh();
  // One vertex inside is two, 2 mm apart, for the triangles to both sides.
  const int inside = 7 * 2 + 3, copy = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back(mesh.vertices[inside] + Vec3(0.002, 0, 0));
  for (auto& t : mesh.triangles)
    for (int& corner : t) {
      const double mean = (mesh.vertices[t[0]].x() + mesh.vertices[t[1]].x() + mesh.vertices[t[2]].x()) / 3;
      if (corner == inside && mean > mesh.vertices[inside].x()) corner = copy;
    }
  CHECK(!all_faults(welded(mesh)).empty());
}

TEST_CASE("topography and pit shell in one file are refused with the place, or the largest is kept") {
  for (int seed = 0; seed < samples(100); ++seed) {
    CAPTURE(seed);
    RandomStream rng = dice(2000 + seed);
    Sheet topography = random_sheet(rng);
    topography.columns = topography.rows = 8;
    Sheet shell = topography;
    shell.cell *= rng.uniform(0.2, 0.45);
    shell.corner += topography.cell * Vec2(rng.uniform(0.5, 3), rng.uniform(0.5, 3));
    Mesh below = shell.mesh();
    const double depth = rng.uniform(-30, 30);
    for (Vec3& vertex : below.vertices) vertex.z() += depth;
    Mesh mesh = topography.mesh();
    append(mesh, below);
    const auto found = all_faults(welded(mesh));
    REQUIRE(has(found, MeshFault::Kind::over));
    CHECK(texts(found).find("two surfaces lie over each other at (") == 0);
    check_same_ground(mended(mesh, {.keep_largest = true}), topography.mesh(), topography, 1e-9, rng);
  }
}

TEST_CASE("a closed rock on the ground and tiles far apart are no fault") {
  Mesh mesh = Sheet{}.mesh();
  Mesh rock;
  rock.vertices = {{4, 4, 45}, {6, 4, 45}, {6, 6, 45}, {4, 6, 45}, {5, 5, 47}};
  rock.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
  append(mesh, rock);
  Sheet far;
  far.corner = {30, 0};
  append(mesh, far.mesh());
  CHECK(texts(all_faults(welded(mesh))) == "");
}

TEST_CASE("skirts of tiles are dropped, upright walls of the ground stay") {
  for (int seed = 0; seed < samples(100); ++seed) {
    CAPTURE(seed);
    RandomStream rng = dice(3000 + seed);
    Sheet whole = random_sheet(rng);
    whole.columns = whole.rows = 6;
    Mesh mesh;
    mesh.parts = {""};
    for (int tile = 0; tile < 4; ++tile) {
      Sheet part = whole;
      part.columns = part.rows = 3;
      part.corner += 3 * whole.cell * Vec2(tile % 2, tile / 2);
      Mesh piece = part.mesh();
      // A strip of upright triangles below each edge of the outline.
      const std::size_t triangles = piece.triangles.size();
      std::map<int, int> below;
      const auto low = [&](int v) {
        const auto [found, is_new] = below.try_emplace(v, static_cast<int>(piece.vertices.size()));
        if (is_new) piece.vertices.push_back(piece.vertices[static_cast<std::size_t>(v)] - Vec3(0, 0, 2));
        return found->second;
      };
      const auto across = neighbours_of(piece.triangles, sorted_sides(piece.triangles));
      for (std::size_t t = 0; t < triangles; ++t)
        for (int k = 0; k < 3; ++k) {
          if (across[t][static_cast<std::size_t>(k)] >= 0) continue;
          const int a = piece.triangles[t][static_cast<std::size_t>(k)],
                    b = piece.triangles[t][static_cast<std::size_t>((k + 1) % 3)];
          piece.triangles.insert(piece.triangles.end(), {{b, a, low(a)}, {b, low(a), low(b)}});
          piece.part.insert(piece.part.end(), {0, 0});
        }
      append(mesh, piece);
    }
    check_same_ground(mended(mesh), whole.mesh(), whole, 1e-9, rng);
  }
  // A step: two levels and the wall between them.
  Mesh step;
  step.parts = {""};
  step.vertices = {{0, 0, 5}, {0, 4, 5}, {4, 0, 5}, {4, 4, 5}, {4, 0, 1}, {4, 4, 1}, {8, 0, 1}, {8, 4, 1}};
  step.triangles = {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}, {4, 6, 7}, {4, 7, 5}};
  step.part.assign(6, 0);
  CHECK(mended(step).triangles.size() == 6);
}

TEST_CASE("a hole is refused with its edges, and filled where that is allowed") {
  for (int seed = 0; seed < samples(100); ++seed) {
    CAPTURE(seed);
    RandomStream rng = dice(4000 + seed);
    Sheet sheet = random_sheet(rng);
    sheet.columns = sheet.rows = 8;
    sheet.hill = 0;  // what fills a hole in a plane is the plane
    const Mesh made = sheet.mesh();
    Mesh mesh = made;
    const auto cell = static_cast<std::size_t>(8 * rng.integer(2, 5) + rng.integer(2, 5));
    const auto count = static_cast<std::size_t>(2 * rng.integer(1, 2));
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(2 * cell),
                         mesh.triangles.begin() + static_cast<std::ptrdiff_t>(2 * cell + count));
    mesh.part.resize(mesh.triangles.size());
    const auto found = all_faults(welded(mesh));
    REQUIRE(has(found, MeshFault::Kind::hole));
    CHECK(found.front().size == (count == 2 ? 4 : 6));
    check_same_ground(mended(mesh, {.fill_holes = static_cast<int>(found.front().size)}), made, sheet, 1e-9,
                      rng);
  }
}

TEST_CASE("what was mended is said with how often and where") {
  Mesh mesh = Sheet{.columns = 2, .rows = 1, .hill = 0}.mesh();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.part.assign(mesh.triangles.size(), 0);
  turn_over(mesh);
  std::vector<int> lines = {7, 8, 9, 10, 11, 12};
  const std::vector<std::string> notes = mend(mesh, lines, {});
  CHECK(notes == std::vector<std::string>{
                     "dropped 1 triangle with the corners of another one (line 12)",
                     "dropped 1 triangle without an area (line 11), the first with a corner at (0, 0, 40)",
                     "turned the surface over: its corners are clockwise, seen from above (4 triangles)"});
  CHECK(lines == std::vector<int>{7, 8, 9, 10});
}

}  // namespace mesh_repair_test
