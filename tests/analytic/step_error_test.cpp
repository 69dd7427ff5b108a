// Steps chosen by their error against short steps: random phases in contact end at the same place.
#include <catch2/catch.hpp>
#include <random>

#include "analytic/lab_3d.h"
#include "geometry/hull.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace step_error_test {

namespace {

struct Uniform {
  std::mt19937 rng;
  double operator()(double a, double b) { return std::uniform_real_distribution<double>(a, b)(rng); }
};

/// How a body moves in contact: it slides flat, rolls (with slip at first), pivots about a corner, or rocks
/// from corner to corner.
enum class Phase { slide, roll, pivot, rock };
constexpr int phases = 4;

constexpr double lasts = 0.3;  // s

struct End {
  Vec3 place = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double radius = 0;
  double diameter() const { return 2 * radius; }
};

End end_of(const Body<2>& body) {
  End end{{body.x.x(), body.x.y(), 0}, Eigen::Matrix3d::Identity(), body.radius};
  end.axes.topLeftCorner<2, 2>() << std::cos(body.attitude.angle), -std::sin(body.attitude.angle),
      std::sin(body.attitude.angle), std::cos(body.attitude.angle);
  return end;
}
End end_of(const Body<3>& body) {
  End end{body.x, Eigen::Matrix3d::Identity(), body.radius};
  for (int i = 0; i < 3; ++i) end.axes.col(i) = body.attitude.rotation * Vec3(Vec3::Unit(i));
  return end;
}

/// The greatest displacement of the centre, or of a place at the radius by turning, as a share of the
/// diameter.
double distance(const End& a, const End& b) {
  return std::max((a.place - b.place).norm(), a.radius * (a.axes - b.axes).norm()) / a.diameter();
}

/// A tetrahedron on its base of three corners.
Body<3> tetrahedron(const Vec3& size, const Vec3& along, const Vec3& up) {
  const auto at = [&](double x, double y, double z) {
    return Vec3(x * size.x() * along + y * size.y() * up.cross(along) + z * size.z() * up);
  };
  return make_body({convex_hull({at(-0.4, -0.6, 0), at(0.7, -0.1, 0), at(-0.3, 0.7, 0), at(0, 0, 0.6)})}, 0,
                   100);
}

/// A phase of body and ground, run with one choice of steps.
template <class RunOf>
End in_plane(Phase phase, Uniform uniform, RunOf run) {
  const double slope = uniform(-0.3, 0.3), mu = uniform(0.2, 0.8);
  const bool turns = phase == Phase::pivot || phase == Phase::rock;
  Material material(0, turns ? uniform(0.6, 1) : mu, phase == Phase::roll ? uniform(0, 0.02) : 0);
  Bench bench(ground(100, slope), material, run.settings);
  const Vec2 along(std::cos(slope), -std::sin(slope)), up(std::sin(slope), std::cos(slope));
  const double width = uniform(0.2, 1), height = uniform(0.2, 1), speed = uniform(-3, 3);
  if (phase == Phase::roll) {
    const double radius = 0.5 * width;
    bench.add(disk(radius, 100, radius * up, speed * along, uniform(-8, 8)));
  } else {
    double tilt = 0;
    if (phase == Phase::pivot) tilt = uniform(0.3, 1) * std::atan2(width, height);
    if (phase == Phase::rock) tilt = uniform(0.05, 0.3);
    Body<2> body = box(width, height, 100, Vec2::Zero(), -slope + tilt);
    const Vec2 corner = body.attitude.rotation * Vec2(-width / 2, -height / 2),
               other = body.attitude.rotation * Vec2(width / 2, -height / 2);
    const Vec2 lowest = corner.dot(up) < other.dot(up) ? corner : other;
    body.x = -lowest + (lowest - lowest.dot(up) * up);  // the lowest corner on the ground
    if (turns) {
      body.w = uniform(-2, 2);
      body.v = -cross(body.w, lowest);
    } else {
      body.v = speed * along;
    }
    bench.add(std::move(body));
  }
  return run(bench);
}

template <class RunOf>
End in_space(Phase phase, Uniform uniform, RunOf run) {
  const double slope = uniform(0, 0.3), mu = uniform(0.2, 0.8), azimuth = uniform(0, 6);
  const bool turns = phase == Phase::pivot || phase == Phase::rock;
  Material material(0, turns ? uniform(0.6, 1) : mu, phase == Phase::roll ? uniform(0, 0.02) : 0);
  const Plane ground = plane(slope, azimuth);
  Bench3 bench(ground, material, run.settings);
  const Vec3 up = ground.normal, along = down(slope, azimuth), across = up.cross(along);
  const auto any = [&](double most) {
    return Vec3(uniform(-most, most), uniform(-most, most), uniform(-most, most));
  };
  if (phase == Phase::roll) {
    const double radius = uniform(0.1, 0.5);
    const Vec3 spin = any(8);
    bench.add(sphere(radius, 100, radius * up, uniform(-3, 3) * along + uniform(-3, 3) * across, spin));
  } else {
    const Vec3 size(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
    // Three corners on the ground, because the loads of four are not determined.
    Body<3> body =
        phase == Phase::slide ? tetrahedron(size, along, up) : box(size, 100, Vec3::Zero(), along, up);
    double tilt = 0;
    if (phase == Phase::pivot) tilt = uniform(0.2, 0.6);
    if (phase == Phase::rock) tilt = uniform(0.05, 0.2);
    const Vec3 axis = std::cos(azimuth) * along + std::sin(azimuth) * across;
    if (tilt > 0) body.attitude = body.attitude.turned(tilt * axis);
    Vec3 lowest = Vec3::Zero();
    for (const Vec3& point : body.contactors[0].points) {
      const Vec3 arm = body.attitude.rotation * point;
      if (arm.dot(up) < lowest.dot(up)) lowest = arm;
    }
    body.x = -lowest.dot(up) * up;
    if (turns) {
      body.w = any(2);
      body.v = -body.w.cross(lowest);
    } else {
      body.v = uniform(-3, 3) * along + uniform(-3, 3) * across;
      body.w = uniform(-4, 4) * up;
    }
    bench.add(std::move(body));
  }
  return run(bench);
}

struct RunWith {
  WorldSettings settings;
  template <int D>
  End operator()(BenchOf<D>& bench) const {
    bench.run_settings.stop_speed = 0;
    const BodyHistory& history = bench.run(lasts);
    if (!history.fault.empty())
      printf("fault %s (greatest E %g) tol %g h %g\n", history.fault.c_str(), bench.world.total_energy(),
             settings.step_tolerance, settings.time_step);
    return end_of(bench.world.bodies[0]);
  }
};

End phase_end(int number, const WorldSettings& settings) {
  const Uniform uniform{std::mt19937(number)};
  const Phase phase = static_cast<Phase>(number % phases);
  const RunWith run{settings};
  return number / phases % 2 == 0 ? in_plane(phase, uniform, run) : in_space(phase, uniform, run);
}

/// Compares `count` phases with steps of `reference` [s].
void compare(int count, double reference) {
  WorldSettings fine;
  fine.time_step = reference;
  std::vector<End> ends;
  for (int i = 0; i < count; ++i) ends.push_back(phase_end(i, fine));
  double last_mean = 1;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    WorldSettings chosen;
    chosen.step_tolerance = tolerance;
    int within = 0;
    double mean = 0;
    for (int i = 0; i < count; ++i) {
      const double error = distance(ends[i], phase_end(i, chosen));
      within += error <= tolerance;
      if (error > tolerance) UNSCOPED_INFO("phase " << i << ": " << error);
      mean += std::log10(std::max(error, 1e-12)) / count;
    }
    INFO("tolerance " << tolerance << ": " << within << " of " << count << " within, mean error 10^" << mean);
    CHECK(within >= 0.95 * count);
    CHECK(mean < last_mean - 0.5);
    last_mean = mean;
  }
}

}  // namespace

TEST_CASE("Random phases in contact end within the tolerance of chosen steps", "[slow]") {
  compare(80, 1e-5);
}

TEST_CASE("500 random phases in contact end within the tolerance of chosen steps", "[heavy]") {
  compare(500, 1e-6);
}

}  // namespace step_error_test
