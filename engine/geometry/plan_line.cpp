#include "geometry/plan_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/place_text.h"
#include "math/polynomial.h"
#include "math/travel_time.h"

namespace flyrock {

namespace {

constexpr double nanometre = 1e-9;

using Coefficients = std::array<double, 6>;

/// The first t in [0, end] at which the polynomial `ahead`, positive at first, is 0 and `counts(t)`.
template <class Counts>
std::optional<double> first_zero(const Coefficients& ahead, bool is_parabola, double end, Counts counts) {
  if (is_parabola) {
    for (const double t : travel_times(ahead[0], -ahead[1], -2 * ahead[2]))
      if (t <= end && t < infinite && counts(t)) return t;
    return std::nullopt;
  }
  if (ahead[0] <= 0 && counts(0.0)) return 0;
  Coefficients positive = ahead;
  const auto change_sign = [&] {
    std::transform(positive.begin(), positive.end(), positive.begin(), std::negate());
  };
  if (ahead[0] <= 0) change_sign();
  for (double from = 0; from <= end; change_sign()) {
    const std::optional<double> zero = first_fall(positive, from, end);
    if (!zero || counts(*zero)) return zero;
    from = std::nextafter(*zero, infinite);
  }
  return std::nullopt;
}

/// side * n.(path - start), where n = (n_x, n_y).
Coefficients component(const PlanPath& path, const Vec2& n, const Vec2& start, double side) {
  Coefficients c;
  c[0] = side * n.dot(Vec2(path.x[0], path.y[0]) - start);
  for (std::size_t k = 1; k < c.size(); ++k) c[k] = side * n.dot(Vec2(path.x[k], path.y[k]));
  return c;
}

bool is_zero(const Coefficients& c) {
  return std::all_of(c.begin(), c.end(), [](double value) { return value == 0; });
}

std::optional<double> first_arrival(const PlanLine::Piece& piece, double side, const PlanPath& path,
                                    double end) {
  const auto is_on = [&](double t) { return piece.reaches(path.position(t)); };
  const bool is_parabola = path.is_parabola();
  const Coefficients ahead = component(path, perpendicular(piece.along), piece.start, side);
  if (!is_zero(ahead)) return first_zero(ahead, is_parabola, end, is_on);
  if (is_on(0)) return 0;  // the path runs along the line
  std::optional<double> first;
  for (const double of_end : {0.0, piece.length}) {
    const Vec2 tip = piece.start + of_end * piece.along;
    const double from = piece.along.dot(Vec2(path.x[0], path.y[0]) - tip) > 0 ? 1 : -1;
    const auto t = first_zero(component(path, piece.along, tip, from), is_parabola, end, is_on);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

}  // namespace

bool PlanLine::Piece::reaches(const Vec2& place) const {
  const double s = along.dot(place - start);
  return length == infinite || (s >= -nanometre && s <= length + nanometre);
}

PlanLine::PlanLine(double x) : pieces_{{Vec2(x, 0), Vec2::UnitY(), infinite}} {}

PlanLine::PlanLine(const std::vector<Vec2>& points) {
  double before = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 along = points[i + 1] - points[i];
    pieces_.push_back({points[i], along.normalized(), along.norm(), before});
    before += along.norm();
  }
}

int PlanLine::side(const Vec2& place) const {
  const bool is_closed =
      pieces_.size() > 1 &&
      (pieces_.back().start + pieces_.back().length * pieces_.back().along - pieces_.front().start).norm() <=
          nanometre;
  double nearest = infinite, across = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double first = i > 0 || is_closed ? 0 : -infinite,
                 last = i + 1 < pieces_.size() || is_closed ? piece.length : infinite;
    const double s = std::clamp(piece.along.dot(place - piece.start), first, last);
    const double distance = (piece.start + s * piece.along - place).norm(), side = piece.distance(place);
    // At a corner two pieces are equally near. The side is that of the one that the place is farther beside.
    const bool is_tie = std::abs(distance - nearest) <= nanometre;
    if (is_tie ? std::abs(side) > std::abs(across) : distance < nearest) across = side;
    nearest = std::min(nearest, distance);
  }
  return across < 0 ? -1 : 1;
}

bool stretches_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double left = cross(Vec2(b - a), Vec2(c - a)), right = cross(Vec2(b - a), Vec2(d - a));
  const double above = cross(Vec2(d - c), Vec2(a - c)), below = cross(Vec2(d - c), Vec2(b - c));
  const Vec2 low = a.cwiseMin(b).cwiseMax(c.cwiseMin(d)), high = a.cwiseMax(b).cwiseMin(c.cwiseMax(d));
  if ((low.array() > high.array()).any()) return false;
  return left * right <= 0 && above * below <= 0;
}

std::string line_fault(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  if (n < 2) return fmt::format("a line needs at least 2 points, this one has {}", n);
  const bool is_closed = points.front() == points.back();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Vec2 &a = points[i], &b = points[i + 1];
    if (a == b) return fmt::format("a line has the point {} twice in a row", place_text(a));
    if (i + 2 < n && cross(Vec2(b - a), Vec2(points[i + 2] - b)) == 0 && (b - a).dot(points[i + 2] - b) < 0)
      return fmt::format("the line turns back on itself at {}", place_text(b));
    for (std::size_t k = i + 2; k + 1 < n; ++k) {
      if (is_closed && i == 0 && k + 2 == n) continue;  // neighbours
      if (stretches_meet(a, b, points[k], points[k + 1]))
        return fmt::format("the line crosses itself: the piece from {} to {} meets the piece from {} to {}",
                           place_text(a), place_text(b), place_text(points[k]), place_text(points[k + 1]));
    }
  }
  return "";
}

Vec2 PlanPath::position(double t) const { return {evaluate(x, t), evaluate(y, t)}; }

bool PlanPath::is_parabola() const {
  for (std::size_t k = 3; k < x.size(); ++k)
    if (x[k] != 0 || y[k] != 0) return false;
  return true;
}

Approach::Approach(const PlanLine& line, const Vec2& start) : pieces_(&line.pieces()) {
  side_.assign(line.pieces().size(), 1);
  move_to(start);
}

std::optional<Approach::Arrival> Approach::arrival(const PlanPath& path, double end) const {
  if (!pieces_) return std::nullopt;
  std::optional<Arrival> first;
  for (std::size_t i = 0; i < pieces_->size(); ++i) {
    const PlanLine::Piece& piece = (*pieces_)[i];
    const auto t = first_arrival(piece, side_[i], path, first ? first->time : end);
    if (!t || (first && *t >= first->time)) continue;
    const Vec2 place = piece.nearest(path.position(*t));
    first = Arrival{*t, place, piece.before + piece.along.dot(place - piece.start)};
  }
  return first;
}

void Approach::move_to(const Vec2& place) {
  if (!pieces_) return;
  for (std::size_t i = 0; i < pieces_->size(); ++i) {
    const double distance = (*pieces_)[i].distance(place);
    if (distance != 0) side_[i] = distance > 0 ? 1 : -1;
  }
}

}  // namespace flyrock
