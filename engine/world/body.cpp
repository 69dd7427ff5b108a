#include "world/body.h"

#include <algorithm>
#include <cmath>

#include "geometry/volume_properties.h"

namespace flyrock {

namespace {

double mass_of(double volume, double density, double mass, const std::optional<double>& own) {
  if (own) return *own;
  return density > 0 ? density * volume : mass;
}

/// A point has no extent. Its contacts have no lever, so nothing turns it and its moment is of no effect.
/// What counts relative to the size of a body needs one.
template <int D>
void make_point(Body<D>& body) {
  constexpr double point_size = 1e-3;  // m
  for (auto& contactor : body.contactors) contactor.bound = point_size;
  body.size = body.radius = point_size;
  if constexpr (D == 2)
    body.inertia = body.mass * point_size * point_size;
  else
    body.inertia = Vec3::Constant(body.mass * point_size * point_size);
}

template <int D>
bool is_point(const Body<D>& body) {
  return body.contactors.size() == 1 && body.contactors[0].form == Form::ball &&
         body.contactors[0].radius == 0;
}

}  // namespace

Body<2> make_body(std::vector<Contactor2> contactors, double density, double mass, double thickness,
                  const OwnMass<2>& own) {
  const AreaProperties properties = area_properties(contactors);
  const Vec2 centre = own.centre.value_or(properties.centroid);
  Body<2> body;
  for (Contactor2& contactor : contactors) {
    if (contactor.form != Form::outline) contactor.translate(-centre);
    body.size = std::max(body.size, contactor.bound);
  }
  body.parts = PartTree<2>(contactors);
  body.contactors = std::move(contactors);
  const double t = thickness > 0 ? thickness : default_thickness(properties.area);
  body.volume = properties.area * t;
  body.mass = mass_of(body.volume, density, mass, own.mass);
  if (own.inertia)
    body.inertia = *own.inertia;
  else if (properties.area > 0)
    body.inertia = body.mass * properties.polar_moment / properties.area;
  body.radius = std::sqrt(properties.area / pi);
  if (is_point(body)) make_point(body);
  return body;
}

void make_pneumatic(Body<2>& body, const Pneumatic& filling) {
  const Contactor2& ring = body.contactors.front();
  const double share = (ring.form == Form::hollow) ? 1 : 0.5;
  body.inertia = share * body.mass * ring.radius * ring.radius;
  body.breathing = {.now = {ring.radius, 0},
                    .mass = filling.radial_mass.value_or(share * body.mass),
                    .rest_radius = ring.radius,
                    .moment = body.inertia,
                    .thickness = body.volume / area_properties(body.contactors).area,
                    .pressure = filling.pressure,
                    .outside = filling.outside,
                    .gamma = filling.gamma,
                    .stiffness = filling.stiffness,
                    .damping = filling.damping,
                    .side = (ring.form == Form::hollow) ? 1.0 : -1.0};
}

Body<3> make_body(std::vector<Contactor3> contactors, double density, double mass, const OwnMass<3>& own) {
  const VolumeProperties properties = volume_properties(contactors);
  const PrincipalFrame principal = principal_frame(own.inertia.value_or(properties.inertia));
  const Vec3 centre = own.centre.value_or(properties.centroid);
  Body<3> body;
  for (Contactor3& contactor : contactors) {
    if (contactor.form != Form::outline) contactor.change_frame(centre, principal.rotation);
    body.size = std::max(body.size, contactor.bound);
  }
  body.parts = PartTree<3>(contactors);
  body.contactors = std::move(contactors);
  body.volume = properties.volume;
  body.mass = mass_of(body.volume, density, mass, own.mass);
  if (own.inertia)
    body.inertia = principal.moments;
  else if (properties.volume > 0)
    body.inertia = body.mass / properties.volume * principal.moments;
  body.radius = std::cbrt(0.75 * properties.volume / pi);
  body.attitude = principal.rotation;
  if (is_point(body)) make_point(body);
  return body;
}

template <>
void Body<2>::set_shape(const Breathing::State& wanted) {
  if (!breathing.moves()) return;
  Breathing::State state = wanted;
  state.radius = std::max(state.radius, breathing.least_radius());  // where the ring counts as collapsed
  if (state.radius != breathing.now.radius) {
    Contactor2& ring = contactors.front();
    const double moment = breathing.moment_at(state.radius);
    w *= inertia / moment;
    inertia = moment;
    const bool is_drum = ring.form == Form::hollow;
    if (is_drum) ring.outer *= state.radius / ring.radius;
    ring.radius = state.radius;
    ring.bound = size = is_drum ? ring.outer : ring.radius;
    radius = is_drum ? std::sqrt(ring.outer * ring.outer - ring.radius * ring.radius) : ring.radius;
  }
  breathing.now = state;
}

Vec3 free_spin(const Body<3>& body, double h, double theta, const Vec3& by_contacts) {
  constexpr int most_iterations = 20;
  const auto& r = body.attitude.rotation;
  const auto& moments = body.inertia;
  const Vec3 before = r.inverse(body.w), pushed = theta * r.inverse(by_contacts);
  const auto momentum = [&](const Vec3& w) -> Vec3 { return moments.cwiseProduct(w); };
  const auto skew = [](const Vec3& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
  };
  // Newton's method in the body's frame, where I is diagonal.
  Vec3 w = before;
  for (int i = 0; i < most_iterations; ++i) {
    const Vec3 middle = (1 - theta) * before + theta * w + pushed;
    const Vec3 residual = momentum(w - before) + h * middle.cross(momentum(middle));
    Eigen::Matrix3d slope =
        h * theta * (skew(middle) * moments.asDiagonal().toDenseMatrix() - skew(momentum(middle)));
    slope.diagonal() += moments;
    const Vec3 change = slope.inverse() * residual;
    if (!change.allFinite()) break;
    w -= change;
    if (change.norm() <= 1e-15 * w.norm()) break;
  }
  return r * w;
}

namespace {

/// w x I w [N m], all in the frame of the body.
Vec3 own_moment(const Body<3>& body, const Vec3& w) { return w.cross(body.inertia.cwiseProduct(w)); }

}  // namespace

Vec3 gyroscopic_moment(const Body<3>& body, const Vec3& w) {
  return body.attitude.rotation * own_moment(body, body.attitude.rotation.inverse(w));
}

double free_spin_rate(const Body<3>& body) {
  if (body.inertia.minCoeff() <= 0) return 0;
  return own_moment(body, body.attitude.rotation.inverse(body.w)).cwiseQuotient(body.inertia).norm();
}

}  // namespace flyrock
