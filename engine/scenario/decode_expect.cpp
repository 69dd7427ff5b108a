
#include "scenario/decode_sections.h"
#include "scenario/normalise_number.h"

namespace flyrock {

namespace {

Expectation decode_expectation(const Node& item, const MeasureNames& names) {
  Expectation expectation;
  const Value* measure = item.value->find("measure");
  if (!measure || !measure->text()) return expectation;  // already reported, as all that is wrong here
  expectation.measure = *measure->text();
  expectation.unit = si_unit(check_measure(expectation.measure, names).dimension);
  for (std::size_t kind = 0; kind < expect_kind_names.size(); ++kind) {
    const Value* value = item.value->find(expect_kind_names[kind]);
    if (!value) continue;
    expectation.kind = static_cast<ExpectKind>(kind);
    const List* ends = value->list();
    expectation.value = si_of(ends ? ends->front() : *value);
    if (ends) expectation.high = si_of(ends->back());
  }
  if (const Value* tolerance = item.value->find("tolerance")) expectation.tolerance = si_of(*tolerance);
  if (const Value* relative = item.value->find("relative")) expectation.relative = si_of(*relative);
  const Value *order_in = item.value->find("order_in"), *exact = item.value->find("exact");
  if (order_in && order_in->text() && exact) {
    expectation.order = Expectation::Order{si_of(*exact), *order_in->text()};
    expectation.unit = si_unit(dimension::none);
  }
  if (const auto at = item.find("at"))
    for (const Node& entry : at->entries()) expectation.at.emplace_back(entry.key, si_of(*entry.value));
  return expectation;
}

}  // namespace

std::vector<Expectation> decode_expect(const Node& node, const MeasureNames& names) {
  return decode_list<Expectation>(node, [&](const Node& item) { return decode_expectation(item, names); });
}

std::optional<AnswerPlan> decode_answer(const Node& node, const MeasureNames& names) {
  const Value* least = node.value->find("least");
  if (!least || !least->text()) return std::nullopt;  // reported
  const auto unit_of = [&](const std::string& measure) {
    return si_unit(check_measure(measure, names).dimension);
  };
  AnswerPlan plan{*least->text(), unit_of(*least->text()), {}};
  const auto limits = node.find("such_that");
  for (const Node& item : limits ? limits->items() : std::vector<Node>()) {
    const Value* measure = item.value->find("measure");
    const Value *below = item.value->find("below"), *above = item.value->find("above");
    if (!measure || !measure->text() || (!below && !above)) continue;
    plan.limits.push_back(
        {*measure->text(), below != nullptr, si_of(below ? *below : *above), unit_of(*measure->text())});
  }
  return plan;
}

}  // namespace flyrock
