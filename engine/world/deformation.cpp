#include "world/deformation.h"

#include <cmath>

#include "elastic/elastic_block.h"
#include "world/body.h"

namespace flyrock {

double Deformation::strain_energy() const { return block->model.strain_energy(u); }
double Deformation::vibration_energy() const { return block->model.kinetic_energy(rate); }
int Deformation::node_of(int contactor) const {
  return block->model.mesh().surface[static_cast<std::size_t>(contactor)];
}

template <>
void Body<2>::place_nodes() {
  deformation.greatest = std::sqrt(2.0) * deformation.u.cwiseAbs().maxCoeff();
  const auto& nodes = deformation.block->model.mesh().nodes;
  for (std::size_t k = 0; k < contactors.size(); ++k) {
    const int node = deformation.node_of(static_cast<int>(k));
    Vec2& place = contactors[k].points.front();
    place = nodes[static_cast<std::size_t>(node)] + deformation.displacement(node);
    contactors[k].bound = place.norm();
  }
}

template <>
void Body<2>::deform(double dt) {
  deformation.u += dt * deformation.rate;
  place_nodes();
}

void make_deformable(Body<2>& body, std::shared_ptr<const ElasticBlock> block,
                     const std::optional<double>& strength) {
  const Eigen::Index dofs = block->model.size();
  body.deformation.block = std::move(block);
  body.deformation.strength = strength;
  for (Eigen::VectorXd* room :
       {&body.deformation.u, &body.deformation.rate, &body.deformation.start, &body.deformation.change})
    room->setZero(dofs);
  const auto& mesh = body.deformation.block->model.mesh();
  body.contactors.assign(mesh.surface.size(), Contactor2::disk(0));
  body.place_nodes();
  body.parts = PartTree<2>(body.contactors);
}

}  // namespace flyrock
