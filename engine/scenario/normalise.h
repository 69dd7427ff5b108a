#pragma once
// Normalises a document (decode_context.h).

#include <optional>
#include <string>
#include <vector>

#include "scenario/measure.h"
#include "scenario/normalise_params.h"

namespace flyrock {

/// The normalised document, in schema order, with the places of the document: what `show` prints.
Value normalise(DecodeContext& context, const Node& root);

/// Its parts.
Value normalise_materials(DecodeContext& context, const Node& node);
Value normalise_terrain(DecodeContext& context, const Node& node);
/// A list of what is `between` two, each in a section; `expected`: what names they may have, for messages.
Value normalise_between(DecodeContext& context, const Node& node, const std::string& section,
                        const std::string& expected);
Value normalise_rocks(DecodeContext& context, const Node& list);
Value normalise_bodies(DecodeContext& context, const Node& list);
/// One of the shapes of the document.
Value normalise_shape_of_rocks(DecodeContext& context, const Node& node);
Value normalise_shape_of_bodies(DecodeContext& context, const Node& node);
Value normalise_expectations(DecodeContext& context, const Node& node, const MeasureNames& names);
Value normalise_answer(DecodeContext& context, const Node& node, const MeasureNames& names);
/// What a measure is compared with: a number in its unit.
Value normalise_expected(DecodeContext& context, const Node& node, const Dimension& dimension);

/// The key of a release that says of which kind it is: "from", "x", "position", ...; nothing if it has none.
std::optional<Node> key_of_release(const Node& release, int dimension);
/// The section of the schema for a release of that kind.
std::string section_of_release(const Node& key, int dimension);

/// The key of a zone in 3D that says of which kind it is: "polygon", "raster" or "group".
std::optional<Node> key_of_zone(const Node& zone);
/// The section of the schema for a zone; `key` in 3D.
std::string section_of_zone(const std::optional<Node>& key);

/// The keys of earthworks that a terrain takes on its profile: `ditch` and `bund` in 2D, unless its plugin
/// has its own.
std::vector<std::string> earthworks_of(DecodeContext& context, const Node& terrain);

/// What the measures of a document may name.
MeasureNames measure_names(const Node& root, int dimension);

/// The names of the elements of a list, including elements with other errors.
std::vector<std::string> element_names(const std::optional<Node>& list);

/// A list whose elements are sections of the schema with names.
inline constexpr NumberRules air_rules{.varies = true, .scope = Scope::trial, .finest = Scope::rock};

/// A list of names, where a number is a name too. `expected`: "hole".
Value normalise_names(DecodeContext& context, const Node& node, const char* expected);

Value normalise_list_of(DecodeContext& context, const Node& node, const std::string& section);

/// Reports an error at each element of a list whose `name` is already used by an earlier element.
void refuse_duplicate_names(DecodeContext& context, const Node& list);

/// The `columns` of a section that names a table, if it has any: other heads by name of column.
void put_columns(DecodeContext& context, Map& map, const Node& section, std::string_view columns_section);

/// Measured holes: `{ file, columns }`, or a list.
Value normalise_holes(DecodeContext& context, const Node& node);

/// Branches; what they `set` stays as it is written.
Value normalise_branches(DecodeContext& context, const Node& list);

Value normalise_forest(DecodeContext& context, const Node& node);

/// A list of maps, each normalised by normalise(element), which gives a map. An element that is no map
/// is null. Null if it is no list. Names of elements must be names, each only once.
template <class Normalise>
Value normalise_list(DecodeContext& context, const Node& node, Normalise&& normalise) {
  if (!node.expect_list(context.diagnostics)) return {};
  List list;
  for (const Node& item : node.items()) {
    Value value;
    if (item.expect_map(context.diagnostics)) {
      value = normalise(item);
      if (const auto name = item.find("name")) check_name(context, *name);
    }
    value.at = item.value->at;
    list.push_back(std::move(value));
  }
  refuse_duplicate_names(context, node);
  return list_value(std::move(list));
}

}  // namespace flyrock
