#include "world/shape_motion.h"

namespace flyrock {

template <int D>
Vec<D> shape_velocity(const Body<D>& body, const ShapeTouch<D>&) {
  Vec<D> velocity = Vec<D>::Zero();
  velocity[0] = body.breathing.side * body.breathing.now.rate;
  return velocity;
}

template <int D>
Eigen::Matrix<double, D, D> shape_mobility(const Body<D>& body, const ShapeTouch<D>&, const ShapeTouch<D>&,
                                           double theta_h) {
  Eigen::Matrix<double, D, D> mobility = Eigen::Matrix<double, D, D>::Zero();
  mobility(0, 0) = body.breathing.inverse_mass(theta_h);  // side^2 = 1
  return mobility;
}

template <int D>
void push_shape(Body<D>& body, const ShapeTouch<D>&, const Vec<D>& impulse, double theta_h) {
  body.breathing.now.rate += body.breathing.inverse_mass(theta_h) * body.breathing.side * impulse[0];
}

template <int D>
void accelerate_shape(Body<D>& body, double h, double theta) {
  body.breathing.now.rate = body.breathing.free_rate(body.spin_speed(), h, theta);
}

template <int D>
void move_shape(Body<D>& body, double dt) {
  body.swell(dt * body.breathing.now.rate);
}

template <int D>
double potential_energy_of_shape(const Body<D>& body) {
  return body.breathing.potential_energy();
}

#define FLYROCK_INSTANTIATE(D)                                                              \
  template Vec<D> shape_velocity(const Body<D>&, const ShapeTouch<D>&);                     \
  template Eigen::Matrix<double, D, D> shape_mobility(const Body<D>&, const ShapeTouch<D>&, \
                                                      const ShapeTouch<D>&, double);        \
  template void push_shape(Body<D>&, const ShapeTouch<D>&, const Vec<D>&, double);          \
  template void accelerate_shape(Body<D>&, double, double);                                 \
  template void move_shape(Body<D>&, double);                                               \
  template double potential_energy_of_shape(const Body<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
