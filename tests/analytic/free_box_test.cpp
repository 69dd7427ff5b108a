// The rotation of a free box in a world, against Jacobi's functions and power series.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"
#include "analytic/taylor_rotation.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

Vec3 momentum_of(const Body<3>& body) {
  const Rotation3& r = body.attitude.rotation;
  return r * Vec3(body.inertia.cwiseProduct(r.inverse(body.w)));
}

/// The spin about the axes x, y, z of least, middle and greatest moment at time t, where it has no z
/// component at t = 0 and circles the x axis: Landau and Lifshitz, Mechanics, 37, counted from an extreme of
/// the middle component. In long double, because the modulus is within 1e-4 of 1.
Vec3 spin_by_jacobi(const Vec3& moments, const Vec3& spin, double t) {
  const long double i1 = moments.x(), i2 = moments.y(), i3 = moments.z();
  const long double w1 = spin.x(), w2 = spin.y();
  const long double twice_energy = i1 * w1 * w1 + i2 * w2 * w2;
  const long double square = i1 * i1 * w1 * w1 + i2 * i2 * w2 * w2;
  const long double lambda = std::sqrt((i1 - i2) * (square - twice_energy * i3) / (i1 * i2 * i3));
  const long double modulus =
      std::sqrt((i2 - i3) * (twice_energy * i1 - square) / ((i1 - i2) * (square - twice_energy * i3)));
  long double cn, dn;
  const long double sn =
      boost::math::jacobi_elliptic(modulus, boost::math::ellint_1(modulus) - lambda * t, &cn, &dn);
  const long double most_1 = std::sqrt((square - twice_energy * i3) / (i1 * (i1 - i3)));
  const long double most_2 = std::sqrt((twice_energy * i1 - square) / (i2 * (i1 - i2)));
  const long double most_3 = std::sqrt((twice_energy * i1 - square) / (i3 * (i1 - i3)));
  return {static_cast<double>(most_1 * dn), static_cast<double>(most_2 * sn),
          static_cast<double>(-most_3 * cn)};
}

}  // namespace

TEST_CASE("a box spun about its middle axis turns over 25 times in 100 turns, to 1e-10 of the closed form") {
  Material material(0, 0.5);
  const Vec3 spin(0.07, 2 * pi, 0);
  Body<3> box_at_start = box({0.4, 0.3, 0.1}, 12, {0, 0, 10});
  box_at_start.w = spin;
  const Vec3 moments = 12 / 12.0 * Vec3(0.3 * 0.3 + 0.1 * 0.1, 0.4 * 0.4 + 0.1 * 0.1, 0.4 * 0.4 + 0.3 * 0.3);
  const Vec3 momentum = momentum_of(box_at_start);
  CHECK((momentum - moments.cwiseProduct(spin)).norm() < 1e-12);
  Bench3 stopped(plane(), material, {}, Vec3::Zero());  // at every quarter turn
  stopped.add(box_at_start);
  const double energy = stopped.world.total_energy();
  TaylorRotation series(moments, spin);
  int flips = 0;
  double before = spin.y();
  for (int quarter = 1; quarter <= 400; ++quarter) {
    const double time = 0.25 * quarter;
    Bench3 whole(plane(), material, {}, Vec3::Zero());  // in one flight
    whole.add(box_at_start);
    whole.run(time);
    series.advance(0.025, 10);
    const Body<3>& now = whole.world.bodies[0];
    CHECK((momentum_of(now) - momentum).norm() <= 1e-10 * momentum.norm());
    CHECK(std::abs(whole.world.total_energy() - energy) <= 1e-10 * energy);
    CHECK((now.w - series.spin()).norm() <= 1e-10 * spin.norm());
    // A box is described along its axes, so that the series' frame is the one of its description.
    const Vec3 own = series.attitude().transpose() * now.w;
    CHECK((own - spin_by_jacobi(moments, spin, time)).norm() <= 1e-10 * spin.norm());
    // A stop rounds the spin in its last digit. While the box flips, that changes the complement of the
    // modulus by 1e-16, which is 1e-12 of its value, and the next periods as much: 400 stops, 1e-9 together.
    stopped.run(time);
    CHECK((stopped.world.bodies[0].w - series.spin()).norm() <= 1e-9 * spin.norm());
    flips += own.y() * before < 0;
    before = own.y();
  }
  CHECK(flips == 25);
}
