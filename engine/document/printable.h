#pragma once
// Text from scenarios and plugins as a terminal, a table and a page may show it.

#include <string>
#include <string_view>

namespace flyrock {

/// Why a text cannot be shown and stored: "is not UTF-8" (overlong forms, surrogates and what lies beyond
/// U+10FFFF are not), or "holds the control character \x1B" (tabs and line feeds aside). Empty where it can.
std::string text_fault(std::string_view text);

/// `text` in one line: control characters (tabs aside) and bytes that are no UTF-8 as \x1B, a line feed as
/// \n; what goes on beyond about `longest` bytes is cut and ends with "...".
std::string printable(std::string_view text, std::size_t longest = 500);

}  // namespace flyrock
