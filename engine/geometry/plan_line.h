#pragma once
// Lines in plan where gates and barriers stand, and when a path first arrives at one.
//
// A place in plan is (x, y) in 3D and (x, 0) in 2D, so that both use the same lines.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// A polyline in plan, or a straight line across the x axis without ends.
class PlanLine {
 public:
  /// A straight stretch: start + s along, 0 <= s <= length [m].
  struct Piece {
    Vec2 start, along;  ///< m; unit vector
    double length;      ///< m; infinite for a line across x
    double before = 0;  ///< m, length of the line up to `start`

    double distance(const Vec2& place) const { return cross(along, Vec2(place - start)); }
    /// Whether a place at the distance 0 lies on the piece, to a nanometre, so that two neighbours leave no
    /// gap.
    bool reaches(const Vec2& place) const;
    Vec2 nearest(const Vec2& place) const { return start + along.dot(place - start) * along; }
  };

  /// Across the x axis at x [m].
  PlanLine(double x);
  /// Through at least two points [m], without line_fault().
  explicit PlanLine(const std::vector<Vec2>& points);

  const std::vector<Piece>& pieces() const { return pieces_; }
  /// +1 or -1: the side of the line on which a place lies, that of the piece nearest to it. An open line goes
  /// on straight beyond its ends.
  int side(const Vec2& place) const;

 private:
  std::vector<Piece> pieces_;
};

/// Why points are not the points of a line in plan; empty if they are: at least two, each differs from the
/// next, and the line neither crosses nor touches itself. It may end where it begins.
std::string line_fault(const std::vector<Vec2>& points);

/// Whether two stretches from a to b and from c to d meet.
bool stretches_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// A path in plan: polynomials of time, x(t) = x[0] + x[1] t + ... + x[5] t^5.
struct PlanPath {
  std::array<double, 6> x{}, y{};

  Vec2 position(double t) const;
  /// At most 2: uniformly accelerated.
  bool is_parabola() const;
};

/// A point on its way to a line. It knows on which side of each piece the point was last, so that rounding
/// between two stretches of its path hides no crossing.
class Approach {
 public:
  Approach(const PlanLine& line, const Vec2& start);

  struct Arrival {
    double time = 0;
    Vec2 place = Vec2::Zero();  ///< on the line
    double along = 0;           ///< m from the first point of the line; y for a line across x
  };
  /// The first time in [0, end] at which a path from where the point was last arrives at the line. Nothing if
  /// the path does not, or if the point has already arrived. Only a parabola may have no end. A path that
  /// starts on the line arrives at 0. A path along the line arrives where it meets an end of a piece.
  std::optional<Arrival> arrival(const PlanPath& path, double end) const;
  /// The point has moved on to `place` without an arrival.
  void move_to(const Vec2& place);
  void arrive() { pieces_ = nullptr; }

 private:
  const std::vector<PlanLine::Piece>* pieces_;  ///< none after the arrival
  std::vector<double> side_;                    ///< of each piece: +1 or -1, the sign of the distance
};

}  // namespace flyrock
