#pragma once
// The keys of the scenario's own sections, described in the same way as plugins describe their parameters.
// Decoding, the resolved scenario and the schema for editors use these tables.

#include <string>
#include <string_view>
#include <vector>

#include "plugin/spec.h"

namespace flyrock {

/// A section of a scenario. `parts` are the keys that hold sections, lists or plugins.
struct SectionSpec {
  std::string_view name;  ///< "solver", "blast.hole"; "" for the document
  std::vector<ParamSpec> keys;
  std::vector<std::string> parts;

  /// All keys, for messages.
  std::vector<std::string> key_names() const;
};

/// The section with that name. An unknown name is a bug of the program (std::logic_error).
const SectionSpec& section_spec(std::string_view name);

/// The section of an element of `gates` or `barriers`, which in 3D may stand along a line.
std::string place_section(std::string_view name, int dimension);

/// All sections, in the order of the document.
const std::vector<SectionSpec>& section_specs();

/// The columns of a table of rocks, and those of a table of measured places.
const std::vector<ParamSpec>& rock_columns();
const std::vector<ParamSpec>& observed_columns();

/// In place of a density: the one that follows from the masses and lengths of a table.
inline constexpr const char* from_table = "from_table";
/// The type of a shape that has the lengths of a table.
inline constexpr std::string_view from_lengths = "from_lengths";

/// The population of a group that gives no `type`.
inline constexpr std::string_view default_population = "independent";

}  // namespace flyrock
