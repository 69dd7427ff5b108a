// Lemke's method on linear complementarity problems from the literature.
#include "solver/lemke.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace lemke_test {

using Kind = LcpVariable::Kind;

// K. G. Murty, Linear Complementarity, Linear and Nonlinear Programming, 1988: page 2, example 2.8.
TEST_CASE("Lemke solves Murty's problem of two unknowns") {
  const Eigen::Matrix2d m{{2, 1}, {1, 2}};
  const LemkePath path = lemke(m, Eigen::Vector2d(-5, -6));
  REQUIRE(path.end == LemkeEnd::solution);
  CHECK(path.z[0] == Approx(4.0 / 3));
  CHECK(path.z[1] == Approx(7.0 / 3));
  REQUIRE(path.pivots.size() == 3);
  CHECK(path.pivots[0].entering.kind == Kind::artificial);
  CHECK(path.pivots[0].leaving == LcpVariable{Kind::w, 1});
  CHECK(path.pivots[0].artificial == 6);
  CHECK(path.pivots[1].entering == LcpVariable{Kind::z, 1});
  CHECK(path.pivots[1].leaving == LcpVariable{Kind::w, 0});
  CHECK(path.pivots[2].entering == LcpVariable{Kind::z, 0});
  CHECK(path.pivots[2].leaving.kind == Kind::artificial);
  CHECK(path.pivots[2].artificial == 0);
}

TEST_CASE("Lemke solves Murty's example 2.8") {
  const Eigen::Matrix4d m{{1, -1, -1, -1}, {-1, 1, -1, -1}, {1, 1, 2, 0}, {1, 1, 0, 2}};
  const Eigen::Vector4d q(3, 5, -9, -5);
  const LemkePath path = lemke(m, q);
  REQUIRE(path.end == LemkeEnd::solution);
  CHECK((path.z - Eigen::Vector4d(2, 1, 3, 1)).norm() < 1e-12);
  CHECK(path.pivots.front().leaving == LcpVariable{Kind::w, 2});
}

TEST_CASE("Lemke ends on a ray in Murty's example 2.9") {
  const Eigen::Matrix3d m{{-1, 0, -3}, {1, -2, -5}, {-2, -1, -2}};
  const LemkePath path = lemke(m, Eigen::Vector3d(-3, -2, -1));
  CHECK(path.end == LemkeEnd::ray);
  CHECK(path.pivots.front().leaving == LcpVariable{Kind::w, 0});
  CHECK(path.pivots.back().artificial > 0);
}

TEST_CASE("a problem with q >= 0 is solved before the first pivot") {
  const LemkePath path = lemke(-Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 0));
  CHECK(path.end == LemkeEnd::solution);
  CHECK(path.pivots.empty());
  CHECK(path.z.isZero(0));
}

TEST_CASE("a ray names the variable that grows without bound") {
  const LemkePath path = lemke(Eigen::MatrixXd::Constant(1, 1, -1), Eigen::VectorXd::Constant(1, -1));
  CHECK(path.end == LemkeEnd::ray);
  CHECK(path.pivots.size() == 1);
  CHECK(path.on_ray == LcpVariable{Kind::z, 0});
}

TEST_CASE("ties do not make Lemke cycle") {
  // All right sides are equal, as for the corners of boxes at rest.
  const int n = 12;
  Eigen::MatrixXd m = Eigen::MatrixXd::Ones(n, n) + Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(n, -1);
  const LemkePath path = lemke(m, q);
  REQUIRE(path.end == LemkeEnd::solution);
  CHECK((path.z.array() - 1.0 / 13).abs().maxCoeff() < 1e-12);
  CHECK(lemke(m, q, 3).end == LemkeEnd::too_long);
  // Dependent rows: any z with the sum 1 is a solution.
  const LemkePath flat = lemke(Eigen::MatrixXd::Ones(n, n), q);
  REQUIRE(flat.end == LemkeEnd::solution);
  CHECK(flat.z.sum() == Approx(1));
}

}  // namespace lemke_test
