#include "world/deformation.h"

#include <cmath>

#include "elastic/elastic_block.h"
#include "world/body.h"

namespace flyrock {

template <int D>
double Deformation<D>::strain_energy() const {
  return block->model.strain_energy(u);
}

template <int D>
double Deformation<D>::vibration_energy() const {
  return block->model.kinetic_energy(rate);
}

template <int D>
int Deformation<D>::node_of(int contactor) const {
  return block->model.mesh().surface[static_cast<std::size_t>(contactor)];
}

template <int D>
Vec<D> Deformation<D>::place(int node) const {
  return block->model.mesh().nodes[static_cast<std::size_t>(node)] + displacement(node);
}

template <int D>
void Body<D>::place_nodes() {
  deformation.greatest = std::sqrt(static_cast<double>(D)) * deformation.u.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < contactors.size(); ++k) {
    Vec<D>& place = contactors[k].points.front();
    place = deformation.place(deformation.node_of(static_cast<int>(k)));
    contactors[k].bound = place.norm();
  }
}

template <int D>
void Body<D>::deform(double dt) {
  deformation.u += dt * deformation.rate;
  place_nodes();
}

template <int D>
void make_deformable(Body<D>& body, std::shared_ptr<const ElasticBlock<D>> block,
                     const std::optional<double>& strength) {
  const ElasticModel<D>& model = block->model;
  const Eigen::Index dofs = model.size();
  if constexpr (D == 3) {  // its principal frame, which is that of the nodes
    body.inertia = model.inertia();
    body.attitude = model.rotation();
    body.contactors.assign(model.mesh().surface.size(), Contactor3::sphere(0));
  } else {
    body.contactors.assign(model.mesh().surface.size(), Contactor2::disk(0));
  }
  body.deformation.block = std::move(block);
  body.deformation.strength = strength;
  for (Eigen::VectorXd* room :
       {&body.deformation.u, &body.deformation.rate, &body.deformation.start, &body.deformation.change})
    room->setZero(dofs);
  body.place_nodes();
  body.parts = PartTree<D>(body.contactors);
}

#define FLYROCK_INSTANTIATE(D)                                                    \
  template struct Deformation<D>;                                                 \
  template void Body<D>::place_nodes();                                           \
  template void Body<D>::deform(double);                                          \
  template void make_deformable(Body<D>&, std::shared_ptr<const ElasticBlock<D>>, \
                                const std::optional<double>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
