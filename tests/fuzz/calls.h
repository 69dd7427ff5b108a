#pragma once
// Commands of flyrock called without a process for each, and what they answered to one mutant.

#include <cstdio>
#include <string>
#include <vector>

#include "judge.h"

namespace flyrock::fuzz {

/// Two files without names that stand in for stdout and stderr of the child of a batch. The parent makes
/// them, so that it can read what a child said that has died.
class Capture {
 public:
  Capture();
  ~Capture();
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  void redirect() const;    ///< from here on everything printed goes into the files
  void clear() const;       ///< empties them
  std::string err() const;  ///< what was said since then

 private:
  std::FILE *out_, *err_;
};

class Calls {
 public:
  explicit Calls(const Capture* capture) : capture_(capture) {}

  /// Calls a command in the current folder and judges its answer; its exit code. Without a capture (one
  /// mutant is looked at) it prints as ever and is not judged.
  int operator()(const cli::Arguments& arguments, ErrorForm form);

  const std::vector<std::string>& lines() const { return lines_; }  ///< the command lines so far
  int gravest() const { return gravest_; }                          ///< exit code
  const std::string& fault() const { return fault_; }  ///< the first that was found, by fault_of()
  const std::string& rocks() const { return rocks_; }  ///< what a run with exit code 3 said of its rocks

 private:
  const Capture* capture_;
  std::vector<std::string> lines_;
  int gravest_ = 0;
  std::string fault_, rocks_;
};

}  // namespace flyrock::fuzz
