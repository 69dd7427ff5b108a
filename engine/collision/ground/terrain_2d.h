#pragma once
// A profile, prepared for contact search.

#include "collision/motion.h"
#include "geometry/ground2.h"
#include "geometry/profile.h"
#include "geometry/terrain_names.h"

namespace flyrock {

/// The line of a profile. The ground is below it. The line continues level for one kilometre beyond both ends
/// of the profile, because a body whose centre is still over the profile must not tip over its end. Segment
/// and corner indices include these two extensions.
class Terrain2 : public Ground2 {
 public:
  explicit Terrain2(Profile profile);

  const Profile& profile() const { return profile_; }
  /// The name of each part, as laws use it.
  const std::vector<std::string>& names() const { return names_; }
  /// The height of the ground at x [m]; level beyond the profile.
  double height(double x) const;

 private:
  Profile profile_;
  std::vector<std::string> names_;
};

}  // namespace flyrock
