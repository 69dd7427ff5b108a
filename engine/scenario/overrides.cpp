// `--set path=value`, `--seed` and `--trials`.

#include <fmt/format.h>

#include <charconv>

#include "document/node.h"
#include "document/yaml_reader.h"
#include "scenario/decode.h"
#include "units/units.h"

namespace flyrock {

namespace {

void relocate(Value& value, const Location& at) {
  value.at = at;
  if (List* list = value.list())
    for (Value& item : *list) relocate(item, at);
  if (Map* map = value.map())
    for (Entry& entry : *map) {
      entry.at = at;
      relocate(entry.value, at);
    }
}

/// The element of a list, found by its index or its `name`.
Value* find_item(List& list, const std::string& step) {
  for (Value& item : list)
    if (const Value* name = item.find("name"); name && name->text() && *name->text() == step) return &item;
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(step.data(), step.data() + step.size(), index);
  const bool is_index = code == std::errc() && end == step.data() + step.size();
  return is_index && index < list.size() ? &list[index] : nullptr;
}

std::vector<std::string> item_names(const List& list) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Value* name = list[i].find("name");
    names.push_back(name && name->text() ? *name->text() : std::to_string(i));
  }
  return names;
}

void apply(Value& root, const std::string& assignment, Diagnostics& diagnostics) {
  auto source = std::make_shared<Source>();
  source->name = "--set " + assignment;
  const Location at{source, 0, 0};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    return diagnostics.error(at, "", "expected path=value, as in --set terrain.height=10");
  const std::string path = assignment.substr(0, equals);
  if (path.find('[') != std::string::npos)
    return diagnostics.error(at, path,
                             "an element of a list is written with a dot: rocks.0.density, or by its name");
  Diagnostics reading;
  std::optional<Value> value = read_yaml(assignment.substr(equals + 1), source->name, reading);
  for (const Diagnostic& diagnostic : reading.all())
    diagnostics.error(at, path, "the value cannot be read: " + diagnostic.text);
  if (!value) return;
  relocate(*value, at);
  set_path(root, path, std::move(*value), at, diagnostics);
}

void set_number(Value& root, const char* key, std::uint64_t number, Diagnostics& diagnostics) {
  auto source = std::make_shared<Source>();
  source->name = fmt::format("--{} {}", key, number);
  const Location at{source, 0, 0};
  Value value{static_cast<double>(number), at};
  value.rounded = rounds_to_whole(std::to_string(number));
  set_path(root, key, std::move(value), at, diagnostics);
}

}  // namespace

void set_path(Value& root, const std::string& path, Value value, const Location& at,
              Diagnostics& diagnostics) {
  Value* place = &root;
  std::string done;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string step = path.substr(begin, end - begin);
    begin = end + 1;
    if (place->is_null() && place != &root) place->data = Map{};
    if (List* list = place->list(); list && !list->empty()) {
      Value* item = find_item(*list, step);
      if (!item)
        return diagnostics.error(
            at, path,
            fmt::format("{} has no element `{}`{}", done, step, suggestion(step, item_names(*list))));
      place = item;
    } else if (Map* map = place->map()) {
      if (!place->find(step)) map->push_back({step, at, Value{{}, at}});
      place = place->find(step);
    } else {
      return diagnostics.error(
          at, path,
          fmt::format("{} is {}, it has no `{}`", done.empty() ? "the document" : done, place->kind(), step));
    }
    done = join_path(done, step);
  }
  *place = std::move(value);
}

void apply_overrides(Value& root, const Overrides& overrides, Diagnostics& diagnostics) {
  for (const std::string& assignment : overrides.set) apply(root, assignment, diagnostics);
  if (overrides.seed) set_number(root, "seed", *overrides.seed, diagnostics);
  if (overrides.trials) set_number(root, "trials", *overrides.trials, diagnostics);
}

std::vector<std::pair<std::string, Location>> plugin_files(const Value& root, Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, Location>> files;
  const std::optional<Node> plugins = Node::root(root).find("plugins");
  if (!plugins || !plugins->expect_list(diagnostics)) return files;
  for (const Node& item : plugins->items()) {
    if (const std::string* name = item.value->text(); name && !name->empty())
      files.emplace_back(*name, item.value->at);
    else
      item.error(diagnostics,
                 fmt::format("expected the name of a file or folder, found {}", shown(*item.value)));
  }
  return files;
}

}  // namespace flyrock
