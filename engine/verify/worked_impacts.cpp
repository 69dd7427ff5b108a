// Impacts worked by hand: rods A to G and the double pendulum in closed form, the box by integration in
// impulse space.

#include <fmt/format.h>

#include "math/space.h"
#include "verify/check.h"
#include "verify/single_impact.h"

namespace flyrock {

namespace {

/// How an impact is computed: a form of the solver, its two phases, or the path in impulse space.
enum class By { newton, newton_mean, poisson, energy, two_phase_poisson, path_newton };
constexpr const char* names[] = {"newton", "newton_mean",           "poisson",
                                 "energy", "poisson in two phases", "path to -e v_n"};

template <int D>
SingleOutcome<D> compute(const SingleImpact<D>& impact, By by) {
  switch (by) {
    case By::newton:
      return solve_single(impact, RestitutionForm::newton);
    case By::newton_mean:
      return solve_single(impact, RestitutionForm::newton_mean);
    case By::poisson:
      return solve_single(impact, RestitutionForm::poisson);
    case By::energy:
      return solve_single(impact, RestitutionForm::energy);
    case By::two_phase_poisson:
      return solve_single(impact, RestitutionForm::poisson, true);
    case By::path_newton:
      break;
  }
  return follow_single(impact, ImpactEnd::newton);
}

struct RodRow {
  const char* id;
  double degrees, mu, e, vx;  // the rod falls at 1 m/s
  By by;
  double p_t, p_n, v_t, v_n, energy;
};

// Uniform rod, m = 1, L = 1, no spin, contact at its lower right tip. Six decimals.
constexpr RodRow rod_rows[] = {
    {"A", 30, 0.3, 0.5, 1, By::newton, -0.157327, 0.524423, 1.405923, 0.5, -0.320364},
    {"A", 30, 0.3, 0.5, 1, By::newton_mean, -0.157327, 0.524423, 1.405923, 0.5, -0.320364},
    {"A", 30, 0.3, 0.5, 1, By::poisson, -0.157327, 0.524423, 1.405923, 0.5, -0.320364},
    {"A", 30, 0.3, 0.5, 1, By::energy, -0.157327, 0.524423, 1.405923, 0.5, -0.320364},
    {"B", 30, 0.3, 0.5, -1.2, By::newton, 0.123636, 0.412121, -0.448276, 0.5, -0.204923},
    {"B", 30, 0.3, 0.5, -1.2, By::newton_mean, 0.123636, 0.412121, -0.448276, 0.5, -0.204923},
    {"B", 30, 0.3, 0.5, -1.2, By::poisson, 0.123636, 0.412121, -0.448276, 0.5, -0.204923},
    {"B", 30, 0.3, 0.5, -1.2, By::energy, 0.123636, 0.412121, -0.448276, 0.5, -0.204923},
    {"C", 30, 0.3, 0.5, -0.2, By::path_newton, -0.082575, 0.494544, 0.297925, 0.5, -0.127679},
    {"C", 30, 0.3, 0.5, -0.2, By::poisson, -0.078093, 0.479605, 0.286362, 0.457269, -0.133520},
    {"C", 30, 0.3, 0.5, -0.2, By::energy, -0.078856, 0.482146, 0.288329, 0.464538, -0.132568},
    {"C", 30, 0.3, 0.5, -0.2, By::newton, -0.157327, 0.524423, 0.205923, 0.5, -0.131572},
    {"C", 30, 0.3, 0.5, -0.2, By::newton_mean, -0.157327, 0.524423, 0.205923, 0.5, -0.131572},
    {"C", 30, 0.3, 0.5, -0.2, By::two_phase_poisson, -0.157327, 0.524423, 0.205923, 0.5, -0.131572},
    {"D", 30, 0.8, 0.5, -0.5, By::path_newton, -0.080889, 0.493870, 0, 0.5, -0.103245},
    {"D", 30, 0.8, 0.5, -0.5, By::newton, -0.080889, 0.493870, 0, 0.5, -0.103245},
    {"D", 30, 0.8, 0.5, -0.5, By::poisson, -0.020621, 0.412680, 0, 0.314423, -0.136307},
    {"D", 30, 0.8, 0.5, -0.5, By::two_phase_poisson, -0.020621, 0.412680, 0, 0.314423, -0.136307},
    {"D", 30, 0.8, 0.5, -0.5, By::energy, -0.039219, 0.437733, 0, 0.371687, -0.127712},
    {"D", 30, 0.8, 0.5, -0.5, By::newton_mean, 0.279770, 0.349713, 0.443889, 0.5, -0.095277},
    {"E", 45, 0.8, 0.8, -0.75, By::newton, -0.206250, 0.843750, 0, 0.8, -0.007031},
    {"E", 45, 0.8, 0.8, -0.75, By::poisson, -0.071250, 0.618750, 0, 0.44, -0.146531},
    {"E", 45, 0.8, 0.8, -0.75, By::energy, -0.109008, 0.681680, 0, 0.540687, -0.115674},
    {"F", 30, 0.3, 0.8, -0.8, By::path_newton, 0.110215, 0.509793, 0.055116, 0.8, -0.092028},
    {"F", 30, 0.3, 0.8, -0.8, By::poisson, 0.114789, 0.494545, 0.043313, 0.756386, -0.103669},
    {"F", 30, 0.3, 0.8, -0.8, By::energy, 0.114306, 0.496153, 0.044558, 0.760986, -0.102470},
    {"F", 30, 0.3, 0.8, -0.8, By::newton, 0.065433, 0.527692, 0, 0.8, -0.078942},
    {"F", 30, 0.3, 0.8, -0.8, By::two_phase_poisson, 0.090039, 0.494545, 0, 0.724234, -0.104205},
    {"E2", 45, 0.8, 0.8, -1.2, By::newton, 0.075, 0.675, 0, 0.8, -0.112500},
    {"E2", 45, 0.8, 0.8, -1.2, By::poisson, 0.188108, 0.486486, 0, 0.498378, -0.234881},
    {"E2", 45, 0.8, 0.8, -1.2, By::two_phase_poisson, 0.188108, 0.486486, 0, 0.498378, -0.234881},
    {"E2", 45, 0.8, 0.8, -1.2, By::energy, 0.163633, 0.527278, 0, 0.563645, -0.213220},
    {"G (newton gains)", 45, 1, 0.9, -0.6, By::newton, -0.3375, 0.9625, 0, 0.9, 0.053125},
    {"G", 45, 1, 0.9, -0.6, By::poisson, -0.216, 0.76, 0, 0.576, -0.096320},
    {"G", 45, 1, 0.9, -0.6, By::energy, -0.237692, 0.796153, 0, 0.633845, -0.074450},
    {"G", 45, 1, 0.9, -0.6, By::newton_mean, 0.0375, 0.7375, 0.6, 0.9, -0.036875},
};

struct PendulumRow {
  double mu, e;
  By by;
  double energy;
};

// Two rods (m = 1, l = 1) at 20 and 30 degrees from the vertical, rates -0.1 and -0.2 rad/s, tip on the
// floor.
constexpr PendulumRow pendulum_rows[] = {
    {0.5, 0.5, By::path_newton, -0.006093}, {0.5, 0.5, By::newton, 0.013619},
    {0.5, 0.5, By::poisson, -0.010546},     {0.5, 0.5, By::energy, -0.010358},
    {0.5, 0.5, By::newton_mean, -0.010143}, {0.5, 0.5, By::two_phase_poisson, -0.010551},
    {0.5, 0.7, By::path_newton, -0.000163}, {0.5, 0.7, By::newton, 0.040744},
    {0.5, 0.7, By::poisson, -0.009929},     {0.5, 0.7, By::energy, -0.009270},
    {0.5, 0.9, By::path_newton, 0.006910},  {0.7, 0.7, By::path_newton, 0.048947},
    {0.7, 0.7, By::energy, -0.009950},
};

struct BoxRow {
  double mu;
  By by;
  double p_x, p_y, p_z, energy;
};

// Box 1 x 0.6 x 0.4 (m = 1) that falls on a corner, z is the normal; e = 0.6. Five decimals.
constexpr BoxRow box_rows[] = {
    {0.3, By::path_newton, -0.06699, 0.05107, 0.28278, -0.13441},
    {0.3, By::newton, -0.05715, 0.06477, 0.28793, -0.13435},
    {0.3, By::poisson, -0.06659, 0.05060, 0.28074, -0.13515},
    {0.3, By::energy, -0.06672, 0.05076, 0.28142, -0.13491},
    {0.9, By::newton, -0.20951, 0.13592, 0.27749, -0.20472},
    {0.9, By::energy, -0.21026, 0.12527, 0.27255, -0.20703},
};

void check_boxes(Checks& checks) {
  const Vec3 lever(-0.5, -0.3, -0.2);
  const Vec3 inertia = Vec3(0.6 * 0.6 + 0.4 * 0.4, 1 + 0.4 * 0.4, 1 + 0.6 * 0.6) / 12;
  Eigen::Matrix3d cross_lever;
  cross_lever << 0, -lever.z(), lever.y(), lever.z(), 0, -lever.x(), -lever.y(), lever.x(), 0;
  const Eigen::Matrix3d xyz =
      Eigen::Matrix3d::Identity() - cross_lever * inertia.cwiseInverse().asDiagonal() * cross_lever;
  const Eigen::PermutationMatrix<3> to_ntx(Eigen::Vector3i(1, 2, 0));  // x, y, z to (n, t, s) = (z, x, y)
  SingleImpact<3> box{to_ntx * xyz * to_ntx.transpose(), {-1, 1, -0.5}, 0, 0.6};
  for (const BoxRow& row : box_rows) {
    box.mu = row.mu;
    const SingleOutcome<3> out = compute(box, row.by);
    add_worst(checks, fmt::format("box on its corner, mu {}, {}", row.mu, names[static_cast<int>(row.by)]),
              "problem", 3e-5,
              {{"p_n", out.impulse[0], row.p_z},
               {"p_x", out.impulse[1], row.p_x},
               {"p_y", out.impulse[2], row.p_y},
               {"energy change", out.energy, row.energy}});
  }
  // For these cases the reference gives only the velocity after the impact.
  box.mu = 0.9;
  add_worst(checks, "box on its corner, mu 0.9, path to -e v_n", "problem", 3e-5,
            {{"v_x", compute(box, By::path_newton).after[1], 0.08053},
             {"v_y", compute(box, By::path_newton).after[2], -0.07724}});
  add_worst(checks, "box on its corner, mu 0.9, poisson", "problem", 3e-5,
            {{"v_n", compute(box, By::poisson).after[0], 0.58225}});
}

}  // namespace

void check_worked_impacts(Checks& checks) {
  for (const RodRow& row : rod_rows) {
    const SingleImpact<2> impact{rod_mobility(row.degrees * pi / 180), {-1, row.vx}, row.mu, row.e};
    const SingleOutcome<2> out = compute(impact, row.by);
    add_worst(checks, fmt::format("rod impact {}, {}", row.id, names[static_cast<int>(row.by)]), "problem",
              1e-6,
              {{"p_n", out.impulse[0], row.p_n},
               {"p_t", out.impulse[1], row.p_t},
               {"v_n", out.after[0], row.v_n},
               {"v_t", out.after[1], row.v_t},
               {"energy change", out.energy, row.energy}});
  }
  SingleImpact<2> pendulum;
  pendulum.w << 1.009560, 1.521309, 1.521309, 2.440338;
  pendulum.v = {-0.134202, -0.267174};
  for (const PendulumRow& row : pendulum_rows) {
    pendulum.mu = row.mu;
    pendulum.e = row.e;
    add_worst(checks,
              fmt::format("double pendulum, mu {}, e {}, {}", row.mu, row.e, names[static_cast<int>(row.by)]),
              "problem", 2e-6, {{"energy change", compute(pendulum, row.by).energy, row.energy}});
  }
  check_boxes(checks);
}

}  // namespace flyrock
