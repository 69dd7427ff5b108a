#pragma once
// Linear elasticity of a block in its own frame: finite elements of constant strain
// (T3 in 2D, T4 in 3D).

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "elastic/elastic_mesh.h"

namespace flyrock {

/// Isotropic; plane strain in 2D. SI units.
struct ElasticMaterial {
  double young = 0;      ///< Pa
  double poisson = 0;    ///< below 0.5
  double density = 0;    ///< kg/m3
  double thickness = 1;  ///< m, of the 2D world; 1 in 3D
  double alpha = 0;      ///< 1/s, damping in proportion to the mass
  double beta = 0;       ///< s, damping in proportion to the stiffness
};

/// The equation of motion of the nodes, M u'' + C u' + K u = f, with the lumped mass M (each corner of a
/// cell has the same share of it) and C = alpha M + beta K. Degrees of freedom are node by node: (x, y) or
/// (x, y, z) of node 0, of node 1, ...
///
/// The motion splits into a rigid one, which the body has, and a deformation u that is M-orthogonal to it
/// (mean axes): R' M u = 0 with the rigid modes R, of which R' M R = 1. Without the split, a stiff block
/// would lose its rigid motion in the rounding of K. Linear in u: strains must stay small; turns may be
/// large.
template <int D>
class ElasticModel {
 public:
  static constexpr int rigid = Space<D>::dof;
  static constexpr int strains = D * (D + 1) / 2;
  using Modes = Eigen::Matrix<double, Eigen::Dynamic, rigid>;
  /// Strain or stress as a vector: (xx, yy, xy) in 2D, (xx, yy, zz, yz, zx, xy) in 3D; shear strains doubled.
  using Tensor = Vec<strains>;

  /// The nodes of the mesh are moved into the frame of the body: the centre of mass of the cells is the
  /// origin, and in 3D the axes are the principal ones. Throws std::invalid_argument for a cell that is
  /// inverted.
  ElasticModel(ElasticMesh<D> mesh, const ElasticMaterial& material);

  const ElasticMesh<D>& mesh() const { return mesh_; }
  const ElasticMaterial& material() const { return material_; }
  const Eigen::SparseMatrix<double>& stiffness() const { return stiffness_; }
  const Eigen::VectorXd& masses() const { return masses_; }  ///< of each degree of freedom [kg]
  const Modes& rigid_modes() const { return modes_; }
  int size() const { return static_cast<int>(masses_.size()); }

  double mass() const { return mass_; }  ///< kg, exact
  /// About the centre of mass [kg m2], exact of the cells.
  const typename Space<D>::Inertia& inertia() const { return inertia_; }
  /// From the frame of the body to that of the mesh as it was given; in 2D no turn.
  const typename Space<D>::Rotation& rotation() const { return rotation_; }

  /// f - M R R' f: what of a force on the nodes does not move the body [N]. In place.
  void drop_rigid_force(Eigen::VectorXd& force) const;
  /// u - R R' M u: what of a displacement deforms. In place.
  void drop_rigid_motion(Eigen::VectorXd& motion) const;

  double strain_energy(const Eigen::VectorXd& u) const;      ///< u.K u / 2 [J]
  double kinetic_energy(const Eigen::VectorXd& rate) const;  ///< u'.M u' / 2 [J]

  /// The stress in a cell [Pa], in the body's frame, tension positive.
  Tensor stress(int cell, const Eigen::VectorXd& u) const;
  double volume(int cell) const { return volumes_[static_cast<std::size_t>(cell)]; }  ///< m3

 private:
  static constexpr int dofs_of_cell = D * (D + 1);
  using CellStrain = Eigen::Matrix<double, strains, dofs_of_cell>;  ///< by the displacements of its nodes
  CellStrain strain_of(const std::array<int, D + 1>& cell) const;

  ElasticMesh<D> mesh_;
  ElasticMaterial material_;
  Eigen::Matrix<double, strains, strains> law_;  ///< stress by strain
  Eigen::SparseMatrix<double> stiffness_;
  Eigen::VectorXd masses_;
  Modes modes_;
  std::vector<double> volumes_;
  double mass_ = 0;
  typename Space<D>::Inertia inertia_{};
  typename Space<D>::Rotation rotation_;
};

extern template class ElasticModel<2>;
extern template class ElasticModel<3>;

}  // namespace flyrock
