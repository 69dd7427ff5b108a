#include "solver/local_2d.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

using Problem = ContactProblem<2>;
using Row = Problem::Row;
using Block = Problem::Block;

/// The state of a friction or rolling row: at rest, moving in the positive or in the negative direction.
constexpr int states[] = {0, 1, -1};

/// By how much a state violates its signs; 0 if they hold. Velocities are expressed as the impulses that
/// would remove them, so that both kinds can be compared.
double row_violation(int state, double impulse, double bound, double velocity, double diagonal) {
  if (state == 0) return std::max(0.0, std::abs(impulse) - bound);
  return std::max(0.0, -state * velocity / diagonal);
}

/// Friction only: r_n and r_t in closed form.
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
      if (stiffness <= 0) continue;  // sliding in this direction jams
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

/// Friction and rolling resistance. If the contact is `open`, r_n = 0 and only the constant parts of the
/// bounds resist.
Row solve_rolling(const Problem::Contact& c, const Row& b, bool open) {
  Row best = Row::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const int slide : states) {
    for (const int roll : states) {
      Block m = c.w;
      Row rhs = -b;
      if (open) {
        m.row(0) << 1, 0, 0;
        rhs[0] = 0;
      }
      if (slide != 0) {
        m.row(1) << slide * c.mu, 1, 0;
        rhs[1] = -slide * c.c_t;
      }
      if (roll != 0) {
        m.row(2) << roll * c.mu_r, 0, 1;
        rhs[2] = -roll * c.c_r;
      }
      const double scale = m.row(0).norm() * m.row(1).norm() * m.row(2).norm();
      Block inverse;
      double determinant;
      bool invertible;
      m.computeInverseAndDetWithCheck(inverse, determinant, invertible, 1e-14 * scale);
      if (!invertible) continue;
      const Row r = inverse * rhs;
      const Row u = b + c.w * r;
      const double violation = std::max(0.0, -r[0]) +
                               row_violation(slide, r[1], c.mu * r[0] + c.c_t, u[1], c.w(1, 1)) +
                               row_violation(roll, r[2], c.mu_r * r[0] + c.c_r, u[2], c.w(2, 2));
      if (violation < least) {
        least = violation;
        best = r;
        if (violation == 0) return best;
      }
    }
  }
  return best;
}

/// Clips r exactly to its bounds.
Row clipped(const Problem::Contact& c, Row r) {
  r[0] = std::max(r[0], 0.0);
  for (int group = 0; group < 2; ++group) {
    const double radius = c.radius(group, r[0]);
    r[1 + group] = std::clamp(r[1 + group], -radius, radius);
  }
  return r;
}

}  // namespace

Row solve_local(const Problem::Contact& contact, const Row& b) {
  Row open = Row::Zero();
  if (contact.c_r > 0)
    open = clipped(contact, solve_rolling(contact, b, true));
  else if (contact.c_t > 0)
    open[1] = std::clamp(-b[1] / contact.w(1, 1), -contact.c_t, contact.c_t);
  if (!contact.normal || b[0] + contact.w.row(0).dot(open) >= 0) return open;
  return clipped(contact,
                 contact.resists_rotation() ? solve_rolling(contact, b, false) : solve_friction(contact, b));
}

}  // namespace flyrock
