#pragma once
// A flight without air.

#include "collision/motion.h"
#include "geometry/plan_line.h"

namespace flyrock {

/// A path of `length` seconds that begins at the time `start`. Its parameter is the time since then, up to
/// end(); that of an Arc is s.
template <int D>
struct Parabola : Path<D> {
  double start = 0, length = 0;  ///< s

  double end() const { return length; }
  double time(double t) const { return start + t; }
  // The first coefficients of the position as a polynomial of the parameter.
  const Vec<D>& origin() const { return this->x; }
  const Vec<D>& rate() const { return this->v; }
  Vec<D> bend() const { return 0.5 * this->a; }
};

/// The path in plan, as polynomials of its time.
inline PlanPath in_plan(const Path<2>& path) { return {.x = {path.x.x(), path.v.x(), 0.5 * path.a.x()}}; }
inline PlanPath in_plan(const Path<3>& path) {
  return {.x = {path.x.x(), path.v.x(), 0.5 * path.a.x()}, .y = {path.x.y(), path.v.y(), 0.5 * path.a.y()}};
}

}  // namespace flyrock
