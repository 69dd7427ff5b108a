#include <algorithm>

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
  if (const auto at = item.find("at"))
    for (const Node& entry : at->entries()) expectation.at.emplace_back(entry.key, si_of(*entry.value));
  return expectation;
}

}  // namespace

std::vector<Expectation> decode_expect(const Node& node, const MeasureNames& names) {
  return decode_list<Expectation>(node, [&](const Node& item) { return decode_expectation(item, names); });
}

}  // namespace flyrock
