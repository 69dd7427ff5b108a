#pragma once
// Calls commands of flyrock without a process for each, and keeps their answers to one mutant.

#include <atomic>
#include <cstdio>
#include <string>
#include <vector>

#include "judge.h"

namespace flyrock::fuzz {

/// Two files without names in place of stdout and stderr of a batch's child. The parent makes them, so that
/// it can read the output of a child that has died.
class Capture {
 public:
  Capture();
  ~Capture();
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  void redirect() const;    ///< from here on all output goes into the files
  void clear() const;       ///< empties them
  std::string err() const;  ///< output since then

 private:
  std::FILE *out_, *err_;
};

class Calls {
 public:
  /// `is_listed` is what only_list() sets.
  explicit Calls(const Capture* capture, std::atomic<bool>* is_listed = nullptr)
      : capture_(capture), is_listed_(is_listed) {}

  /// Calls a command in the current folder, judges its answer and returns its exit code. Without a capture
  /// (to look at one mutant) the command prints as usual and is not judged.
  int operator()(const cli::Arguments& arguments, ErrorForm form);

  /// A fault that the kind has found itself; empty: none.
  void blame(const std::string& fault) {
    if (fault_.empty()) fault_ = fault;
    if (!capture_ && !fault.empty()) std::printf("wrong: %s\n", fault.c_str());
  }

  /// From here on what is found of this mutant goes on a list and is no failure, except for a signal.
  void only_list() {
    if (is_listed_) *is_listed_ = true;
  }

  /// Whether answers are kept; if not, they are on the terminal.
  bool captures() const { return capture_ != nullptr; }
  /// What the last command wrote on stderr; empty without a capture.
  const std::string& err() const { return err_; }
  const std::vector<std::string>& lines() const { return lines_; }  ///< command lines so far
  int gravest() const { return gravest_; }                          ///< exit code
  const std::string& fault() const { return fault_; }               ///< the first found by fault_of()
  const std::string& rocks() const {
    return rocks_;
  }  ///< message about failed rocks of a run with exit code 3

 private:
  const Capture* capture_;
  std::atomic<bool>* is_listed_;
  std::vector<std::string> lines_;
  int gravest_ = 0;
  std::string fault_, rocks_, err_;
};

}  // namespace flyrock::fuzz
