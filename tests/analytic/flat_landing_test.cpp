// A box that is dropped flat lands flat, bounce after bounce: apex n = e^(2n) H, and no spin.
#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab.h"
#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

struct Drop {
  double height, e, mu, mass;
  Vec3 size;
};

Drop drawn(std::mt19937& rng) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); };
  return {uniform(0.1, 5),
          uniform(0.2, 0.8),
          uniform(0, 1),
          uniform(0.1, 1e4),
          {uniform(0.1, 3), uniform(0.1, 3), uniform(0.1, 3)}};
}

void check_bounces(const Drop& drop, const BodyHistory& box, const SolverQuality& quality,
                   double rest_speed) {
  INFO("height " << drop.height << ", e " << drop.e << ", mu " << drop.mu << ", size "
                 << drop.size.transpose());
  CHECK(box.max.spin.norm() < 1e-6);
  CHECK(box.min.spin.norm() < 1e-6);
  CHECK(box.reason == StopReason::stopped);
  CHECK(quality.not_converged == 0);
  CHECK(quality.energy_gains == 0);
  double height = drop.height, speed = std::sqrt(2 * 9.81 * drop.height);
  std::size_t impacts = 0;
  for (; speed > rest_speed; ++impacts, speed *= drop.e) {
    if (impacts > 0 && impacts <= box.apexes.size())
      CHECK(std::abs(box.apexes[impacts - 1].height - height) <= 1e-6 * drop.height);
    height *= drop.e * drop.e;
  }
  CHECK(box.impacts.size() == impacts);  // one an arrival: its corners land together
}

void drop_boxes(int count) {
  std::mt19937 rng(7);
  for (int k = 0; k < count; ++k) {
    const Drop drop = drawn(rng);
    Material material(drop.e, drop.mu);
    Bench plane_2d(ground(100), material);
    plane_2d.add(box(drop.size.x(), drop.size.y(), drop.mass, {0, drop.height + 0.5 * drop.size.y()}));
    check_bounces(drop, plane_2d.run(60), plane_2d.world.quality(), WorldSettings{}.rest_speed);

    Bench3 plane_3d(plane(), material);
    const double turn = 0.1 * k;
    plane_3d.add(box(drop.size, drop.mass, {0, 0, drop.height + 0.5 * drop.size.z()},
                     {std::cos(turn), std::sin(turn), 0}));
    check_bounces(drop, plane_3d.run(60), plane_3d.world.quality(), WorldSettings{}.rest_speed);
  }
}

}  // namespace

TEST_CASE("a box dropped flat bounces without a spin, in 2D and 3D") { drop_boxes(100); }

TEST_CASE("ten thousand boxes dropped flat bounce without a spin", "[heavy]") { drop_boxes(10'000); }
