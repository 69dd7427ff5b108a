#include "cli/summary_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/not_used_line.h"
#include "cli/terminal.h"
#include "math/space.h"
#include "results/measured/lost.h"
#include "results/say/answer.h"
#include "results/say/answer_shares.h"
#include "results/say/farthest_group.h"
#include "results/say/fault_line.h"
#include "results/say/weights.h"
#include "results/say/wording.h"

namespace flyrock::cli {

namespace {

/// "point 1: terrain.face_angle = 70 deg"
std::string point_title(const Plan& plan, std::size_t point) {
  return fmt::format("point {}: {}\n", point, point_text(plan, point));
}

std::string row_name(const GroupSummary& group) { return group.name.empty() ? "all rocks" : group.name; }

/// The width of the first column: the longest name of a group.
std::size_t name_width(const Results& results) {
  std::size_t width = 16;
  for (const GroupSummary& group : results.points.front().groups)
    width = std::max(width, row_name(group).size());
  return width;
}

/// "10.1 to 14.8 %"
std::string range_text(const Interval& interval) {
  if (interval.trials_needed > 0) return "too few trials";
  if (std::isnan(interval.upper)) return "-";
  return fmt::format("{:.3g} to {}", 100 * interval.lower, percent(interval.upper));
}

std::string group_line(const GroupSummary& group, std::size_t width) {
  std::string text = fmt::format(
      "  {:<{}}{:>8}{:>9}{:>19}", row_name(group), width, group.count, percent(group.censored_share.value),
      group.count > group.faults ? range_text(group.censored_share.interval) : "-");
  for (const Statistic s : {Statistic::p50, Statistic::p90, Statistic::p95, Statistic::p99, Statistic::max})
    text += fmt::format("{:>9}", display(group.at(rock_statistic("runout"), s), ""));
  return text + '\n';
}

/// The line of a group whose point lost too many rocks: no numbers.
std::string lost_line(const GroupSummary& group, std::size_t width) {
  std::string text =
      fmt::format("  {:<{}}{:>8}{:>9}{:>19}", row_name(group), width, group.count, "lost", "-");
  constexpr int statistics = 5;  // those of group_line
  for (int s = 0; s < statistics; ++s) text += fmt::format("{:>9}", "-");
  return text + '\n';
}

std::string reasons_line(const Scenario& scenario, const GroupSummary& group) {
  std::vector<std::string> parts;
  for (std::size_t r = 0; r < group.reasons.size(); ++r)
    if (group.reasons[r] > 0)
      parts.push_back(fmt::format("{} {}", group.reasons[r], ended(static_cast<StopReason>(r), scenario)));
  return fmt::format("  {}\n", fmt::join(parts, ", "));
}

std::string place_line(const std::string& place, double share, const char* bound, const Interval& interval) {
  if (std::isnan(share)) return "";
  return fmt::format("  {:<34}{:>12}{:>19}\n", place, bound + percent(share), range_text(interval));
}
std::string place_line(const std::string& place, const Share& share) {
  return place_line(place, share.value, share.censored ? ">= " : "", share.interval);
}

/// The number of rocks at the gates and barriers of a point, one line for each.
std::string places_text(const Scenario& scenario, const PointResult& point) {
  if (scenario.gates.empty() && scenario.barriers.empty() && !point.trees) return "";
  std::string text = fmt::format("  {:<34}{:>12}{:>19}\n", "share of all rocks", "share", "95 % interval");
  const auto& [gates, barriers, caught] = point.crossings.front();
  for (std::size_t g = 0; g < gates.size(); ++g)
    text += place_line(fmt::format("gate {}: passed", scenario.gates[g].name), gates[g].shares.of_all);
  for (std::size_t b = 0; b < barriers.size(); ++b) {
    const std::string name = fmt::format("barrier {}: ", scenario.barriers[b].name);
    const Share& reached = barriers[b].share(BarrierShare::reached).of_all;
    text += place_line(name + "reached", reached);
    for (const BarrierShare what : {BarrierShare::caught, BarrierShare::over_top, BarrierShare::over_energy})
      text += place_line(name + std::string(barrier_share_names[static_cast<std::size_t>(what)]),
                         barriers[b].share(what).of_all);
    const Complement others = complement_of(reached);
    text +=
        place_line(name + "not_reached", others.value, others.is_upper_bound ? "<= " : "", others.interval);
  }
  if (point.trees) {
    text += place_line("trees: hit at least one", point.trees->hit_share);
    text += place_line("trees: stopped", point.trees->stopped_share);
  }
  return text;
}

std::string wanted(const Verdict& verdict) {
  const Expectation& e = verdict.expectation;
  switch (e.kind) {
    case ExpectKind::equals:
      if (verdict.tolerance == 0) return shortest(e.value);
      return fmt::format("{} within {:.3g}", shortest(e.value), verdict.tolerance);
    case ExpectKind::below:
      return "below " + shortest(e.value);
    case ExpectKind::above:
      return "above " + shortest(e.value);
    case ExpectKind::between:
      return fmt::format("from {} to {}", shortest(e.value), shortest(e.high));
  }
  return {};
}

std::string verdict_line(const Verdict& verdict, bool sweep) {
  static constexpr const char* words[] = {"ok", "FAILED", "not judged"};
  std::string text = fmt::format("  {:<11}{}", words[static_cast<int>(verdict.judgement)],
                                 compared_text(verdict.expectation));
  if (sweep && verdict.point >= 0) text += fmt::format(" at point {}", verdict.point);
  // Ten digits, because four would hide how close the value is to a textbook's number.
  text += fmt::format(" = {}{:.10g}, expected {}", verdict.censored ? ">= " : "", verdict.computed,
                      wanted(verdict));
  if (!verdict.reason.empty()) text += fmt::format(" ({})", verdict.reason);
  return text + '\n';
}

}  // namespace

namespace {

/// The difference of the runout from point 0 of a group; empty without.
std::string difference_text(const Results& results, std::size_t point, std::size_t group) {
  if (point == 0 || results.differences.size() < point) return "";
  const PointDifferences& of_point = results.differences[point - 1];
  if (!of_point.reason.empty()) return "";
  return flyrock::difference_text(of_point.groups.at(group).numbers.at(rock_statistic("runout")));
}

/// The differences of a point in the table of all points: a line for each group.
std::string differences_lines(const Plan& plan, const Results& results, std::size_t point) {
  std::string text;
  const char* what = plan.all_end_at_landing() ? "first landing" : "runout";
  const std::vector<GroupSummary>& groups = results.points[point].groups;
  for (std::size_t g = groups.size() > 1 ? 1 : 0; g < groups.size(); ++g)
    if (const std::string difference = difference_text(results, point, g); !difference.empty())
      text +=
          fmt::format("  {} against point 0, same rocks, {}: {}\n", what, row_name(groups[g]), difference);
  return text;
}

/// The points that are not the best because they do not keep the limits, and by how much.
std::string short_points_text(const Plan& plan, const Results& results) {
  constexpr std::size_t most_named = 3;
  std::string text;
  std::size_t count = 0;
  for (std::size_t p = 0; results.best && p < results.best->points.size(); ++p) {
    const BestPoint::Point& point = results.best->points[p];
    if (point.holds() || ++count > most_named) continue;
    text += fmt::format("  point {} falls short: {}\n", p, short_text(plan, point));
  }
  if (count > most_named) text += fmt::format("  {} more points fall short\n", count - most_named);
  return text.empty() ? text : text + '\n';
}

/// What the terminal says of each point: the ends of its rocks, its gates and barriers.
std::string points_text(const Plan& plan, const Results& results) {
  const std::size_t width = name_width(results);
  const char* what = plan.all_end_at_landing() ? "first landing, m" : "runout in m";
  std::string text = fmt::format("  {:<{}}{:>8}{:>9}{:>19}{:>9}{:>9}{:>9}{:>9}{:>9}\n", what, width, "rocks",
                                 "censored", "95 % interval", "p50", "p90", "p95", "p99", "max");
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    if (!plan.axes.empty()) text += point_title(plan, p);
    const bool is_lost = has_lost(plan.points[p], results.points[p]);
    const std::vector<GroupSummary>& groups = results.points[p].groups;
    for (std::size_t g = first_shown_group(plan, results); g < groups.size(); ++g)
      text += is_lost ? lost_line(groups[g], width) : group_line(groups[g], width);
    text += reasons_line(plan.points[p], results.points[p].groups.front());
    text += is_lost ? fmt::format("  {}\n", lost_text(results.points[p]))
                    : places_text(plan.points[p], results.points[p]);
    text += differences_lines(plan, results, p);
  }
  return text;
}

constexpr std::ptrdiff_t most_lines = 40;
constexpr std::size_t most_point_lines = 28;

/// Many points: a line for each, with the p95 of the group that goes farthest at point 0.
std::string brief_points_text(const Plan& plan, const Results& results) {
  const std::size_t runout = rock_statistic("runout");
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  const std::size_t farthest = farthest_group(groups);
  std::string text =
      fmt::format("p95 of the {} of {}\n", plan.all_end_at_landing() ? "first landing" : "runout",
                  row_name(groups[farthest]));
  for (std::size_t p = 0; p < std::min(results.points.size(), most_point_lines); ++p) {
    const GroupSummary& group = results.points[p].groups.at(farthest);
    if (has_lost(plan.points[p], results.points[p])) {
      text += fmt::format("  point {}: {}: {}\n", p, point_text(plan, p), lost_text(results.points[p]));
      continue;
    }
    const std::string difference = difference_text(results, p, farthest);
    text += fmt::format("  point {}: {}: {}{}\n", p, point_text(plan, p),
                        with_interval(group.at(runout, Statistic::p95),
                                      group.interval(runout, Statistic::p95), stated_confidence),
                        difference.empty() ? "" : "; mean against point 0: " + difference);
  }
  if (results.points.size() > most_point_lines)
    text += fmt::format("  {} more points are in the report\n", results.points.size() - most_point_lines);
  return text;
}

/// The questions of a permit, a row each, in columns that are as wide as their texts; without empty columns.
std::string questions_text(const std::vector<Question>& questions) {
  if (questions.empty()) return {};
  using Row = std::array<std::string, question_heads.size()>;
  std::vector<Row> rows(1);
  std::copy(question_heads.begin(), question_heads.end(), rows.front().begin());
  for (const Question& q : questions)
    rows.push_back({q.asks, q.per_blast, q.interval, q.per_year, q.limit, q.verdict});
  std::array<std::size_t, question_heads.size()> widths{};
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const auto is_empty = [&](const Row& row) { return row[column].empty(); };
    if (std::all_of(rows.begin() + 1, rows.end(), is_empty)) continue;
    for (const Row& row : rows) widths[column] = std::max(widths[column], row[column].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < widths.size(); ++column)
      if (widths[column] > 0)
        line += fmt::format("  {:<{}}", row[column].empty() ? "-" : row[column], widths[column]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text + '\n';
}

/// The answer: with a table of questions without the distances of the rocks, which follow in a table.
std::string answer_text(const Plan& plan, const Results& results) {
  const AnswerTexts texts = answer_texts(plan, results);
  if (texts.first.empty()) return texts.rest() + "\n\n";
  if (texts.questions.empty()) return texts.first + "\n" + texts.rest() + "\n\n";
  const std::string rest = texts.beside_table();
  return texts.first + "\n\n" + questions_text(texts.questions) + (rest.empty() ? "" : rest + "\n\n");
}

}  // namespace

std::string summary_text(const Plan& plan, const Results& results, const std::vector<std::string>& told) {
  const bool sweep = !plan.axes.empty();
  std::string text = fault_line(plan, results);
  if (!text.empty()) text = bold(text) + "\n\n";
  text += bold(plan.points.front().title.empty() ? "flyrock" : plan.points.front().title) + '\n';
  text += answer_text(plan, results) + short_points_text(plan, results);
  if (plan.points.front().bodies.empty()) {
    std::string points = points_text(plan, results);
    if (sweep && std::count(points.begin(), points.end(), '\n') > most_lines)
      points = brief_points_text(plan, results);
    text += points;
    text += '\n';
  }
  if (!results.verdicts.empty()) {
    const int open = results.count(Judgement::not_judged);
    const int judged = static_cast<int>(results.verdicts.size()) - open;
    if (judged > 0)
      text += fmt::format("{} of {} expectations hold\n", results.count(Judgement::passed), judged);
    if (open > 0) text += fmt::format("{} expectation{} not judged\n", open, open == 1 ? "" : "s");
    for (const Verdict& verdict : results.verdicts) text += verdict_line(verdict, sweep);
    text += '\n';
  }
  for (const std::string& warning : results.warnings)
    if (std::find(told.begin(), told.end(), warning) == told.end())
      text += fmt::format("warning: {}\n", warning);
  return text + not_used_line(plan.not_used);
}

std::string trial_text(const Scenario& scenario, const std::vector<RockRecord>& rocks) {
  const std::vector<std::string> groups = group_names(scenario);
  std::string text =
      fmt::format("  {:<6}{:<16}{:>10}{:>13}{:>13}{:>11}{:>9}{:>9}  {}\n", "rock", "group", "mass kg",
                  "launch m/s", "elevation", scenario.method == Method::ballistic ? "landing m" : "runout m",
                  "impacts", "time s", "ended");
  for (const RockRecord& rock : rocks)
    text += fmt::format("  {:<6}{:<16}{:>10.4g}{:>13.4g}{:>9.4g} deg{:>11.4g}{:>9}{:>9.4g}  {}{}\n",
                        rock.rock, groups.at(rock.group), rock.mass, rock.launch_speed,
                        rock.launch_elevation * 180 / pi, rock.runout, rock.impacts, rock.time,
                        ended(rock.reason, scenario), rock.fault.empty() ? "" : ": " + rock.fault);
  return text + '\n';
}

}  // namespace flyrock::cli
