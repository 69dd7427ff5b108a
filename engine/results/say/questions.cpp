#include "results/say/questions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "results/measured/lost.h"
#include "results/say/wording.h"

namespace flyrock {

namespace {

/// Up to this probability "one blast in N" is plain: N is 2 or more.
constexpr double most_one_in = 0.5;

/// "one in 190", "one in 8.1"
std::string one_in(double p, std::string_view what) {
  const double n = 1 / p;
  return fmt::format("one{} in {}", what, n < 10 ? fmt::format("{:.2g}", n) : three_digits(n));
}

/// "0.527 %, one in 190"
std::string chance_text(double p) {
  return p > 0 && p <= most_one_in ? fmt::format("{}, {}", percent(p), one_in(p, "")) : percent(p);
}

/// "one blast in 190 hits", "96 % of the blasts hit": who does something, with its verb.
std::string blasts_that(double p, std::string_view one, std::string_view several) {
  if (p > 0 && p <= most_one_in) return fmt::format("{} {}", one_in(p, " blast"), one);
  return fmt::format("{} of the blasts {}", percent(p), several);
}

/// "0.319 to 0.856 %"
std::string percent_range(const Interval& interval) {
  if (interval.trials_needed > 0)
    return fmt::format("too few trials, about {} needed", interval.trials_needed);
  if (std::isnan(interval.upper)) return "not known";
  return fmt::format("{:.3g} to {}", 100 * interval.lower, percent(interval.upper));
}

/// "540 to 650 m", with another confidence than that of the column "430 to 800 m (99 %)"
std::string metres_range(const Interval& interval, double confidence) {
  if (std::isnan(interval.lower)) return "not known";
  const std::string of = confidence == stated_confidence ? "" : fmt::format(" ({})", percent(confidence));
  if (std::isnan(interval.upper)) return fmt::format("from {} m on{}", three_digits(interval.lower), of);
  return fmt::format("{} to {} m{}", three_digits(interval.lower), three_digits(interval.upper), of);
}

std::string year_text(double p, double blasts) {
  // "100 %" of what may also not happen would be false.
  const std::string share = p > 0.9995 ? "above 99.9 %" : percent(p);
  return fmt::format("{} in {} blast{}", share, three_digits(blasts), blasts == 1 ? "" : "s");
}

constexpr const char *verdict_held = "held", *verdict_not_held = "not held", *verdict_not_shown = "not shown";

/// The verdict on a number with an interval that must not exceed a limit.
const char* verdict_of(double lower, double upper, double limit) {
  if (upper <= limit) return verdict_held;
  return lower > limit ? verdict_not_held : verdict_not_shown;  // NaN: not shown
}

// ---- how far
// -----------------------------------------------------------------------------------------------

std::string of_group(const Scenario& scenario, const ClearancePlan& asked) {
  return asked.group < 0 ? "" : " of " + scenario.rocks.at(static_cast<std::size_t>(asked.group)).name;
}

/// "593 m", "at least 593 m", "593 m (890 m with the factor 1.5)"
std::string distance_text(const ClearancePlan& asked, const ClearanceSummary& found) {
  const std::string text =
      fmt::format("{}{} m", found.distance.censored ? "at least " : "", three_digits(found.distance.value));
  if (!asked.factor) return text;
  return fmt::format("{} ({} m with the factor {})", text, three_digits(found.with_factor),
                     three_digits(*asked.factor));
}

/// The verdict on the customary distance, against the distance with its factor and the interval without one.
const char* verdict_of(const ClearanceSummary& found, double customary) {
  if (found.with_factor > customary) return verdict_not_held;
  if (found.distance.censored && !(found.interval.lower > customary)) return verdict_not_shown;
  return verdict_of(found.interval.lower, found.interval.upper, customary);
}

void put_limit(const ClearancePlan& asked, const char* verdict, Question& row) {
  if (!asked.customary) return;
  row.limit = fmt::format("{} m, customary", three_digits(*asked.customary));
  row.verdict = verdict;
}

void put_year(const ClearancePlan& asked, double p, Question& row) {
  if (asked.blasts_per_year && !std::isnan(p))
    row.per_year = year_text(carried(p, *asked.blasts_per_year), *asked.blasts_per_year);
}

/// Why the distance of a clearance is not given.
std::string missing_text(const ClearancePlan& asked, const ClearanceSummary& found) {
  if (found.interval.trials_needed > 0)
    return fmt::format("too few trials, about {} needed", found.interval.trials_needed);
  const char* of = asked.per_blast ? "blasts" : "rocks";
  if (asked.sectors > 0)
    return fmt::format("too few: {} {} that are independent", three_digits(found.area.effective), of);
  return fmt::format("too few {}: {} of {} needed", of, found.count, found.needed);
}

Question missing_distance(const ClearancePlan& asked, const ClearanceSummary& found) {
  Question row;
  row.asks =
      fmt::format("{}: the {} that {} of the {} exceed", asked.name, asked.sectors > 0 ? "area" : "distance",
                  percent(asked.probability), asked.per_blast ? "blasts" : "rocks");
  row.per_blast = "not given";
  row.interval = missing_text(asked, found);
  row.clause = fmt::format("the {} of {} is not given ({})", asked.sectors > 0 ? "area" : "distance",
                           asked.name, row.interval);
  put_limit(asked, verdict_not_shown, row);
  return row;
}

/// An area holds with stated_confidence and has no interval.
Question area_question(const ClearancePlan& asked, const ClearanceSummary& found) {
  const std::string reach = distance_text(asked, found);
  const char* of = asked.per_blast ? "blast" : "rock";
  Question row;
  row.asks = fmt::format("{}: a {} outside of the area, which reaches {}", asked.name,
                         asked.per_blast ? "blast with a rock" : "rock", reach);
  row.per_blast = asked.per_blast ? "at most " + chance_text(asked.probability) : "";
  row.interval = percent(stated_confidence) + " confidence";
  row.clause = fmt::format("at most one {} in {} {} outside of the area of {}, which reaches {}", of,
                           three_digits(1 / asked.probability), asked.per_blast ? "throws a rock" : "goes",
                           asked.name, reach);
  if (asked.per_blast) put_year(asked, asked.probability, row);
  if (asked.customary) {
    const double distance = std::max(found.distance.value, asked.factor ? found.with_factor : 0);
    const bool is_held = distance <= *asked.customary && !found.distance.censored;
    put_limit(asked,
              is_held                       ? verdict_held
              : distance > *asked.customary ? verdict_not_held
                                            : verdict_not_shown,
              row);
  }
  return row;
}

/// "one rock of face in 20 goes", "60 % of the rocks of face go"
std::string rocks_that_go(double p, const std::string& of) {
  return p <= most_one_in ? one_in(p, " rock" + of) + " goes"
                          : fmt::format("{} of the rocks{} go", percent(p), of);
}

Question distance_question(const Scenario& scenario, const ClearancePlan& asked,
                           const ClearanceSummary& found) {
  const std::string distance = distance_text(asked, found), of = of_group(scenario, asked);
  const bool is_bound = found.is_upper_bound(asked);
  Question row;
  row.asks = fmt::format("{}: a rock{} beyond {}", asked.name, of, distance);
  row.interval = metres_range(found.interval, asked.confidence);
  if (asked.per_blast) {
    row.per_blast = (is_bound ? "at most " : "") + chance_text(asked.probability);
    row.clause = fmt::format("{}{} a rock{} beyond {}", is_bound ? "at most " : "",
                             blasts_that(asked.probability, "throws", "throw"), of, distance);
    put_year(asked, asked.probability, row);
  } else {
    const double p = found.beyond_distance.share.upper;
    row.per_blast = chance_text(p);
    row.clause = fmt::format("{} beyond {}", rocks_that_go(asked.probability, of), distance);
    if (found.count > found.beyond_distance.blasts) {  // else a blast is a rock
      row.asks += fmt::format(", which {} of the rocks exceed", percent(asked.probability));
      row.clause += fmt::format(", and {} such a rock", blasts_that(p, "throws", "throw"));
    }
    put_year(asked, p, row);
  }
  put_limit(asked, asked.customary ? verdict_of(found, *asked.customary) : "", row);
  return row;
}

/// The same the other way round: how often a rock goes beyond the customary distance.
Question customary_question(const Scenario& scenario, const ClearancePlan& asked,
                            const BlastsBeyond& beyond) {
  const std::string of = of_group(scenario, asked), bound = beyond.is_lower_bound ? "at least " : "";
  const double p = beyond.share.upper;
  Question row;
  row.asks =
      fmt::format("{}: a rock{} beyond {} m, customary", asked.name, of, three_digits(beyond.distance));
  row.per_blast = p > 0 ? bound + chance_text(p) : "below " + chance_text(beyond.share.interval.upper);
  row.interval = percent_range(beyond.share.interval);
  put_year(asked, p > 0 ? p : beyond.share.interval.upper, row);
  if (p <= 0 && !row.per_year.empty()) row.per_year = "below " + row.per_year;
  row.clause = fmt::format("{}{} one beyond the customary {} m", p > 0 ? bound : "fewer than ",
                           blasts_that(p > 0 ? p : beyond.share.interval.upper, "throws", "throw"),
                           three_digits(beyond.distance));
  return row;
}

// ---- who is hit
// --------------------------------------------------------------------------------------------

/// "house: hit by a rock of 20 J or more, there 20 % of the time"
std::string exposed_text(const ExposurePlan& asked) {
  std::string text = asked.name + ": ";
  text += asked.has_traffic() ? "a vehicle is hit" : "hit by a rock";
  if (asked.energy > 0)
    text += asked.has_traffic() ? fmt::format(" with {} J or more", three_digits(asked.energy))
                                : fmt::format(" of {} J or more", three_digits(asked.energy));
  if (asked.occupied != 1 && !asked.has_traffic())
    text += fmt::format(", occupied {} of the time", percent(asked.occupied));
  return text;
}

/// "1 % a blast, 10 % a year"
std::string limits_text(const ExposurePlan& asked) {
  std::string text;
  if (asked.limit_per_blast) text = percent(*asked.limit_per_blast) + " a blast";
  if (asked.limit_per_year) text += (text.empty() ? "" : ", ") + percent(*asked.limit_per_year) + " a year";
  return text;
}

/// The worse verdict of both limits.
std::string verdict_of(const ExposurePlan& asked, const ExposureSummary& found) {
  std::vector<std::string> verdicts;
  const auto judge = [&](const std::optional<double>& limit, const Interval& interval) {
    if (limit) verdicts.emplace_back(verdict_of(interval.lower, interval.upper, *limit));
  };
  judge(asked.limit_per_blast, found.per_blast.interval);
  judge(asked.limit_per_year, found.per_year_interval);
  for (const char* worst : {verdict_not_held, verdict_not_shown, verdict_held})
    for (const std::string& verdict : verdicts)
      if (verdict == worst) return verdict;
  return {};
}

Question exposure_question(const ExposurePlan& asked, const ExposureSummary& found) {
  const BlastBounds& hit = found.per_blast;
  const std::string whom = asked.has_traffic() ? "a vehicle on " + asked.name : asked.name;
  const bool is_none = !(hit.upper > 0);
  Question row;
  row.asks = exposed_text(asked);
  row.interval = percent_range(hit.interval);
  if (is_none) {
    row.per_blast = "below " + chance_text(hit.interval.upper);
    row.interval =
        std::isnan(found.radius) ? "no rock landed" : "no rock within " + three_digits(found.radius) + " m";
    row.clause = "fewer than " + blasts_that(hit.interval.upper, "hits ", "hit ") + whom;
  } else if (!hit.tells()) {
    row.per_blast = fmt::format("{:.3g} to {}, {}", 100 * hit.lower, percent(hit.upper), telling_text(hit));
    row.clause =
        fmt::format("between {:.3g} and {} of the blasts hit {}", 100 * hit.lower, percent(hit.upper), whom);
  } else {
    row.per_blast = chance_text(hit.upper);
    row.clause = blasts_that(hit.upper, "hits ", "hit ") + whom;
  }
  if (asked.blasts_per_year != 1 || (asked.occupied != 1 && !asked.has_traffic()))
    row.per_year = (is_none ? "below " : "") +
                   year_text(is_none ? found.per_year_interval.upper : found.per_year, asked.blasts_per_year);
  row.limit = limits_text(asked);
  row.verdict = verdict_of(asked, found);
  return row;
}

}  // namespace

std::vector<Question> questions(const Scenario& scenario, const PointResult& point) {
  std::vector<Question> rows;
  if (has_lost(scenario, point)) return rows;
  for (std::size_t c = 0; c < scenario.clearances.size(); ++c) {
    const ClearancePlan& asked = scenario.clearances[c];
    const ClearanceSummary& found = point.clearances.at(c);
    rows.push_back(std::isnan(found.distance.value) || !found.enough() ? missing_distance(asked, found)
                   : asked.sectors > 0                                 ? area_question(asked, found)
                                       : distance_question(scenario, asked, found));
    if (found.beyond_customary) rows.push_back(customary_question(scenario, asked, *found.beyond_customary));
  }
  for (std::size_t e = 0; e < scenario.exposures.size(); ++e)
    rows.push_back(exposure_question(scenario.exposures[e], point.exposures.at(e)));
  return rows;
}

std::string first_sentence(std::span<const Question> questions) {
  std::vector<std::string> clauses;
  for (const Question& question : questions)
    if (!question.clause.empty()) clauses.push_back(question.clause);
  if (clauses.empty()) return {};
  // "one blast in 20 ...; one in 190 ...": what is counted is said once.
  bool is_said = false;
  for (std::string& clause : clauses) {
    const std::size_t at = clause.find("one blast in ");
    if (at == std::string::npos) continue;
    if (is_said) clause.erase(at + 3, std::string_view(" blast").size());
    is_said = true;
  }
  clauses.front().front() =
      static_cast<char>(std::toupper(static_cast<unsigned char>(clauses.front().front())));
  return fmt::format("{}.", fmt::join(clauses, "; "));
}

}  // namespace flyrock
