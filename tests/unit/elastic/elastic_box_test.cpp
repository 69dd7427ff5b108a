// Deformable blocks in 3D: tetrahedra, their mesh, and a block that falls flat.

#include <catch2/catch.hpp>

#include "elastic/stress_share.h"
#include "unit/elastic/bounce.h"

using namespace flyrock;
using namespace flyrock::test;

namespace elastic_box_test {

const ElasticMaterial rock{.young = 50e9, .poisson = 0.25, .density = 2700};
const double sound = std::sqrt(50e9 / 2700);

/// A cube of side 1 of n^3 bricks, each of six tetrahedra about the same diagonal.
ElasticMesh<3> one_diagonal_cube(int n) {
  ElasticMesh<3> mesh = bricked_box(Vec3::Ones(), {n, n, n});
  mesh.cells.clear();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (int first = 0; first < 3; ++first)
          for (const int then : {1, 2}) {
            Eigen::Vector3i at(i, j, k);
            ElasticMesh<3>::Cell cell{};
            for (int corner = 0; corner < 4; ++corner) {
              cell[corner] = (at.z() * (n + 1) + at.y()) * (n + 1) + at.x();
              if (corner < 3) at[(first + corner * then) % 3] += 1;
            }
            if (then == 2) std::swap(cell[2], cell[3]);
            mesh.cells.push_back(cell);
          }
  return mesh;
}

/// The natural frequency f [Hz] to which inverse iteration from `x` leads, with any mass matrix.
double frequency(const ElasticModel<3>& model, const Eigen::SparseMatrix<double>& mass, Eigen::VectorXd x,
                 int passes) {
  Eigen::SparseMatrix<double> shifted =
      model.stiffness() + mass;  // rigid modes would have an infinite inverse
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(shifted);
  Eigen::MatrixXd rigid = model.rigid_modes();
  for (int k = 0; k < rigid.cols(); ++k) {
    for (int j = 0; j < k; ++j) rigid.col(k) -= rigid.col(j).dot(mass * rigid.col(k)) * rigid.col(j);
    rigid.col(k) /= std::sqrt(rigid.col(k).dot(mass * rigid.col(k)));
  }
  for (int pass = 0; pass < passes; ++pass) {
    x = factor.solve(mass * x);
    x -= rigid * (rigid.transpose() * (mass * x));
    x /= std::sqrt(x.dot(mass * x));
  }
  return std::sqrt(x.dot(model.stiffness() * x)) / (2 * pi);
}

Eigen::SparseMatrix<double> lumped_mass(const ElasticModel<3>& model) {
  Eigen::SparseMatrix<double> mass(model.size(), model.size());
  mass.setIdentity();
  mass.diagonal() = model.masses();
  return mass;
}

/// The integrals of products of shape functions: V/20 between two corners of a cell, V/10 of one.
Eigen::SparseMatrix<double> consistent_mass(const ElasticModel<3>& model) {
  Eigen::SparseMatrix<double> mass(model.size(), model.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < model.mesh().cells.size(); ++i)
    for (const int a : model.mesh().cells[i])
      for (const int b : model.mesh().cells[i])
        for (int k = 0; k < 3; ++k)
          entries.emplace_back(
              3 * a + k, 3 * b + k,
              model.material().density * model.volume(static_cast<int>(i)) / (a == b ? 10 : 20));
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

Eigen::VectorXd any_motion(const ElasticModel<3>& model) {
  Eigen::VectorXd x(model.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 + 0.37 * static_cast<double>(i * i % 101));
  return x;
}

TEST_CASE("tetrahedra in a field of constant strain have constant stress and no force at nodes inside") {
  const ElasticMesh<3> mesh = bricked_box({1, 0.6, 0.4}, {3, 3, 2});
  const ElasticModel<3> model(mesh, rock);
  Eigen::Matrix3d gradient;
  gradient << 1e-4, 3e-4, -1e-4, -2e-4, 5e-5, 2e-4, 6e-5, -7e-5, -9e-5;
  Eigen::VectorXd u(model.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    u.segment<3>(static_cast<Eigen::Index>(3 * i)) = gradient * model.mesh().nodes[i];
  const double lame = 50e9 * 0.25 / (1.25 * 0.5), shear = 50e9 / 2.5;
  const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
  const Eigen::Matrix3d stress = lame * strain.trace() * Eigen::Matrix3d::Identity() + 2 * shear * strain;
  const Vec<6> expected({stress(0, 0), stress(1, 1), stress(2, 2), stress(1, 2), stress(2, 0), stress(0, 1)});
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stress).eigenvalues();
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    CHECK((model.stress(cell, u) - expected).norm() < 1e-12 * stress.norm());
    CHECK(principal_stress(model, cell, u).greatest == Approx(principal[2]).epsilon(1e-12));
    CHECK(principal_stress(model, cell, u).least == Approx(principal[0]).epsilon(1e-12));
  }
  const Eigen::VectorXd force = model.stiffness() * u;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (!std::binary_search(mesh.surface.begin(), mesh.surface.end(), static_cast<int>(i)))
      CHECK(force.segment<3>(static_cast<Eigen::Index>(3 * i)).norm() < 1e-12 * stress.norm());
  CHECK(model.strain_energy(u) ==
        Approx(0.5 * (stress * strain).trace() * model.mass() / rock.density).epsilon(1e-12));
  CHECK(stress_share(model, u, 0.9 * principal[2]).above_strength == Approx(1).epsilon(1e-12));
}

TEST_CASE("a box of tetrahedra has six rigid modes and no other without a force") {
  const ElasticModel<3> model(bricked_box({1, 0.6, 0.4}, {2, 2, 1}), rock);
  const Eigen::MatrixXd rigid = model.stiffness() * model.rigid_modes();
  CHECK(rigid.norm() < 1e-12 * model.stiffness().norm() * model.rigid_modes().norm());
  const Eigen::MatrixXd modes = model.rigid_modes();
  CHECK((modes.transpose() * model.masses().asDiagonal() * modes - Eigen::MatrixXd::Identity(6, 6)).norm() <
        1e-14);
  const Eigen::MatrixXd dense = model.stiffness();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, 0).eigenvalues();
  CHECK(std::abs(values[5]) < 1e-12 * values[values.size() - 1]);
  CHECK(values[6] > 1e-4 * values[values.size() - 1]);
}

TEST_CASE("mass, inertia and principal axes of tetrahedra are exact") {
  const ElasticModel<3> box(bricked_box({2, 0.5, 1}, {4, 1, 2}), rock);
  CHECK(box.mass() == Approx(2700).epsilon(1e-14));
  CHECK((box.inertia() - 2700 / 12.0 * Vec3(0.25 + 1, 4 + 1, 4 + 0.25)).norm() < 1e-12 * 2700);
  CHECK(box.rotation().vector().isZero(0));
  ElasticMesh<3> mesh = bricked_box({2, 0.5, 1}, {4, 1, 2});
  const Rotation3 turn = Rotation3::from_vector({0.3, -0.5, 0.9});
  for (Vec3& node : mesh.nodes) node = turn * node + Vec3(1, 2, 3);
  const ElasticModel<3> turned(mesh, rock);
  CHECK((turned.inertia() - 2700 / 12.0 * Vec3(1.25, 4.25, 5)).norm() < 1e-12 * 2700);  // in ascending order
  double error = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    error =
        std::max(error, (turned.rotation() * turned.mesh().nodes[i] + Vec3(1, 2, 3) - mesh.nodes[i]).norm());
  CHECK(error < 1e-13);
  std::swap(mesh.cells[2][0], mesh.cells[2][1]);
  CHECK_THROWS_WITH(ElasticModel<3>(mesh, rock), "cell 3 is inverted or has no volume");
}

TEST_CASE("the sides of a box face outwards and close it") {
  const ElasticMesh<3> mesh = bricked_box({1, 2, 3}, {3, 2, 3});
  CHECK(mesh.cells.size() == 5 * 18);
  CHECK(mesh.sides.size() == 2 * 2 * (6 + 6 + 9));
  CHECK(mesh.surface.size() == 4 * 3 * 4 - 2 * 1 * 2);
  double volume = 0;
  for (const auto& [a, b, c] : mesh.sides) {
    const Vec3 area = 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
    CHECK(area.dot(mesh.nodes[a]) > 0);
    volume += area.dot(mesh.nodes[a]) / 3;
  }
  CHECK(volume == Approx(6).epsilon(1e-14));
  CHECK(moments_of(mesh).volume == Approx(6).epsilon(1e-14));
}

TEST_CASE("a free cube vibrates with the frequencies of its tetrahedra") {
  // f L/c of the lowest modes, nu 0.25, 4 bricks a side
  const ElasticMaterial unit{.young = 1, .poisson = 0.25, .density = 1};
  const ElasticModel<3> diagonals(one_diagonal_cube(4), unit);
  CHECK(frequency(diagonals, consistent_mass(diagonals), any_motion(diagonals), 40) ==
        Approx(0.343525).epsilon(3e-6));
  const ElasticModel<3> bricks(bricked_box(Vec3::Ones(), {4, 4, 4}), unit);
  CHECK(frequency(bricks, lumped_mass(bricks), any_motion(bricks), 40) == Approx(0.301792).epsilon(3e-6));
}

TEST_CASE("a bar of tetrahedra with nu 0 has the frequency and the rebound of the 1D wave") {
  const ElasticModel<3> bar(bricked_box({1, 0.1, 0.1}, {20, 2, 2}), {.young = 1, .density = 1});
  Eigen::VectorXd x = Eigen::VectorXd::Zero(bar.size());
  for (std::size_t i = 0; i < bar.mesh().nodes.size(); ++i)
    x[static_cast<Eigen::Index>(3 * i)] = std::sin(pi * bar.mesh().nodes[i].x());
  CHECK(frequency(bar, lumped_mass(bar), x, 3) == Approx(0.5).epsilon(2e-3));
  // The bar of 10 elements of the 1D table
  const ElasticModel<3> upright(bricked_box({0.1, 0.1, 1}, {1, 1, 10}), {.young = 50e9, .density = 2700});
  const Bounce fall = bounce(upright, 0.1 / sound, 1, 0);
  CHECK(fall.rebound == Approx(0.900349).epsilon(5e-3));
  CHECK(fall.energy == Approx(0.929289).epsilon(1e-3));
  CHECK(fall.forces.front() / (2700 * sound * 0.01) == Approx(0.707107).epsilon(5e-3));
}

TEST_CASE("a cantilever of tetrahedra sags as far as they let it") {
  // 4 x 1 x 1, E 1, nu 0.25, a load of 1 spread over its end; by a dense program of the same elements
  for (const auto& [bricks, expected] : {std::pair(1, 95.5466), std::pair(2, 177.6736)}) {
    const ElasticModel<3> model(bricked_box({4, 1, 1}, {4 * bricks, bricks, bricks}),
                                {.young = 1, .poisson = 0.25, .density = 1});
    Eigen::SparseMatrix<double> stiffness = model.stiffness();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(model.size());
    const auto& nodes = model.mesh().nodes;
    const auto at_end = [&](int node, double end) { return std::abs(nodes[node].x() - end) < 1e-9; };
    for (const auto& side : model.mesh().sides) {
      if (!std::all_of(side.begin(), side.end(), [&](int node) { return at_end(node, 2); })) continue;
      const double area =
          0.5 * (nodes[side[1]] - nodes[side[0]]).cross(nodes[side[2]] - nodes[side[0]]).norm();
      for (const int node : side) load[3 * node + 2] += area / 3;
    }
    CHECK(load.sum() == Approx(1).epsilon(1e-12));
    for (int node = 0; node < static_cast<int>(nodes.size()); ++node)  // held by stiff springs
      for (int k = 0; k < 3 && at_end(node, -2); ++k) stiffness.coeffRef(3 * node + k, 3 * node + k) = 1e12;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(stiffness);
    CHECK(load.dot(factor.solve(load)) == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("a cube that falls flat rebounds by its waves, and the split of its motion changes nothing") {
  for (const double poisson : {0.0, 0.25}) {
    const ElasticModel<3> model(bricked_box(Vec3::Ones(), {2, 2, 2}),
                                {.young = 50e9, .poisson = poisson, .density = 2700});
    const Bounce apart = bounce(model, 0.5 / sound, 2, 0), whole = bounce_of_all(model, 0.5 / sound, 2);
    CHECK(apart.rebound == Approx(whole.rebound).epsilon(1e-9));
    CHECK(apart.energy == Approx(whole.energy).epsilon(1e-9));
    CHECK(apart.drift < 1e-12);
    CHECK(apart.gain <= 0);
  }
}

TEST_CASE("a cube that is too stiff for its step stops as a rigid one") {
  const ElasticModel<3> model(bricked_box(Vec3::Ones(), {3, 3, 3}),
                              {.young = 2700, .poisson = 0.25, .density = 2700});  // c = 1 m/s
  double last = 0;
  for (const double transits : {1e3, 1e4, 1e5}) {  // of a step
    const Bounce stop = bounce(model, transits, 1e-3 / transits, 0, 40);
    if (last > 0) CHECK(stop.rebound == Approx(last / 100).epsilon(0.01));
    last = stop.rebound;
    CHECK(stop.rebound * transits * transits < 200);
    CHECK(stop.impulse == Approx(model.mass() * 1e-3 / transits).epsilon(1e-3));
  }
}

}  // namespace elastic_box_test
