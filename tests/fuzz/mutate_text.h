#pragma once
// Mutates a text by tokens and lines (YAML, Lua, JSON), and any file by bytes.

#include <string>

#include "dictionary.h"

namespace flyrock::fuzz {

/// Makes one or a few changes. A number, a word or a quoted text is replaced from the dictionary, doubled,
/// removed or swapped with another. A line is removed, doubled or moved.
void mutate_text(std::string& text, const Dictionary& dictionary, Dice& dice);

/// Makes one or a few changes. A bit is flipped; bytes are set, inserted, removed, doubled or replaced by a
/// difficult 8-byte number; the end is cut off. Bytes before `from` stay.
void mutate_bytes(std::string& bytes, Dice& dice, std::size_t from = 0);

}  // namespace flyrock::fuzz
