#pragma once
// Well-known text, in which GIS write coordinate systems: KEYWORD["name", value, KEYWORD[...], ...].

#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// One keyword with what stands in its brackets.
struct WktNode {
  std::string keyword;              ///< in capital letters
  std::vector<std::string> values;  ///< texts without their quotes, numbers and words, in their order
  std::vector<WktNode> children;

  /// The first child with one of these keywords; null: none.
  const WktNode* child(std::initializer_list<std::string_view> keywords) const;
};

/// The nodes of a text, one after the other; ESRI writes a system of heights after that of places. Empty if
/// the text is none: a bracket or a quote that is not closed, or no keyword.
std::vector<WktNode> read_well_known_text(const std::string& text);

}  // namespace flyrock
