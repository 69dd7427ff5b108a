#include "report/page/scenario_text.h"

#include <fmt/format.h>

#include "units/units.h"

namespace flyrock {

namespace {

/// "70 deg" for "1.2217304763960306 rad"; any other text unchanged.
std::string degrees_text(const std::string& text) {
  const std::optional<Quantity> angle = parse_quantity(text);
  if (!angle || angle->unit_text != "rad") return text;
  const ReadableUnit degrees = readable_unit("rad");
  for (const int digits : {15, 16, 17}) {
    std::string readable = fmt::format("{:.{}g} {}", angle->si() * degrees.per_si, digits, degrees.name);
    const std::optional<Quantity> again = parse_quantity(readable);
    if (again && again->si() == angle->si()) return readable;
  }
  return text;
}

void turn_to_degrees(Value& value) {
  if (List* list = value.list()) {
    for (Value& item : *list) turn_to_degrees(item);
  } else if (Map* map = value.map()) {
    for (Entry& entry : *map)
      if (entry.key != "title" && entry.key != "name") turn_to_degrees(entry.value);
  } else if (const std::string* text = value.text()) {
    value.data = degrees_text(*text);
  }
}

}  // namespace

Value in_degrees(Value resolved) {
  turn_to_degrees(resolved);
  return resolved;
}

std::string scenario_text(const Value& resolved) { return to_yaml(in_degrees(resolved)); }

}  // namespace flyrock
