#pragma once
// What all JSON of the report shares.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace flyrock {

/// JSON has no NaN and no infinity: null stands for them.
inline nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// { key: value, ... } of keys and values by turns. ordered_json copies all members, whole arrays, each time
/// that it finds no room for another; here it has the room at once.
template <class... Members>
nlohmann::ordered_json json_object(Members&&... members) {
  nlohmann::ordered_json::object_t object;
  object.reserve(sizeof...(Members) / 2);
  const auto add = [&](const auto& self, std::string key, auto&& value, auto&&... rest) -> void {
    object.emplace_back(std::move(key), nlohmann::ordered_json(std::forward<decltype(value)>(value)));
    if constexpr (sizeof...(rest) > 0) self(self, std::forward<decltype(rest)>(rest)...);
  };
  add(add, std::forward<Members>(members)...);
  return nlohmann::ordered_json(std::move(object));
}

}  // namespace flyrock
