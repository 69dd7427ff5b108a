#pragma once
// Mutates a scenario as a tree. The result has the correct grammar of YAML or Lua, and wrong content.

#include "dictionary.h"

namespace flyrock::fuzz {

/// Makes one to four changes. A value is replaced, swapped with another, wrapped or emptied. A key is
/// removed, doubled, renamed, or added with a value from the dictionary.
void mutate_tree(Value& root, const Dictionary& dictionary, Dice& dice);

/// The tree as a Lua scenario: `return fr.scenario { ... }`.
std::string to_lua_scenario(const Value& root);

}  // namespace flyrock::fuzz
