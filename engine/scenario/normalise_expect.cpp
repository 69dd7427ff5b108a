// What expectations compare measures with.

#include <fmt/format.h>

#include "scenario/normalise.h"
#include "scenario/scenario.h"

namespace flyrock {

namespace {

constexpr NumberRules expect_rules{.bare_angles = true};  // bare numbers are SI, angles too

Value expected_range(DecodeContext& context, const Node& node, const Dimension& dimension) {
  const std::vector<Node> ends = node.items();
  if (ends.size() != 2) {
    node.error(context.diagnostics, "expected [low, high]");
    return {};
  }
  const Value low = normalise_expected(context, ends[0], dimension),
              high = normalise_expected(context, ends[1], dimension);
  if (si_of(low) > si_of(high)) node.error(context.diagnostics, "the low end must not be above the high end");
  return list_value({low, high});
}

void put_tolerances(DecodeContext& context, const Node& item, const Dimension& dimension, bool equals,
                    Map& map) {
  const auto tolerance = item.find("tolerance"), relative = item.find("relative");
  if ((tolerance || relative) && !equals)
    (tolerance ? tolerance : relative)->error(context.diagnostics, "stands beside `equals` only");
  if (tolerance && relative) relative->error(context.diagnostics, "replaces `tolerance`: give only one");
  const auto put_positive = [&](const Node& node, const Dimension& of) {
    Value value = normalise_expected(context, node, of);
    if (si_of(value) < 0) node.error(context.diagnostics, "must be at least 0");
    put(map, node, std::move(value));
  };
  if (tolerance) put_positive(*tolerance, dimension);
  if (relative) put_positive(*relative, dimension::none);
}

/// `at`. The values are compared with those of the axes once the axes are known.
void put_sweep_points(DecodeContext& context, const Node& item, Map& map) {
  const auto at = item.find("at");
  if (!at || !at->expect_map(context.diagnostics)) return;
  Map points;
  for (const Node& entry : at->entries()) {
    const std::string* text = entry.value->text();
    const std::optional<Quantity> quantity = text ? parse_quantity(*text) : std::nullopt;
    const bool is_choice = (text && !quantity) || entry.value->boolean();
    if (!text && !entry.value->number() && !is_choice)
      entry.error(context.diagnostics,
                  fmt::format("expected a value of the sweep, found {}", shown(*entry.value)));
    const double number = quantity ? quantity->si() : entry.value->number() ? *entry.value->number() : 0;
    put(points, entry, is_choice ? *entry.value : number_value(number, dimension::none));
  }
  put(map, *at, map_value(std::move(points)));
}

/// `exact`, which stands beside `order_in`. Whether there are both.
bool put_order(DecodeContext& context, const Node& item, const Dimension& dimension, Map& map) {
  const auto order_in = item.find("order_in"), exact = item.find("exact");
  if (order_in.has_value() != exact.has_value())
    (order_in ? order_in : exact)
        ->error(context.diagnostics, order_in ? "needs `exact`, the number from which errors count"
                                              : "stands beside `order_in` only");
  if (exact) put(map, *exact, normalise_expected(context, *exact, dimension));
  return order_in && exact;
}

/// What a measure, or the order of its error, is compared with.
void put_values(DecodeContext& context, const Node& item, const Dimension& of_measure, Map& map) {
  const bool is_order = put_order(context, item, of_measure, map);
  const Dimension& dimension = is_order ? dimension::none : of_measure;
  const std::vector<std::string> kinds(expect_kind_names.begin(), expect_kind_names.end());
  std::vector<std::string> given;
  for (const std::string& kind : kinds)
    if (item.find(kind)) given.push_back(kind);
  if (given.size() != 1)
    return item.error(context.diagnostics,
                      fmt::format("expected exactly one of {}, found {}", choice_text(kinds), given.size()));
  const Node value = *item.find(given[0]);
  put(map, value,
      given[0] == "between" ? expected_range(context, value, dimension)
                            : normalise_expected(context, value, dimension));
  put_tolerances(context, item, dimension, given[0] == "equals", map);
  put_sweep_points(context, item, map);
}

}  // namespace

Value normalise_expected(DecodeContext& context, const Node& node, const Dimension& dimension) {
  const std::string text = dimension == dimension::none ? "a number" : "a number in " + si_unit(dimension);
  const auto si = quantity_of(context, node, dimension, expect_rules, text);
  return si ? number_value(*si, dimension::none) : Value{};
}

Value normalise_expectations(DecodeContext& context, const Node& node, const MeasureNames& names) {
  if (!node.expect_list(context.diagnostics)) return {};
  List list;
  for (const Node& item : node.items()) {
    Value expectation = normalise_section(context, item, "expect", {});
    const Value* measure = expectation.find("measure");
    if (measure && measure->text()) {
      const MeasureInfo info = check_measure(*measure->text(), names);
      if (info.fault.empty())
        put_values(context, item, info.dimension, *expectation.map());
      else
        item.find("measure")->error(context.diagnostics, info.fault);
    }
    expectation.at = item.value->at;
    list.push_back(std::move(expectation));
  }
  return list_value(std::move(list));
}

}  // namespace flyrock
