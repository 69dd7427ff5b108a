#pragma once
// Makes text from scenarios and plugins safe to show in a terminal, a table or a page.

#include <string>
#include <string_view>

namespace flyrock {

/// Why a text cannot be shown and stored: "is not UTF-8" (overlong forms, surrogates and code points above
/// U+10FFFF are not valid either), or "holds the control character \x1B" (tabs and line feeds are allowed).
/// Empty if the text is fine.
std::string text_fault(std::string_view text);

/// `text` in one line. Control characters (except tabs) and bytes that are not UTF-8 become \x1B and the
/// like, a line feed becomes \n, and marks that turn the direction of text become <U+202E> and the like. Text
/// longer than about `longest` bytes is cut and ends with "...".
std::string printable(std::string_view text, std::size_t longest = 500);

}  // namespace flyrock
