#include "report/tables/comparison_data.h"

#include "report/tables/json_object.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json bound_data(DifferenceBound bound) {
  switch (bound) {
    case DifferenceBound::none:
      return nullptr;
    case DifferenceBound::at_least:
      return ">=";
    case DifferenceBound::at_most:
      return "<=";
    case DifferenceBound::not_known:
      break;
  }
  return "unknown";
}

Json difference_data(const ComparedNumber& compared, const Difference& difference) {
  const Interval& interval = difference.interval;
  return {{"unit", compared.unit},
          {"mean", number(difference.mean)},
          {"bound", bound_data(difference.bound)},
          {"interval", interval_data(interval)},
          {"design_effect", number(interval.design_effect)},
          {"trials_needed", interval.trials_needed > 0 ? Json(interval.trials_needed) : Json(nullptr)},
          {"pairs", difference.pairs},
          {"censored", difference.censored},
          {"left_out", difference.left_out},
          {"differing_trials", difference.differing}};
}

/// { value, interval, lower_bound, reason }
Json asked_data(const AskedNumber& asked) {
  const bool is_known = asked.measured.fault.empty();
  return {{"value", is_known ? number(asked.measured.value) : Json(nullptr)},
          {"interval", interval_data(asked.interval)},
          {"lower_bound", is_known && asked.measured.censored},
          {"reason", is_known ? Json(nullptr) : Json(asked.measured.fault)}};
}

Json limit_data(const AskedNumber& asked) {
  Json data = asked_data(asked);
  data["holds"] = asked.holds;
  data["short_by"] = number(asked.short_by);
  return data;
}

}  // namespace

Json differences_data(const Plan& plan, const Results& results) {
  const std::vector<ComparedNumber> compared = compared_numbers(plan.points.front());
  Json list = Json::array();
  for (const PointDifferences& of_point : results.differences) {
    Json groups = Json::array();
    for (const PointDifferences::Group& group : of_point.groups) {
      Json numbers = Json::object();
      for (std::size_t i = 0; i < compared.size(); ++i)
        numbers[compared[i].name] = difference_data(compared[i], group.numbers[i]);
      groups.push_back({{"group", group.name.empty() ? Json(nullptr) : Json(group.name)},
                        {"unpaired", group.unpaired},
                        {"numbers", numbers}});
    }
    list.push_back({{"point", of_point.point},
                    {"against", 0},
                    {"reason", of_point.reason.empty() ? Json(nullptr) : Json(of_point.reason)},
                    {"groups", groups}});
  }
  return list;
}

Json best_point_data(const Plan& plan, const BestPoint& best) {
  const AnswerPlan& asked = plan.points.front().answer.value();
  Json limits = Json::array(), points = Json::array();
  for (const AnswerPlan::Limit& limit : asked.limits)
    limits.push_back({{"measure", limit.measure},
                      {"below", limit.is_below ? Json(limit.value) : Json(nullptr)},
                      {"above", limit.is_below ? Json(nullptr) : Json(limit.value)},
                      {"unit", limit.unit},
                      {"is_share", is_share(limit.measure)}});
  for (std::size_t p = 0; p < best.points.size(); ++p) {
    const BestPoint::Point& point = best.points[p];
    Json numbers = Json::array();
    for (const AskedNumber& limit : point.limits) numbers.push_back(limit_data(limit));
    points.push_back({{"point", p},
                      {"holds", point.holds()},
                      {"least", asked_data(point.least)},
                      {"such_that", numbers},
                      {"short", short_text(plan, point)}});
  }
  return {{"least", asked.least}, {"unit", asked.unit}, {"is_share", is_share(asked.least)},
          {"such_that", limits},  {"best", best.best},  {"points", points}};
}

}  // namespace flyrock
