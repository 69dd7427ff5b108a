#pragma once
// Mutations of a text by its tokens and lines (YAML, Lua, JSON), and of any file by its bytes.

#include <string>

#include "dictionary.h"

namespace flyrock::fuzz {

/// One change or a few: a number, a word or a quoted text is replaced from the dictionary, doubled, removed
/// or swapped with another; a line is removed, doubled or moved.
void mutate_text(std::string& text, const Dictionary& dictionary, Dice& dice);

/// One change or a few: a bit flips, bytes are set, inserted, removed, doubled or replaced by a number of 8
/// bytes that readers get wrong; the end is cut off. Bytes before `from` stay.
void mutate_bytes(std::string& bytes, Dice& dice, std::size_t from = 0);

}  // namespace flyrock::fuzz
