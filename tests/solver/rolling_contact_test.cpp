// One contact with rolling resistance: the local problem is solved exactly, whatever slides and rolls.

#include <catch2/catch.hpp>

#include "solver/local_2d.h"
#include "solver/residual.h"

using namespace flyrock;

TEST_CASE("a contact with rolling resistance is solved in one go, sliding or sticking, rolling or held") {
  const double mass = 200, inertia = 7, x = 0.12, y = -0.25;
  Eigen::Matrix3d rows;  // normal, tangent and rolling velocity from (v_x, v_y, w)
  rows << 0, 1, x, 1, 0, -y, 0, 0, 1;
  const Eigen::Matrix3d inverse_mass = Eigen::Vector3d(1 / mass, 1 / mass, 1 / inertia).asDiagonal();
  for (double mu : {0.1, 0.5, 0.9})
    for (double mu_r : {1e-3, 0.03, 0.3})
      for (const Eigen::Vector3d& velocity :
           {Eigen::Vector3d(0, -0.01, 0), Eigen::Vector3d(0.5, -0.2, -1), Eigen::Vector3d(0.5, -0.2, -3),
            Eigen::Vector3d(-0.3, -1, 2), Eigen::Vector3d(-3, -1, -2)}) {
        ContactProblem<2>::Contact contact;
        contact.w = rows * inverse_mass * rows.transpose();
        contact.q = rows * velocity;
        contact.mu = mu;
        contact.mu_r = mu_r;
        const auto r = solve_local(contact, contact.q);
        const auto u = (contact.q + contact.w * r).eval();
        INFO("mu " << mu << ", mu_r " << mu_r << ", velocity " << velocity.transpose());
        CHECK(local_error<2>(contact, u, r) < 1e-14);
        CHECK(r.dot(contact.q + u) <= 0);
      }
}

TEST_CASE(
    "bounds with a constant part resist slip and rolling of an open contact together, and of a closed one") {
  Eigen::Matrix3d rows;
  rows << 0, 1, 0.12, 1, 0, 0.25, 0, 0, 1;
  const Eigen::Matrix3d inverse_mass = Eigen::Vector3d(1.0 / 200, 1.0 / 200, 1.0 / 7).asDiagonal();
  for (const bool normal : {true, false})
    for (const double c_t : {0.0, 4.0, 400.0})
      for (const double c_r : {0.5, 50.0})
        for (const Eigen::Vector3d& velocity :
             {Eigen::Vector3d(0.5, 0.2, -1), Eigen::Vector3d(0.5, -0.2, -3), Eigen::Vector3d(-0.3, 0.01, 2),
              Eigen::Vector3d(0.01, -1, 0.02)}) {
          ContactProblem<2>::Contact contact;
          contact.w = rows * inverse_mass * rows.transpose();
          contact.q = rows * velocity;
          contact.mu = 0.4;
          contact.mu_r = 0.05;
          contact.c_t = c_t;
          contact.c_r = c_r;
          contact.normal = normal;
          const auto r = solve_local(contact, contact.q);
          const auto u = (contact.q + contact.w * r).eval();
          INFO("c_t " << c_t << ", c_r " << c_r << ", velocity " << velocity.transpose());
          CHECK(local_error<2>(contact, u, r) < 1e-13);
        }
}
