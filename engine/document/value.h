#pragma once
// The tree of located values. YAML and Lua scenarios both become such a tree.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "document/location.h"

namespace flyrock {

struct Value;

struct Entry;

using List = std::vector<Value>;
using Map = std::vector<Entry>;  ///< in the order of the file; keys are unique

/// One value. A plain YAML scalar that reads as a number or as true/false becomes a number or a boolean, as
/// in Lua. A quoted scalar is text.
struct Value {
  std::variant<std::monostate, bool, double, std::string, List, Map> data;
  Location at;
  bool leading_zero = false;  ///< text such as 010, which YAML 1.1 would read as 8
  bool rounded = false;       ///< written as a number that is not this whole number (rounds_to_whole)
  bool assumed = false;       ///< a default, which the document does not give

  bool is_null() const { return std::holds_alternative<std::monostate>(data); }
  const bool* boolean() const { return std::get_if<bool>(&data); }
  const double* number() const { return std::get_if<double>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
  const List* list() const { return std::get_if<List>(&data); }
  List* list() { return std::get_if<List>(&data); }
  const Map* map() const { return std::get_if<Map>(&data); }
  Map* map() { return std::get_if<Map>(&data); }
  /// The value of a key of a map; null if there is none.
  const Value* find(std::string_view key) const;
  Value* find(std::string_view key);
  /// "a number", "text", "a list", "a map", "true or false", "nothing".
  std::string kind() const;
};

struct Entry {
  std::string key;
  Location at;
  Value value;
};

/// The shortest decimal text that reads back as the same double: "0.1", "1e+300". Integers have no ".0".
std::string shortest(double number);

/// The tree as YAML (maps in their order) and as JSON.
std::string to_yaml(const Value& value);
std::string to_json(const Value& value, int indent = 2);

}  // namespace flyrock
