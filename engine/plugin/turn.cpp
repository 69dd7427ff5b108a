#include "plugin/turn.h"

#include "plugin/params.h"

namespace flyrock {

Rotation3 turn_of(std::span<const double, 4> numbers, bool about_axis) {
  Eigen::Quaterniond q(1, 0, 0, 0);
  double length = 0;
  if (about_axis) {
    const Vec3 axis(numbers[0], numbers[1], numbers[2]);
    length = axis.norm();
    if (length > 0) q = Eigen::AngleAxisd(numbers[3], axis / length);
  } else {
    q = {numbers[0], numbers[1], numbers[2], numbers[3]};
    length = q.norm();
  }
  if (!(length > 0)) throw StartError("its axis or quaternion was drawn as zero, which is not a rotation");
  return Rotation3(q);
}

}  // namespace flyrock
