#pragma once
// The ground of a run in 3D: a plane, triangles or a grid of heights, as facets with neighbours.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "geometry/facet.h"
#include "geometry/terrain_shape.h"

namespace flyrock {

/// The surface of triangles under a run. It does not change after it is made, so that threads share it. A
/// query is one virtual call; answers are appended to vectors that the caller keeps. Metres.
class Ground3 {
 public:
  virtual ~Ground3() = default;

  /// Appends the facets whose boxes meet `box`, in the order of their ids, also those on which bodies hang
  /// over the border.
  virtual void facets(const Box3& box, std::vector<Facet>& out) const = 0;
  /// The same within the extent, without what is around them: `rim`, `beyond` and `edge` are not set. A point
  /// needs no more.
  virtual void triangles(const Box3& box, std::vector<Facet>& out) const = 0;
  /// How many facets() finds, but at most `limit`: what a search needs to know before it asks for them.
  virtual int count(const Box3& box, int limit) const = 0;
  /// Appends the facets whose boxes meet the segment from a to b in plan, in the order of their ids, as
  /// triangles().
  virtual void triangles_under(const Vec2& a, const Vec2& b, std::vector<Facet>& out) const = 0;
  virtual Facet facet(std::uint32_t id) const = 0;
  virtual Vec3 vertex(std::uint64_t index) const = 0;
  /// Appends the directions [m] of the edges that leave a vertex. False if the ground is not convex there:
  /// the vertex is then no feature. Fewer than three convex edges cannot form a peak.
  virtual bool peak(std::uint64_t vertex, std::vector<Vec3>& edges) const = 0;
  /// A facet at a vertex.
  virtual std::uint32_t facet_at(std::uint64_t vertex) const = 0;
  /// The index of the part that a facet belongs to.
  virtual int part(std::uint32_t facet) const = 0;
  /// The smallest box that contains the ground; infinite for a plane.
  virtual const Box3& extent() const = 0;

  /// The facet of a feature: of an edge the one that names it, of a vertex one of those around it.
  std::uint32_t facet_of(FeatureId feature) const;

  /// A place where the vertical line through (x, y) passes the surface. `upward`: out of the ground.
  struct Crossing {
    double z;
    bool upward;
    std::uint32_t facet;
  };
  /// The lowest crossing above or at `at` (above = true), or the highest one below or at it.
  std::optional<Crossing> crossing(const Vec3& at, bool above) const;
  /// The highest crossing at (x, y). Nothing where there is no ground.
  std::optional<Crossing> top(double x, double y) const;
  /// Its z.
  std::optional<double> height(double x, double y) const;
  /// How far `at` lies below the surface: a vertical line up from it meets a facet from behind. Negative or
  /// 0: it is free.
  double depth(const Vec3& at) const;

  /// The facet nearest to a place and its distance [m]; nothing if there is none within `reach`.
  struct Nearest {
    double distance;
    std::uint32_t facet;
  };
  std::optional<Nearest> nearest(const Vec3& at, double reach) const;

  /// Whether there is ground under every place of its extent in plan.
  bool whole() const { return whole_; }
  /// Whether a vertical line may pass the surface more than once.
  bool overhangs() const { return overhangs_; }
  /// The cell of a grid, or the median length of the edges of a mesh [m]; 0 for a plane.
  double cell() const { return cell_; }
  const std::vector<std::string>& parts() const { return parts_; }

 protected:
  explicit Ground3(std::vector<std::string> parts) : parts_(std::move(parts)) {}

  bool whole_ = true, overhangs_ = false;  ///< known once the ground is made
  double cell_ = 0;

 private:
  std::vector<std::string> parts_;
};

/// Prepares a shape for queries. A mesh must have neither an edge of three facets nor neighbours that face
/// opposite ways.
std::unique_ptr<const Ground3> make_ground(TerrainShape3 shape);

}  // namespace flyrock
