#pragma once
// What mutations insert: the keys and words of scenarios and plugins, units, and numbers and texts that are
// difficult for readers of files.

#include <string>
#include <vector>

#include "dice.h"
#include "document/value.h"
#include "plugin/registry.h"

namespace flyrock::fuzz {

struct Dictionary {
  std::vector<std::string>
      keys;  ///< of every section, of every parameter, of distributions, sweeps and manifests
  std::vector<std::string> words;  ///< choices, kinds and names of plugins, measures, fields of contacts
  std::vector<std::string> units;
  std::vector<std::string> numbers;  ///< as written: "1e308", "010", ".nan"
  std::vector<std::string> texts;    ///< empty, very long, not UTF-8, with control characters
};

Dictionary make_dictionary(const Registry& registry);

/// A number, a quantity, a text, a distribution, a sweep, a list or a map.
Value some_value(const Dictionary& dictionary, Dice& dice);

}  // namespace flyrock::fuzz
