#pragma once
// Reads the fields of one table of a manifest. Each field is read once; a field that is never read is an
// error.

#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "document/wording.h"

namespace flyrock {

struct Value;

class TableReader {
 public:
  /// `table` must be a map, or an empty list, which counts as an empty map.
  TableReader(const Value& table, std::string path, Diagnostics& diagnostics);

  /// The field, or null. Marks the name as known.
  const Value* field(const std::string& name);
  std::optional<double> number(const std::string& name);
  std::optional<bool> boolean(const std::string& name);
  std::optional<std::string> text(const std::string& name);
  std::optional<std::vector<std::string>> texts(const std::string& name);
  std::optional<std::vector<double>> numbers(const std::string& name);
  /// A text that must be present and not empty.
  std::string required_text(const std::string& name);

  /// Reports an error about a field, or about the table if the name is empty. `at` is for a field that is not
  /// in the tree.
  void error(const std::string& name, const std::string& text, const Location* at = nullptr);
  /// Reports the fields that were never read, with the nearest known name.
  void finish();
  bool failed() const { return failed_; }

 private:
  void wrong_type(const std::string& name, const Value& value, const std::string& expected);
  template <class T>
  std::optional<T> scalar(const std::string& name, const std::string& expected);
  template <class T>
  std::optional<std::vector<T>> list_of(const std::string& name, const std::string& expected);

  const Value& table_;
  std::string path_;
  Diagnostics& diagnostics_;
  std::vector<std::string> known_;
  bool failed_ = false;
};

}  // namespace flyrock
