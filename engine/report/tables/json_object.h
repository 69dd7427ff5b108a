#pragma once
// What all JSON of the report shares.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "results/statistics/sample.h"

namespace flyrock {

/// A number, or null for NaN and infinity, which JSON does not have.
inline nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// [lower, upper]
inline nlohmann::ordered_json interval_data(const Interval& interval) {
  return {number(interval.lower), number(interval.upper)};
}

/// { key: value, ... } from alternating keys and values. ordered_json copies all members, including whole
/// arrays, each time it runs out of room for another one. This reserves the room at the start.
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
