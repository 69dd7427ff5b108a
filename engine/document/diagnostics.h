#pragma once
// Messages about a scenario. All of them are collected; none stops the reading.

#include <set>
#include <string>
#include <vector>

#include "document/location.h"

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

/// A message that is given twice is kept once, for example one about a value that several sweep points share.
class Diagnostics {
 public:
  void error(const Location& at, const std::string& path, const std::string& text);
  void warning(const Location& at, const std::string& path, const std::string& text);
  void unusual(const Location& at, const std::string& path, const std::string& text);
  /// Turns warnings about unusual values into errors.
  void be_strict();

  bool has_errors() const { return errors_given_ > 0; }
  /// The number of errors given so far, repeated ones included. If it does not grow while something is read,
  /// then that is sound.
  std::size_t errors_given() const { return errors_given_; }
  const std::vector<Diagnostic>& all() const { return all_; }
  std::vector<std::string> warnings() const;

  /// All messages as `file:line:column: error: path: text`, each followed by the line and a caret under the
  /// column, ordered by line and column. Only the first 100 are shown; the text ends with the number of the
  /// others.
  std::string to_text() const;

 private:
  void add(Diagnostic diagnostic);

  std::vector<Diagnostic> all_;
  std::set<std::string> known_;  ///< the texts of all_, to keep each once
  std::size_t errors_given_ = 0;
};

/// One message in the same form.
std::string to_text(const Diagnostic& diagnostic);

}  // namespace flyrock
