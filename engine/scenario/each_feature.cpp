#include "scenario/each_feature.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scenario/layer.h"

namespace flyrock {

namespace {

/// The part of a name that a value gives.
std::string name_of_value(std::string value) {
  for (char& c : value)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
  return value;
}

/// The layer with `each` that an entry has; null: none.
Value* layer_of_each(Value& item) {
  for (const char* key : {"line", "polygon"}) {
    Value* layer = item.find(key);
    if (layer && is_layer(*layer) && layer->find("each")) return layer;
  }
  return nullptr;
}

/// The entry for one value of the attribute.
Value entry_of(const Value& item, const std::string& attribute, const std::string& value) {
  Value entry = item;
  Value& name = *entry.find("name");
  name.data = *name.text() + "_" + name_of_value(value);
  Value& layer = *layer_of_each(entry);
  Map& keys = *layer.map();
  const Location at = layer.find("each")->at;
  std::erase_if(keys, [](const Entry& key) { return key.key == "each"; });
  if (!layer.find("where")) keys.push_back({"where", at, {.data = Map(), .at = at}});
  Map& where = *layer.find("where")->map();
  std::erase_if(where, [&](const Entry& key) { return key.key == attribute; });
  where.push_back({attribute, at, {.data = value, .at = at}});
  return entry;
}

/// Whether the values can be asked for. If not, the entry is left to normalise, which says what is wrong.
bool is_complete(const Value& item, const Value& layer, const std::string& folder) {
  const Value *name = item.find("name"), *where = layer.find("where"), *layer_name = layer.find("name");
  const std::string* file = layer.find("layer")->text();
  std::error_code code;
  return name && name->text() && layer.find("each")->text() && (!layer_name || layer_name->text()) &&
         (!where || where->map()) && file &&
         std::filesystem::is_regular_file(std::filesystem::path(folder) / *file, code);
}

void expand_list(Value& root, const std::string& path, DecodeContext& context) {
  Value* list = &root;
  for (std::size_t begin = 0; list && begin < path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    list = list->find(path.substr(begin, end - begin));
    begin = end + 1;
  }
  if (!list || !list->list()) return;
  List expanded;
  for (const Node& item : node_at(root, path).items()) {
    Value copy = *item.value;
    const Value* layer = layer_of_each(copy);
    if (!layer || !is_complete(copy, *layer, context.folder)) {
      expanded.push_back(std::move(copy));
      continue;
    }
    const std::string attribute = *layer->find("each")->text();
    const std::optional<Node> place = item.find(copy.find("line") == layer ? "line" : "polygon");
    for (const std::string& value : layer_values(context, *place, attribute))
      expanded.push_back(entry_of(copy, attribute, value));
  }
  *list->list() = std::move(expanded);
}

}  // namespace

void expand_each_feature(Value& root, DecodeContext& context) {
  for (const char* path : {"terrain.zones", "gates", "barriers", "exposure"})
    expand_list(root, path, context);
}

}  // namespace flyrock
