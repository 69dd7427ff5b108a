#pragma once
// Messages about a scenario: all are collected, none stops the reading.

#include <set>
#include <string>
#include <vector>

#include "document/value.h"

namespace flyrock {

enum class Severity {
  error,
  warning,
  unusual  ///< a warning that `--strict` makes an error
};

struct Diagnostic {
  Severity severity = Severity::error;
  Location at;
  std::string path;  ///< "terrain.face_angle"; empty for the document
  std::string text;  ///< what is wrong, what was expected, did you mean
};

/// A message that is given twice (a value that several points of a sweep share) is kept once.
class Diagnostics {
 public:
  void error(const Location& at, const std::string& path, const std::string& text);
  void warning(const Location& at, const std::string& path, const std::string& text);
  void unusual(const Location& at, const std::string& path, const std::string& text);
  /// Makes errors of what is unusual.
  void be_strict();

  bool has_errors() const { return errors_given_ > 0; }
  /// Errors given so far, repeated ones too: what was read while this did not grow is sound.
  std::size_t errors_given() const { return errors_given_; }
  const std::vector<Diagnostic>& all() const { return all_; }
  std::vector<std::string> warnings() const;

  /// Each as `file:line:column: error: path: text`, then the line and a caret under the column; in the order
  /// of lines and columns. The first 100; how many more there are is said at the end.
  std::string to_text() const;

 private:
  void add(Diagnostic diagnostic);

  std::vector<Diagnostic> all_;
  std::set<std::string> known_;  ///< texts of all, to keep each once
  std::size_t errors_given_ = 0;
};

/// One message in that form.
std::string to_text(const Diagnostic& diagnostic);

}  // namespace flyrock
