#include "document/node.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/value.h"

namespace flyrock {

std::string shown(const Value& value) {
  if (const std::string* text = value.text()) return fmt::format("`{}`", *text);
  if (const double* number = value.number()) return fmt::format("`{}`", shortest(*number));
  if (const bool* boolean = value.boolean()) return *boolean ? "`true`" : "`false`";
  return value.kind();
}

std::optional<Node> Node::find(std::string_view wanted) const {
  if (const Map* map = value->map())
    for (const Entry& entry : *map)
      if (entry.key == wanted)
        return Node{&entry.value, entry.at, join_path(path, wanted), join_path(stream, wanted), entry.key};
  return std::nullopt;
}

std::vector<Node> Node::entries() const {
  std::vector<Node> nodes;
  if (const Map* map = value->map())
    for (const Entry& entry : *map)
      nodes.push_back(
          {&entry.value, entry.at, join_path(path, entry.key), join_path(stream, entry.key), entry.key});
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.key < b.key; });
  return nodes;
}

std::vector<Node> Node::items() const {
  std::vector<Node> nodes;
  if (const List* list = value->list())
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Value& item = (*list)[i];
      const Value* name = item.find("name");
      const std::string index = std::to_string(i);
      const std::string step = name && name->text() ? *name->text() : index;
      nodes.push_back({&item, item.at, join_path(path, index), join_path(stream, step), index});
    }
  return nodes;
}

Node node_at(const Value& root, const std::string& path) {
  Node node = Node::root(root);
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string step = path.substr(begin, end - begin);
    begin = end + 1;
    std::optional<Node> next = node.find(step);
    for (Node& item : node.items())
      if (item.key == step) next = std::move(item);
    if (!next) break;
    node = std::move(*next);
  }
  return node;
}

void Node::error(Diagnostics& diagnostics, const std::string& text) const {
  diagnostics.error(value->is_null() ? key_at : value->at, path, text);
}

bool Node::expect_map(Diagnostics& diagnostics) const {
  if (is_map()) return true;
  error(diagnostics, value->is_null() ? "is empty, expected a map"
                                      : fmt::format("expected a map, found {}", shown(*value)));
  return false;
}

bool Node::expect_list(Diagnostics& diagnostics) const {
  if (is_list()) return true;
  error(diagnostics, value->is_null() ? "is empty, expected a list"
                                      : fmt::format("expected a list, found {}", shown(*value)));
  return false;
}

void Node::refuse_unknown_keys(const std::vector<std::string>& known, Diagnostics& diagnostics) const {
  const Map* map = value->map();
  if (!map) return;
  for (const Entry& entry : *map)
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      diagnostics.error(entry.at, join_path(path, entry.key), "unknown key" + suggestion(entry.key, known));
}

}  // namespace flyrock
