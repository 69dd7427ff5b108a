#include "solver/local_2d.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;
using Block = Problem::Block;

/// The state of a friction or rolling row: at rest, or moving in the positive or negative direction.
constexpr int states[] = {0, 1, -1};

/// How far the signs of a state are violated: 0 where they hold. Velocities are measured in the impulse that
/// would remove them, so that both kinds compare.
double row_violation(int state, double impulse, double bound, double velocity, double diagonal) {
  if (state == 0) return std::max(0.0, std::abs(impulse) - bound);
  return std::max(0.0, -state * velocity / diagonal);
}

/// Friction alone. r_n and r_t in closed form.
Row solve_friction(const Problem::Contact& c, const Row& b) {
  const double wnn = c.w(0, 0), wnt = c.w(0, 1), wtn = c.w(1, 0), wtt = c.w(1, 1);
  Row best = Row::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const int state : states) {
    double rn, rt;
    if (state == 0) {
      const double determinant = wnn * wtt - wnt * wtn;
      if (determinant <= 1e-14 * wnn * wtt) continue;
      rn = (-b[0] * wtt + b[1] * wnt) / determinant;
      rt = (-b[1] * wnn + b[0] * wtn) / determinant;
    } else {
      const double stiffness = wnn - state * c.mu * wnt;
      if (stiffness <= 0) continue;  // this way of sliding jams
      rn = (-b[0] + state * c.c_t * wnt) / stiffness;
      rt = -state * (c.mu * rn + c.c_t);
    }
    const double violation =
        std::max(0.0, -rn) + row_violation(state, rt, c.mu * rn + c.c_t, b[1] + wtn * rn + wtt * rt, wtt);
    if (violation < least) {
      least = violation;
      best << rn, rt, 0;
      if (violation == 0) break;
    }
  }
  return best;
}

/// Friction and rolling resistance.
Row solve_rolling(const Problem::Contact& c, const Row& b) {
  Row best = Row::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const int slide : states) {
    for (const int roll : states) {
      Block m = c.w;
      Row rhs = -b;
      if (slide != 0) {
        m.row(1) << slide * c.mu, 1, 0;
        rhs[1] = -slide * c.c_t;
      }
      if (roll != 0) {
        m.row(2) << roll * c.mu_r, 0, 1;
        rhs[2] = 0;
      }
      const double scale = m.row(0).norm() * m.row(1).norm() * m.row(2).norm();
      Block inverse;
      double determinant;
      bool invertible;
      m.computeInverseAndDetWithCheck(inverse, determinant, invertible, 1e-14 * scale);
      if (!invertible) continue;
      const Row r = inverse * rhs;
      const Row u = b + c.w * r;
      const double violation = std::max(0.0, -r[0]) + row_violation(slide, r[1], c.mu * r[0] + c.c_t, u[1], c.w(1, 1)) +
                               row_violation(roll, r[2], c.mu_r * r[0], u[2], c.w(2, 2));
      if (violation < least) {
        least = violation;
        best = r;
        if (violation == 0) return best;
      }
    }
  }
  return best;
}

}  // namespace

Row solve_local(const Problem::Contact& contact, const Row& b) {
  // Open: only cohesion resists slip.
  const double shear = contact.c_t > 0 ? std::clamp(-b[1] / contact.w(1, 1), -contact.c_t, contact.c_t) : 0;
  if (!contact.normal || b[0] + contact.w(0, 1) * shear >= 0) return {0, shear, 0};
  Row r = contact.mu_r > 0 ? solve_rolling(contact, b) : solve_friction(contact, b);
  r[0] = std::max(r[0], 0.0);
  const double bound = contact.mu * r[0] + contact.c_t;
  r[1] = std::clamp(r[1], -bound, bound);
  r[2] = std::clamp(r[2], -contact.mu_r * r[0], contact.mu_r * r[0]);
  return r;
}

}  // namespace flyrock
