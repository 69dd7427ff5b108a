// Writes the tree of values as YAML and as JSON.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "document/value.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::size_t flow_width =
    88;  // a value that fits into one line of this width is written in one line

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Whether a text can be written without quotes and still reads back as the same text.
bool is_plain(const std::string& text) {
  if (text.empty() || text == "true" || text == "false" || text == "null" || text == "Null" || text == "NULL")
    return false;
  if (text.front() == ' ' || text.back() == ' ') return false;
  auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_number_like = is_digit(text[0]) || (text[0] == '-' && text.size() > 1 && is_digit(text[1]));
  if (!is_letter(text.front()) && !is_number_like) return false;
  auto is_safe = [&](char c) {
    return is_letter(c) || is_digit(c) || std::string_view(" ./+-^*%()").find(c) != std::string_view::npos;
  };
  if (!std::all_of(text.begin(), text.end(), is_safe)) return false;
  // "010" and "12" need quotes to stay text; "12 m" does not.
  return !is_number_like || text.find(' ') != std::string::npos;
}

std::string scalar_text(const Value& value) {
  if (const bool* boolean = value.boolean()) return *boolean ? "true" : "false";
  if (const double* number = value.number()) return shortest(*number);
  if (const std::string* text = value.text()) return is_plain(*text) ? *text : quoted(*text);
  return "null";
}

std::string key_text(const std::string& key) { return is_plain(key) ? key : quoted(key); }

std::string flow_text(const Value& value) {
  std::string text;
  if (const List* list = value.list()) {
    for (const Value& item : *list) text += (text.empty() ? "" : ", ") + flow_text(item);
    return "[" + text + "]";
  }
  if (const Map* map = value.map()) {
    for (const Entry& entry : *map)
      text += (text.empty() ? "" : ", ") + key_text(entry.key) + ": " + flow_text(entry.value);
    return text.empty() ? "{}" : "{ " + text + " }";
  }
  return scalar_text(value);
}

bool is_flow(const Value& value, const std::string& flow) {
  return flow.size() <= flow_width || (!value.list() && !value.map());
}

void write_block(std::string& out, const Value& value, int indent);

/// The entries of a map. The first one continues the current line (after "- " of a list).
void write_map(std::string& out, const Map& map, int indent) {
  bool first = true;
  for (const Entry& entry : map) {
    if (!first) out.append(indent, ' ');
    first = false;
    out += key_text(entry.key) + ":";
    if (const std::string flow = flow_text(entry.value); is_flow(entry.value, flow)) {
      out += " " + flow + "\n";
    } else {
      out += "\n";
      out.append(indent + 2, ' ');
      write_block(out, entry.value, indent + 2);
    }
  }
}

void write_block(std::string& out, const Value& value, int indent) {
  if (const Map* map = value.map()) return write_map(out, *map, indent);
  bool first = true;
  for (const Value& item : *value.list()) {
    if (!first) out.append(indent, ' ');
    first = false;
    out += "- ";
    if (const std::string flow = flow_text(item); is_flow(item, flow)) {
      out += flow + "\n";
    } else {
      write_block(out, item, indent + 2);
    }
  }
}

nlohmann::ordered_json json_of(const Value& value) {
  if (const bool* boolean = value.boolean()) return *boolean;
  if (const std::string* text = value.text()) return *text;
  if (const double* number = value.number()) {
    // Whole numbers are written as integers: JSON shows 3, not 3.0.
    constexpr double exact = 9007199254740992.0;
    if (*number == std::floor(*number) && std::abs(*number) < exact)
      return static_cast<std::int64_t>(*number);
    return *number;
  }
  if (const List* list = value.list()) {
    auto json = nlohmann::ordered_json::array();
    for (const Value& item : *list) json.push_back(json_of(item));
    return json;
  }
  if (const Map* map = value.map()) {
    auto json = nlohmann::ordered_json::object();
    for (const Entry& entry : *map) json[entry.key] = json_of(entry.value);
    return json;
  }
  return nullptr;
}

}  // namespace

std::string to_yaml(const Value& value) {
  std::string out;
  const Map* map = value.map();
  if (map && !map->empty())
    write_map(out, *map, 0);
  else
    out = flow_text(value) + "\n";
  return out;
}

std::string to_json(const Value& value, int indent) {
  return json_of(value).dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace flyrock
