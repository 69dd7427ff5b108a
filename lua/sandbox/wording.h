#pragma once
// The wording of the sandbox's messages. The host provides it, so that they sound like all other messages.

#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

struct Wording {
  /// The text in one line, without control characters.
  std::string (*printable)(std::string_view text);
  /// ", did you mean `x`?" with the candidate nearest to a word; empty if none is near.
  std::string (*did_you_mean)(std::string_view word, const std::vector<std::string>& candidates);
};

}  // namespace flyrock
