#include "scenario/decode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenario/branches.h"
#include "scenario/decode_document.h"
#include "scenario/decode_sections.h"
#include "scenario/each_feature.h"
#include "scenario/normalise.h"
#include "scenario/sweep.h"
#include "scenario/sweep_rows.h"
#include "scenario/trial_design.h"

namespace flyrock {

namespace {

constexpr double most_points = 10000;

bool check_axes(const std::vector<SweptValue>& sweeps, const std::optional<SweepRows>& rows,
                Diagnostics& diagnostics) {
  double points = rows ? static_cast<double>(rows->count()) : 1;
  if (rows && !rows->product && !sweeps.empty()) {
    diagnostics.error(
        sweeps.front().at, sweeps.front().path,
        "is swept beside the rows of `sweep`: expected a column there, or `product: true`, which runs each "
        "row at each of its values");
    return false;
  }
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
    const std::size_t errors_before = diagnostics_.errors_given();
    DecodeContext layers{registry_, folder_, diagnostics_, swept_};
    expand_each_feature(tree_, layers);
    if (diagnostics_.errors_given() > errors_before) return std::nullopt;
    rows_ = read_sweep_rows(tree_, folder_, diagnostics_);
    if (diagnostics_.errors_given() > errors_before) return std::nullopt;
    sweeps_ = find_sweeps(tree_, diagnostics_);
    if (!check_axes(sweeps_, rows_, diagnostics_)) return std::nullopt;
    std::vector<std::size_t> sizes;
    for (const SweptValue& sweep : sweeps_) sizes.push_back(sweep.values.size());
    const std::vector<std::vector<std::size_t>> points = with_rows(grid_points(sizes));
    for (const SweptValue& sweep : sweeps_) {
      swept_.insert(sweep.path);
      steps_.emplace_back(sweep.values.size());
      resolved_values_.emplace_back(sweep.values.size());
    }
    for (const auto& [name, at] : plugin_files(tree_, diagnostics_)) plan_.plugin_files.push_back(name);
    for (const auto& point : points) decode_point(point);
    if (diagnostics_.has_errors()) return std::nullopt;
    refuse_too_many_trials();
    warn_of_equal_runs();
    make_axes(points);
    write_sweeps();
    resolve_expectations();
    return diagnostics_.has_errors() ? std::nullopt : std::optional<Plan>(std::move(plan_));
  }

 private:
  /// The columns of the rows become axes, in front of the others; each row stands at each point of the grid.
  std::vector<std::vector<std::size_t>> with_rows(const std::vector<std::vector<std::size_t>>& grid) {
    if (!rows_) return grid;
    const std::size_t columns = rows_->columns.size();
    sweeps_.insert(sweeps_.begin(), rows_->columns.begin(), rows_->columns.end());
    std::vector<std::vector<std::size_t>> points;
    for (std::size_t row = 0; row < rows_->count(); ++row)
      for (const std::vector<std::size_t>& at : grid) {
        std::vector<std::size_t>& point = points.emplace_back(columns, row);
        point.insert(point.end(), at.begin(), at.end());
      }
    return points;
  }

  bool is_of_row(std::size_t axis) const { return rows_ && axis < rows_->columns.size(); }

  void decode_point(const std::vector<std::size_t>& point) {
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      const SweptValue& sweep = sweeps_[a];
      if (sweep.slot)
        *sweep.slot = sweep.values[point[a]];
      else
        set_path(tree_, sweep.path, sweep.values[point[a]], sweep.values[point[a]].at, diagnostics_);
    }
    DecodeContext context{registry_, folder_, diagnostics_, swept_, earlier_errors_};
    context.grounds = grounds_;
    Value tree = normalise(context, Node::root(tree_));
    Scenario scenario = decode_document(context, Node::root(tree));
    if (diagnostics_.has_errors()) return;
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      const Value* value = find_path(tree, sweeps_[a].path);
      std::optional<Step> step;
      if (value && may_be_swept(sweeps_[a].path)) step = step_of(context, sweeps_[a].path, *value);
      if (!step)
        return diagnostics_.error(
            sweeps_[a].at, sweeps_[a].path,
            "takes no sweep, only numbers, choices and sections with a `type` are swept");
      steps_[a][point[a]] = std::move(*step);
      resolved_values_[a][point[a]] = *value;
    }
    refuse_charges_without_length(Node::root(tree), scenario, diagnostics_);
    std::vector<std::string> not_used = find_not_used(Node::root(tree), scenario);
    decode_branches(scenario, not_used);
    if (diagnostics_.has_errors()) return;
    plan_.files.merge(context.files);
    keep_not_used(not_used);
    if (plan_.points.empty()) plan_.resolved = std::move(tree);
    plan_.points.push_back(std::move(scenario));
  }

  /// The scenario of each branch: the document of this point with what the branch sets.
  /// Adds what they set and nothing reads to `not_used`.
  void decode_branches(Scenario& regular, std::vector<std::string>& not_used) {
    for (const Node& branch : branches_of(tree_)) {
      const std::size_t errors_before = diagnostics_.errors_given();
      const auto is_sound = [&] { return diagnostics_.errors_given() == errors_before; };
      BranchPlan plan = read_branch(branch, diagnostics_);
      Value changed = tree_;
      apply_branch(branch, plan, changed, diagnostics_);
      if (!is_sound()) continue;
      DecodeContext context{registry_, folder_, diagnostics_, swept_, earlier_errors_};
      context.grounds = grounds_;
      context.forced_fields = fields_of_branch(branch);
      const Value tree = normalise(context, Node::root(changed));
      auto own = std::make_shared<Scenario>(decode_document(context, Node::root(tree)));
      if (!is_sound()) continue;
      cover_alike(regular, *own);
      plan_.files.merge(context.files);
      const std::vector<std::string> idle = settings_not_used(branch, find_not_used(Node::root(tree), *own));
      not_used.insert(not_used.end(), idle.begin(), idle.end());
      keep_branch(branch, std::move(plan), std::move(own), regular, diagnostics_);
    }
    check_probabilities(tree_, regular, diagnostics_);
  }

  /// The runs of `outer` must differ by more than chance.
  void warn_of_equal_runs() {
    const auto differs = [](const Scenario& scenario) {
      return std::any_of(scenario.draws.begin(), scenario.draws.end(),
                         [](const Draw& draw) { return draw.scope == Scope::run; });
    };
    for (const Scenario& point : plan_.points) {
      if (point.outer == 1 || differs(point)) return;
      for (const BranchPlan& branch : point.branches)
        if (differs(*branch.scenario)) return;
    }
    const Node outer = *Node::root(tree_).find("outer");
    diagnostics_.warning(outer.key_at, outer.path,
                         "no distribution has `per: run`: its runs differ by chance alone");
  }

  /// What one value of a sweep is, normalised: a number with its SI unit, or a choice with its text.
  struct Step {
    std::optional<DecodeContext::SweptNumber> number;
    std::string label;
  };

  static std::string label_of(double si, const std::string& unit) {
    return unit.empty() || unit == "1" ? shortest(si) : shortest(si) + " " + unit;
  }

  static std::optional<Step> step_of(const DecodeContext& context, const std::string& path,
                                     const Value& value) {
    const auto number = context.swept_values.find(path);
    if (number != context.swept_values.end())
      return Step{number->second, label_of(number->second.si, number->second.unit)};
    const Value* type = value.find("type");
    if (const std::string* text = type ? type->text() : value.text()) return Step{std::nullopt, *text};
    if (const bool* flag = value.boolean()) return Step{std::nullopt, *flag ? "true" : "false"};
    return std::nullopt;
  }

  /// The axes, and the place of each point on them.
  void make_axes(const std::vector<std::vector<std::size_t>>& points) {
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      SweepAxis axis{.path = sweeps_[a].path, .values = {}, .name = sweeps_[a].stream};
      const bool all_numbers = std::all_of(steps_[a].begin(), steps_[a].end(),
                                           [](const Step& step) { return step.number.has_value(); });
      for (std::size_t i = 0; i < steps_[a].size(); ++i) {
        const Step& step = steps_[a][i];
        if (all_numbers) {
          axis.values.push_back(step.number->si);
          axis.unit = step.number->unit;
          continue;
        }
        // A row may have the choice of another one; a value of a sweep is one of its own.
        const auto known = std::find(axis.labels.begin(), axis.labels.end(), step.label);
        const bool is_known = is_of_row(a) && known != axis.labels.end();
        axis.values.push_back(static_cast<double>(
            is_known ? static_cast<std::size_t>(known - axis.labels.begin()) : axis.labels.size()));
        if (!is_known) axis.labels.push_back(unique(step.label, axis.labels));
      }
      plan_.axes.push_back(std::move(axis));
    }
    for (const auto& point : points) {
      plan_.at.emplace_back();
      for (std::size_t a = 0; a < sweeps_.size(); ++a)
        plan_.at.back().push_back(plan_.axes[a].values[point[a]]);
    }
    add_labels(points);
  }

  /// The labels of the rows, as an axis of their own.
  void add_labels(const std::vector<std::vector<std::size_t>>& points) {
    if (!rows_ || rows_->labels.empty()) return;
    SweepAxis axis{.path = label_axis, .values = {}, .name = "row"};
    for (std::size_t row = 0; row < rows_->labels.size(); ++row) {
      const std::string& label = rows_->labels[row];
      axis.values.push_back(static_cast<double>(row));
      axis.labels.push_back(unique(label.empty() ? fmt::format("row {}", row + 1) : label, axis.labels));
    }
    plan_.axes.push_back(std::move(axis));
    for (std::size_t a = 0; a < sweeps_.size(); ++a) plan_.axes[a].is_named = is_of_row(a);
    for (std::size_t p = 0; p < points.size(); ++p)
      plan_.at[p].push_back(static_cast<double>(points[p].front()));
  }

  /// "newton", and "newton 2" for a second section of this type.
  static std::string unique(const std::string& label, const std::vector<std::string>& before) {
    std::string name = label;
    for (int n = 2; std::find(before.begin(), before.end(), name) != before.end(); ++n)
      name = fmt::format("{} {}", label, n);
    return name;
  }

  /// A key is not used if no point reads it.
  void keep_not_used(const std::vector<std::string>& of_point) {
    if (plan_.points.empty())
      plan_.not_used = of_point;
    else
      std::erase_if(plan_.not_used, [&](const std::string& key) {
        return std::find(of_point.begin(), of_point.end(), key) == of_point.end();
      });
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

  /// Puts the sweeps back into the resolved tree of the first point. The rows stay in their section.
  void write_sweeps() {
    if (rows_) write_rows();
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      if (is_of_row(a)) continue;
      Map sweep;
      put(sweep, "sweep", list_value(std::move(resolved_values_[a])));
      *find_path(plan_.resolved, sweeps_[a].path) = map_value(std::move(sweep));
    }
  }

  void write_rows() {
    List list;
    for (std::size_t row = 0; row < rows_->count(); ++row) {
      Map map;
      if (!rows_->labels.empty()) {
        Value label;
        label.data = rows_->labels[row];
        put(map, "label", std::move(label));
      }
      for (std::size_t a = 0; a < rows_->columns.size(); ++a)
        put(map, sweeps_[a].stream, resolved_values_[a][row]);
      list.push_back(map_value(std::move(map)));
    }
    Map section;
    put(section, "rows", list_value(std::move(list)));
    Value product;
    product.data = true;
    if (rows_->product) put(section, "product", std::move(product));
    if (Value* there = plan_.resolved.find("sweep"))
      *there = map_value(std::move(section));
    else
      put(*plan_.resolved.map(), "sweep", map_value(std::move(section)));
    if (!rows_->file.empty()) plan_.files[rows_->file] = rows_->path_of_file;
  }

  /// Resolves `at` of expectations: the axes by their paths, and the values exactly as the points have them.
  void resolve_expectations() {
    const auto expect = Node::root(tree_).find("expect");
    if (!expect) return;
    const std::vector<Node> items = expect->items();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (const auto order_in = items[i].find("order_in"); order_in && plan_.points.front().expect[i].order) {
        const std::string axis = swept_number(*order_in);
        for (Scenario& scenario : plan_.points) scenario.expect[i].order->in = axis;
      }
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

  /// The path of the axis that `order_in` names.
  std::string swept_number(const Node& order_in) {
    const std::string name = *order_in.value->text();
    std::vector<std::string> paths;
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      if (plan_.axes[a].is_choice()) continue;
      paths.push_back(sweeps_[a].path);
      if (name == sweeps_[a].path || name == sweeps_[a].stream) return sweeps_[a].path;
    }
    order_in.error(diagnostics_, fmt::format("no number is swept at `{}`{}", name, suggestion(name, paths)));
    return {};
  }

  std::pair<std::string, double> resolve_at(const Node& entry, double value) {
    std::vector<std::string> paths;
    for (std::size_t a = 0; a < sweeps_.size(); ++a) {
      paths.push_back(sweeps_[a].path);
      if (entry.key != sweeps_[a].path && entry.key != sweeps_[a].stream) continue;
      const SweepAxis& axis = plan_.axes[a];
      for (std::size_t i = 0; i < axis.values.size(); ++i)
        if (is_at(entry, value, steps_[a][i]) ||
            (axis.is_choice() && axis.label(axis.values[i]) == text_at(entry)))
          return {sweeps_[a].path, axis.values[i]};
      entry.error(diagnostics_,
                  fmt::format("the sweep of `{}` has no value {}{}", entry.key, shown(*entry.value),
                              axis.is_choice() ? suggestion(text_at(entry), axis.labels) : ""));
      return {};
    }
    diagnostics_.error(entry.key_at, entry.path,
                       fmt::format("nothing is swept at `{}`{}", entry.key, suggestion(entry.key, paths)));
    return {};
  }

  /// Whether `at` gives the number of a step; `value`: in SI units.
  static bool is_at(const Node& entry, double value, const Step& step) {
    constexpr double rounding = 1e-12;  // 20 mm and 0.02 m may differ in the last digit
    const std::string* text = entry.value->text();
    if (!step.number || !(entry.value->number() || (text && parse_quantity(*text)))) return false;
    return std::abs(step.number->si - value) <= rounding * std::abs(step.number->si);
  }

  /// What `at` says of a choice.
  static std::string text_at(const Node& entry) {
    if (const bool* flag = entry.value->boolean()) return *flag ? "true" : "false";
    return entry.value->text() ? *entry.value->text() : "";
  }

  Value tree_;  ///< as written; the value of the current point stands in place of each sweep
  const Registry& registry_;
  const std::string& folder_;
  Diagnostics& diagnostics_;
  const bool earlier_errors_;       // or another step before this one
  std::vector<SweptValue> sweeps_;  ///< columns of rows first
  std::optional<SweepRows> rows_;
  std::set<std::string> swept_;
  std::vector<std::vector<Step>> steps_;  ///< of each axis
  std::vector<List> resolved_values_;     ///< for each axis and step
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
