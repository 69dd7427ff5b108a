// Boxes that lean on each other, with flush sides: dominoes in 3D and their twins in 2D.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace dominoes_test {

constexpr double thickness = 0.1, height = 1, distance = 0.4, lean = 0.3;  // m, rad

/// A box at its place in the world, from the vertices of its contactor.
struct Placed {
  Vec3 centre, half;
  Eigen::Matrix3d axes;

  explicit Placed(const Body<3>& body) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Vec3& p : body.contactors[0].points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    half = 0.5 * (high - low);
    centre = body.pose() * Vec3(0.5 * (low + high));
    axes = body.attitude.rotation.matrix();
  }
  double reach(const Vec3& direction) const { return half.dot((axes.transpose() * direction).cwiseAbs()); }
};

/// The overlap of two boxes along the axis of least overlap, of all fifteen that can separate them [m].
double overlap(const Placed& a, const Placed& b) {
  double least = 1e300;
  const auto look_along = [&](const Vec3& axis) {
    if (axis.norm() < 1e-7) return;
    const Vec3 n = axis.normalized();
    least = std::min(least, a.reach(n) + b.reach(n) - std::abs(n.dot(b.centre - a.centre)));
  };
  for (int i = 0; i < 3; ++i) {
    look_along(a.axes.col(i));
    look_along(b.axes.col(i));
    for (int j = 0; j < 3; ++j) look_along(a.axes.col(i).cross(b.axes.col(j)));
  }
  return least;
}

double overlap(const std::vector<Body<2>>&) { return 0; }
double overlap(const std::vector<Body<3>>& bodies) {
  double deepest = 0;
  std::vector<Placed> boxes(bodies.begin(), bodies.end());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      deepest = std::max(deepest, overlap(boxes[i], boxes[j]));
  return deepest;
}

/// The cosine of the angle by which a box has fallen.
double upright(const Body<2>& body) { return std::cos(body.attitude.angle); }
double upright(const Body<3>& body) {
  const Placed box(body);
  int longest = 0;
  box.half.maxCoeff(&longest);
  return std::abs(box.axes(2, longest));
}

struct Fall {
  std::vector<double> times;  ///< s, of each box: when it has fallen by 60 degrees
  double deepest = 0;         ///< m, by `overlap`
};

template <int D>
Fall fall_of(BenchOf<D>& bench, double seconds) {
  Fall fall;
  fall.times.assign(bench.world.bodies.size(), 0.0);
  bench.run_settings.advanced = [&](double) {
    const auto& bodies = bench.world.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (fall.times[i] == 0 && upright(bodies[i]) < 0.5) fall.times[i] = bench.world.time;
    fall.deepest = std::max(fall.deepest, overlap(bodies));
  };
  bench.run(seconds);
  return fall;
}

/// Where a box stands; the first one leans towards the others, on its lower edge.
Vec2 place_of(int box) {
  if (box > 0) return {distance * box, height / 2};
  return 0.5 * Vec2(std::sin(lean) * height + (1 - std::cos(lean)) * thickness,
                    std::cos(lean) * height + std::sin(lean) * thickness);
}

/// `width`: across the row, in 3D.
template <int D>
Fall fall_of_row(int count, double width, double mu, double e, double seconds, SolverQuality& quality) {
  Material material(e, mu);
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  const auto run = [&](auto bench) {
    for (int i = 0; i < count; ++i) {
      const double angle = i == 0 ? lean : 0;
      const Vec2 at = place_of(i);
      if constexpr (D == 2)
        bench->add(box(thickness, height, 10, at, -angle));
      else
        bench->add(box({thickness, width, height}, 10, {at.x(), 0, at.y()}, down(angle),
                       {std::sin(angle), 0, std::cos(angle)}));
    }
    Fall fall = fall_of<D>(*bench, seconds);
    quality = bench->world.quality();
    return fall;
  };
  if constexpr (D == 2)
    return run(std::make_unique<Bench>(ground(50), material, settings));
  else
    return run(std::make_unique<Bench3>(plane(), material, settings));
}

}  // namespace dominoes_test

TEST_CASE("dominoes in 3D fall as in 2D, at a few times the cost, and overlap by no more than they report") {
  using namespace dominoes_test;
  struct Case {
    int count;
    double width, mu, e, seconds;
  };
  for (const Case& c : {Case{2, 0.1, 0.3, 0, 1.0}, Case{4, 0.1, 0.3, 0, 1.3}, Case{6, 0.5, 0, 0, 1.2}}) {
    INFO(c.count << " boxes, mu " << c.mu << ", e " << c.e);
    SolverQuality in_2d, in_3d;
    const Fall plane = fall_of_row<2>(c.count, c.width, c.mu, c.e, c.seconds, in_2d);
    const Fall space = fall_of_row<3>(c.count, c.width, c.mu, c.e, c.seconds, in_3d);
    for (int i = 0; i < c.count; ++i) CHECK(space.times[i] == Approx(plane.times[i]).epsilon(0.01));
    CHECK(in_3d.max_penetration == Approx(space.deepest).margin(1e-6));
    CHECK(in_3d.problems < 5 * in_2d.problems);
  }
}
