// The question that the points of a sweep are compared by.

#include <fmt/format.h>

#include "scenario/normalise.h"

namespace flyrock {

namespace {

/// The dimension of the measure that a key names; nothing if it is none, which is reported.
std::optional<Dimension> dimension_of(DecodeContext& context, const Node& section, const char* key,
                                      const MeasureNames& names) {
  const auto node = section.find(key);
  if (!node || !node->value->text()) return std::nullopt;  // reported
  const MeasureInfo info = check_measure(*node->value->text(), names);
  if (info.fault.empty()) return info.dimension;
  node->error(context.diagnostics, info.fault);
  return std::nullopt;
}

/// { measure, below | above }
Value limit(DecodeContext& context, const Node& item, const MeasureNames& names) {
  Value value = normalise_section(context, item, "answer.such_that", {});
  const auto dimension = dimension_of(context, item, "measure", names);
  if (!value.map() || !dimension) return value;
  const auto below = item.find("below"), above = item.find("above");
  if (below.has_value() == above.has_value())
    item.error(context.diagnostics,
               fmt::format("expected exactly one of `below`, `above`, found {}", below ? "both" : "none"));
  else
    put(*value.map(), below ? *below : *above,
        normalise_expected(context, below ? *below : *above, *dimension));
  return value;
}

}  // namespace

Value normalise_answer(DecodeContext& context, const Node& node, const MeasureNames& names) {
  Value answer = normalise_section(context, node, "answer", {});
  if (!answer.map()) return answer;
  dimension_of(context, node, "least", names);
  const auto limits = node.find("such_that");
  if (!limits || !limits->expect_list(context.diagnostics)) return answer;
  List list;
  for (const Node& item : limits->items()) {
    list.push_back(limit(context, item, names));
    list.back().at = item.value->at;
  }
  put(*answer.map(), *limits, list_value(std::move(list)));
  return answer;
}

}  // namespace flyrock
