#pragma once
// One number of a trial: what a sensitivity analysis explains.
//
//   rocks.NAME.QUANTITY.mean | .max | .p95 | .beyond[300 m]   of the rocks of a group, with their weights;
//   p95
//                                                             of at least 20 rocks
//   gate.NAME.per_trial, barrier.NAME.OUTCOME.per_trial       1 if at least one rock passes, else 0
//   exposure.NAME.per_blast                                   1 - prod (1 - q)^w (results/risk/exposure.h)
//
// It is unknown in a trial with a lost rock, or with a censored one that may change it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/records.h"
#include "results/statistics/statistics.h"
#include "results/statistics/unknown.h"
#include "scenario/scenario.h"

namespace flyrock {

class TrialMeasure {
 public:
  /// `text` as above. Nothing if it is no such number; `fault` then says what was expected.
  static std::optional<TrialMeasure> read(const std::string& text, const Scenario& scenario,
                                          std::string& fault);

  const std::string& text() const { return text_; }
  /// "the greatest runout of `face`"
  std::string words() const;
  const std::string& unit() const { return unit_; }  ///< SI
  /// The group that it counts; -1: of all.
  int group() const { return group_; }
  /// The exposure of which it needs the radius first; -1: none.
  int exposure() const { return kind_ == Kind::exposure ? place_ : -1; }
  void set_radius(double radius) { radius_ = radius; }
  /// The number of a trial without rocks.
  double without_rocks() const { return kind_ <= Kind::p95 ? unknown : 0; }

  /// Puts the number of each trial of a chunk to its place.
  void add(const TrialRecords& chunk, std::vector<double>& of_trial) const;

  static constexpr std::size_t least_rocks_for_p95 = 20;

 private:
  enum class Kind { mean, greatest, p95, beyond, gate, barrier, exposure };
  struct Rocks;

  explicit TrialMeasure(const Scenario& scenario) : scenario_(&scenario) {}
  bool read_rocks(const std::vector<std::string>& steps, std::string& fault);
  bool read_crossing(const std::vector<std::string>& steps, std::string& fault);
  double of_rocks(const Rocks& rocks) const;
  double of_crossings(const Rocks& rocks) const;
  double of_exposure(const Rocks& rocks) const;

  const Scenario* scenario_;
  std::string text_, unit_ = "1";
  Kind kind_ = Kind::mean;
  int group_ = -1;
  int place_ = 0;  ///< of a gate, barrier or exposure
  int outcome_ = 0;
  std::size_t quantity_ = 0;  ///< of rock_statistics
  double limit_ = 0;          ///< of `beyond`, SI
  double radius_ = 0;         ///< m, of the kernel of an exposure
};

}  // namespace flyrock
