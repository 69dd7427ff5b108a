#include "elastic/elastic_model.h"

#include <fmt/format.h>

#include <stdexcept>

namespace flyrock {

namespace {

/// Stress by strain (xx, yy, 2xy) in plane strain [Pa].
Eigen::Matrix3d plane_strain_law(const ElasticMaterial& material) {
  const double nu = material.poisson;
  const double scale = material.young / ((1 + nu) * (1 - 2 * nu));
  Eigen::Matrix3d law;
  law << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 * (1 - 2 * nu);
  return scale * law;
}

}  // namespace

template <int D>
ElasticModel<D>::ElasticModel(ElasticMesh<D> mesh, const ElasticMaterial& material)
    : mesh_(std::move(mesh)), material_(material), law_(plane_strain_law(material)) {
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i)
    if (!(doubled_cell_area(mesh_, mesh_.cells[i]) > 0))
      throw std::invalid_argument(fmt::format("cell {} is inverted or has no area", i + 1));
  const MeshSection section = section_of(mesh_);
  for (Vec<D>& node : mesh_.nodes) node -= section.centre;
  const double area_density = material_.density * material_.thickness;
  mass_ = area_density * section.area;
  inertia_ = area_density * section.polar_moment;

  const auto dofs = static_cast<Eigen::Index>(D * mesh_.nodes.size());
  masses_ = Eigen::VectorXd::Zero(dofs);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& cell : mesh_.cells) {
    const double volume = 0.5 * doubled_cell_area(mesh_, cell) * material_.thickness;
    volumes_.push_back(volume);
    const CellStrain strain = strain_of(cell);
    const Eigen::Matrix<double, 6, 6> own = volume * strain.transpose() * law_ * strain;
    for (int a = 0; a < 6; ++a) {
      const int row = D * cell[a / D] + a % D;
      masses_[row] += material_.density * volume / (D + 1);
      for (int b = 0; b < 6; ++b) entries.emplace_back(row, D * cell[b / D] + b % D, own(a, b));
    }
  }
  stiffness_.resize(dofs, dofs);
  stiffness_.setFromTriplets(entries.begin(), entries.end());

  modes_ = Modes::Zero(dofs, rigid);
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(D * i);
    modes_(at, 0) = modes_(at + 1, 1) = 1;
    modes_(at, 2) = -mesh_.nodes[i].y();
    modes_(at + 1, 2) = mesh_.nodes[i].x();
  }
  for (int k = 0; k < rigid;
       ++k) {  // Gram and Schmidt, with the scalar product of M; twice for the last digits
    for (int again = 0; again < 2; ++again)
      for (int j = 0; j < k; ++j)
        modes_.col(k) -= modes_.col(j).dot(masses_.cwiseProduct(modes_.col(k))) * modes_.col(j);
    modes_.col(k) /= std::sqrt(modes_.col(k).dot(masses_.cwiseProduct(modes_.col(k))));
  }
}

template <int D>
typename ElasticModel<D>::CellStrain ElasticModel<D>::strain_of(const std::array<int, D + 1>& cell) const {
  CellStrain strain = CellStrain::Zero();
  const double doubled = doubled_cell_area(mesh_, cell);
  for (int k = 0; k < 3; ++k) {
    const Vec2 side = (mesh_.nodes[cell[(k + 2) % 3]] - mesh_.nodes[cell[(k + 1) % 3]]) / doubled;
    const Vec2 gradient(-side.y(), side.x());  // of the shape function of corner k
    strain(0, 2 * k) = strain(2, 2 * k + 1) = gradient.x();
    strain(1, 2 * k + 1) = strain(2, 2 * k) = gradient.y();
  }
  return strain;
}

template <int D>
void ElasticModel<D>::drop_rigid_force(Eigen::VectorXd& force) const {
  const Eigen::Matrix<double, rigid, 1> share = modes_.transpose() * force;
  for (int k = 0; k < rigid; ++k) force -= share[k] * masses_.cwiseProduct(modes_.col(k));
}

template <int D>
void ElasticModel<D>::drop_rigid_motion(Eigen::VectorXd& motion) const {
  for (int k = 0; k < rigid; ++k) motion -= modes_.col(k).dot(masses_.cwiseProduct(motion)) * modes_.col(k);
}

template <int D>
double ElasticModel<D>::strain_energy(const Eigen::VectorXd& u) const {
  double twice = 0;  // without the room that the product K u would take
  for (int column = 0; column < stiffness_.outerSize(); ++column) {
    double force = 0;  // K is symmetric
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness_, column); entry; ++entry)
      force += entry.value() * u[entry.row()];
    twice += force * u[column];
  }
  return 0.5 * twice;
}

template <int D>
double ElasticModel<D>::kinetic_energy(const Eigen::VectorXd& rate) const {
  return 0.5 * rate.dot(masses_.cwiseProduct(rate));
}

template <int D>
Eigen::Vector3d ElasticModel<D>::stress(int cell, const Eigen::VectorXd& u) const {
  const auto& nodes = mesh_.cells[static_cast<std::size_t>(cell)];
  Eigen::Matrix<double, 6, 1> own;
  for (int a = 0; a < 6; ++a) own[a] = u[D * nodes[a / D] + a % D];
  return law_ * (strain_of(nodes) * own);
}

template class ElasticModel<2>;

}  // namespace flyrock
