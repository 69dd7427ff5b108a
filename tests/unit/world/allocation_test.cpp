// The step loop does not allocate: a run of ten seconds allocates as often as one of half a second.
#ifndef __SANITIZE_ADDRESS__  // the sanitizer has its own operators
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "analytic/lab_ground.h"
#include "elastic/elastic_block.h"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

#ifdef __GLIBC__
namespace {
std::atomic<long> blocks_of_memory{0};  // also those of Eigen, which do not come from `new`
}
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++blocks_of_memory;
  return __libc_malloc(size);
}
#endif

using namespace flyrock;
using namespace flyrock::lab;

namespace {

/// Allocations of a run in which a square and a disk fall, bounce, slide and rest on 200 rough segments.
long allocations_of(double seconds, bool exact) {
  Profile profile = ground(100, 0.1, 200);
  for (std::size_t i = 0; i < profile.points.size(); ++i)
    profile.points[i].y() += 0.1 * std::sin(3.0 * static_cast<double>(i));
  Material material(0.4, 0.5, 0.05);
  Bench bench(profile, material);
  bench.add(box(1, 0.7, 1000, {0, 3}, 0.3));
  bench.add(disk(0.4, 1000, {3, 4}, {2, 0}));
  bench.run_settings.exact_flight = exact;
  bench.run_settings.keep_impacts = false;
  bench.run_settings.stop_speed = 0;
  const long before = allocations;
  bench.run(seconds);
  const long during = allocations - before;
  CHECK(bench.world.quality().steps > 100);
  return during;
}

/// The same of a box and a sphere on an incline of space, or on rough triangles.
long allocations_in_space(double seconds, bool exact, bool mesh) {
  Material material(0.4, 0.5, 0.05);
  Bench3 bench(mesh ? TerrainShape3(mesh_of(rough(1, 0.3, 0.1), 20, 60, 0.2)) : plane(0.1, 0.5), material);
  Body<3> tumbling = box({1, 0.7, 0.5}, 1000, {0, 0, 3}, Vec3(0.6, 0, -0.8), Vec3(0.8, 0, 0.6));
  tumbling.w = {1, 2, 3};
  bench.add(tumbling);
  bench.add(sphere(0.4, 1000, {3, 0, 4}, {2, 0, 0}));
  bench.run_settings.exact_flight = exact;
  bench.run_settings.keep_impacts = false;
  bench.run_settings.stop_speed = 0;
  const long before = allocations;
  bench.run(seconds);
  const long during = allocations - before;
  CHECK(bench.world.quality().steps > 100);
  return during;
}

}  // namespace

TEST_CASE("the step loop in space does not allocate") {
  const bool exact = GENERATE(true, false), mesh = GENERATE(false, true);
  // By 3 s the box has landed flat, so that the buffers have the greatest number of contacts.
  const long warm = allocations_in_space(3, exact, mesh);
  // On triangles a box lands again and again, and some of its impacts go to the second solver. An allocation
  // a step would be 4000.
  CHECK(allocations_in_space(9, exact, mesh) <= warm + (mesh ? 600 : 8));
  // One problem of the landing goes to the second solver, whose sparse factors take about 500.
  CHECK(warm < 1200);
}

#ifdef __GLIBC__
TEST_CASE("the step of a deformable block allocates nothing once its nodes have touched") {
  constexpr double young = 50e9, density = 2700, h = 2e-5;
  WorldSettings settings;
  settings.time_step = h;
  Material material(0, 0.5);
  Bench bench(ground(5), material, settings);
  Body<2> block =
      make_body({Contactor2::polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})}, density, 0, 1);
  const ElasticMaterial rock{.young = young, .poisson = 0.25, .density = density, .beta = 1e-5};
  make_deformable<2>(block,
                     std::make_shared<const ElasticBlock<2>>(crossed_rectangle({1, 1}, {6, 6}), rock, h, 0.5),
                     std::nullopt);
  block.move_to({0, 0.5}, 0);
  bench.add(std::move(block));
  for (int n = 0; n < 1000; ++n) bench.world.step(h, false);
  REQUIRE(bench.world.contacts().size() == 7);
  const long before = blocks_of_memory;
  for (int n = 0; n < 1000; ++n) bench.world.step(h, false);
  CHECK(blocks_of_memory == before);
}

TEST_CASE("the step of a deformable box allocates nothing once its nodes have touched") {
  constexpr double h = 2e-5;
  WorldSettings settings;
  settings.time_step = h;
  Material material(0, 0.5);
  Bench3 bench(mesh_of([](double, double) { return 0; }, 4, 10), material, settings);
  Body<3> block = make_body({Contactor3::box({1, 1, 0.5})}, 2700, 0);
  const ElasticMaterial rock{.young = 50e9, .poisson = 0.25, .density = 2700, .beta = 1e-5};
  make_deformable<3>(
      block, std::make_shared<const ElasticBlock<3>>(bricked_box({1, 1, 0.5}, {4, 4, 2}), rock, h, 0.5),
      std::nullopt);
  block.x = {0.1, 0.2, 0.25};
  bench.add(std::move(block));
  for (int n = 0; n < 1000; ++n) bench.world.step(h, false);
  REQUIRE(bench.world.contacts().size() >= 25);
  const long before = blocks_of_memory;
  for (int n = 0; n < 1000; ++n) bench.world.step(h, false);
  CHECK(blocks_of_memory == before);
}

TEMPLATE_TEST_CASE_SIG("the step of linked bodies allocates nothing once their contacts are closed", "",
                       ((int D), D), 2, 3) {
  constexpr double h = 1e-3;
  const auto at = [](double x, double up) {
    Vec<D> place = Vec<D>::Zero();
    place[0] = x;
    place[D - 1] = up;
    return place;
  };
  Material material(0, 0.5);
  const auto add_bodies = [&](auto& bench, const auto& block, const auto& ball) {
    for (const double x : {0.0, 2.0}) bench.add(block(at(x, 0.25)));
    for (const double x : {5.0, 8.0}) bench.add(ball(at(x, 2)));
    const auto add = [&](LinkType type, int a, int b, const Vec<D>& from, const Vec<D>& to) {
      Link<D> link;
      link.type = type;
      link.a = a;
      link.b = b;
      link.end_a = from;
      link.end_b = to;
      link.axis = at(0, 1);
      link.frame_b = {at(0, 1), at(1, 0), Vec<D>(Vec<D>::Ones() - at(1, 1))};
      link.side = at(1, 0);
      link.stiffness = 1e4;
      if (type != LinkType::hinge) link.length = bench.world.links.length(link, bench.world.bodies);
      bench.world.links.add(link);
    };
    add(LinkType::rod, 0, 1, at(0, 0.1), at(0, 0.1));
    add(LinkType::spring, 1, -1, at(0, 0), at(4, 0.3));
    add(LinkType::hinge, 2, -1, at(1, 0), at(6, 2));
    add(LinkType::rope, 3, -1, at(0, 0), at(8, 4));
    for (int n = 0; n < 200; ++n) bench.world.step(h, false);
    REQUIRE(bench.world.contacts().size() == 4 * (D - 1));
    const long before = blocks_of_memory;
    for (int n = 0; n < 200; ++n) bench.world.step(h, false);
    CHECK(blocks_of_memory == before);
  };
  if constexpr (D == 2) {
    Bench bench(ground(20), material);
    add_bodies(
        bench, [](const Vec2& x) { return box(1, 0.5, 100, x); },
        [](const Vec2& x) { return disk(0.2, 10, x); });
  } else {
    Bench3 bench(plane(), material);
    add_bodies(
        bench, [](const Vec3& x) { return box(Vec3(1, 1, 0.5), 100, x); },
        [](const Vec3& x) { return sphere(0.2, 10, x); });
  }
}
#endif

TEST_CASE("the step loop does not allocate") {
  const bool exact = GENERATE(true, false);
  const long warm = allocations_of(3, exact);
  CHECK(allocations_of(12, exact) <= warm + 8);  // a buffer may grow once more
  CHECK(warm < 400);
}
#endif
