#pragma once
// Characters that are not what they look like: blanks that are no blanks, signs without a width, dashes that
// are no minus, marks that turn the direction of the text around them. People paste them from tables and
// pages, and cannot see why a number is refused.

#include <string>
#include <string_view>

#include "document/value.h"

namespace flyrock {

/// The code of the character at the start of a text that is invisible or turns the text around it:
/// "<U+00A0>". Empty for every other character.
std::string code_of_invisible(std::string_view text);

/// The same only for the marks that turn the direction of text (U+202A to U+202E, U+2066 to U+2069 and the
/// marks of one direction): with them, a message could show another text than it has.
std::string code_of_turning(std::string_view text);

/// `text` with the codes of its invisible characters: "1<U+00A0>kg".
std::string with_codes(std::string_view text);

/// What the first odd character of a text is and what to write: "U+00A0 is a no-break space, write a blank".
/// Empty if there is none.
std::string odd_character_hint(std::string_view text);

/// " (U+00A0 is a no-break space, write a blank)" for the line of a place that has an odd character, because
/// parsers take it for a letter. Empty if there is none.
std::string hint_of_line(const Location& at);

}  // namespace flyrock
