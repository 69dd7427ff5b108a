#include "world/shape_motion.h"

#include "elastic/elastic_block.h"

namespace flyrock {

namespace {

/// The node of a deformable block that touches.
template <int D>
int node_at(const Body<D>& body, const ShapeTouch<D>& touch) {
  return body.deformation.node_of(contactor_of(touch.feature));
}

}  // namespace

template <int D>
Vec<D> shape_velocity(const Body<D>& body, const ShapeTouch<D>& touch) {
  if (body.deforms()) {
    const Vec<D> rate = body.deformation.rate.template segment<D>(D * node_at(body, touch));
    return touch.side * (touch.frame.transpose() * (body.attitude.rotation * rate));
  }
  Vec<D> velocity = Vec<D>::Zero();
  velocity[0] = body.breathing.side * body.breathing.now.rate;
  return velocity;
}

template <int D>
Eigen::Matrix<double, D, D> shape_mobility(const Body<D>& body, const ShapeTouch<D>& a,
                                           const ShapeTouch<D>& b, double theta_h) {
  Eigen::Matrix<double, D, D> mobility = Eigen::Matrix<double, D, D>::Zero();
  if (body.deforms()) {
    const auto own = body.deformation.block->step.mobility(node_at(body, a), node_at(body, b));
    const auto& r = body.attitude.rotation;
    for (int k = 0; k < D; ++k)
      mobility.col(k) =
          a.side * b.side * (a.frame.transpose() * (r * Vec<D>(own * r.inverse(Vec<D>(b.frame.col(k))))));
    return mobility;
  }
  mobility(0, 0) = body.breathing.inverse_mass(theta_h);  // side^2 = 1
  return mobility;
}

template <int D>
void push_shape(Body<D>& body, const ShapeTouch<D>& touch, const Vec<D>& impulse, double theta_h) {
  if (body.deforms()) {
    if (impulse.isZero(0)) return;
    const Vec<D> own = body.attitude.rotation.inverse(Vec<D>(touch.side * (touch.frame * impulse)));
    const auto& column = body.deformation.block->step.column(node_at(body, touch));
    for (int k = 0; k < D; ++k) body.deformation.rate += own[k] * column.col(k);
    return;
  }
  body.breathing.now.rate += body.breathing.inverse_mass(theta_h) * body.breathing.side * impulse[0];
}

/// A deformable block stands at u + (1 - theta) h u' here, where contacts are detected.
template <int D>
void accelerate_shape(Body<D>& body, double h, double theta) {
  if (body.deforms()) {
    Deformation<D>& own = body.deformation;
    own.start = own.rate;
    own.u -= (1 - theta) * h * own.rate;
    own.block->step.free_change(own.u, own.rate, own.change);
    own.u += (1 - theta) * h * own.rate;
    own.rate += own.change;
    return;
  }
  body.breathing.now.rate = body.breathing.free_rate(body.spin_speed(), h, theta);
}

template <int D>
void take_back_pushes(Body<D>& body, const Breathing::State& start, double h, double theta) {
  if (body.deforms()) {
    body.deformation.rate = body.deformation.start + body.deformation.change;
    return;
  }
  body.breathing.now.rate = start.rate;
  accelerate_shape(body, h, theta);
}

template <int D>
void move_shape(Body<D>& body, double dt) {
  if (body.deforms()) return body.deform(dt);
  body.swell(dt * body.breathing.now.rate);
}

template <int D>
double potential_energy_of_shape(const Body<D>& body) {
  return body.deforms() ? body.deformation.strain_energy() : body.breathing.potential_energy();
}

#define FLYROCK_INSTANTIATE(D)                                                              \
  template Vec<D> shape_velocity(const Body<D>&, const ShapeTouch<D>&);                     \
  template Eigen::Matrix<double, D, D> shape_mobility(const Body<D>&, const ShapeTouch<D>&, \
                                                      const ShapeTouch<D>&, double);        \
  template void push_shape(Body<D>&, const ShapeTouch<D>&, const Vec<D>&, double);          \
  template void accelerate_shape(Body<D>&, double, double);                                 \
  template void take_back_pushes(Body<D>&, const Breathing::State&, double, double);        \
  template void move_shape(Body<D>&, double);                                               \
  template double potential_energy_of_shape(const Body<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
