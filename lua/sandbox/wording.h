#pragma once
// How the sandbox words its messages: the host says, so that they sound like all others of the program.

#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

struct Wording {
  /// A text in one line, without control characters.
  std::string (*printable)(std::string_view text);
  /// ", did you mean `x`?" with the candidate nearest to a word; empty where none is near.
  std::string (*did_you_mean)(std::string_view word, const std::vector<std::string>& candidates);
};

}  // namespace flyrock
