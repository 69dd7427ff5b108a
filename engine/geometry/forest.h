#pragma once
// The stems of a forest: upright cylinders that stand on the ground, and where a path first touches one.
//
// A sphere of radius R touches a stem of radius r and height h, with its foot at z = f, where the distance of
// its centre from the axis is r + R and its centre is below the top:
//   g(t) = |p_xy(t) - c|^2 - (r + R)^2 <= 0   and   p_z(t) - (f + h) <= 0.
// A centre that comes down from above the top within r + R of the axis touches the stem at the height of the
// top. g is a polynomial of degree 10 along an arc in air, of degree 4 on a parabola, of degree 2 on one that
// is straight in plan. Its roots are bracketed between those of its derivatives (math/polynomial.h), so that
// no stem is missed.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "geometry/plan_line.h"

namespace flyrock {

struct Stem {
  Vec2 place = Vec2::Zero();  ///< of the axis, m
  double radius = 0;          ///< m, half the diameter at breast height
  double height = 0;          ///< m
  double strength = 1;        ///< factor of its species on the energy that it takes
};

/// A path as polynomials of time: p(t) = sum of the coefficients times t^k.
struct SpacePath {
  PlanPath plan;
  std::array<double, 6> z{};
};

/// When a sphere whose centre follows `path` first touches the stem with its top at z = top [m], in [0, end].
/// A sphere that starts within reach touches it immediately if it approaches the axis, and not otherwise.
std::optional<double> first_touch(const SpacePath& path, double end, double radius, const Stem& stem,
                                  double top);

/// Stems with a grid in plan, so that a path asks only those near to it.
class Forest {
 public:
  explicit Forest(std::vector<Stem> stems);

  const std::vector<Stem>& stems() const { return stems_; }

  struct Touch {
    double time = 0;
    int tree = 0;  ///< index of the stem
  };
  /// The first stem that a sphere touches in [0, end]; of two at one time that with the lower index.
  /// foot(place) is the height of the ground there, or nothing; stems with skip(index) are not asked.
  template <class Foot, class Skip>
  std::optional<Touch> first(const SpacePath& path, double end, double radius, Foot&& foot,
                             Skip&& skip) const;

 private:
  /// A piece of a path in plan: all of it is within `reach` of the segment between its ends.
  struct Piece {
    Vec2 from, to;
    double reach;
  };
  /// Pieces about as long as a cell, and how far a piece of that duration strays from its chord:
  /// max |p''| dt^2 / 8.
  int pieces_of(const PlanPath& path, double end, double& sag) const;
  template <class Visit>
  void visit_near(const Piece& piece, Visit&& visit) const;

  std::vector<Stem> stems_;
  double greatest_radius_ = 0;
  Vec2 corner_ = Vec2::Zero();  ///< of the grid
  double cell_ = 1;             ///< m
  int columns_ = 0, rows_ = 0;
  std::vector<int> begin_, sorted_;  ///< the stems of cell i are sorted_[begin_[i]] to sorted_[begin_[i + 1]]
};

template <class Visit>
void Forest::visit_near(const Piece& piece, Visit&& visit) const {
  const double reach = piece.reach + greatest_radius_;
  const Vec2 low = piece.from.cwiseMin(piece.to) - corner_ - Vec2::Constant(reach);
  const Vec2 high = piece.from.cwiseMax(piece.to) - corner_ + Vec2::Constant(reach);
  if (!(high.x() >= 0 && high.y() >= 0 && low.x() <= columns_ * cell_ && low.y() <= rows_ * cell_)) return;
  const auto index = [&](double place, int count) {
    return static_cast<int>(std::clamp(place / cell_, 0.0, static_cast<double>(count - 1)));
  };
  for (int row = index(low.y(), rows_); row <= index(high.y(), rows_); ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const int last = begin_[start + static_cast<std::size_t>(index(high.x(), columns_)) + 1];
    for (int i = begin_[start + static_cast<std::size_t>(index(low.x(), columns_))]; i < last; ++i)
      visit(sorted_[static_cast<std::size_t>(i)]);
  }
}

template <class Foot, class Skip>
std::optional<Forest::Touch> Forest::first(const SpacePath& path, double end, double radius, Foot&& foot,
                                           Skip&& skip) const {
  std::optional<Touch> found;
  if (stems_.empty()) return found;
  double sag = 0;
  const int pieces = pieces_of(path.plan, end, sag);
  for (int i = 0; i < pieces; ++i) {
    const double begin = end * i / pieces;
    if (found && found->time < begin) break;
    const Piece piece{path.plan.position(begin), path.plan.position(end * (i + 1) / pieces), radius + sag};
    visit_near(piece, [&](int tree) {
      const Stem& stem = stems_[static_cast<std::size_t>(tree)];
      const double distance = distance_to_segment(stem.place, piece.from, piece.to);
      if (distance > stem.radius + piece.reach || skip(tree)) return;
      const std::optional<double> ground = foot(stem.place);
      if (!ground) return;
      const auto time = first_touch(path, end, radius, stem, *ground + stem.height);
      if (!time || (found && (*time > found->time || (*time == found->time && tree >= found->tree)))) return;
      found = Touch{*time, tree};
    });
  }
  return found;
}

}  // namespace flyrock
