// Deformable blocks: the elements, the step, and a block that falls flat on a wall without friction.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "unit/elastic/bounce.h"

using namespace flyrock;
using namespace flyrock::test;

namespace elastic_block_test {

/// A rectangle of quads with one diagonal each.
ElasticMesh<2> one_diagonal(double length, double height, int columns, int rows) {
  ElasticMesh<2> mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.nodes.emplace_back(length * i / columns, height * j / rows);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      mesh.cells.push_back({a, b, c});
      mesh.cells.push_back({a, c, d});
    }
  return mesh;
}

TEST_CASE("a field of constant strain has constant stress and no force at the nodes inside") {
  const ElasticMaterial rock{.young = 50e9, .poisson = 0.25, .density = 2700, .thickness = 0.7};
  for (const ElasticMesh<2>& mesh : {crossed_rectangle({1, 0.6}, {5, 3}), ringed_disk(0.5, 4)}) {
    const ElasticModel<2> model(mesh, rock);
    Eigen::Matrix2d gradient;
    gradient << 1e-4, 3e-4, -2e-4, 5e-5;
    Eigen::VectorXd u(model.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      u.segment<2>(static_cast<Eigen::Index>(2 * i)) = gradient * model.mesh().nodes[i];
    const double lame = 50e9 * 0.25 / (1.25 * 0.5), shear = 50e9 / 2.5;
    const Eigen::Matrix2d strain = 0.5 * (gradient + gradient.transpose());
    const Eigen::Matrix2d stress = lame * strain.trace() * Eigen::Matrix2d::Identity() + 2 * shear * strain;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
      CHECK((model.stress(cell, u) - Eigen::Vector3d(stress(0, 0), stress(1, 1), stress(0, 1))).norm() <
            1e-12 * stress.norm());
    const Eigen::VectorXd force = model.stiffness() * u;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (std::find(mesh.surface.begin(), mesh.surface.end(), static_cast<int>(i)) == mesh.surface.end())
        CHECK(force.segment<2>(static_cast<Eigen::Index>(2 * i)).norm() < 1e-12 * stress.norm());
    CHECK(model.strain_energy(u) ==
          Approx(0.5 * (stress * strain).trace() * model.mass() / rock.density).epsilon(1e-12));
    // Rigid modes give no force, and no other mode does.
    const Eigen::MatrixXd rigid = model.stiffness() * model.rigid_modes();
    CHECK(rigid.norm() < 1e-12 * model.stiffness().norm() * model.rigid_modes().norm());
    const Eigen::MatrixXd dense = model.stiffness();
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, 0).eigenvalues();
    CHECK(std::abs(values[2]) < 1e-12 * values[values.size() - 1]);
    CHECK(values[3] > 1e-4 * values[values.size() - 1]);
  }
}

TEST_CASE("mass, centre and inertia of a mesh are exact, and its rigid modes have mass 1") {
  const ElasticMaterial rock{.young = 1, .density = 2700, .thickness = 0.7};
  const ElasticModel<2> block(crossed_rectangle({2, 0.5}, {4, 1}), rock);
  CHECK(block.mass() == Approx(2700 * 0.7).epsilon(1e-14));
  CHECK(block.inertia() == Approx(2700 * 0.7 / 12 * (4 + 0.25)).epsilon(1e-14));
  const Eigen::MatrixXd modes = block.rigid_modes();
  const Eigen::MatrixXd unit = modes.transpose() * block.masses().asDiagonal() * modes;
  CHECK((unit - Eigen::Matrix3d::Identity()).norm() < 1e-14);
  ElasticMesh<2> mesh = crossed_rectangle({1, 1}, {1, 1});
  std::swap(mesh.cells[2][0], mesh.cells[2][1]);
  CHECK_THROWS_WITH(ElasticModel<2>(mesh, rock), "cell 3 is inverted or has no area");
}

TEST_CASE("a cantilever sags as far as its triangles let it") {
  // 4 x 1 in plane strain, E 1, nu 0.25, a load of 1 as a parabola over its end: 250.502456 m by fine
  // elements
  for (const auto& [cells, expected] : {std::pair(1, 0.5988), std::pair(2, 0.8463)}) {
    const ElasticModel<2> model(crossed_rectangle({4, 1}, {4 * cells, cells}),
                                {.young = 1, .poisson = 0.25, .density = 1});
    Eigen::MatrixXd stiffness = model.stiffness();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(model.size());
    for (std::size_t i = 0; i < model.mesh().nodes.size(); ++i) {
      const Vec2& node = model.mesh().nodes[i];
      for (int k = 0; k < 2 && node.x() < -2 + 1e-9; ++k) {
        const auto row = static_cast<Eigen::Index>(2 * i) + k;
        stiffness.row(row).setZero();
        stiffness.col(row).setZero();
        stiffness(row, row) = 1;
      }
      if (node.x() < 2 - 1e-9) continue;
      for (int side = -1; side <= 1;
           side += 2) {  // the edges below and above, by Simpson's rule in each half
        const double length = 1.0 / cells;
        for (int k = 0; k <= 4; ++k) {
          const double y = node.y() + side * length * k / 4, weight = (k % 2 ? 4 : k == 2 ? 2 : 1) / 12.0;
          if (std::abs(node.y() + side * length) > 0.5 + 1e-9) continue;
          load[static_cast<Eigen::Index>(2 * i + 1)] += length * weight * 6 * (0.25 - y * y) * (1 - k / 4.0);
        }
      }
    }
    CHECK(load.sum() == Approx(1).epsilon(1e-12));
    CHECK(load.dot(stiffness.ldlt().solve(load)) / 250.502456 == Approx(expected).margin(5e-5));
  }
}

TEST_CASE("a free rectangle vibrates with the frequencies of its elements") {
  // f L/c of 10 x 1, nu 0, 80 x 8 quads with one diagonal
  const ElasticModel<2> model(one_diagonal(10, 1, 80, 8), {.young = 1, .density = 1});
  const double h = 2000;  // so long that a step is an iteration of (K + M/(theta h)^2)^-1 M
  const ElasticStep<2> step(model, h, 1);
  std::vector<Eigen::VectorXd> found;
  for (const double expected : {0.102169, 0.267478}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(model.size());
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = std::sin(1.0 + 0.37 * static_cast<double>(i * i % 101));
    double square = 0;
    for (int pass = 0; pass < 30; ++pass) {
      for (const Eigen::VectorXd& mode : found) x -= mode.dot(model.masses().cwiseProduct(x)) * mode;
      x = model.masses().cwiseProduct(x);
      step.solve(x);
      const double length = std::sqrt(x.dot(model.masses().cwiseProduct(x)));
      square = (1 / length - 1) / (h * h);
      x /= length;
    }
    found.push_back(x);
    CHECK(std::sqrt(square) / (2 * pi) * 10 == Approx(expected).epsilon(1e-5));
  }
}

ElasticModel<2> square_of(int cells, double poisson) {
  return {crossed_rectangle({1, 1}, {cells, cells}), {.young = 50e9, .poisson = poisson, .density = 2700}};
}
const double sound = std::sqrt(50e9 / 2700);

TEST_CASE("a square that falls flat rebounds by its waves") {
  const Bounce stiff = bounce(square_of(10, 0), 0.1 / sound, 1, 0);
  CHECK(stiff.rebound == Approx(0.911201).epsilon(1e-5));
  const Bounce wide = bounce(square_of(10, 0.25), 0.1 / sound, 1, 0);
  CHECK(wide.rebound == Approx(0.825063).epsilon(1e-5));
  CHECK(wide.energy == Approx(0.935374).epsilon(1e-5));
  CHECK(bounce(square_of(10, 0.25), 0.1 / sound, 1, 0.003).rebound > 0.8);
  for (const Bounce& one : {stiff, wide}) {
    CHECK(one.drift < 1e-12);
    CHECK(one.gain <= 0);
  }
}

TEST_CASE("the split into rigid motion and deformation changes nothing") {
  for (const double poisson : {0.0, 0.3})
    for (const double courant : {0.4, 1.0, 3.0}) {
      const ElasticModel<2> model = square_of(4, poisson);
      const Bounce apart = bounce(model, courant * 0.25 / sound, 2, 0);
      const Bounce whole = bounce_of_all(model, courant * 0.25 / sound, 2);
      CHECK(apart.rebound == Approx(whole.rebound).epsilon(1e-9));
      CHECK(apart.energy == Approx(whole.energy).epsilon(1e-9));
    }
}

TEST_CASE("a block that is too stiff for its step stops as a rigid one, to the last digits") {
  const ElasticModel<2> model(crossed_rectangle({1, 1}, {20, 20}),
                              {.young = 2700, .poisson = 0.25, .density = 2700});  // c = 1 m/s
  double last = 0;
  for (const double transits : {1e3, 1e4, 1e5}) {  // of a step
    const Bounce stop = bounce(model, transits, 1e-3 / transits, 0, 40);
    if (last > 0) CHECK(stop.rebound == Approx(last / 100).epsilon(0.01));
    last = stop.rebound;
    if (transits != 1e4) continue;
    CHECK(stop.rebound == Approx(9.86e-7).epsilon(1e-3));
    CHECK(stop.impulse == Approx(model.mass() * 1e-3 / transits).epsilon(2e-6));
  }
}

TEST_CASE("a block that vibrates keeps its energy, and damping takes some") {
  for (const double beta : {0.0, 1e-5}) {
    const ElasticModel<2> model(ringed_disk(0.5, 5),
                                {.young = 50e9, .poisson = 0.25, .density = 2700, .beta = beta});
    const ElasticStep<2> step(model, 2e-5, 0.5);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(model.size()), rate = u, change = u;
    for (Eigen::Index i = 0; i < rate.size(); ++i) rate[i] = std::sin(static_cast<double>(i * i % 17));
    model.drop_rigid_motion(rate);
    const double start = model.kinetic_energy(rate);
    double damped = 0;
    for (int n = 0; n < 500; ++n) {
      step.free_change(u, rate, change);
      const Eigen::VectorXd middle = rate + 0.5 * change;
      damped += 2e-5 * beta * middle.dot(model.stiffness() * middle);
      rate += change;
      u += 2e-5 * middle;
    }
    CHECK(model.kinetic_energy(rate) + model.strain_energy(u) + damped == Approx(start).epsilon(1e-9));
    CHECK((damped > 0.5 * start) == (beta > 0));
    // Nothing of the motion becomes rigid: 500 steps of 20 us at the speed of the start.
    CHECK((model.rigid_modes().transpose() * model.masses().asDiagonal() * u).norm() <
          1e-12 * std::sqrt(2 * start) * 500 * 2e-5);
  }
}

}  // namespace elastic_block_test
