#include "results/compare/observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "results/compare/misfit.h"
#include "results/say/wording.h"
#include "results/statistics/share.h"

namespace flyrock {

namespace {

/// The fewest trials of a rock from which its band is read.
constexpr std::size_t least_of_band = 20;

/// The way along which places are counted: from the mean start to the mean of the measured places.
struct Way {
  Vec2 from = Vec2::Zero(), along = Vec2::UnitX();
  bool is_of_places = false;

  double at(const Vec2& value) const { return is_of_places ? along.dot(value - from) : value.x(); }
  double beside(const Vec2& value) const { return cross(along, Vec2(value - from)); }
};

Vec2 mean_of(const std::vector<Vec2>& values) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The mean of errors, and its standard error.
std::pair<double, double> mean_and_error(const std::vector<double>& values) {
  if (values.empty()) return {unknown, unknown};
  const SortedSample sample(values);
  if (values.size() < 2) return {sample.mean(), unknown};
  return {sample.mean(), sample.standard_deviation() / std::sqrt(static_cast<double>(values.size()))};
}

/// The values of a row, trial by trial, differ from those of the first trial.
bool differs_between_trials(const SimulatedRow& row) {
  const auto is_other = [&](const SimulatedValue& v) { return v.trial != row.values.front().trial; };
  if (row.values.empty()) return false;
  const auto second = std::find_if(row.values.begin(), row.values.end(), is_other);
  const auto in_first = static_cast<std::size_t>(second - row.values.begin());
  constexpr double rounding = 1e-9;  // m
  for (std::size_t i = in_first; i < row.values.size(); ++i)
    if ((row.values[i].value - row.values[i % in_first].value).norm() > rounding) return true;
  return false;
}

class Comparing {
 public:
  Comparing(const ObservedPlan& plan, const SimulatedRows& simulated, const std::vector<std::size_t>& rows,
            std::uint64_t seed)
      : plan_(plan), simulated_(simulated), rows_(rows), seed_(seed), all_(observed_values(plan, simulated)) {
    std::sort(rows_.begin(), rows_.end());
    // A rock that failed in each trial has no start from which its distance counts.
    std::erase_if(rows_, [&](std::size_t row) { return !all_[row].allFinite(); });
    for (const std::size_t row : rows_) observed_.push_back(all_[row]);
  }

  /// Along the way.
  SortedSample measured() {
    if (rows_.empty()) return {};
    find_way();
    std::vector<double> values;
    for (const Vec2& value : observed_) values.push_back(way_.at(value));
    return SortedSample(std::move(values));
  }

  ObservationSummary summary() {
    result_.rows = rows_.size();
    result_.is_paired = plan_.is_paired();
    count();
    if (rows_.empty() || result_.values == 0) return std::move(result_);
    result_.observed = measured();
    distribution_of_model();
    bias();
    count_censored();
    energies();
    bands();
    if (plan_.per == ObservedUnit::hole) throws();
    return std::move(result_);
  }

 private:
  std::vector<const SimulatedRow*> simulated_rows() const {
    std::vector<const SimulatedRow*> list;
    if (!plan_.is_paired()) return {&simulated_.rows.front()};
    for (const std::size_t row : rows_) list.push_back(&simulated_.rows[row]);
    return list;
  }

  void count() {
    result_.has_scatter = false;
    for (const SimulatedRow* row : simulated_rows()) {
      for (const SimulatedValue& value : row->values) ++(value.censored ? result_.censored : result_.values);
      result_.lost += row->lost;
      result_.has_scatter = result_.has_scatter || differs_between_trials(*row);
    }
  }

  void find_way() {
    if (plan_.of != ObservedNumber::place) return;
    way_.is_of_places = true;
    std::vector<Vec2> starts;
    for (const SimulatedRow* row : simulated_rows()) starts.push_back(row->start);
    way_.from = mean_of(starts);
    const Vec2 to = mean_of(observed_) - way_.from;
    if (to.norm() > 0) way_.along = to.normalized();
  }

  void distribution_of_model() {
    std::vector<double> model;
    for (const SimulatedRow* row : simulated_rows())
      for (const SimulatedValue& value : row->values)
        if (!value.censored) model.push_back(way_.at(value.value));
    result_.model = SortedSample(std::move(model));
  }

  /// The mean over the rows of their rock less what was measured; else the difference of the two means.
  std::pair<double, double> bias_of(double (Way::*component)(const Vec2&) const, Censored censored) const {
    const auto counts = [&](const SimulatedValue& value) {
      return !value.censored || censored == Censored::at_their_end;
    };
    std::vector<double> errors;
    if (plan_.is_paired()) {
      for (const std::size_t r : rows_) {
        std::vector<double> own;
        for (const SimulatedValue& value : simulated_.rows[r].values)
          if (counts(value)) own.push_back((way_.*component)(value.value));
        if (!own.empty()) errors.push_back(SortedSample(own).mean() - (way_.*component)(all_[r]));
      }
      return mean_and_error(errors);
    }
    std::vector<double> observed, means, of_trial, all;
    for (const Vec2& value : observed_) observed.push_back((way_.*component)(value));
    const std::vector<SimulatedValue>& values = simulated_.rows.front().values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (counts(values[i])) {
        of_trial.push_back((way_.*component)(values[i].value));
        all.push_back(of_trial.back());
      }
      if (i + 1 < values.size() && values[i + 1].trial == values[i].trial) continue;
      if (!of_trial.empty()) means.push_back(SortedSample(of_trial).mean());
      of_trial.clear();
    }
    const double of_model = mean_and_error(means).second, of_observed = mean_and_error(observed).second;
    return {SortedSample(all).mean() - SortedSample(observed).mean(), std::hypot(of_model, of_observed)};
  }

  void bias() {
    constexpr Censored left_out = Censored::left_out;
    std::tie(result_.bias, result_.bias_error) = bias_of(&Way::at, left_out);
    if (way_.is_of_places) std::tie(result_.across, result_.across_error) = bias_of(&Way::beside, left_out);
  }

  /// The scores of all rocks, also of those that would have gone on.
  void count_censored() {
    auto& scores = result_.with_censored;
    std::tie(scores.bias, scores.bias_error) = bias_of(&Way::at, Censored::at_their_end);
    const MisfitPool pool(simulated_rows(), way_.is_of_places, Censored::at_their_end);
    scores.energy = pool.energy_of(observed_);
  }

  void energies() {
    const bool in_plane = way_.is_of_places;
    const MisfitPool pool(simulated_rows(), in_plane, Censored::left_out);
    result_.energy = pool.energy_of(observed_);
    result_.constant = in_plane ? way_.at(mean_of(observed_)) : result_.observed.quantile(0.5);
    const Vec2 constant = in_plane ? mean_of(observed_) : Vec2(result_.constant, 0);
    result_.constant_energy = energy_of_constant(observed_, constant, in_plane);
    if (!result_.has_scatter) return;
    const std::vector<double> noise = pool.energies_of_draws(rows_.size(), seed_);
    const SortedSample sorted(noise);
    result_.energy_noise = sorted.mean();
    result_.energy_noise_p90 = sorted.quantile(0.9);
  }

  void bands() {
    for (const std::size_t r : rows_) {
      ObservedRock& rock = result_.rocks.emplace_back();
      rock.name = plan_.rows[r].name;
      rock.group = plan_.rows[r].group;
      rock.observed = way_.at(all_[r]);
      if (!plan_.is_paired()) continue;
      std::vector<double> own;
      for (const SimulatedValue& value : simulated_.rows[r].values) {
        ++rock.trials;
        rock.censored += value.censored;
        if (!value.censored) own.push_back(way_.at(value.value));
      }
      const SortedSample sorted(std::move(own));
      if (plan_.per == ObservedUnit::hole) rock.p50 = sorted.quantile(0.5);
      if (sorted.size() < least_of_band || !result_.has_scatter) continue;
      rock.p5 = sorted.quantile(0.05);
      rock.p50 = sorted.quantile(0.5);
      rock.p95 = sorted.quantile(0.95);
      rock.is_inside = rock.p5 <= rock.observed && rock.observed <= rock.p95;
      ++result_.with_band;
      result_.inside += rock.is_inside;
    }
    if (result_.with_band > 0)
      result_.inside_interval = share_interval(static_cast<double>(result_.inside),
                                               static_cast<double>(result_.with_band), stated_confidence);
  }

  /// Holes that throw nothing in any trial have no distance to compare.
  void throws() {
    std::vector<Throw> list;
    for (const std::size_t r : rows_) {
      std::vector<double> own;
      for (const SimulatedValue& value : simulated_.rows[r].values) own.push_back(value.value.x());
      const double model = SortedSample(std::move(own)).quantile(0.5);
      if (model > 0) list.push_back({all_[r].x(), model});
    }
    result_.throws = summary_of(list);
  }

  const ObservedPlan& plan_;
  const SimulatedRows& simulated_;
  std::vector<std::size_t> rows_;
  const std::uint64_t seed_;
  std::vector<Vec2> all_, observed_;
  Way way_;
  ObservationSummary result_;
};

std::vector<std::size_t> all_rows(const ObservedPlan& plan) {
  std::vector<std::size_t> rows(plan.rows.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

/// "Of 264 blasts it falls short of the farthest rock on 90 % (95 % interval 86 to 94 %); times 3.2 it covers
/// 95 % of them ..."
std::string throws_text(const ThrowSummary& throws) {
  std::string text = fmt::format("Of {} blasts it falls short of the farthest rock on {}", throws.blasts,
                                 display(throws.short_of));
  for (const CoveringFactor& factor : throws.factors)
    if (factor.covers > 0.5)
      text += fmt::format("{} times {} it covers {} of them", factor.covers < 0.99 ? ";" : ",",
                          three_digits(factor.factor), percent(factor.covers));
  text += fmt::format("; the ranks of model and measurement have the correlation {}.",
                      three_digits(throws.rank.r));
  if (throws.site)
    text += fmt::format(
        " The factor {} of every other blast, made to cover 95 % of these, covers {} of the others.",
        three_digits(throws.site->factor), percent(throws.site->covered.value));
  return text;
}

}  // namespace

std::vector<Vec2> observed_values(const ObservedPlan& plan, const SimulatedRows& simulated) {
  std::vector<Vec2> values;
  for (std::size_t r = 0; r < plan.rows.size(); ++r) {
    const ObservedRow& row = plan.rows[r];
    const Vec2 place = row.place.head<2>();
    const Vec2 start = simulated.rows[plan.is_paired() ? r : 0].start;
    if (plan.of == ObservedNumber::place)
      values.push_back(place);
    else
      values.emplace_back(std::isnan(row.distance) ? (place - start).norm() : row.distance, 0);
  }
  return values;
}

ObservationSummary compare(const ObservedPlan& plan, const SimulatedRows& simulated,
                           const std::vector<std::size_t>& rows, std::uint64_t seed) {
  return Comparing(plan, simulated, rows, seed).summary();
}

ObservationSummary compare(const ObservedPlan& plan, const SimulatedRows& simulated, std::uint64_t seed) {
  return compare(plan, simulated, all_rows(plan), seed);
}

SortedSample measured(const ObservedPlan& plan, const SimulatedRows& simulated) {
  return Comparing(plan, simulated, all_rows(plan), 0).measured();
}

std::string measured_text(const ObservedPlan& plan, const SortedSample& measured) {
  if (measured.empty()) return "no row with a start";
  const char* along = plan.of == ObservedNumber::place ? " along the way from the mean start" : "";
  return fmt::format("{} row{}, {} {} to {} m{}, median {} m", measured.size(),
                     measured.size() == 1 ? "" : "s", name_of(plan.of), three_digits(measured.quantile(0)),
                     three_digits(measured.quantile(1)), along, three_digits(measured.quantile(0.5)));
}

std::string observation_text(const ObservedPlan& plan, const ObservationSummary& summary) {
  if (std::isnan(summary.energy))
    return "Compared with the measured rows: no rock of the model came to rest.";
  std::string text = fmt::format(
      "Compared with what was measured ({}): the model is {} m too {} on the mean (standard error {} m); "
      "energy "
      "distance {} m",
      measured_text(plan, summary.observed), three_digits(std::abs(summary.bias)),
      summary.bias < 0 ? "short" : "far", three_digits(summary.bias_error), three_digits(summary.energy));
  if (summary.has_scatter)
    text += fmt::format(", {} m where the model were true (90 % below {} m)",
                        three_digits(summary.energy_noise), three_digits(summary.energy_noise_p90));
  text += fmt::format("; a constant of {} m has {} m", three_digits(summary.constant),
                      three_digits(summary.constant_energy));
  if (summary.with_band > 0)
    text += fmt::format("; {} of {} rows are inside their own 90 % band", summary.inside, summary.with_band);
  text += '.';
  if (!summary.has_scatter)
    text += " The model has no scatter between trials, so it has neither bands nor noise.";
  if (summary.throws && summary.throws->blasts > 0) text += " " + throws_text(*summary.throws);
  if (summary.censored > 0)
    text += fmt::format(
        " {} rocks of the model left the domain or still moved: they are in none of these numbers. Counted "
        "where they were last seen, the model is {} m {} (standard error {} m) and its energy distance {} m.",
        summary.censored, three_digits(std::abs(summary.with_censored.bias)),
        summary.with_censored.bias < 0 ? "short" : "far", three_digits(summary.with_censored.bias_error),
        three_digits(summary.with_censored.energy));
  return text;
}

}  // namespace flyrock
