#include "host/table_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/value.h"
#include "host/locate.h"
#include "units/units.h"

namespace flyrock {

TableReader::TableReader(const Value& table, std::string path, Diagnostics& diagnostics)
    : table_(table), path_(std::move(path)), diagnostics_(diagnostics) {
  const bool empty = table.list() && table.list()->empty();
  if (!table.map() && !empty) {
    failed_ = true;
    diagnostics_.error(table.at, path_, fmt::format("{}, expected a table of named fields", table.kind()));
  }
}

const Value* TableReader::field(const std::string& name) {
  known_.push_back(name);
  return table_.find(name);
}

void TableReader::error(const std::string& name, const std::string& text, const Location* at) {
  failed_ = true;
  const Value* value = table_.find(name);
  diagnostics_.error(at      ? *at
                     : value ? value->at
                             : table_.at,
                     name.empty() ? path_ : join_path(path_, name), text);
}

void TableReader::wrong_type(const std::string& name, const Value& value, const std::string& expected) {
  error(name, fmt::format("{}, expected {}", value.kind(), expected));
}

template <class T>
std::optional<T> TableReader::scalar(const std::string& name, const std::string& expected) {
  const Value* value = field(name);
  if (!value) return std::nullopt;
  if (const T* found = std::get_if<T>(&value->data)) return *found;
  wrong_type(name, *value, expected);
  return std::nullopt;
}

std::optional<double> TableReader::number(const std::string& name) {
  return scalar<double>(name, "a number");
}
std::optional<bool> TableReader::boolean(const std::string& name) {
  return scalar<bool>(name, "true or false");
}
std::optional<std::string> TableReader::text(const std::string& name) {
  return scalar<std::string>(name, "text");
}

template <class T>
std::optional<std::vector<T>> TableReader::list_of(const std::string& name, const std::string& expected) {
  const Value* value = field(name);
  if (!value) return std::nullopt;
  std::vector<T> found;
  if (const List* list = value->list())
    for (const Value& item : *list)
      if (const T* element = std::get_if<T>(&item.data)) found.push_back(*element);
  if (value->list() && found.size() == value->list()->size()) return found;
  wrong_type(name, *value, expected);
  return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(const std::string& name) {
  return list_of<std::string>(name, "a list of texts");
}
std::optional<std::vector<double>> TableReader::numbers(const std::string& name) {
  return list_of<double>(name, "a list of numbers");
}

std::string TableReader::required_text(const std::string& name) {
  const std::string found = text(name).value_or("");
  if (!table_.find(name))
    error(name, "missing, expected text");
  else if (found.empty() && table_.find(name)->text())
    error(name, "empty, expected text");
  return found;
}

void TableReader::finish() {
  if (!table_.map()) return;
  for (const Entry& entry : *table_.map())
    if (std::find(known_.begin(), known_.end(), entry.key) == known_.end()) {
      failed_ = true;
      std::string hint = did_you_mean(entry.key, known_);
      if (hint.empty()) hint = ", expected one of " + choice_text(known_);
      diagnostics_.error(entry.at, join_path(path_, entry.key), "unknown key" + hint);
    }
}

}  // namespace flyrock
