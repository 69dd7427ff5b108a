#pragma once
// Mutations of a scenario as a tree: what comes out is YAML or Lua by its grammar, and wrong in what it says.

#include "dictionary.h"

namespace flyrock::fuzz {

/// One to four changes: a value is replaced, swapped with another, wrapped or emptied; a key is removed,
/// doubled, renamed or added with a value of the dictionary.
void mutate_tree(Value& root, const Dictionary& dictionary, Dice& dice);

/// The tree as a scenario in Lua: `return fr.scenario { ... }`.
std::string to_lua_scenario(const Value& root);

}  // namespace flyrock::fuzz
