#include "collision/smooth/gjk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

/// A place of A - B + shift, with the place of A that it comes from.
struct SupportPoint {
  Vec3 w, on_a;
};

/// At most four support points, and the place of their hull that is nearest to the origin.
class Simplex {
 public:
  const Vec3& nearest() const { return nearest_; }
  bool is_inside() const { return count_ == 4; }

  bool has(const Vec3& w) const {
    return std::any_of(point_.begin(), point_.begin() + count_,
                       [&](const SupportPoint& p) { return p.w == w; });
  }

  /// Adds a point and keeps those that span the nearest place: the new one is one of them.
  void add(const SupportPoint& point) {
    point_[count_++] = point;
    keep_nearest(1 << (count_ - 1));
  }

  /// Moves A - B and keeps the points that span the nearest place now.
  void move(const Vec3& by) {
    for (int i = 0; i < count_; ++i) point_[i].w += by;
    keep_nearest(1);
  }

  Vec3 on_a() const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < count_; ++i) sum += share_[i] * point_[i].on_a;
    return sum;
  }

 private:
  /// Of the sets of points from a first one on, as bits, the one that spans the nearest place.
  void keep_nearest(int first) {
    const int all = (1 << count_) - 1;
    double least = std::numeric_limits<double>::infinity();
    int best = all;
    std::array<double, 4> best_shares{};
    for (int some = first; some <= all; ++some) {
      std::array<double, 4> shares{};
      Vec3 place = Vec3::Zero();
      if (!spans(some, shares, place) || place.squaredNorm() >= least) continue;
      least = place.squaredNorm();
      best = some;
      best_shares = shares;
      nearest_ = place;
    }
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      if (!(best >> i & 1)) continue;
      share_[kept] = best_shares[i];
      point_[kept++] = point_[i];
    }
    count_ = kept;
  }

  /// The place nearest to the origin on the line, plane or space through some points, if it lies between
  /// them.
  bool spans(int some, std::array<double, 4>& shares, Vec3& place) const {
    std::array<int, 4> index{};
    int n = 0;
    for (int i = 0; i < count_; ++i)
      if (some >> i & 1) index[n++] = i;
    const auto w = [&](int i) -> const Vec3& { return point_[index[i]].w; };
    if (n == 1) {
      shares[index[0]] = 1;
      place = w(0);
      return true;
    }
    if (n == 2) {
      const Vec3 along = w(1) - w(0);
      const double square = along.squaredNorm(), s = square > 0 ? -w(0).dot(along) / square : -1;
      shares[index[0]] = 1 - s;
      shares[index[1]] = s;
      place = w(0) + s * along;
      return s > 0 && s < 1;
    }
    if (n == 3) {
      const Vec3 first = w(1) - w(0), second = w(2) - w(0), normal = first.cross(second);
      const double square = normal.squaredNorm();
      // The normal of a very thin triangle is rounding noise. Neighbouring places of a rim form such
      // triangles.
      if (!(square > thin * thin * first.squaredNorm() * second.squaredNorm())) return false;
      place = normal * (normal.dot(w(0)) / square);
      for (int i = 0; i < 3; ++i) {
        shares[index[i]] = normal.dot((w((i + 1) % 3) - place).cross(w((i + 2) % 3) - place)) / square;
        if (!(shares[index[i]] > 0)) return false;
      }
      return true;
    }
    const Vec3 first = w(1) - w(0), second = w(2) - w(0), third = w(3) - w(0);
    const double volume = first.dot(second.cross(third));
    if (!(std::abs(volume) > thin * thin * first.norm() * second.norm() * third.norm())) return false;
    shares[0] = w(1).dot(w(2).cross(w(3))) / volume;
    shares[1] = -w(0).dot(w(2).cross(w(3))) / volume;
    shares[2] = w(0).dot(w(1).cross(w(3))) / volume;
    shares[3] = -w(0).dot(w(1).cross(w(2))) / volume;
    place.setZero();
    return *std::min_element(shares.begin(), shares.end()) > 0;
  }

  static constexpr double thin = 1e-8;  // rad, between the sides of a triangle that spans a plane

  std::array<SupportPoint, 4> point_;
  std::array<double, 4> share_{};
  int count_ = 0;
  Vec3 nearest_ = Vec3::Zero();
};

/// Finds the place of A - B + shift that is nearest to the origin, for one shift after the other.
class NearestPlace {
 public:
  NearestPlace(const Placed3& a, const Placed3& b, const Vec3& shift, const Vec3& first)
      : a_(a), b_(b), shift_(shift) {
    simplex_.add(support(-first));
  }

  /// The place; zero: the origin is inside. If the distance is below `enough` [m], a place that is not
  /// farther than that is enough. `error`: of the square of the distance, as a share of it.
  Vec3 find(double enough, double error) {
    constexpr int most_iterations = 100;
    for (int i = 0; i < most_iterations; ++i) {
      const Vec3 v = simplex_.nearest();
      const double square = v.squaredNorm();
      if (square < enough * enough) break;
      const SupportPoint point = support(-v);
      if (!(square > 0) || square - v.dot(point.w) <= error * square || simplex_.has(point.w)) break;
      Simplex next = simplex_;
      next.add(point);
      if (next.is_inside()) return Vec3::Zero();
      if (!(next.nearest().squaredNorm() < square)) break;  // no more than rounding is left
      simplex_ = next;
    }
    return simplex_.nearest();
  }

  void move_to(const Vec3& shift) {
    simplex_.move(shift - shift_);
    shift_ = shift;
  }

  Vec3 on_a() const { return simplex_.on_a(); }

 private:
  SupportPoint support(const Vec3& towards) const {
    const Vec3 on_a = a_.support(towards);
    return {on_a - b_.support(-towards) + shift_, on_a};
  }

  const Placed3& a_;
  const Placed3& b_;
  Vec3 shift_;
  Simplex simplex_;
};

constexpr double exact = 1e-14;  // of the square of a distance: its direction is good to 1e-7

/// The directions of a first guess for cores that touch or overlap, the best first: normals of faces and
/// caps, the line between the centres, and 26 fixed ones.
class Guesses {
 public:
  Guesses(const Placed3& a, const Placed3& b) : a_(a), b_(b) {
    if (const Vec3 between = a.pose.x - b.pose.x; between.norm() > 0) add(between.normalized());
    add_planes(a, -1);
    add_planes(b, 1);
    for (int i = 0; i < 27; ++i)
      if (i != 13) add(Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).normalized());
  }
  const Vec3& normal(int i) const { return best_[i].normal; }
  static constexpr int count = 8;

 private:
  struct Guess {
    double distance = -std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();
  };

  void add(const Vec3& normal) {
    Guess guess{distance_along(a_, b_, normal), normal};
    for (Guess& known : best_)
      if (guess.distance > known.distance) std::swap(guess, known);
  }
  void add_planes(const Placed3& placed, double outward) {
    for (const Contactor3::Face& face : placed.shape.faces) add(outward * (placed.pose.r * face.normal));
    for (const Contactor3::Circle& circle : placed.shape.circles)
      add(outward * (placed.pose.r * circle.axis));
  }

  const Placed3& a_;
  const Placed3& b_;
  std::array<Guess, count> best_;
};

/// Improves a normal of cores that are nearer than `back` or overlap.
Separation improved(const Placed3& a, const Placed3& b, const Vec3& guess, double back) {
  constexpr int most_turns = 40;
  constexpr double settled = 1e-6, of_turn = 0.01;
  Separation found{guess, 0, a.support(-guess)};
  NearestPlace nearest(a, b, back * guess, guess);
  double turned = 1;
  for (int i = 0; i < most_turns; ++i) {
    const double error = std::max(exact, of_turn * of_turn * turned * turned);
    const Vec3 place = nearest.find(0, error);
    const double length = place.norm();
    if (length < 0.3 * back) {
      back *= 4;
    } else {
      const Vec3 normal = place / length;
      turned = (normal - found.normal).norm();
      found.normal = normal;
      found.on_a = nearest.on_a();
      if (turned < settled && error == exact) break;
    }
    nearest.move_to(back * found.normal);
  }
  found.distance = distance_along(a, b, found.normal);
  return found;
}

}  // namespace

Separation separation(const Placed3& a, const Placed3& b) {
  constexpr double share = 1e-3, touching = 1e-3;
  const Vec3 between = a.pose.x - b.pose.x;
  const double small = std::min(a.shape.bound, b.shape.bound);
  const double back = share * (small > 0 ? small : std::max(a.shape.bound, b.shape.bound));
  NearestPlace nearest(a, b, Vec3::Zero(), between.norm() > 0 ? between : Vec3::UnitZ());
  const Vec3 place = nearest.find(touching * back, exact);
  const double length = place.norm();
  if (length > back) {
    const Vec3 normal = place / length;
    return {normal, distance_along(a, b, normal), nearest.on_a()};
  }
  Separation best;
  best.distance = -std::numeric_limits<double>::infinity();
  if (length > touching * back) best = improved(a, b, place / length, back);
  const Guesses guesses(a, b);
  for (int i = 0; i < Guesses::count && best.distance < -1e-3 * back; ++i) {
    const Separation next = improved(a, b, guesses.normal(i), back);
    if (next.distance > best.distance) best = next;
  }
  return best;
}

}  // namespace flyrock
