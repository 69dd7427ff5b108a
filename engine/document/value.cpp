#include "document/value.h"

#include <fmt/format.h>

namespace flyrock {

namespace {

template <class Entries>
auto find_in(Entries* map, std::string_view key) -> decltype(&map->front().value) {
  if (map)
    for (auto& entry : *map)
      if (entry.key == key) return &entry.value;
  return nullptr;
}

}  // namespace

const Value* Value::find(std::string_view key) const { return find_in(map(), key); }
Value* Value::find(std::string_view key) { return find_in(map(), key); }

std::string Value::kind() const {
  constexpr const char* names[] = {"nothing", "true or false", "a number", "text", "a list", "a map"};
  return names[data.index()];
}

std::string shortest(double number) { return fmt::format("{}", number); }

}  // namespace flyrock
