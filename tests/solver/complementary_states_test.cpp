// All states of small contact problems, and the same problems by Lemke's method.
#include "solver/complementary_states.h"

#include <catch2/catch.hpp>

#include "solver/lemke.h"

using namespace flyrock;

namespace complementary_states_test {

using enum ContactMode;

FewContacts without_friction(const Eigen::MatrixXd& w, const Eigen::VectorXd& q) {
  return {std::vector<FewContacts::Contact>(static_cast<std::size_t>(q.size())), w, q, 1};
}

std::uint64_t feasible(const StateSurvey& survey) { return survey.by_fault[0]; }

/// The state of a survey with these states of its contacts.
const ComplementaryState& state(const StateSurvey& survey, const std::vector<ContactMode>& states) {
  const auto at = std::find_if(survey.states.begin(), survey.states.end(),
                               [&](const ComplementaryState& s) { return s.states == states; });
  REQUIRE(at != survey.states.end());
  return *at;
}

void check_lemke(const FewContacts& problem) {
  const ContactLcp lcp = lcp_of(problem);
  const LemkePath path = lemke(lcp.m, lcp.q);
  REQUIRE(path.end == LemkeEnd::solution);
  const Eigen::VectorXd u = problem.q + problem.w * impulses_of(problem, lcp, path.z);
  const StateSurvey survey = survey_states(problem, 10000);
  const bool is_listed = std::any_of(survey.motions.begin(), survey.motions.end(), [&](const auto& motion) {
    return (survey.states[motion.front()].u - u).norm() < 1e-8 * problem.q.norm();
  });
  CHECK(is_listed);
}

// K. G. Murty 1988, page 2: M is a P-matrix, so that there is one solution for each q.
TEST_CASE("a P-matrix has one feasible state") {
  const FewContacts problem = without_friction(Eigen::Matrix2d{{2, 1}, {1, 2}}, Eigen::Vector2d(-5, -6));
  const StateSurvey survey = survey_states(problem, 64);
  CHECK(survey.count == 4);
  REQUIRE(feasible(survey) == 1);
  const ComplementaryState& solution = state(survey, {closed, closed});
  CHECK(solution.fault == StateFault::none);
  CHECK_FALSE(solution.many);
  CHECK(solution.r[0] == Approx(4.0 / 3));
  CHECK(solution.r[1] == Approx(7.0 / 3));
  CHECK(state(survey, {open, open}).fault == StateFault::penetrates);
  CHECK(state(survey, {open, open}).value == -5);
  check_lemke(problem);
}

// W = (1 2; 2 1) is no P-matrix: q = (-1, -1) lies in three complementary cones (Cottle, Pang, Stone,
// section 1.3), q = (-1, 1) in one.
TEST_CASE("a matrix that is no P-matrix has one or three feasible states") {
  const Eigen::Matrix2d w{{1, 2}, {2, 1}};
  const StateSurvey three = survey_states(without_friction(w, Eigen::Vector2d(-1, -1)), 64);
  CHECK(feasible(three) == 3);
  CHECK(three.motions.size() == 3);
  CHECK(state(three, {open, open}).fault == StateFault::penetrates);
  CHECK(state(three, {closed, closed}).r[0] == Approx(1.0 / 3));
  CHECK(feasible(survey_states(without_friction(w, Eigen::Vector2d(-1, 1)), 64)) == 1);
}

TEST_CASE("Murty's example 2.9 has no feasible state, and Lemke ends on a ray") {
  const Eigen::Matrix3d m{{-1, 0, -3}, {1, -2, -5}, {-2, -1, -2}};
  const StateSurvey survey = survey_states(without_friction(m, Eigen::Vector3d(-3, -2, -1)), 64);
  CHECK(survey.count == 8);
  CHECK(feasible(survey) == 0);
  CHECK(survey.motions.empty());
}

TEST_CASE("a table on four legs has one motion and many loads") {
  // Unit mass and inertia, legs at (+-1, +-1); W = sum of rank 3.
  Eigen::Matrix<double, 4, 3> h;
  h << 1, 1, 1, 1, -1, 1, 1, -1, -1, 1, 1, -1;
  const FewContacts problem = without_friction(h * h.transpose(), Eigen::Vector4d::Constant(-1));
  const StateSurvey survey = survey_states(problem, 64);
  CHECK(survey.count == 16);
  REQUIRE(survey.motions.size() == 1);
  const ComplementaryState& all = state(survey, {closed, closed, closed, closed});
  CHECK(all.fault == StateFault::none);
  CHECK(all.many);
  CHECK(all.r.sum() == Approx(1));
  // Two legs across carry it too, with nothing to spare: u_n = 0 at the open ones. Two legs of one side do
  // not.
  CHECK(state(survey, {closed, open, closed, open}).fault == StateFault::none);
  CHECK_FALSE(state(survey, {closed, open, closed, open}).many);
  CHECK(state(survey, {closed, closed, open, open}).fault == StateFault::penetrates);
  check_lemke(problem);
}

// A disc that meets the ground: m W = diag(1, 3), v = (-1, v_t).
TEST_CASE("one contact with friction sticks or slides") {
  FewContacts problem{{{0.3, 0}}, Eigen::Matrix2d{{1, 0}, {0, 3}}, Eigen::Vector2d(-1, 0.6), 2};
  const StateSurvey sticking = survey_states(problem, 64);
  CHECK(sticking.count == 4);
  REQUIRE(feasible(sticking) == 1);
  CHECK(state(sticking, {sticks}).r[1] == Approx(-0.2));
  CHECK(state(sticking, {slides_forward}).fault == StateFault::along_slip);
  check_lemke(problem);
  problem.q[1] = 1.2;
  const StateSurvey sliding = survey_states(problem, 64);
  REQUIRE(feasible(sliding) == 1);
  CHECK(state(sliding, {slides_forward}).u[1] == Approx(0.3));
  CHECK(state(sliding, {sticks}).fault == StateFault::exceeds);
  CHECK(state(sliding, {sticks}).value == Approx(-0.1));
  CHECK(state(sliding, {slides_back}).fault == StateFault::along_slip);
  check_lemke(problem);
}

// Painleve's rod, tan(theta) = 2, on its tip, which slides in positive direction: m W = (1.6 1.2; 1.2 3.4).
const Eigen::Matrix2d rod{{1.6, 1.2}, {1.2, 3.4}};

FewContacts rod_of_forces(double mu, double normal) {
  return {{{mu, 1}}, rod, Eigen::Vector2d(normal, 0), 2};
}

TEST_CASE("the forces of Painleve's rod: one solution, none, two") {
  // a_n = b + (1.6 - 1.2 mu) f
  const StateSurvey one = survey_states(rod_of_forces(1.3, -9.81), 64);
  CHECK(one.count == 2);
  REQUIRE(feasible(one) == 1);
  CHECK(state(one, {closed}).r[0] == Approx(245.25));
  CHECK(state(one, {closed}).r[1] == Approx(-1.3 * 245.25));

  const StateSurvey none = survey_states(rod_of_forces(1.4, -9.81), 64);
  CHECK(feasible(none) == 0);
  CHECK(state(none, {open}).fault == StateFault::penetrates);
  CHECK(state(none, {closed}).fault == StateFault::pulls);
  const ContactLcp lcp = lcp_of(rod_of_forces(1.4, -9.81));
  CHECK(lcp.m(0, 0) < 0);
  CHECK(lemke(lcp.m, lcp.q).end == LemkeEnd::ray);

  const StateSurvey two = survey_states(rod_of_forces(1.4, 9.81), 64);
  CHECK(feasible(two) == 2);
  CHECK(two.motions.size() == 2);
  CHECK(state(two, {closed}).r[0] == Approx(9.81 / 0.08));

  // At mu = 4/3 the equations of contact are dependent: no force, and any force without weight.
  const StateSurvey border = survey_states(rod_of_forces(4.0 / 3, -9.81), 64);
  CHECK(state(border, {closed}).fault == StateFault::no_impulse);
  const StateSurvey weightless = survey_states(rod_of_forces(4.0 / 3, 0), 64);
  CHECK(state(weightless, {closed}).many);
  CHECK(weightless.motions.size() == 1);
}

TEST_CASE("the impulses of Painleve's rod: one solution where forces have none, three where they have two") {
  const double h = 1e-6;
  const FewContacts falling{{{1.4, 0}}, rod, Eigen::Vector2d(-9.81 * h, 1), 2};
  const StateSurvey one = survey_states(falling, 64);
  REQUIRE(feasible(one) == 1);
  CHECK(state(one, {sticks}).r[0] == Approx(0.3).epsilon(1e-4));
  CHECK(state(one, {sticks}).r[1] == Approx(-0.4).epsilon(1e-4));
  check_lemke(falling);

  const FewContacts lifted{{{1.4, 0}}, rod, Eigen::Vector2d(9.81 * h, 1), 2};
  const StateSurvey three = survey_states(lifted, 64);
  CHECK(feasible(three) == 3);
  CHECK(three.motions.size() == 3);
  CHECK(state(three, {slides_forward}).r[0] == Approx(9.81 * h / 0.08));
  CHECK(state(three, {slides_back}).fault != StateFault::none);
}

// A point in a groove with walls at 30 degrees from the upright, pulled upwards. Contacts: the normals
// (+-cos 30, sin 30); unit mass.
FewContacts groove(double mu) {
  const double c = std::sqrt(0.75), s = 0.5;
  Eigen::Matrix<double, 4, 2> h;
  h << c, s, s, -c, -c, s, s, c;  // n, t of the left wall, n, t of the right one; t is n turned clockwise
  return {{{mu, 0}, {mu, 0}}, h * h.transpose(), h * Eigen::Vector2d(0, 1), 2};
}

TEST_CASE("a wedge in a groove leaves or is stuck if mu exceeds the tangent of its half angle") {
  const StateSurvey smooth = survey_states(groove(0.5), 64);  // tan 30 = 0.577
  CHECK(smooth.count == 16);
  CHECK(smooth.motions.size() == 1);
  CHECK(state(smooth, {open, open}).fault == StateFault::none);
  CHECK(state(smooth, {sticks, sticks}).fault != StateFault::none);

  const FewContacts rough_groove = groove(0.7);
  const StateSurvey rough = survey_states(rough_groove, 64);
  CHECK(rough.motions.size() == 2);
  CHECK(state(rough, {open, open}).u[0] == Approx(0.5));
  const ComplementaryState& stuck = state(rough, {sticks, sticks});
  CHECK(stuck.fault == StateFault::none);
  CHECK(stuck.many);
  CHECK(stuck.u.isZero(1e-9));
  for (const int i : {0, 2}) CHECK(std::abs(stuck.r[i + 1]) <= 0.7 * stuck.r[i] * (1 + 1e-9));
}

TEST_CASE("walls that close on a body without friction have no solution, and Lemke ends on a ray") {
  const FewContacts jam = without_friction(Eigen::Matrix2d{{1, -1}, {-1, 1}}, Eigen::Vector2d(-1, -1));
  const StateSurvey survey = survey_states(jam, 64);
  CHECK(feasible(survey) == 0);
  CHECK(state(survey, {closed, closed}).fault == StateFault::no_impulse);
  const ContactLcp lcp = lcp_of(jam);
  CHECK(lemke(lcp.m, lcp.q).end == LemkeEnd::ray);
}

TEST_CASE("Lemke and enumeration agree on chains of boxes with friction") {
  // Contacts i and i + 1 share a body.
  for (const int n : {2, 3, 5}) {
    FewContacts problem;
    problem.rows = 2;
    problem.w = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    problem.q.resize(2 * n);
    for (int i = 0; i < n; ++i) {
      problem.contacts.push_back({0.2 + 0.1 * i, 0});
      problem.w.block<2, 2>(2 * i, 2 * i) = Eigen::Matrix2d{{2, 0.3}, {0.3, 3}};
      if (i > 0) {
        problem.w.block<2, 2>(2 * i, 2 * i - 2) = Eigen::Matrix2d{{-0.9, 0.1}, {0.2, -1}};
        problem.w.block<2, 2>(2 * i - 2, 2 * i) = problem.w.block<2, 2>(2 * i, 2 * i - 2).transpose();
      }
      problem.q[2 * i] = i % 2 ? 0.2 : -1;
      problem.q[2 * i + 1] = 0.4 - 0.3 * i;
    }
    check_lemke(problem);
  }
}

TEST_CASE("more states than are listed leave the feasible ones") {
  const FewContacts problem =
      without_friction(Eigen::MatrixXd::Identity(12, 12), Eigen::VectorXd::Constant(12, -1));
  const StateSurvey survey = survey_states(problem, 64);
  CHECK(survey.count == 4096);
  CHECK(survey.states.size() == 1);
  CHECK(survey.by_fault[0] == 1);
  CHECK(survey.by_fault[static_cast<std::size_t>(StateFault::penetrates)] == 4095);
}

}  // namespace complementary_states_test
