#pragma once
// What a population or a launch may ask of the ground.

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace flyrock {

class Ground3;
struct Profile;

/// The ground of a trial in 2D or 3D, in the coordinates of the scenario [m]. It refers to the ground, which
/// must outlive it. In 2D the y of a place in plan does not count.
class TerrainView {
 public:
  /// A bench face: its lines from end to end, one point each in 2D.
  struct Face {
    std::string name;
    std::vector<Vec3> toe, crest;
  };

  explicit TerrainView(const Profile& profile) : profile_(&profile) {}
  /// `ground` and `faces` count from `origin`.
  TerrainView(const Ground3& ground, const std::vector<Mesh::Face>& faces, const Vec3& origin,
              double north = pi / 2)
      : ground_(&ground), faces_(&faces), origin_(origin), north_(north) {}

  int dimension() const { return profile_ ? 2 : 3; }
  /// The azimuth of bearing 0 (geometry/bearing.h) [rad].
  double north() const { return north_; }
  /// The ends in plan; infinite for a plane in 3D.
  Vec2 low() const;
  Vec2 high() const;
  /// The height of the ground at a place; the highest one if there are several. Nothing where there is none.
  std::optional<double> height(double x, double y) const;
  /// The unit normal out of the ground where it has this height, (n_x, n_y, 0) in 2D. At an edge, that of one
  /// of the two sides.
  std::optional<Vec3> normal(double x, double y) const;
  /// The bench faces, the uppermost first.
  std::vector<Face> faces() const;
  /// What a notch takes out of a bench (terrain benches): the prism between the parts notch_back, notch_base
  /// and, in 3D, notch_end, and the face that was there.
  struct Notch {
    std::vector<Vec3> corners;
    Vec3 outward = Vec3::UnitX();  ///< horizontal, unit, out of the face
  };
  std::optional<Notch> notch() const;
  /// The polyline in 2D, otherwise null.
  const Profile* profile() const { return profile_; }

 private:
  const Profile* profile_ = nullptr;
  const Ground3* ground_ = nullptr;
  const std::vector<Mesh::Face>* faces_ = nullptr;
  Vec3 origin_ = Vec3::Zero();
  double north_ = pi / 2;
};

}  // namespace flyrock
