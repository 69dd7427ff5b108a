#include "scenario/normalise_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "document/workbook.h"
#include "document/yaml_reader.h"
#include "scenario/layer.h"
#include "scenario/normalise_params.h"
#include "scenario/table_cells.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_records = 10000;

std::vector<std::string> names_of_fields(const ParamSpec& spec) {
  std::vector<std::string> names;
  for (const ParamSpec& field : spec.fields) names.push_back(field.name);
  return names;
}

Value normalise_record(DecodeContext& context, const Node& node, const ParamSpec& spec,
                       const NumberRules& rules) {
  if (!node.expect_map(context.diagnostics)) return {};
  node.refuse_unknown_keys(names_of_fields(spec), context.diagnostics);
  Value record = map_value(normalise_params(context, node, spec.fields, rules));
  record.at = node.value->at;
  return record;
}

Value normalise_list(DecodeContext& context, const Node& node, const ParamSpec& spec,
                     const NumberRules& rules) {
  const std::vector<Node> items = node.items();
  if (items.empty() || items.size() > most_records) {
    node.error(context.diagnostics, fmt::format("has {} records, expected from 1 to {}: {}", items.size(),
                                                most_records, expected_text(spec)));
    return {};
  }
  List list;
  for (const Node& item : items) list.push_back(normalise_record(context, item, spec, rules));
  return list_value(std::move(list));
}

/// The list that a YAML file has under the name of the parameter.
Value read_yaml_file(DecodeContext& context, const Node& node, const ParamSpec& spec, const fs::path& path,
                     const NumberRules& rules) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  const std::optional<Value> document = read_yaml(text.str(), path.string(), context.diagnostics);
  if (!document) return {};
  const Value* found = document->find(spec.name);
  if (!found) {
    node.error(context.diagnostics, fmt::format("{} has no `{}`, expected {} under this name", path.string(),
                                                spec.name, expected_text(spec)));
    return {};
  }
  Node list = node;
  list.value = found;
  list.key_at = found->at;
  if (!list.expect_list(context.diagnostics)) return {};
  return normalise_list(context, list, spec, rules);
}

/// The records of a table. Its cells are numbers in SI units or texts.
Value read_table_file(DecodeContext& context, const Node& node, const ParamSpec& spec, const fs::path& path) {
  std::vector<TableColumn> columns = table_columns(spec.fields);
  for (std::size_t i = 0; i < columns.size(); ++i)
    columns[i].required = spec.fields[i].required_in(context.dimension);
  const auto table = read_table_of(context, spec.name, path.string(), columns, {}, node);
  if (!table) return {};
  List list;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    Map record;
    for (const ParamSpec& field : spec.fields) {
      if (field.type == ParamType::text) {
        const std::string_view text = table->text(row, field.name);
        if (!text.empty()) put(record, field.name, text_value(std::string(text)));
      } else if (const auto number = table->number(row, field.name)) {
        if (const std::string fault = fault_of_cell(*table, field, *number); !fault.empty())
          context.diagnostics.error(table->at(row, field.name), node.path,
                                    fmt::format("`{}` {}", field.name, fault));
        put(record, field.name, number_value(*number, field.dimension));
      } else if (field.default_number) {
        put(record, field.name, number_value(*field.default_number, field.dimension));
      }
    }
    list.push_back(map_value(std::move(record)));
    list.back().at = table->at(row, spec.fields.front().name);
  }
  return list_value(std::move(list));
}

Value read_records_file(DecodeContext& context, const Node& node, const ParamSpec& spec,
                        const NumberRules& rules) {
  const std::string name = sheet_name(*node.value->text()).file;
  const fs::path path = fs::path(context.folder) / name;
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    node.error(context.diagnostics, fmt::format("there is no file `{}` in the scenario's folder", name));
    return {};
  }
  context.files[name] = path.string();
  add_files_beside(context, name);
  const std::string ending = path.extension().string();
  if (ending == ".yaml" || ending == ".yml") return read_yaml_file(context, node, spec, path, rules);
  return read_table_file(context, node, spec, fs::path(context.folder) / *node.value->text());
}

}  // namespace

Value normalise_records(DecodeContext& context, const Node& node, const ParamSpec& spec,
                        const NumberRules& rules) {
  if (const std::string* text = node.value->text()) {
    if (std::find(spec.choices.begin(), spec.choices.end(), *text) != spec.choices.end())
      return text_value(*text);
    if (spec.from_file && !text->empty()) return read_records_file(context, node, spec, rules);
    node.error(context.diagnostics, fmt::format("expected {}, found {}{}", expected_text(spec),
                                                shown(*node.value), did_you_mean(*text, spec.choices)));
    return {};
  }
  if (spec.single && node.value->map()) {
    List one{normalise_record(context, node, spec, rules)};
    return one.front().is_null() ? Value{} : list_value(std::move(one));
  }
  if (node.value->is_null() || !node.is_list()) {
    node.error(context.diagnostics,
               node.value->is_null()
                   ? "is empty, expected " + expected_text(spec)
                   : fmt::format("expected {}, found {}", expected_text(spec), shown(*node.value)));
    return {};
  }
  if (spec.single && node.items().size() != 1) {
    node.error(context.diagnostics, "expected " + expected_text(spec));
    return {};
  }
  return normalise_list(context, node, spec, rules);
}

Value normalise_law(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  ParamSpec number = spec;
  number.type = ParamType::number;
  if (const std::optional<Node> per = node.find("per")) {
    per->error(context.diagnostics, "is not for this law, which is drawn anew each time that it is used");
    return {};
  }
  NumberRules rules;
  rules.varies = true;
  Value law = normalise_number(context, node, number, rules);
  if (Map* map = law.map()) std::erase_if(*map, [](const Entry& entry) { return entry.key == "per"; });
  return law;
}

}  // namespace flyrock
