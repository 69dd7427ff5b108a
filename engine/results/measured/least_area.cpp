#include "results/measured/least_area.h"

#include <algorithm>
#include <cmath>

#include "geometry/plan_hull.h"

namespace flyrock {

namespace {

/// Radii that are tried, as shares of the clearance's distance.
constexpr double tried_radii[] = {0.06, 0.09, 0.13, 0.2, 0.3, 0.45, 0.7, 1};
constexpr double cells_of_radius = 6;
constexpr double hectare = 1e4;  // m2

Vec2 stop_of(const RockRecord& rock) { return {rock.stop_x, rock.stop_y}; }
std::size_t class_of(const RockRecord& rock) { return static_cast<std::size_t>(rock.trial % 4); }

ClearancePlan in_one_sector(ClearancePlan plan) {
  plan.sectors = 1;
  plan.about.reset();
  return plan;
}

/// The area within a distance of a convex hull.
double area_about(const std::vector<Vec2>& hull, double distance) {
  double area = pi * distance * distance, twice = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 from = hull[i] - hull[0], to = hull[(i + 1) % hull.size()] - hull[0];
    twice += cross(from, to);
    area += (to - from).norm() * distance;
  }
  return area + twice / 2;
}

}  // namespace

void LeastScores::add(double score, double weight) {
  least_.push_back({score, weight});
  std::push_heap(least_.begin(), least_.end());
  weight_ += weight;
  while (weight_ - least_.front().weight >= needed_) {
    weight_ -= least_.front().weight;
    std::pop_heap(least_.begin(), least_.end());
    least_.pop_back();
  }
}

std::optional<double> LeastScores::level() const {
  if (least_.empty() || weight_ < needed_) return std::nullopt;
  return least_.front().score;
}

LeastAreaTally::LeastAreaTally(const ClearancePlan& plan) : plan_(plan), circle_(in_one_sector(plan)) {
  if (!plan.least_area) stage_ = Stage::done;
}

/// Calls add(score, rock): for each rock of some classes its number in the field; per blast once a trial.
/// Trials are never split between chunks.
template <class Add>
void LeastAreaTally::each_score(const TrialRecords& chunk, const PlanField& field,
                                std::initializer_list<int> classes, Add&& add) const {
  double least = infinite;
  for (std::size_t i = 0; i < chunk.rocks.size(); ++i) {
    const RockRecord& rock = chunk.rocks[i];
    const bool is_of_class =
        std::find(classes.begin(), classes.end(), static_cast<int>(class_of(rock))) != classes.end();
    if (!is_of_class) continue;
    if (counts(rock)) {
      const double score = field.at(stop_of(rock));
      if (!plan_.per_blast) add(score, rock);
      least = std::min(least, score);
    }
    if (i + 1 < chunk.rocks.size() && chunk.rocks[i + 1].trial == rock.trial) continue;
    if (plan_.per_blast && least < infinite) add(least, rock);
    least = infinite;
  }
}

void LeastAreaTally::add(const TrialRecords& chunk) {
  if (!plan_.least_area) return;
  circle_.add(chunk);
  switch (stage_) {
    case Stage::extent:
      for (const RockRecord& rock : chunk.rocks)
        if (counts(rock)) widen(rock);
      break;
    case Stage::spread:
      for (const RockRecord& rock : chunk.rocks)
        if (counts(rock) && rock.trial % 2 == 0) spread(rock);
      break;
    case Stage::choose:
      for (Candidate& candidate : candidates_)
        each_score(chunk, candidate.field, {2}, [&](double score, const RockRecord& rock) {
          candidate.scores.add(score, unit_of(rock, {2}));
        });
      break;
    case Stage::judge:
      each_score(chunk, field_, {1, 3}, [&](double score, const RockRecord& rock) {
        scores_.add(score, unit_of(rock, {1, 3}));
      });
      break;
    case Stage::waiting:
    case Stage::done:
      break;
  }
}

void LeastAreaTally::widen(const RockRecord& rock) {
  Class& of_trial = classes_[class_of(rock)];
  const bool is_first = releases_.empty();
  for (const Vec2& place : {stop_of(rock), Vec2(rock.start_x, rock.start_y)}) {
    low_ = is_first ? stop_of(rock).cwiseMin(place) : Vec2(low_.cwiseMin(place));
    high_ = is_first ? stop_of(rock).cwiseMax(place) : Vec2(high_.cwiseMax(place));
  }
  of_trial.trials += of_trial.rocks == 0 || rock.trial != last_trial_;
  last_trial_ = rock.trial;
  ++of_trial.rocks;
  of_trial.weight += rock.weight;
  weights_.add(rock.weight);
  greatest_weight_ = std::max(greatest_weight_, rock.weight);
  area_.censored += rock.censored;
  constexpr std::size_t most = 4096;  // few of a million places are corners of the hull
  releases_.emplace_back(rock.start_x, rock.start_y);
  if (releases_.size() >= most && (releases_.size() & (releases_.size() - 1)) == 0)
    releases_ = plan_hull(std::move(releases_));
}

double LeastAreaTally::effective(std::initializer_list<int> classes) const {
  std::uint64_t units = 0;
  for (const int c : classes) {
    const Class& of_class = classes_[static_cast<std::size_t>(c)];
    units += plan_.per_blast ? of_class.trials : of_class.rocks;
  }
  return static_cast<double>(units) / design_effect_;
}

double LeastAreaTally::unit_of(const RockRecord& rock, std::initializer_list<int> classes) const {
  if (plan_.per_blast || !weights_.differ()) return 1 / design_effect_;
  double rocks = 0, weight = 0;
  for (const int c : classes) {
    rocks += static_cast<double>(classes_[static_cast<std::size_t>(c)].rocks);
    weight += classes_[static_cast<std::size_t>(c)].weight;
  }
  return rock.weight * rocks / weight / design_effect_;
}

void LeastAreaTally::begin(const Clearance& clearance) {
  if (!plan_.per_blast) design_effect_ = clearance.design_effect;
  probability_ = plan_.probability;
  // So many real rocks as the heaviest one stands for are outside with the probability of the clearance.
  if (plan_.per_blast && greatest_weight_ > 1)
    probability_ = -std::expm1(std::log1p(-plan_.probability) / greatest_weight_);
  area_.effective = effective({1, 3});
  area_.beyond = rocks_beyond(1, area_.effective, probability_);
  const bool has_even = classes_[0].rocks + classes_[2].rocks > 0;
  if (!area_.beyond || !has_even || !(clearance.distance > 0)) {
    area_.beyond.reset();
    stage_ = Stage::done;
    return;
  }
  scores_ = LeastScores(static_cast<double>(*area_.beyond) + 1);
  const auto add_radius = [&](double radius) {
    const Vec2 margin(radius, radius);
    Candidate& candidate = candidates_.emplace_back();
    candidate.radius = radius;
    candidate.field = PlanField(low_ - margin, high_ + margin, radius / cells_of_radius);
    candidate.other = candidate.field;
  };
  if (plan_.radius > 0)
    add_radius(plan_.radius);
  else
    for (const double share : tried_radii) add_radius(share * clearance.distance);
  stage_ = Stage::spread;
}

void LeastAreaTally::spread(const RockRecord& rock) {
  for (Candidate& candidate : candidates_) {
    PlanField& field = class_of(rock) == 0 ? candidate.field : candidate.other;
    field.add_kernel(stop_of(rock), candidate.radius, rock.weight);
  }
}

/// The candidate that needs the least land, and its density of all even trials.
void LeastAreaTally::choose() {
  std::size_t chosen = candidates_.size() - 1;  // where none can be judged, the smoothest one
  double least = infinite;
  for (std::size_t c = 0; c < candidates_.size() && candidates_.size() > 1; ++c) {
    const std::optional<double> level = candidates_[c].scores.level();
    if (!level || !(*level > 0)) continue;
    PlanField field = candidates_[c].field;
    field.lift(releases_);
    const double area = area_of(field.region_above(*level));
    if (area >= least) continue;
    least = area;
    chosen = c;
  }
  area_.radius = candidates_[chosen].radius;
  field_ = std::move(candidates_[chosen].field);
  field_.add(candidates_[chosen].other);
  candidates_.clear();
  field_ = field_.with_distances(0);
}

void LeastAreaTally::finish() {
  const std::optional<double> level = scores_.level();
  if (!level) {
    area_.beyond.reset();
    return;
  }
  if (*level < 0) field_ = field_.with_distances(-*level + field_.cell());
  field_.lift(releases_);
  area_.polygons = field_.region_above(*level);
  area_.hectares = area_of(area_.polygons) / hectare;
  field_ = {};
}

bool LeastAreaTally::needs_another_pass(const std::optional<Clearance>& clearance) {
  if (!plan_.least_area) return false;
  const bool circle =
      circle_.needs_another_pass(clearance ? std::optional(clearance->design_effect) : std::nullopt);
  const auto choose_radius = [&] {
    choose();
    stage_ = Stage::judge;
  };
  switch (stage_) {
    case Stage::extent:
      releases_ = plan_hull(std::move(releases_));
      stage_ = releases_.empty() ? Stage::done : Stage::waiting;
      break;
    case Stage::spread: {
      const std::optional<std::uint64_t> beyond = rocks_beyond(1, effective({2}), probability_);
      if (candidates_.size() == 1 || !beyond) {
        choose_radius();
        break;
      }
      for (Candidate& candidate : candidates_)
        candidate.scores = LeastScores(static_cast<double>(*beyond) + 1);
      stage_ = Stage::choose;
      break;
    }
    case Stage::choose:
      choose_radius();
      break;
    case Stage::judge:
      finish();
      stage_ = Stage::done;
      break;
    case Stage::waiting:
    case Stage::done:
      break;
  }
  if (stage_ == Stage::waiting && clearance) begin(*clearance);
  return circle || stage_ != Stage::done;
}

LeastArea LeastAreaTally::summary(Told told) const {
  if (told == Told::counts) return {.effective = area_.effective, .censored = area_.censored};
  LeastArea area = area_;
  const AreaSummary circle = circle_.summary();
  if (!plan_.least_area || !circle.beyond || circle.sectors.empty()) return area;
  area.circle_distance = circle.sectors.front().distance.value;
  area.circle_hectares = area_about(circle.hull, area.circle_distance) / hectare;
  return area;
}

}  // namespace flyrock
