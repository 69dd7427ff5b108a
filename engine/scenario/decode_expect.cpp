#include <fmt/format.h>

#include "scenario/decode_sections.h"
#include "scenario/measure.h"

namespace flyrock {

namespace {

constexpr NumberRules expect_rules{.bare_angles = true};  // bare numbers are SI, angles too

class ExpectationDecoder {
 public:
  ExpectationDecoder(DecodeContext& context, const Node& node, const Dimension& dimension,
                     Expectation& expectation, Map& resolved)
      : context_(context),
        node_(node),
        dimension_(dimension),
        expectation_(expectation),
        resolved_(resolved) {}

  void decode() {
    const std::vector<std::string> kinds(expect_kind_names.begin(), expect_kind_names.end());
    std::vector<std::string> given;
    for (const std::string& kind : kinds)
      if (node_.find(kind)) given.push_back(kind);
    if (given.size() != 1)
      return node_.error(context_.diagnostics, fmt::format("expected exactly one of {}, found {}",
                                                           choice_text(kinds), given.size()));
    const Node value = *node_.find(given[0]);
    if (given[0] == "between") {
      decode_between(value);
    } else {
      expectation_.kind = given[0] == "equals"  ? ExpectKind::equals
                          : given[0] == "below" ? ExpectKind::below
                                                : ExpectKind::above;
      expectation_.value = read(value, dimension_);
      put(resolved_, given[0], bare(expectation_.value));
    }
    decode_tolerance();
    decode_at();
  }

 private:
  static Value bare(double number) { return number_value(number, dimension::none); }

  double read(const Node& node, const Dimension& dimension) {
    const std::string expected =
        dimension == dimension::none ? "a number" : "a number in " + si_unit(dimension);
    return decode_quantity(context_, node, dimension, expect_rules, expected).value_or(0);
  }

  void decode_between(const Node& node) {
    expectation_.kind = ExpectKind::between;
    const std::vector<Node> ends = node.items();
    if (ends.size() != 2) return node.error(context_.diagnostics, "expected [low, high]");
    expectation_.value = read(ends[0], dimension_);
    expectation_.high = read(ends[1], dimension_);
    if (expectation_.value > expectation_.high)
      node.error(context_.diagnostics, "the low end must not be above the high end");
    put(resolved_, "between", list_value({bare(expectation_.value), bare(expectation_.high)}));
  }

  void decode_tolerance() {
    const auto tolerance = node_.find("tolerance"), relative = node_.find("relative");
    if ((tolerance || relative) && expectation_.kind != ExpectKind::equals)
      (tolerance ? tolerance : relative)->error(context_.diagnostics, "stands beside `equals` only");
    if (tolerance && relative)
      relative->error(context_.diagnostics, "stands in place of `tolerance`, not beside it");
    if (tolerance) {
      expectation_.tolerance = read(*tolerance, dimension_);
      if (expectation_.tolerance < 0) tolerance->error(context_.diagnostics, "must be at least 0");
      put(resolved_, "tolerance", bare(expectation_.tolerance));
    }
    if (relative) {
      expectation_.relative = read(*relative, dimension::none);
      if (*expectation_.relative < 0) relative->error(context_.diagnostics, "must be at least 0");
      put(resolved_, "relative", bare(*expectation_.relative));
    }
  }

  /// Stores `at`. The values are compared with those of the axes once the axes are known.
  void decode_at() {
    const auto at = node_.find("at");
    if (!at || !at->expect_map(context_.diagnostics)) return;
    Map map;
    for (const Node& entry : at->entries()) {
      std::optional<double> value;
      if (entry.value->number()) value = *entry.value->number();
      if (entry.value->text())
        if (const auto quantity = parse_quantity(*entry.value->text())) value = quantity->si();
      if (!value)
        entry.error(context_.diagnostics,
                    fmt::format("expected a value of the sweep, found {}", shown(*entry.value)));
      expectation_.at.emplace_back(entry.key, value.value_or(0));
      put(map, entry.key, bare(value.value_or(0)));
    }
    put(resolved_, "at", map_value(std::move(map)));
  }

  DecodeContext& context_;
  const Node& node_;
  Dimension dimension_;
  Expectation& expectation_;
  Map& resolved_;
};

}  // namespace

std::vector<Expectation> decode_expect(DecodeContext& context, const Node& node, const MeasureNames& names,
                                       Map& resolved) {
  std::vector<Expectation> expectations;
  if (!node.expect_list(context.diagnostics)) return expectations;
  List list;
  for (const Node& item : node.items()) {
    Map map;
    Expectation expectation;
    const Section section = decode_section(context, item, "expect", {}, map);
    expectation.measure = section.text("measure");
    if (expectation.measure.empty()) continue;
    const MeasureInfo info = check_measure(expectation.measure, names);
    expectation.unit = si_unit(info.dimension);
    if (!info.fault.empty())
      item.find("measure")->error(context.diagnostics, info.fault);
    else
      ExpectationDecoder(context, item, info.dimension, expectation, map).decode();
    expectations.push_back(std::move(expectation));
    list.push_back(map_value(std::move(map)));
  }
  put(resolved, "expect", list_value(std::move(list)));
  return expectations;
}

}  // namespace flyrock
