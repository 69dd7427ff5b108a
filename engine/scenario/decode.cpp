#include "scenario/decode.h"

#include <fmt/format.h>

#include <cmath>

#include "scenario/decode_document.h"
#include "scenario/decode_sections.h"
#include "scenario/normalise.h"
#include "scenario/sweep.h"

namespace flyrock {

namespace {

constexpr double most_points = 10000;

bool check_axes(const std::vector<SweptValue>& sweeps, Diagnostics& diagnostics) {
  double points = 1;
  for (const SweptValue& sweep : sweeps) {
    if (sweep.values.empty()) return false;  // reported
    points *= static_cast<double>(sweep.values.size());
    if (points <= most_points) continue;
    diagnostics.error(
        sweep.at, sweep.path,
        fmt::format("the sweep has {:.6g} points, must be at most {:.6g}", points, most_points));
    return false;
  }
  return true;
}

/// The value at a path of the normalised tree.
Value* find_path(Value& root, const std::string& path) {
  Value* place = &root;
  for (std::size_t begin = 0; place && begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string step = path.substr(begin, end - begin);
    if (List* list = place->list())
      place = &list->at(std::stoul(step));
    else
      place = place->find(step);
    begin = end + 1;
  }
  return place;
}

class PlanDecoder {
 public:
  PlanDecoder(const Value& root, const Registry& registry, const std::string& folder,
              Diagnostics& diagnostics, std::shared_ptr<GroundStore> grounds)
      : tree_(root),
        registry_(registry),
        folder_(folder),
        diagnostics_(diagnostics),
        earlier_errors_(diagnostics.has_errors()),
        grounds_(std::move(grounds)) {}

  std::optional<Plan> decode() {
    if (!Node::root(tree_).expect_map(diagnostics_)) return std::nullopt;
    sweeps_ = find_sweeps(tree_, diagnostics_);
    if (!check_axes(sweeps_, diagnostics_)) return std::nullopt;
    std::vector<std::size_t> sizes;
    for (const SweptValue& sweep : sweeps_) {
      swept_.insert(sweep.path);
      sizes.push_back(sweep.values.size());
      plan_.axes.push_back({sweep.path, std::vector<double>(sweep.values.size()), ""});
      resolved_values_.emplace_back(sweep.values.size());
    }
    for (const auto& [name, at] : plugin_files(tree_, diagnostics_)) plan_.plugin_files.push_back(name);
    for (const auto& point : grid_points(sizes)) decode_point(point);
    if (diagnostics_.has_errors()) return std::nullopt;
    refuse_too_many_trials();
    write_sweeps();
    resolve_expectations();
    plan_.not_used = find_not_used(Node::root(plan_.resolved), plan_.points.front());
    return diagnostics_.has_errors() ? std::nullopt : std::optional<Plan>(std::move(plan_));
  }

 private:
  void decode_point(const std::vector<std::size_t>& point) {
    for (std::size_t a = 0; a < sweeps_.size(); ++a) *sweeps_[a].slot = sweeps_[a].values[point[a]];
    DecodeContext context{registry_, folder_, diagnostics_, swept_, earlier_errors_};
    context.grounds = grounds_;
    Value tree = normalise(context, Node::root(tree_));
    Scenario scenario = decode_document(context, Node::root(tree));
    if (diagnostics_.has_errors()) return;
    std::vector<double> at;
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      const auto met = context.swept_values.find(sweeps_[a].path);
      if (met == context.swept_values.end())
        return diagnostics_.error(sweeps_[a].at, sweeps_[a].path,
                                  "takes no sweep, only numbers that may vary are swept");
      at.push_back(met->second.si);
      plan_.axes[a].values[point[a]] = met->second.si;
      plan_.axes[a].unit = met->second.unit;
    }
    plan_.files.merge(context.files);
    for (std::size_t a = 0; a < sweeps_.size(); ++a)
      resolved_values_[a][point[a]] = *find_path(tree, sweeps_[a].path);
    if (plan_.points.empty()) plan_.resolved = std::move(tree);
    plan_.points.push_back(std::move(scenario));
    plan_.at.push_back(std::move(at));
  }

  void refuse_too_many_trials() {
    constexpr double most = most_trials;
    const double points = static_cast<double>(plan_.points.size());
    const double trials = static_cast<double>(plan_.points.front().trials);
    if (points * trials > most)
      diagnostics_.error(
          tree_.find("trials")->at, "trials",
          fmt::format("{:.6g} at each of {} points of the sweep, must be at most {:.0e} in all", trials,
                      points, most));
  }

  /// Puts the sweeps back into the resolved tree of the first point.
  void write_sweeps() {
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      Map sweep;
      put(sweep, "sweep", list_value(std::move(resolved_values_[a])));
      *find_path(plan_.resolved, sweeps_[a].path) = map_value(std::move(sweep));
    }
  }

  /// Resolves `at` of expectations: the axes by their paths, and the values exactly as the points have them.
  void resolve_expectations() {
    const auto expect = Node::root(tree_).find("expect");
    if (!expect) return;
    const std::vector<Node> items = expect->items();
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto at = items[i].find("at");
      if (!at) continue;
      const std::vector<Node> entries = at->entries();
      for (std::size_t k = 0; k < entries.size(); ++k) {
        const std::pair<std::string, double> exact =
            resolve_at(entries[k], plan_.points.front().expect[i].at[k].second);
        for (Scenario& scenario : plan_.points) scenario.expect[i].at[k] = exact;
      }
    }
  }

  std::pair<std::string, double> resolve_at(const Node& entry, double value) {
    constexpr double rounding = 1e-12;  // 20 mm and 0.02 m may differ in the last digit
    std::vector<std::string> paths;
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      paths.push_back(sweeps_[a].path);
      if (entry.key != sweeps_[a].path && entry.key != sweeps_[a].stream) continue;
      for (const double step : plan_.axes[a].values)
        if (std::abs(step - value) <= rounding * std::abs(step)) return {sweeps_[a].path, step};
      entry.error(diagnostics_,
                  fmt::format("the sweep of `{}` has no value {}", entry.key, shown(*entry.value)));
      return {};
    }
    diagnostics_.error(entry.key_at, entry.path,
                       fmt::format("nothing is swept at `{}`{}", entry.key, suggestion(entry.key, paths)));
    return {};
  }

  Value tree_;  ///< as written; the value of the current point stands in place of each sweep
  const Registry& registry_;
  const std::string& folder_;
  Diagnostics& diagnostics_;
  const bool earlier_errors_;  // or another step before this one
  std::vector<SweptValue> sweeps_;
  std::set<std::string> swept_;
  std::vector<List> resolved_values_;  ///< for each axis and step
  Plan plan_;
  const std::shared_ptr<GroundStore> grounds_;
};

}  // namespace

std::optional<Plan> decode(const Value& root, const Registry& registry, const std::string& folder,
                           Diagnostics& diagnostics, std::shared_ptr<GroundStore> grounds) {
  if (!grounds) grounds = std::make_shared<GroundStore>();
  return PlanDecoder(root, registry, folder, diagnostics, std::move(grounds)).decode();
}

}  // namespace flyrock
