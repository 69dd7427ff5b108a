// Laws as terms of the problem, on one contact of a body of 2 kg.

#include "solver/law_terms.h"

#include <catch2/catch.hpp>

#include "solver/spring.h"

using namespace flyrock;

namespace {

using Row = Eigen::Vector3d;
using Stretch = Eigen::Matrix<double, 1, 1>;

constexpr double mass = 2, h = 1e-3;

struct Solved {
  Row impulse, velocity;
};

Solved solve(const ContactLaw& law, double gap, double duration, const Row& before, const Row& free,
             bool sticking = false, double stretch = 0) {
  ContactProblem<2> problem;
  ContactProblem<2>::Contact contact;
  contact.w = Eigen::Vector3d(1 / mass, 1 / mass, 1).asDiagonal();
  contact.q = free;
  Rebound<2> rebound;
  rebound.before = before;
  set_law<2>(law, sticking, gap, duration, contact, rebound);
  problem.contacts.push_back(contact);
  problem.first = {0, 0};
  if (law.condition == NormalCondition::penalty)
    set_spring<2>(law.spring, -gap, Stretch::Constant(stretch), duration, problem, 0, rebound);
  std::vector<Row> r(1, Row::Zero());
  ImpactSolver<2>().solve(problem, {rebound}, {}, r);
  return {r[0], free + contact.w * r[0]};
}

}  // namespace

TEST_CASE("a cohesive contact bears its pull and no more, and its friction goes with it") {
  ContactLaw law;
  law.condition = NormalCondition::cohesive;
  law.mu_s = law.mu_d = 0.5;
  law.c_n = 100;  // N: 0.05 m/s for 2 kg in 1 ms
  law.c_t = 50;
  const Solved held = solve(law, 0, h, Row::Zero(), {0.04, 0.004, 0});
  CHECK(held.impulse[0] == Approx(-0.08));
  CHECK(held.velocity.head<2>().norm() < 1e-12);
  const Solved torn = solve(law, 0, h, Row::Zero(), {0.08, 0.01, 0});
  CHECK(torn.impulse[0] == Approx(-0.1));
  CHECK(torn.velocity[0] == Approx(0.03));
  CHECK(torn.impulse[1] == Approx(0).margin(1e-15));  // at full pull the cone of friction has its tip
  const Solved pulled = solve(law, 0, h, Row::Zero(), {0.02, 1, 0});
  CHECK(pulled.impulse[0] == Approx(-0.04));
  CHECK(pulled.impulse[1] == Approx(-0.5 * (-0.04 + 0.1)));
}

TEST_CASE("shear strength holds an open contact of a joint without friction") {
  ContactLaw law;
  law.c_t = 100;
  CHECK(solve(law, 0, h, Row::Zero(), {1, 0.04, 0}).velocity[1] == Approx(0).margin(1e-15));
  CHECK(solve(law, 0, h, Row::Zero(), {1, 0.08, 0}).velocity[1] == Approx(0.03));
}

TEST_CASE("a quasi-shock lets the gap close within the step, Signorini's condition does not") {
  ContactLaw law;
  CHECK(solve(law, 1e-4, h, Row::Zero(), {-0.5, 0, 0}).velocity[0] == Approx(0).margin(1e-15));
  law.condition = NormalCondition::quasi_shock;
  CHECK(solve(law, 1e-4, h, Row::Zero(), {-0.5, 0, 0}).velocity[0] == Approx(-0.1));
  CHECK(solve(law, -1e-4, h, Row::Zero(), {-0.5, 0, 0}).velocity[0] == Approx(0).margin(1e-15));
}

TEST_CASE("a spring pushes with k times the overlap, and friction is bound by that") {
  ContactLaw law;
  law.condition = NormalCondition::penalty;
  law.spring.stiffness = 1e5;
  law.mu_s = law.mu_d = 0.3;
  const Solved pushed = solve(law, -2e-3, h, Row::Zero(), {-0.5, 1, 0});
  CHECK(pushed.impulse[0] == Approx(0.2));
  CHECK(pushed.impulse[1] == Approx(-0.06));
  CHECK(pushed.velocity[0] == Approx(-0.4));
  CHECK(solve(law, 1e-3, h, Row::Zero(), {-0.5, 1, 0}).impulse.norm() == 0);
  CHECK(solve(law, -2e-3, 0, {-0.5, 1, 0}, {-0.5, 1, 0}).impulse.norm() == 0);  // an impact has no duration
}

TEST_CASE("a damper acts by a mean of the velocities before and after, and never pulls") {
  ContactLaw law;
  law.condition = NormalCondition::penalty;
  law.spring = {.stiffness = 1e5, .damping = 400, .exponent = 1.5};
  const double d = 2e-3, c = 400 * std::sqrt(d), elastic = 1e5 * d * std::sqrt(d);
  const Solved pressed = solve(law, -d, h, {-0.5, 0, 0}, {-0.51, 0, 0});
  const double weight = damper_weight(h * c / mass);
  const double mean = (1 - weight) * -0.5 + weight * pressed.velocity[0];
  CHECK(pressed.impulse[0] == Approx(h * (elastic - c * mean)).epsilon(1e-12));
  CHECK(solve(law, -d, h, {5, 0, 0}, {5, 0, 0}).impulse[0] == 0);  // elastic - c mean is a pull
}

TEST_CASE("a damper alone lets a speed decay as exp(-c h/m), however strong it is") {
  ContactLaw law;
  law.condition = NormalCondition::penalty;
  for (const double decay : {1e-6, 0.00999, 0.01001, 0.3, 2.0, 20.0, 1e6}) {
    law.spring = {.stiffness = 1e-6, .damping = decay * mass / h};
    const Solved slowed = solve(law, -1e-9, h, {-0.5, 0, 0}, {-0.5, 0, 0});
    CHECK(slowed.velocity[0] == Approx(-0.5 * std::exp(-decay)).epsilon(1e-12).margin(1e-14));
  }
}

TEST_CASE("a tangential spring holds by its stretch, up to the friction of the push") {
  ContactLaw law;
  law.condition = NormalCondition::penalty;
  law.spring = {.stiffness = 1e5, .tangential_stiffness = 8e4};
  law.mu_s = law.mu_d = 0.3;
  CHECK(solve(law, -2e-3, h, Row::Zero(), {0, 1, 0}, true, 5e-4).impulse[1] == Approx(-h * 8e4 * 5e-4));
  CHECK(solve(law, -2e-3, h, Row::Zero(), {0, 1, 0}, true, -2e-3).impulse[1] == Approx(h * 0.3 * 1e5 * 2e-3));
  CHECK(solve(law, 1e-3, h, Row::Zero(), {0, 1, 0}, true, 1e-3).impulse.norm() == 0);
}

TEST_CASE("LMGC90's law lets a separating contact come back, Moreau's does not") {
  ContactLaw law;
  law.e_n = 0.5;
  const Row before(1, 0, 0), free(-1, 0, 0);
  CHECK(solve(law, 0, h, before, free).velocity[0] == Approx(0).margin(1e-15));
  law.as_lmgc90 = true;
  CHECK(solve(law, 0, h, before, free).velocity[0] == Approx(-0.5));
}

TEST_CASE("the form velocity gives the velocity whatever the friction, in company the others have e = 0") {
  ContactLaw law;
  law.form = RestitutionForm::velocity;
  law.e_n = 0.4;
  law.e_t = 0.8;
  const Row v(-2, 3, 0);
  const Solved solved = solve(law, 0, 0, v, v);
  CHECK(solved.velocity[0] == Approx(0.8));
  CHECK(solved.velocity[1] == Approx(2.4));

  ContactProblem<2> problem;
  ContactProblem<2>::Contact contact;
  contact.w = Eigen::Vector3d(1, 1, 1).asDiagonal();
  contact.q = v;
  Rebound<2> rebound;
  rebound.before = v;
  set_law<2>(law, false, 0, 0, contact, rebound);
  for (int a : {0, 1}) {
    problem.contacts.push_back(contact);
    problem.first.push_back(problem.couplings());
    problem.couple(1 - a, Eigen::Matrix3d::Identity() * 0.5);
  }
  problem.first.push_back(problem.couplings());
  Rebound<2> other;
  other.before = v;
  std::vector<Row> r(2, Row::Zero());
  CHECK(ImpactSolver<2>().solve(problem, {rebound, other}, {}, r).converged);
  const Row struck = v + r[0] + 0.5 * r[1], stopped = v + r[1] + 0.5 * r[0];
  CHECK(struck[0] >= 0.8);
  CHECK(stopped[0] >= -1e-12);
  CHECK(r[1][0] > 0);
}

TEST_CASE("several contacts under the energetic form keep their balance and gain nothing") {
  // A square of 2 kg that lands flat and sliding, on two corners.
  for (const double mu : {0.0, 0.3, 1.0})
    for (const double slip : {-3.0, -0.5, 0.0, 2.0}) {
      ContactProblem<2> problem;
      std::vector<Rebound<2>> rebounds(2);
      const auto columns = [](double x) {
        Eigen::Matrix3d c;  // columns n, t, rolling of H for a lever (x, -0.5)
        c << 0, 1, 0, 1, 0, 0, x, 0.5, 1;
        return c;
      };
      const Eigen::Matrix3d inverse_mass = Eigen::Vector3d(0.5, 0.5, 3).asDiagonal();
      const Eigen::Vector3d motion(slip, -1, 0.1);
      const double x[] = {-0.5, 0.5};
      for (int a : {0, 1}) {
        ContactProblem<2>::Contact contact;
        contact.w = columns(x[a]).transpose() * inverse_mass * columns(x[a]);
        contact.q = columns(x[a]).transpose() * motion;
        contact.mu = mu;
        rebounds[a].form = RestitutionForm::energy;
        rebounds[a].e_n = 0.6;
        rebounds[a].before = contact.q;
        problem.contacts.push_back(contact);
        problem.first.push_back(problem.couplings());
        problem.couple(1 - a, columns(x[a]).transpose() * inverse_mass * columns(x[1 - a]));
      }
      problem.first.push_back(problem.couplings());
      std::vector<Row> r(2, Row::Zero());
      SolveSettings settings;
      settings.tolerance = 1e-12;
      const SolveResult result = ImpactSolver<2>().solve(problem, rebounds, settings, r);
      INFO("mu " << mu << ", slip " << slip << ", r " << r[0].transpose() << " | " << r[1].transpose());
      CHECK(result.converged);
      const Eigen::Vector3d after = motion + inverse_mass * (columns(-0.5) * r[0] + columns(0.5) * r[1]);
      const auto energy = [&](const Eigen::Vector3d& v) {
        return v.cwiseProduct(v).dot(Eigen::Vector3d(1, 1, 1.0 / 6));
      };
      CHECK(energy(after) <= energy(motion));
      CHECK(after[1] > 0);
      if (mu == 0) CHECK(after[1] == Approx(0.6).epsilon(1e-6));
    }
}

TEST_CASE(
    "rolling resistance of a spring is bound by its push, that of a cohesive contact by pull and pressure") {
  ContactLaw law;
  law.mu_r = 0.1;
  law.condition = NormalCondition::penalty;
  law.spring.stiffness = 1e6;
  const Solved spring = solve(law, -1e-3, h, Row::Zero(), {0, 0, 5});
  CHECK(spring.impulse[0] == Approx(1));  // h k 1e-3
  CHECK(spring.impulse[2] == Approx(-0.1));
  const Solved held = solve(law, -1e-3, h, Row::Zero(), {0, 0, 0.05});
  CHECK(held.velocity[2] == Approx(0).margin(1e-15));
  law = {};
  law.mu_r = 0.1;
  law.condition = NormalCondition::cohesive;
  law.c_n = 100;
  const Solved pulled = solve(law, 0, h, Row::Zero(), {0.02, 0, 5});
  CHECK(pulled.impulse[0] == Approx(-0.04));
  CHECK(pulled.impulse[2] == Approx(-0.1 * (-0.04 + 0.1)));
}

TEST_CASE("a spring in space resists rolling and spinning by its push") {
  ContactLaw law;
  law.mu_r = 0.1;
  law.mu_spin = 0.02;
  law.condition = NormalCondition::penalty;
  law.spring.stiffness = 1e6;
  ContactProblem<3> problem;
  ContactProblem<3>::Contact contact;
  contact.w =
      (Eigen::Matrix<double, 6, 1>() << 1 / mass, 1 / mass, 1 / mass, 1, 1, 1).finished().asDiagonal();
  contact.q << 0, 0, 0, 5, 3, -4;
  Rebound<3> rebound;
  set_law<3>(law, false, -1e-3, h, contact, rebound);
  problem.contacts.push_back(contact);
  problem.first = {0, 0};
  set_spring<3>(law.spring, 1e-3, Eigen::Vector2d::Zero(), h, problem, 0, rebound);
  std::vector<ContactProblem<3>::Row> r(1, ContactProblem<3>::Row::Zero());
  CHECK(ImpactSolver<3>().solve(problem, {rebound}, {}, r).converged);
  CHECK(r[0][0] == Approx(1));
  CHECK(r[0][3] == Approx(-0.02));
  CHECK(r[0][4] == Approx(-0.06));
  CHECK(r[0][5] == Approx(0.08));
}

TEST_CASE(
    "rolling resistance acts in both phases of an impact: a central one has mu_r times the whole normal "
    "impulse") {
  ContactLaw law;
  law.mu_r = 0.1;
  law.e_n = 0.5;
  const Row before(-1, 0, 5);
  for (const RestitutionForm form :
       {RestitutionForm::newton, RestitutionForm::poisson, RestitutionForm::energy}) {
    law.form = form;
    const Solved solved = solve(law, 0, 0, before, before);
    CHECK(solved.impulse[0] == Approx(mass * 1.5));
    CHECK(solved.impulse[2] == Approx(-0.1 * mass * 1.5));
  }
}
