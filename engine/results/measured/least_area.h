#pragma once
// The area of least size outside of which rocks stop with at most a given probability (`area: least`).
//
// Half of the trials say where rocks stop, the other half how many stop outside of it. The even trials'
// landings (their stops, where rocks roll on) make a density in plan with Epanechnikov's kernel of radius R.
// Each rock of the odd trials gets the density at its place; where that is 0, it comes before all others, the
// farther from the nearest place with a density the earlier. The area is the region where the density (or,
// below 0, minus the distance) is at least the (k + 1)-th least of these numbers, with its holes filled and
// the hull of the releases. k is that of a blasting area of one sector for the N effective rocks of the odd
// trials (results/measured/sectors.h): so with 95 % confidence at most the probability of new rocks stops
// outside, whatever the density is (Wilks 1941; Lei, Robins and Wasserman 2013, Distribution-free prediction
// sets).
//
// R decides how much land that takes, not whether the area holds. Where nobody gives it, it is one of eight
// shares of the clearance's distance: the one that needs the least land when a half of the even trials is
// judged by their other half.
//
// `per: blast`: a blast has the least number of its rocks, and N counts blasts; where rocks have weights, the
// probability of a simulated blast is 1 - (1 - p)^(1/w) with the greatest weight w.

#include <array>
#include <optional>
#include <vector>

#include "geometry/plan_field.h"
#include "results/measured/sectors.h"

namespace flyrock {

struct LeastArea {
  std::optional<std::uint64_t> beyond = {};  ///< k; none: there is no area
  double effective = 0;                      ///< N
  double radius = unknown;                   ///< m, R
  double hectares = unknown;
  std::vector<PlanRing> polygons = {};  ///< counter-clockwise; they do not overlap
  std::uint64_t censored = 0;           ///< rocks that count where they were last seen

  /// The circle about the hull of the releases that holds with the same confidence: the area of one sector.
  double circle_distance = unknown, circle_hectares = unknown;
};

/// The least of some scores that weigh `needed` together, and the greatest of these.
class LeastScores {
 public:
  explicit LeastScores(double needed = 0) : needed_(needed) {}
  void add(double score, double weight);
  /// None: all scores weigh less.
  std::optional<double> level() const;

 private:
  struct Scored {
    double score, weight;
    bool operator<(const Scored& other) const { return score < other.score; }
  };
  double needed_, weight_ = 0;
  std::vector<Scored> least_;  ///< a heap, the greatest in front
};

/// Computes a LeastArea from rocks that are shown in passes; see read_in_passes().
class LeastAreaTally {
 public:
  explicit LeastAreaTally(const ClearancePlan& plan);
  void add(const TrialRecords& chunk);
  /// What the clearance without sectors says, once it is known.
  struct Clearance {
    double distance = 0, design_effect = 1;
  };
  bool needs_another_pass(const std::optional<Clearance>& clearance);
  LeastArea summary(Told told = Told::all) const;

 private:
  enum class Stage { extent, waiting, spread, choose, judge, done };
  /// Trials t with the same t mod 4. Classes 0 and 2 are even.
  struct Class {
    std::uint64_t rocks = 0, trials = 0;
    double weight = 0;
  };
  /// A radius that may be chosen, with the density of class 0 and that of class 2.
  struct Candidate {
    double radius = 0;
    PlanField field, other;
    LeastScores scores;  ///< of class 2 in the field of class 0
  };
  bool counts(const RockRecord& rock) const { return !is_fault(rock.reason) && plan_.counts(rock.group); }
  void widen(const RockRecord& rock);
  void begin(const Clearance& clearance);
  void spread(const RockRecord& rock);
  void choose();
  double effective(std::initializer_list<int> classes) const;
  double unit_of(const RockRecord& rock, std::initializer_list<int> classes) const;
  void finish();
  template <class Add>
  void each_score(const TrialRecords& chunk, const PlanField& field, std::initializer_list<int> classes,
                  Add&& add) const;

  ClearancePlan plan_;
  Stage stage_ = Stage::extent;
  SectorTally circle_;
  std::vector<Vec2> releases_;
  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();
  std::array<Class, 4> classes_;
  WeightRange weights_;
  double greatest_weight_ = 0;
  std::uint64_t last_trial_ = 0;
  double design_effect_ = 1, probability_ = 0;
  std::vector<Candidate> candidates_;
  PlanField field_;
  LeastScores scores_;
  LeastArea area_;
};

}  // namespace flyrock
