#pragma once
// A surveyed rock face and its distance from the charge of a hole.

#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

/// A face as triangles, in the coordinates of the survey [m].
class FaceSurvey {
 public:
  /// The triangles of a mesh.
  explicit FaceSurvey(const Mesh& mesh);
  /// Measured points, triangulated (Delaunay) in the plane that fits them best. Triangles with a side longer
  /// than five times the median side are left out: there the survey has a gap. Throws std::invalid_argument
  /// if there are fewer than three points, or all lie in a line.
  explicit FaceSurvey(const std::vector<Vec3>& points);

  struct Nearest {
    double distance = 0;  ///< m
    bool is_inside =
        true;  ///< false: the nearest place is at the border of the survey, beyond it nothing is known
  };
  Nearest nearest(const Vec3& place) const;
  /// The least distance between the face and the pieces of a line.
  double distance_to(const std::vector<Vec3>& line) const;

  /// The standard deviation of the points about their neighbours [m], of the vertices inside: how far each is
  /// from the plane through those around it, from the median, which outliers and edges of blocks hardly
  /// change. A curved face adds to it. 0 where there are too few vertices.
  double noise() const { return noise_; }
  /// By how much the least distance may be wrong because of the noise [m]: the least of n distances with
  /// normal errors lies below the true one by about sqrt(2 ln n) standard deviations.
  double error_of_least() const;

 private:
  struct Triangle {
    std::array<Vec3, 3> corner;
    Vec3 centre;
    double radius;                  ///< of the ball about `centre` that contains it
    std::array<bool, 3> is_border;  ///< of the side from corner k to the next
    std::array<bool, 3> is_end;     ///< whether corner k lies on the border
  };

  void take(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles);
  void measure_noise(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles,
                     const std::vector<bool>& on_border);

  std::vector<Triangle> triangles_;
  std::size_t vertices_ = 0;
  double noise_ = 0;
};

/// The distance of two segments in space.
double segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace flyrock
