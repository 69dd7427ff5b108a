// Impacts with closed forms: an oblique ball, rows of balls, a rod beyond the Painleve paradox, and random
// rods.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/space.h"
#include "random/stream.h"
#include "verify/check.h"
#include "verify/single_impact.h"

namespace flyrock {

namespace {

/// The velocities after the first of n balls of mass 1 hits the others at 1 m/s. The others touch each other
/// and are at rest.
std::vector<double> struck_row(int n, double e, RestitutionForm form) {
  ContactProblem<2> problem;
  std::vector<Rebound<2>> rebounds(n - 1);
  for (int a = 0; a + 1 < n;
       ++a) {  // contact a is between balls a and a + 1; its normal points to ball a + 1
    ContactProblem<2>::Contact contact;
    contact.w = Eigen::Vector3d(2, 2, 1).asDiagonal();
    contact.q = {a == 0 ? -1.0 : 0.0, 0, 0};
    problem.contacts.push_back(contact);
    problem.first.push_back(problem.couplings());
    for (const int b : {a - 1, a + 1})
      if (b >= 0 && b + 1 < n) problem.couple(b, Eigen::Vector3d(-1, -1, 0).asDiagonal().toDenseMatrix());
    rebounds[a].form = form;
    rebounds[a].e_n = e;
    rebounds[a].before = contact.q;
  }
  problem.first.push_back(problem.couplings());
  std::vector<ContactProblem<2>::Row> r(n - 1, ContactProblem<2>::Row::Zero());
  SolveSettings settings;
  settings.tolerance = 1e-13;
  ImpactSolver<2>().solve(problem, rebounds, settings, r);
  std::vector<double> speeds;
  for (int i = 0; i < n; ++i)
    speeds.push_back((i == 0 ? 1 : 0) + (i > 0 ? r[i - 1][0] : 0) - (i + 1 < n ? r[i][0] : 0));
  return speeds;
}

}  // namespace

// Sphere of mass 1 and radius 1 at (3, -2) m/s without spin, e = 0.5. It sticks if mu >= 2 |v_t| / (7 (1 + e)
// |v_n|).
void check_oblique_ball(Checks& checks) {
  SingleImpact<2> ball;
  ball.w << 1, 0, 0, 3.5;
  ball.v = {-2, 3};
  ball.e = 0.5;
  for (const double mu : {0.2, 0.3}) {
    ball.mu = mu;
    const bool sticks = mu > 2.0 * 3 / (7 * 1.5 * 2);
    const double p_t = sticks ? -6.0 / 7 : -0.6, v_t = sticks ? 0 : 0.9;
    for (const RestitutionForm form : {RestitutionForm::newton, RestitutionForm::newton_mean,
                                       RestitutionForm::poisson, RestitutionForm::energy}) {
      const SingleOutcome<2> out = solve_single(ball, form);
      const bool mean =
          sticks && form == RestitutionForm::newton_mean;  // here v_t^+ comes from mu p_n and not from stick
      add_worst(checks, fmt::format("oblique ball that {}, {}", sticks ? "sticks" : "slips", name_of(form)),
                "problem", 1e-10,
                {{"p_n", out.impulse[0], 3},
                 {"p_t", out.impulse[1], mean ? -0.9 : p_t},
                 {"v_t", out.after[1], mean ? -0.15 : v_t}});
    }
  }
}

void check_ball_rows(Checks& checks) {
  for (const RestitutionForm form : {RestitutionForm::newton, RestitutionForm::poisson}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      const std::vector<double> v = struck_row(3, e, form);
      add_worst(checks, fmt::format("three balls, e {}, {}", e, name_of(form)), "problem", 1e-9,
                {{"v_1", v[0], (1 - 2 * e) / 3}, {"v_2", v[1], (1 + e) / 3}, {"v_3", v[2], (1 + e) / 3}});
    }
    const std::vector<double> v = struck_row(5, 1, form);
    add_worst(checks, fmt::format("five balls, e 1, {}", name_of(form)), "problem", 1e-9,
              {{"v_1", v[0], -0.6},
               {"v_2", v[1], 0.4},
               {"v_3", v[2], 0.4},
               {"v_4", v[3], 0.4},
               {"v_5", v[4], 0.4}});
  }
}

// At 63.435 degrees the paradox begins at mu = 4/3. Above this value W_nn - mu |W_tn| < 0 for slip to the
// right.
void check_painleve_rod(Checks& checks) {
  for (const double mu : {1.3, 1.4, 5.0})
    for (const RestitutionForm form : {RestitutionForm::newton, RestitutionForm::newton_mean,
                                       RestitutionForm::poisson, RestitutionForm::energy}) {
      double least_impulse = 1e300, gained = 0;
      for (const double slip : {-1.0, 0.0, 0.2, 1.0}) {
        const SingleOutcome<2> out =
            solve_single<2>({rod_mobility(std::atan(2.0)), {-1, slip}, mu, 0.0}, form);
        least_impulse = std::min(least_impulse, out.impulse[0]);
        gained = std::max(gained, out.energy);
      }
      add_worst(checks,
                fmt::format("rod {} Painleve's paradox, mu {}, {}", mu < 4.0 / 3 ? "below" : "beyond", mu,
                            name_of(form)),
                "problem", 1e-12,
                {{"an impulse (1: yes)", least_impulse > 0 ? 1.0 : 0.0, 1}, {"energy gained", gained, 0}});
    }
}

// Rods at 5 to 85 degrees that hit at 1 m/s from any side, |spin| <= 2 rad/s, mu and e from 0 to 1, no jam.
void check_random_impacts(Checks& checks) {
  constexpr int trials = 100000;
  constexpr RestitutionForm forms[] = {RestitutionForm::newton, RestitutionForm::newton_mean,
                                       RestitutionForm::poisson, RestitutionForm::energy};
  RandomStream rng(1, "random rod impacts", {});
  int struck = 0, gains[4] = {};
  while (struck < trials) {
    const double angle = rng.uniform(5, 85) * pi / 180, course = rng.uniform(0, 2 * pi),
                 spin = rng.uniform(-2, 2);
    const double x = 0.5 * std::cos(angle), y = -0.5 * std::sin(angle);
    SingleImpact<2> impact{rod_mobility(angle),
                           {std::sin(course) + spin * x, std::cos(course) - spin * y},
                           rng.uniform(),
                           rng.uniform()};
    const bool jams = impact.w(0, 0) <= impact.mu * std::abs(impact.w(0, 1));
    if (impact.v[0] >= 0 || jams) continue;
    ++struck;
    for (int k = 0; k < 4; ++k) gains[k] += solve_single(impact, forms[k]).energy > 1e-12;
  }
  // The share of newton depends on the distribution of the rods. Another computation with the same ranges
  // found 1.68 % of 89,200.
  checks.push_back({"random rods, newton: share that gains energy", "problem", double(gains[0]) / trials,
                    0.0168, 0.003, std::abs(double(gains[0]) / trials - 0.0168) <= 0.003});
  for (int k = 1; k < 4; ++k)
    checks.push_back({fmt::format("random rods, {}: impacts that gain energy", name_of(forms[k])), "problem",
                      double(gains[k]), 0, 0, gains[k] == 0});
}

}  // namespace flyrock
