#pragma once
// Linear elasticity of a block in its own frame: finite elements of constant strain (T3).

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "elastic/elastic_mesh.h"

namespace flyrock {

/// Plane strain in 2D. SI units.
struct ElasticMaterial {
  double young = 0;      ///< Pa
  double poisson = 0;    ///< below 0.5
  double density = 0;    ///< kg/m3
  double thickness = 1;  ///< m, of the 2D world
  double alpha = 0;      ///< 1/s, damping in proportion to the mass
  double beta = 0;       ///< s, damping in proportion to the stiffness
};

/// The equation of motion of the nodes, M u'' + C u' + K u = f, with the lumped mass M (a third of each cell
/// at its corners) and C = alpha M + beta K. Degrees of freedom are node by node: (x, y) of node 0, of node
/// 1, ...
///
/// The motion splits into a rigid one, which the body has, and a deformation u that is M-orthogonal to it
/// (mean axes): R' M u = 0 with the rigid modes R, of which R' M R = 1. Without the split, a stiff block
/// would lose its rigid motion in the rounding of K. Linear in u: strains must stay small; turns may be
/// large.
template <int D>
class ElasticModel {
 public:
  static constexpr int rigid = Space<D>::dof;
  using Modes = Eigen::Matrix<double, Eigen::Dynamic, rigid>;

  /// The nodes of the mesh are moved so that the centre of mass of the cells is at the origin. Throws
  /// std::invalid_argument for a cell that is inverted.
  ElasticModel(ElasticMesh<D> mesh, const ElasticMaterial& material);

  const ElasticMesh<D>& mesh() const { return mesh_; }
  const ElasticMaterial& material() const { return material_; }
  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  const Eigen::VectorXd& masses() const { return masses_; }  ///< of each degree of freedom [kg]
  const Modes& rigid_modes() const { return modes_; }
  int size() const { return static_cast<int>(masses_.size()); }

  double mass() const { return mass_; }        ///< kg, exact
  double inertia() const { return inertia_; }  ///< kg m2, about the centre of mass, exact of the cells

  /// f - M R R' f: what of a force on the nodes does not move the body [N]. In place.
  void drop_rigid_force(Eigen::VectorXd& force) const;
  /// u - R R' M u: what of a displacement deforms. In place.
  void drop_rigid_motion(Eigen::VectorXd& motion) const;

  double strain_energy(const Eigen::VectorXd& u) const;      ///< u.K u / 2 [J]
  double kinetic_energy(const Eigen::VectorXd& rate) const;  ///< u'.M u' / 2 [J]

  /// The stress in a cell (xx, yy, xy) [Pa], in the body's frame, tension positive.
  Eigen::Vector3d stress(int cell, const Eigen::VectorXd& u) const;
  double volume(int cell) const { return volumes_[static_cast<std::size_t>(cell)]; }  ///< m3

 private:
  using CellStrain = Eigen::Matrix<double, 3, 6>;  ///< strain (xx, yy, 2xy) by the displacements of a cell
  CellStrain strain_of(const std::array<int, D + 1>& cell) const;

  ElasticMesh<D> mesh_;
  ElasticMaterial material_;
  Eigen::Matrix3d law_;  ///< stress by strain
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::VectorXd masses_;
  Modes modes_;
  std::vector<double> volumes_;
  double mass_ = 0, inertia_ = 0;
};

extern template class ElasticModel<2>;

}  // namespace flyrock
