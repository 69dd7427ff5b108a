#include "scenario/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "document/node.h"
#include "units/units.h"

namespace flyrock {

namespace {

/// `from` to `to` in `count` even steps, ends included; in SI units if they have units.
std::vector<Value> even_steps(const Node& node, Diagnostics& diagnostics) {
  node.refuse_unknown_keys({"from", "to", "count"}, diagnostics);
  constexpr double most = 10000;
  const auto from = node.find("from"), to = node.find("to"), count = node.find("count");
  if (!from || !to || !count) {
    node.error(diagnostics, "expected a list, or `from`, `to` and `count`");
    return {};
  }
  const double* steps = count->value->number();
  if (!steps || *steps != std::floor(*steps) || *steps < 2 || *steps > most) {
    count->error(diagnostics, fmt::format("expected a whole number from 2 to {:.6g}, found {}", most,
                                          shown(*count->value)));
    return {};
  }
  auto quantity_of = [&](const Node& end) -> std::optional<Quantity> {
    if (const double* number = end.value->number()) return Quantity{*number, false, {}, ""};
    if (end.value->text())
      if (auto quantity = parse_quantity(*end.value->text())) return quantity;
    end.error(diagnostics, fmt::format("expected a number, found {}", shown(*end.value)));
    return std::nullopt;
  };
  const auto first = quantity_of(*from), last = quantity_of(*to);
  if (!first || !last) return {};
  if (first->has_unit != last->has_unit || first->unit.dimension != last->unit.dimension) {
    node.error(diagnostics, "`from` and `to` must have the same kind of unit");
    return {};
  }
  std::vector<Value> values;
  for (int i = 0; i < *steps; ++i) {
    const double share = i / (*steps - 1);
    const double si = i == *steps - 1 ? last->si() : first->si() + share * (last->si() - first->si());
    Value value;
    value.at = node.value->at;
    if (first->has_unit)
      value.data = shortest(si) + " " + si_unit(first->unit.dimension);
    else
      value.data = si;
    values.push_back(std::move(value));
  }
  return values;
}

/// The first sweep inside a value of a sweep.
std::optional<Node> inner_sweep(const Node& node) {
  if (const auto inner = node.find("sweep")) return inner;
  for (const std::vector<Node>& nodes : {node.entries(), node.items()})
    for (const Node& below : nodes)
      if (const auto inner = inner_sweep(below)) return inner;
  return std::nullopt;
}

std::vector<Value> listed(const Node& node, Diagnostics& diagnostics) {
  std::vector<Value> values;
  for (const Node& item : node.items()) {
    const Value& value = *item.value;
    const bool is_section = value.map() && value.find("type");
    if (!value.number() && !value.text() && !value.boolean() && !is_section)
      item.error(
          diagnostics,
          fmt::format("a sweep lists numbers, choices or sections with a `type`, found {}", shown(value)));
    else if (const auto inner = inner_sweep(item))
      inner->error(diagnostics, "stands inside another sweep, expected a value");
    else
      values.push_back(value);
  }
  if (node.items().empty()) node.error(diagnostics, "expected a list, or `from`, `to` and `count`");
  return values;
}

void search(Value& value, const Node& node, Diagnostics& diagnostics, std::vector<SweptValue>& found) {
  const std::optional<Node> sweep = node.path.empty() ? std::nullopt : node.find("sweep");
  if (sweep) {
    node.refuse_unknown_keys({"sweep"}, diagnostics);
    std::vector<Value> values = sweep->value->map() && !sweep->value->map()->empty()
                                    ? even_steps(*sweep, diagnostics)
                                    : listed(*sweep, diagnostics);
    found.push_back({&value, node.path, node.stream, sweep->key_at, std::move(values)});
    return;
  }
  if (Map* map = value.map())
    for (Entry& entry : *map) {
      if (node.path.empty() && entry.key == "sweep")
        continue;  // this is the section `sweep`, not a sweep of a value
      search(entry.value, *node.find(entry.key), diagnostics, found);
    }
  if (List* list = value.list()) {
    const std::vector<Node> items = node.items();
    for (std::size_t i = 0; i < list->size(); ++i) search((*list)[i], items[i], diagnostics, found);
  }
}

}  // namespace

std::vector<SweptValue> find_sweeps(Value& root, Diagnostics& diagnostics) {
  std::vector<SweptValue> found;
  search(root, Node::root(root), diagnostics, found);
  std::sort(found.begin(), found.end(),
            [](const SweptValue& a, const SweptValue& b) { return a.path < b.path; });
  return found;
}

bool may_be_swept(std::string_view path) {
  constexpr std::array<std::string_view, 17> parts{
      "branches", "method",    "rock_contacts", "body_contacts", "gravity", "air",
      "terrain",  "materials", "pairs",         "blast",         "rocks",   "bodies",
      "barriers", "gates",     "forest",        "solver",        "links"};
  const std::string_view part = path.substr(0, path.find('.'));
  return std::find(parts.begin(), parts.end(), part) != parts.end() && !path.ends_with(".name");
}

std::vector<std::vector<std::size_t>> grid_points(const std::vector<std::size_t>& sizes) {
  std::vector<std::vector<std::size_t>> points{std::vector<std::size_t>()};
  for (const std::size_t size : sizes) {
    std::vector<std::vector<std::size_t>> next;
    for (const auto& point : points)
      for (std::size_t i = 0; i < size; ++i) {
        next.push_back(point);
        next.back().push_back(i);
      }
    points = std::move(next);
  }
  return points;
}

}  // namespace flyrock
