#pragma once
// A value of the tree and its path. Decoding walks over nodes.

#include <optional>
#include <string>
#include <vector>

#include "document/diagnostics.h"
#include "document/value.h"
#include "document/wording.h"

namespace flyrock {

/// A value and its place. The value must outlive the node. `stream` is the path with the name of an element
/// in place of its index: "rocks.blocks.density" for "rocks.0.density".
struct Node {
  const Value* value = nullptr;
  Location key_at;  ///< of the key, or of the element of a list
  std::string path;
  std::string stream;
  std::string key;  ///< the last step of the path

  static Node root(const Value& value) { return {&value, value.at, "", "", ""}; }

  /// The value of a key; nothing if this is not a map or has no such key.
  std::optional<Node> find(std::string_view key) const;
  /// The entries of a map, sorted by the bytes of their keys, so that a Lua table gives the same order as a
  /// file.
  std::vector<Node> entries() const;
  /// The elements of a list.
  std::vector<Node> items() const;

  /// An empty list and an empty map look the same in Lua, so an empty one counts as both.
  bool is_map() const { return value->map() || (value->list() && value->list()->empty()); }
  bool is_list() const { return value->list() || (value->map() && value->map()->empty()); }

  /// Reports an error at the value, or at its key if the value is empty.
  void error(Diagnostics& diagnostics, const std::string& text) const;
  /// Reports an error unless this is a map: "is empty, expected a map" and the like.
  bool expect_map(Diagnostics& diagnostics) const;
  bool expect_list(Diagnostics& diagnostics) const;
  /// Reports an error at each key of this map that is not in `known`, and names the nearest known key.
  void refuse_unknown_keys(const std::vector<std::string>& known, Diagnostics& diagnostics) const;
};

/// The deepest node that exists on the way to a path: the node of "rocks.0" for "rocks.0.release" if there is
/// no release.
Node node_at(const Value& root, const std::string& path);

/// A value as messages show it: `12 s`, `true`, a list.
std::string shown(const Value& value);

}  // namespace flyrock
