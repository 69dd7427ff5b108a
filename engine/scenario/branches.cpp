#include "scenario/branches.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenario/decode.h"
#include "scenario/decode_sections.h"
#include "scenario/normalise.h"

namespace flyrock {

namespace {

/// "blast", "launch" or "rocks": what a path of a branch is about; empty for anything else.
std::string_view subject_of(const std::string& path) {
  constexpr std::string_view structure[] = {"blast.holes", "blast.rows", "blast.face", "blast.scatter"};
  for (const std::string_view part : structure)
    if (path == part || path.starts_with(std::string(part) + ".")) return {};
  if (path.starts_with("blast.")) return "blast";
  if (!path.starts_with("rocks.")) return {};
  const std::size_t group = path.find('.', 6);
  if (group == std::string::npos) return {};
  const std::string key = path.substr(group + 1);
  if (key == "launch" || key.starts_with("launch.")) return "launch";
  return key == "name" ? std::string_view() : "rocks";
}

}  // namespace

Value normalise_branches(DecodeContext& context, const Node& list) {
  return normalise_list(context, list, [&](const Node& item) {
    Value branch = normalise_section(context, item, "branches", {});
    if (const auto name = item.find("name"); name && name->value->text() && *name->value->text() == "regular")
      name->error(context.diagnostics,
                  "is the name of what is left when no branch happens, expected another one");
    const std::optional<Node> set = item.find("set");
    if (!set) {
      context.diagnostics.error(item.key_at, item.path,
                                "`set` is missing, expected a map of paths and what they become");
    } else if (set->expect_map(context.diagnostics)) {
      if (set->entries().empty()) set->error(context.diagnostics, "is empty, expected at least one path");
      if (branch.map()) put(*branch.map(), *set, *set->value);
    }
    if (const auto holes = item.find("holes"); holes && branch.map())
      put(*branch.map(), *holes, normalise_names(context, *holes, "hole"));
    return branch;
  });
}

std::vector<Node> branches_of(const Value& root) {
  const std::optional<Node> list = Node::root(root).find("branches");
  return list ? list->items() : std::vector<Node>();
}

BranchPlan read_branch(const Node& branch, Diagnostics& diagnostics) {
  BranchPlan plan;
  const auto text = [&](const char* key) {
    const auto node = branch.find(key);
    return node && node->value->text() ? *node->value->text() : std::string();
  };
  plan.name = text("name");
  plan.per_blast = text("per") == "blast";
  const auto probability = branch.find("probability");
  const auto* number = probability ? probability->value->number() : nullptr;
  const auto* quantity = probability ? probability->value->text() : nullptr;
  if (number)
    plan.probability = *number;
  else if (const auto parsed = quantity ? parse_quantity(*quantity) : std::nullopt)
    plan.probability = parsed->si();
  else
    branch.error(diagnostics, "has no probability");
  return plan;
}

void apply_branch(const Node& branch, const BranchPlan& plan, Value& root, Diagnostics& diagnostics) {
  std::erase_if(*root.map(), [](const Entry& entry) { return entry.key == "branches"; });
  const auto set = branch.find("set");
  for (const Node& entry : set ? set->entries() : std::vector<Node>()) {
    const std::string_view subject = subject_of(entry.key);
    if (subject.empty() || (subject == "rocks" && !plan.per_blast))
      diagnostics.error(entry.key_at, entry.path,
                        plan.per_blast
                            ? "a branch of a blast sets fields of `blast` and keys of `rocks.NAME`"
                            : "a branch of a hole sets fields of `blast` and of `rocks.NAME.launch`");
    else
      set_path(root, entry.key, *entry.value, entry.key_at, diagnostics);
  }
}

std::vector<BlastField> fields_of_branch(const Node& branch) {
  std::vector<BlastField> fields;
  const auto set = branch.find("set");
  for (const Node& entry : set ? set->entries() : std::vector<Node>())
    for (const BlastFieldInfo& info : blast_fields())
      if (entry.key == "blast." + std::string(info.path) ||
          (info.field == BlastField::hole_azimuth && entry.key == "blast.hole.bearing"))
        fields.push_back(info.field);
  return fields;
}

std::vector<std::string> settings_not_used(const Node& branch, const std::vector<std::string>& not_used) {
  std::vector<std::string> list;
  const auto set = branch.find("set");
  const auto name = branch.find("name");
  for (const Node& entry : set ? set->entries() : std::vector<Node>())
    for (const std::string& key : not_used)
      // What each measured hole has, a branch sets all the same.
      if (key.starts_with(entry.key + " (") && key.find("has its own)") == std::string::npos)
        list.push_back(fmt::format("branches.{}: {}", *name->value->text(), key));
  return list;
}

void keep_branch(const Node& branch, BranchPlan plan, std::shared_ptr<Scenario> own, Scenario& regular,
                 Diagnostics& diagnostics) {
  if (group_names(*own) != group_names(regular))
    return branch.error(diagnostics, "changes the groups of rocks, expected the same ones");
  for (std::size_t g = 0; g < regular.rocks.size(); ++g)
    if (!plan.per_blast && own->rocks[g].launch.has_value() != regular.rocks[g].launch.has_value())
      return branch.error(diagnostics, fmt::format("launches `{}`, whose regular rocks start at rest",
                                                   regular.rocks[g].name));
  if (const auto holes = branch.find("holes")) {
    if (plan.per_blast || !regular.blast || !regular.blast->has_holes())
      return holes->error(diagnostics, "needs `per: hole` and `blast.holes`");
    plan.holes = holes_named(diagnostics, *holes, regular.blast->pattern.measured, false);
  }
  for (const Draw& draw : regular.draws) {
    const auto found = std::find_if(own->draws.begin(), own->draws.end(), [&](const Draw& other) {
      return other.stream == draw.stream && other.factor == draw.factor;
    });
    plan.own_draw.push_back(found == own->draws.end() ? -1 : static_cast<int>(found - own->draws.begin()));
  }
  plan.scenario = std::move(own);
  regular.branches.push_back(std::move(plan));
}

void check_probabilities(const Value& root, const Scenario& regular, Diagnostics& diagnostics) {
  if (!regular.branches.empty() && regular.rocks.empty())
    Node::root(root).find("branches")->error(diagnostics, "needs `rocks`, the scenario has none");
  double sum = 0;  // of the hole that has most of them
  for (int hole = 0; hole == 0 || (regular.blast && hole < regular.blast->pattern.holes()); ++hole) {
    double of_hole = 0;
    for (const BranchPlan& branch : regular.branches)
      if (branch.may_happen_to(hole)) of_hole += branch.probability;
    sum = std::max(sum, of_hole);
  }
  constexpr double rounding = 1e-12;
  if (sum > 1 + rounding)
    Node::root(root)
        .find("branches")
        ->error(diagnostics,
                fmt::format("have the probability {:.6g} together, must be at most 1: a hole has one of them",
                            sum));
}

}  // namespace flyrock
