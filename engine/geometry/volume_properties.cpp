#include "geometry/volume_properties.h"

#include <Eigen/Eigenvalues>

namespace flyrock {

namespace {

/// Integrals of 1, r and r r^T about one origin; sums of these are exact.
struct VolumeMoments {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

void add_sphere(VolumeMoments& sum, double radius, const Vec3& centre) {
  const double volume = 4.0 / 3.0 * pi * radius * radius * radius;
  sum.volume += volume;
  sum.first += volume * centre;
  sum.second += volume * (centre * centre.transpose() + radius * radius / 5 * Eigen::Matrix3d::Identity());
}

/// Adds a cylinder with a half-sphere on each end. The integral of |z| over a sphere is pi/2 r^4: half of it
/// belongs to each of the two halves, which are length/2 away from the middle.
void add_pill(VolumeMoments& sum, double radius, const Vec3& start, const Vec3& end) {
  const Vec3 middle = 0.5 * (start + end), axis = (end - start).normalized();
  const double length = (end - start).norm(), square = radius * radius;
  const double tube = pi * square * length, caps = 4.0 / 3.0 * pi * square * radius;
  const double along = tube * length * length / 12 + caps * (square / 5 + length * length / 4) +
                       0.5 * pi * square * square * length;
  const double across = tube * square / 4 + caps * square / 5;
  sum.volume += tube + caps;
  sum.first += (tube + caps) * middle;
  sum.second += (tube + caps) * middle * middle.transpose() + across * Eigen::Matrix3d::Identity() +
                (along - across) * axis * axis.transpose();
}

/// Adds a cylinder. `sign`: -1 takes it away.
void add_cylinder(VolumeMoments& sum, double radius, const Vec3& start, const Vec3& end, double sign = 1) {
  const Vec3 middle = 0.5 * (start + end), along = end - start;
  const double square = radius * radius, volume = sign * pi * square * along.norm();
  const Vec3 axis = along.normalized();
  sum.volume += volume;
  sum.first += volume * middle;
  sum.second += volume * (middle * middle.transpose() + along * along.transpose() / 12 +
                          square / 4 * (Eigen::Matrix3d::Identity() - axis * axis.transpose()));
}

/// Adds a cone, whose centre of mass is a quarter of its height above the base.
void add_cone(VolumeMoments& sum, double radius, const Vec3& base, const Vec3& point) {
  const Vec3 along = point - base, centre = base + along / 4, axis = along.normalized();
  const double square = radius * radius, volume = pi / 3 * square * along.norm();
  sum.volume += volume;
  sum.first += volume * centre;
  sum.second += volume * (centre * centre.transpose() + 3.0 / 80 * along * along.transpose() +
                          3.0 / 20 * square * (Eigen::Matrix3d::Identity() - axis * axis.transpose()));
}

/// Adds the tetrahedron (origin, a, b, c) with its sign.
void add_tetrahedron(VolumeMoments& sum, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double det = a.dot(b.cross(c));
  const Vec3 total = a + b + c;
  sum.volume += det / 6;
  sum.first += det / 24 * total;
  sum.second +=
      det / 120 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + total * total.transpose());
}

}  // namespace

VolumeProperties volume_properties(const std::vector<Contactor3>& contactors) {
  if (contactors.empty() || contactors.front().form == Form::outline) return {};
  // Use moments about a point of the body, so that a body drawn far from the frame's origin loses no digits.
  const Contactor3& first = contactors.front();
  const Vec3 origin = !first.circles.empty() ? first.circles.front().centre : first.points.front();
  VolumeMoments sum;
  for (const Contactor3& shape : contactors) {
    const auto circle = [&](std::size_t i) -> Vec3 { return shape.circles[i].centre - origin; };
    const auto point = [&](int i) -> Vec3 { return shape.points[static_cast<std::size_t>(i)] - origin; };
    switch (shape.form) {
      case Form::ball:
        add_sphere(sum, shape.radius, point(0));
        break;
      case Form::pill:
        add_pill(sum, shape.radius, point(0), point(1));
        break;
      case Form::hull:
        for (const Contactor3::Face& face : shape.faces)
          for (int i = 1; i + 1 < face.count; ++i)
            add_tetrahedron(sum, point(shape.vertex(face, 0)), point(shape.vertex(face, i)),
                            point(shape.vertex(face, i + 1)));
        break;
      case Form::smooth:
        if (shape.circles.size() == 1)
          add_cone(sum, shape.circles[0].radius, circle(0), point(0));
        else
          add_cylinder(sum, shape.circles[0].radius, circle(0), circle(1));
        break;
      case Form::hollow:
        add_cylinder(sum, shape.circles[0].radius, circle(0), circle(1), -1);
        add_cylinder(sum, shape.outer, circle(0), circle(1));
        break;
      case Form::cloud:
        for (const auto& [a, b, c] : shape.skin) add_tetrahedron(sum, point(a), point(b), point(c));
        break;
      case Form::half_space:
      case Form::outline:
        break;
    }
  }
  if (sum.volume == 0) return {0, origin, Eigen::Matrix3d::Zero()};
  const Vec3 centre = sum.first / sum.volume;
  const Eigen::Matrix3d second = sum.second - sum.volume * centre * centre.transpose();
  return {sum.volume, origin + centre, second.trace() * Eigen::Matrix3d::Identity() - second};
}

PrincipalFrame principal_frame(const Eigen::Matrix3d& inertia) {
  Eigen::Matrix3d off = inertia;
  off.diagonal().setZero();
  if (off.norm() <= 1e-12 * inertia.trace()) return {inertia.diagonal(), {}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  return {solver.eigenvalues(), Rotation3(axes)};
}

}  // namespace flyrock
