#pragma once
// A stereonet of a survey of joints: the lower hemisphere in equal area (Schmidt's net).

#include <string>

#include "results/statistics/joint_survey.h"

namespace flyrock {

/// The place of a line on the net of radius 1: x to the east, y to the north. A line upwards is turned down.
///   r = sqrt(2) sin(theta/2), theta from straight down
Vec2 on_net(const Vec3& line);

/// Poles of the planes with the contours of their density, the great circles and mean poles of the sets, the
/// face and its friction cone, as a self-contained SVG picture. `face` may be null.
std::string stereonet_svg(const JointSurvey& survey, const SlopeFace* face);

}  // namespace flyrock
