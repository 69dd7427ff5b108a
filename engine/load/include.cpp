#include "load/include.h"

#include <fmt/format.h>

#include <algorithm>

#include "blast/blast.h"
#include "document/node.h"
#include "document/yaml_reader.h"
#include "files/safe_file.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

/// Whether a text stands somewhere in a tree, except as a key.
bool is_said_in(const Value& value, const std::string& text) {
  if (const std::string* own = value.text()) return *own == text;
  if (const List* list = value.list())
    return std::any_of(list->begin(), list->end(), [&](const Value& item) { return is_said_in(item, text); });
  const Map* map = value.map();
  return map &&
         std::any_of(map->begin(), map->end(), [&](const Entry& e) { return is_said_in(e.value, text); });
}

std::vector<std::string> files_in(const fs::path& library) {
  std::vector<std::string> list;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(library, code))
    list.push_back(entry.path().filename().string());
  std::sort(list.begin(), list.end());
  return list;
}

/// An included value without its `source`, which says where its numbers are from.
Value without_source(Value value, const Node& node, Diagnostics& diagnostics) {
  if (!node.expect_map(diagnostics)) return {};
  if (const auto source = node.find("source"); source && !source->value->text())
    source->error(diagnostics,
                  fmt::format("expected text: where the numbers are from, found {}", shown(*source->value)));
  if (Map* map = value.map()) std::erase_if(*map, [](const Entry& entry) { return entry.key == "source"; });
  return value;
}

class Includer {
 public:
  Includer(Value& root, Diagnostics& diagnostics) : root_(root), diagnostics_(diagnostics) {}

  /// Takes over what an included document has.
  void take(const Value& document) {
    const Node node = Node::root(document);
    if (!node.expect_map(diagnostics_)) return;
    node.refuse_unknown_keys({"materials", "explosives"}, diagnostics_);
    if (const auto materials = node.find("materials"); materials && materials->expect_map(diagnostics_))
      for (const Node& entry : materials->entries()) take_material(entry);
    if (const auto explosives = node.find("explosives"); explosives && explosives->expect_map(diagnostics_))
      for (const Node& entry : explosives->entries()) take_explosive(entry);
  }

 private:
  void take_material(const Node& entry) {
    const Value material = without_source(*entry.value, entry, diagnostics_);
    const Value* own = root_.find("materials");
    if ((own && own->find(entry.key)) || !is_named(entry.key)) return;
    if (!own) root_.map()->push_back({"materials", entry.key_at, Value{Map{}, entry.key_at}});
    Value* materials = root_.find("materials");
    if (materials->list() && materials->list()->empty()) materials->data = Map{};  // of Lua
    if (Map* map = materials->map()) map->push_back({entry.key, entry.key_at, material});
  }

  /// Outside of the materials themselves.
  bool is_named(const std::string& material) const {
    const Map& map = *root_.map();
    return std::any_of(map.begin(), map.end(), [&](const Entry& entry) {
      return entry.key != "materials" && is_said_in(entry.value, material);
    });
  }

  void take_explosive(const Node& entry) {
    const Value explosive = without_source(*entry.value, entry, diagnostics_);
    Value* blast = root_.find("blast");
    Value* named = blast ? blast->find("explosive") : nullptr;
    if (named && named->text() && *named->text() == entry.key) *named = explosive;
  }

  Value& root_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::vector<Value> included_files(Value& root, const fs::path& folder, const fs::path& library,
                                  std::map<std::string, std::string>& files, Diagnostics& diagnostics) {
  const std::optional<Node> list = Node::root(root).find("include");
  std::vector<Value> documents;
  if (!list) return documents;
  for (const Node& item : list->expect_list(diagnostics) ? list->items() : std::vector<Node>()) {
    const std::string* name = item.value->text();
    if (!name || name->empty()) {
      item.error(diagnostics, fmt::format("expected the name of a file, found {}", shown(*item.value)));
      continue;
    }
    std::error_code code;
    fs::path path = folder / *name;
    if (!fs::exists(path, code)) path = library / *name;
    if (!fs::is_regular_file(path, code)) {
      item.error(diagnostics,
                 fmt::format("there is no file `{}` beside the scenario or in flyrock's library{}", *name,
                             suggestion(*name, files_in(library))));
      continue;
    }
    try {
      std::string text;
      FileReader(path.string()).append_to(text, most_yaml_bytes + 1);
      if (auto document = read_yaml(text, path.string(), diagnostics))
        documents.push_back(std::move(*document));
      files[*name] = path.string();
    } catch (const FileError& error) {
      item.error(diagnostics, error.what());
    }
  }
  std::erase_if(*root.map(), [](const Entry& entry) { return entry.key == "include"; });
  return documents;
}

void take_included(Value& root, const std::vector<Value>& files, Diagnostics& diagnostics) {
  Includer includer(root, diagnostics);
  for (const Value& file : files) includer.take(file);
}

}  // namespace flyrock
