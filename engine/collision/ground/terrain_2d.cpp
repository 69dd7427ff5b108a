#include "collision/ground/terrain_2d.h"

#include <algorithm>

namespace flyrock {

namespace {

constexpr double beyond = 1000;  // m

std::vector<Vec2> extended(const Profile& profile) {
  std::vector<Vec2> points{profile.points.front() - Vec2(beyond, 0)};
  points.insert(points.end(), profile.points.begin(), profile.points.end());
  points.push_back(profile.points.back() + Vec2(beyond, 0));
  return points;
}

std::vector<int> extended_parts(const Profile& profile) {
  std::vector<int> part{profile.part.front()};
  part.insert(part.end(), profile.part.begin(), profile.part.end());
  part.push_back(profile.part.back());
  return part;
}

}  // namespace

Terrain2::Terrain2(Profile profile)
    : Ground2(extended(profile), extended_parts(profile)),
      profile_(std::move(profile)),
      names_(terrain_names(profile_.parts)) {}

double Terrain2::height(double x) const {
  return profile_.height(std::clamp(x, profile_.x_min(), profile_.x_max()));
}

}  // namespace flyrock
