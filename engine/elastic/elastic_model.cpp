#include "elastic/elastic_model.h"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/volume_properties.h"

namespace flyrock {

namespace {

/// Stress by strain [Pa], in 2D in plane strain.
template <int D>
Eigen::Matrix<double, ElasticModel<D>::strains, ElasticModel<D>::strains> isotropic_law(
    const ElasticMaterial& material) {
  constexpr int strains = ElasticModel<D>::strains;
  const double nu = material.poisson;
  Eigen::Matrix<double, strains, strains> law = Eigen::Matrix<double, strains, strains>::Zero();
  law.template topLeftCorner<D, D>().setConstant(nu);
  for (int i = 0; i < strains; ++i) law(i, i) = i < D ? 1 - nu : 0.5 * (1 - 2 * nu);
  const double scale = material.young / ((1 + nu) * (1 - 2 * nu));
  return scale * law;
}

/// The axes of the shear strains, in the order of ElasticModel::Tensor.
template <int D>
constexpr auto shears() {
  if constexpr (D == 2)
    return std::array<std::pair<int, int>, 1>{{{0, 1}}};
  else
    return std::array<std::pair<int, int>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
}

/// The gradient of the shape function of corner k of a cell [1/m].
Vec2 shape_gradient(const ElasticMesh<2>& mesh, const std::array<int, 3>& cell, int k) {
  const double doubled = cell_determinant(mesh, cell);
  const Vec2 side = (mesh.nodes[cell[(k + 2) % 3]] - mesh.nodes[cell[(k + 1) % 3]]) / doubled;
  return {-side.y(), side.x()};
}
Vec3 shape_gradient(const ElasticMesh<3>& mesh, const std::array<int, 4>& cell, int k) {
  const double sixfold = cell_determinant(mesh, cell);
  const Vec3& origin = mesh.nodes[cell[(k + 1) % 4]];
  const Vec3 normal = (mesh.nodes[cell[(k + 2) % 4]] - origin).cross(mesh.nodes[cell[(k + 3) % 4]] - origin);
  return (k % 2 == 0 ? -1 : 1) / sixfold * normal;
}

/// Moves the nodes into the frame of the body: the moment of inertia there, and the rotation that is left.
double to_own_frame(ElasticMesh<2>& mesh, const MeshMoments<2>& moments, Rotation2&) {
  for (Vec2& node : mesh.nodes) node -= moments.centre;
  return moments.spread.trace();
}
Vec3 to_own_frame(ElasticMesh<3>& mesh, const MeshMoments<3>& moments, Rotation3& rotation) {
  const PrincipalFrame principal =
      principal_frame(moments.spread.trace() * Eigen::Matrix3d::Identity() - moments.spread);
  rotation = principal.rotation;
  for (Vec3& node : mesh.nodes) node = rotation.inverse(Vec3(node - moments.centre));
  return principal.moments;
}

/// The displacements of a node by the rigid modes, in its columns.
Eigen::Matrix<double, 2, 3> rigid_motion(const Vec2& node) {
  Eigen::Matrix<double, 2, 3> columns;
  columns << 1, 0, -node.y(), 0, 1, node.x();
  return columns;
}
Eigen::Matrix<double, 3, 6> rigid_motion(const Vec3& node) {
  Eigen::Matrix<double, 3, 6> columns;
  columns.leftCols<3>().setIdentity();
  for (int axis = 0; axis < 3; ++axis) columns.col(3 + axis) = Vec3::Unit(axis).cross(node);
  return columns;
}

}  // namespace

template <int D>
ElasticModel<D>::ElasticModel(ElasticMesh<D> mesh, const ElasticMaterial& material)
    : mesh_(std::move(mesh)), material_(material), law_(isotropic_law<D>(material)) {
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i)
    if (!(cell_determinant(mesh_, mesh_.cells[i]) > 0))
      throw std::invalid_argument(
          fmt::format("cell {} is inverted or has no {}", i + 1, D == 2 ? "area" : "volume"));
  const MeshMoments<D> moments = moments_of(mesh_);
  const double density = material_.density * material_.thickness;
  mass_ = density * moments.volume;
  inertia_ = density * to_own_frame(mesh_, moments, rotation_);

  const auto dofs = static_cast<Eigen::Index>(D * mesh_.nodes.size());
  masses_ = Eigen::VectorXd::Zero(dofs);
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& cell : mesh_.cells) {
    const double volume = cell_volume(mesh_, cell) * material_.thickness;
    volumes_.push_back(volume);
    const CellStrain strain = strain_of(cell);
    const Eigen::Matrix<double, dofs_of_cell, dofs_of_cell> own = volume * strain.transpose() * law_ * strain;
    for (int a = 0; a < dofs_of_cell; ++a) {
      const int row = D * cell[a / D] + a % D;
      masses_[row] += material_.density * volume / (D + 1);
      for (int b = 0; b < dofs_of_cell; ++b) entries.emplace_back(row, D * cell[b / D] + b % D, own(a, b));
    }
  }
  stiffness_.resize(dofs, dofs);
  stiffness_.setFromTriplets(entries.begin(), entries.end());

  modes_.resize(dofs, rigid);
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i)
    modes_.template middleRows<D>(static_cast<Eigen::Index>(D * i)) = rigid_motion(mesh_.nodes[i]);
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
  for (int k = 0; k <= D; ++k) {
    const Vec<D> gradient = shape_gradient(mesh_, cell, k);
    for (int i = 0; i < D; ++i) strain(i, D * k + i) = gradient[i];
    int row = D;
    for (const auto& [i, j] : shears<D>()) {
      strain(row, D * k + i) = gradient[j];
      strain(row, D * k + j) = gradient[i];
      ++row;
    }
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
typename ElasticModel<D>::Tensor ElasticModel<D>::stress(int cell, const Eigen::VectorXd& u) const {
  const auto& nodes = mesh_.cells[static_cast<std::size_t>(cell)];
  Vec<dofs_of_cell> own;
  for (int a = 0; a < dofs_of_cell; ++a) own[a] = u[D * nodes[a / D] + a % D];
  return law_ * (strain_of(nodes) * own);
}

template class ElasticModel<2>;
template class ElasticModel<3>;

}  // namespace flyrock
