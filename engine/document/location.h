#pragma once
// A place in a text that was read, for messages.

#include <memory>
#include <string>
#include <vector>

namespace flyrock {

/// A text that contains values: a file, or an argument of the command line.
struct Source {
  std::string name;                ///< as messages show it
  std::vector<std::string> lines;  ///< empty if there is nothing to quote
};

/// A place in a source. Lines and columns count from 1; 0 means unknown.
struct Location {
  std::shared_ptr<const Source> source;
  int line = 0;
  int column = 0;
};

}  // namespace flyrock
