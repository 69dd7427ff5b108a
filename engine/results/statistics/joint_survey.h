#pragma once
// What a survey of joints says: its sets, their spacings, and which of its planes could let a face fail.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/statistics/joint_sets.h"

namespace flyrock {

/// A plane that was measured. Angles in rad; directions clockwise from north.
struct SurveyedPlane {
  double dip = 0, direction = 0;
  std::optional<double> position = std::nullopt;  ///< along its scanline [m]
  std::optional<Vec3> scanline = std::nullopt;    ///< unit, along the line on which it was met
  double weight = 1;
  std::optional<double> trace = std::nullopt;  ///< its length on the face [m]
};

/// A face, and how far from it a motion is judged to be one of the face.
struct SlopeFace {
  double dip = 0, direction = 0;
  double friction = 0;
  double lateral = 0;  ///< greatest difference of direction of a plane failure
};

struct SurveyOptions {
  int sets = 0;  ///< 0: 1 to 6, by BIC
  std::optional<SlopeFace> face = std::nullopt;
  std::optional<Vec3> scanline = std::nullopt;  ///< of all planes without one of their own
  double blind = 0;  ///< planes with a smaller angle to their scanline are left out
  std::uint64_t seed = 1;
};

/// An estimate with its 95 % interval by bootstrap over the planes.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

struct SurveyedSet {
  FisherSet fit;
  double dip = 0, direction = 0;
  double cone = 0;  ///< the mean is within this angle with 95 % confidence
  Estimate k, share;
  int planes = 0;                   ///< that belong to it rather than to another set or the rest
  std::optional<Estimate> spacing;  ///< m, normal to its mean plane
  /// m, mean length of its traces. A scanline meets a trace with a probability in proportion to its length:
  /// such traces count 1/length (Priest 1993). Ends that a face does not show make it a lower bound.
  std::optional<Estimate> trace;
};

/// Shares of the planes, and of the pairs of planes, that could let the face fail. If none does or all do,
/// the interval is that of Clopper and Pearson for the effective number of planes (of pairs: half of it,
/// because so many pairs share no plane): the draws of the bootstrap are all alike then.
struct KinematicShares {
  Estimate plane, wedge, toppling;
};

struct JointSurvey {
  std::size_t planes = 0, blind = 0;  ///< read, and of these left out
  Poles poles;                        ///< of those that were used, upwards; with their weights
  std::vector<int> set_of;            ///< of each of these
  SetMixture mixture;
  std::vector<SurveyedSet> sets;
  Estimate rest;  ///< share of the planes that belong to no set
  std::optional<KinematicShares> hazards;
  std::size_t to_halve = 0;  ///< planes that a survey with intervals half as wide takes
};

/// The upward normal of a plane, and the unit vector of a trend and plunge. x is east, y is north.
Vec3 pole_of(double dip, double direction);
Vec3 line_of(double trend, double plunge);
/// Dip and dip direction of the plane with a normal.
std::pair<double, double> dip_of(const Vec3& normal);

/// A plane that meets its scanline at the angle a counts 1/sin(a) (Terzaghi 1965): a scanline meets fewer of
/// those that it is nearly parallel to. Throws std::invalid_argument if fewer than 3 planes are left.
JointSurvey survey_of(const std::vector<SurveyedPlane>& planes, const SurveyOptions& options);

/// Whether a plane lets a block slide out of the face: |direction - face| <= lateral, friction < dip < face.
bool slides_on(const SlopeFace& face, const Vec3& pole);
/// Whether two planes let a wedge slide: friction < plunge of their line < dip of the face along its trend.
bool slides_between(const SlopeFace& face, const Vec3& first, const Vec3& second);
/// Whether a plane lets columns topple: 90 deg - dip <= face - friction, and it dips into the face to 10 deg.
bool topples_on(const SlopeFace& face, const Vec3& pole);

}  // namespace flyrock
