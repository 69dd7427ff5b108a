#pragma once
// The surveyed face of a blast, and what it says of the burdens of the measured holes.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scenario/decode_sections.h"
#include "survey/face_survey.h"

namespace flyrock {

/// The data of `blast.face`, read from its files.
class FaceOfBlast {
 public:
  /// The burden of a hole of the front row: the least distance from the axis of its charge to the face. It
  /// goes into the hole, into its completed blast, and with the burden along the hole and the fields that it
  /// follows from into the plan. Throws std::invalid_argument if the hole does not say where its charge is.
  void put_burden(std::size_t hole, Blast& completed, BlastPlan& plan) const;

  /// Whether a hole of the front row gets farther from the surveyed face as it gets deeper than an upright
  /// one from the same collar.
  bool leans_away(const Hole& hole, const Blast& completed) const;

 private:
  friend std::unique_ptr<const FaceOfBlast> read_face(DecodeContext&, const Node&, BlastPlan&);

  /// A place of the track of a hole, or of its profile: at a depth along the hole.
  struct AtDepth {
    double depth = 0;
    Vec3 place = Vec3::Zero();
    double distance = 0;
  };
  /// The axis of a hole: its place at each depth along it.
  struct Axis {
    Vec3 collar = Vec3::Zero(), direction = -Vec3::UnitZ();
    std::vector<AtDepth> track;  ///< sorted by depth; empty: straight

    Vec3 at(double depth) const;
    /// From one depth to another, with the corners between them.
    std::vector<Vec3> between(double from, double to) const;
  };

  Axis axis_of(const Hole& hole, BlastWriter& blast) const;
  BurdenCurve curve_of_survey(const Axis& axis, const Blast& blast) const;
  BurdenCurve curve_of_profile(const Hole& hole, const Axis& axis, const Blast& blast,
                               const Vec3& across) const;
  Vec3 across_row(const Hole& hole, BlastWriter& blast, const std::vector<Hole>& holes) const;

  std::unique_ptr<const FaceSurvey> survey_;                       ///< null: profiles
  std::map<std::string, std::vector<AtDepth>> profiles_, tracks_;  ///< by the name of the hole
};

/// Reads `face` of a blast; null if it has none, or if it is wrong, which is reported.
std::unique_ptr<const FaceOfBlast> read_face(DecodeContext& context, const Node& blast, BlastPlan& plan);

/// Warns of holes along whose charge the survey of the face ends.
void warn_of_gaps(DecodeContext& context, const Node& blast, const BlastPlan& plan);

}  // namespace flyrock
