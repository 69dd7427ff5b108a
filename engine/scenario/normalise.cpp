#include "scenario/normalise.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "scenario/decode.h"
#include "scenario/scenario.h"

namespace flyrock {

namespace {

constexpr NumberRules gravity_rules{
    .varies = true, .scope = Scope::trial, .finest = Scope::trial, .over_time = "gravity"};

/// Added to each hole in each trial.
constexpr NumberRules scatter_rules{.varies = true, .scope = Scope::hole, .finest = Scope::hole};

/// Rules for one field of the blast. The burden and the hole vary from hole to hole, the rest from trial to
/// trial.
NumberRules rules_of_field(std::string_view path) {
  const bool is_of_hole = path.starts_with("hole.") || path.starts_with("burden");
  return {.varies = true, .scope = is_of_hole ? Scope::hole : Scope::trial, .finest = Scope::rock};
}

class Normaliser {
 public:
  Normaliser(DecodeContext& context, const Node& root)
      : context_(context), diagnostics_(context.diagnostics), root_(root) {}

  Value normalise() {
    root_.refuse_unknown_keys(section_spec("").key_names(), diagnostics_);
    for (const ParamSpec& spec : section_spec("").keys) {
      const NumberRules rules = spec.name == "gravity" ? gravity_rules : NumberRules{};
      put_all(result_, normalise_params(context_, root_, {spec}, rules));
    }
    const Value keys = map_value(result_);
    if (const Value* dimension = keys.find("dimension"); dimension && si_of(*dimension) == 3)
      context_.dimension = 3;
    const Value* method = keys.find("method");
    const bool flies = method && method->text() && *method->text() == "ballistic";
    plugins();
    section("document", {});
    section("air", air_rules);
    put_part("terrain", true, [&](const Node& node) { return normalise_terrain(context_, node); });
    put_part("materials", !flies, [&](const Node& node) { return normalise_materials(context_, node); });
    put_part("pairs", false, [&](const Node& node) {
      return normalise_between(context_, node, "pairs", "two bodies, groups or parts of the terrain");
    });
    put_part("blast", false, [&](const Node& node) { return blast(node); });
    put_part("branches", false, [&](const Node& node) { return normalise_branches(context_, node); });
    read_shapes();
    put_part("rocks", false, [&](const Node& node) { return normalise_rocks(context_, node); });
    put_part("bodies", false, [&](const Node& node) { return normalise_bodies(context_, node); });
    put_part("links", false, [&](const Node& node) {
      return normalise_between(context_, node, "links", "two bodies, or of a body and `terrain`");
    });
    if (!root_.find("rocks") && !root_.find("bodies"))
      diagnostics_.error(root_.key_at, "", "`rocks` or `bodies` is missing");
    for (const char* name : {"barriers", "gates"})
      put_part(name, false, [&](const Node& node) {
        return normalise_list_of(context_, node, place_section(name, context_.dimension));
      });
    put_part("forest", false, [&](const Node& node) { return normalise_forest(context_, node); });
    put_part("clearance", false,
             [&](const Node& node) { return normalise_list_of(context_, node, "clearance"); });
    put_part("exposure", false, [&](const Node& node) { return exposures(node); });
    put_part("observed", false, [&](const Node& node) { return observed(node); });
    put_part_or_default("solver",
                        [&](const auto& node) { return normalise_section(context_, node, "solver", {}); });
    put_part("start", false, [&](const Node& node) { return with_bodies(node, "start"); });
    section("settle", {});
    put_part("stop", true, [&](const Node& node) { return normalise_section(context_, node, "stop", {}); });
    put_part_or_default("output", [&](const auto& node) { return output(node); });
    put_part("sweep", false, [&](const Node& node) { return sweep(node); });
    put_part("expect", false, [&](const Node& node) {
      return normalise_expectations(context_, node, measure_names(root_, context_.dimension));
    });
    put_part("answer", false, [&](const Node& node) {
      return normalise_answer(context_, node, measure_names(root_, context_.dimension));
    });
    Value tree = map_value(std::move(result_));
    tree.at = root_.value->at;
    return tree;
  }

 private:
  /// The rows stay as they are written: scenario/sweep_rows.h reads them before.
  Value sweep(const Node& node) {
    Value section = normalise_section(context_, node, "sweep", {});
    if (const auto rows = node.find("rows"); rows && section.map()) put(*section.map(), *rows, *rows->value);
    return section;
  }

  /// The shapes that groups and bodies name. They take their place in the normalised tree.
  void read_shapes() {
    const std::optional<Node> shapes = root_.find("shapes");
    if (!shapes || !shapes->expect_map(diagnostics_)) return;
    for (const Node& shape : shapes->entries()) {
      Value use = root_.find("bodies") ? normalise_shape_of_bodies(context_, shape)
                                       : normalise_shape_of_rocks(context_, shape);
      context_.shapes.emplace(shape.key, std::move(use));
    }
  }

  /// Places in plan have two coordinates, in 3D too.
  Value exposures(const Node& node) {
    const int dimension = std::exchange(context_.dimension, 2);
    Value list = normalise_list_of(context_, node, place_section("exposure", dimension));
    context_.dimension = dimension;
    return list;
  }

  template <class Part>
  void put_part(const char* key, bool is_required, Part&& part) {
    const std::optional<Node> node = root_.find(key);
    if (node) put(result_, *node, part(*node));
    if (!node && is_required) diagnostics_.error(root_.key_at, "", fmt::format("`{}` is missing", key));
  }

  /// A part that takes its defaults if it is not given.
  template <class Part>
  void put_part_or_default(const char* key, Part&& part) {
    const std::optional<Node> node = root_.find(key);
    Value value = part(node);
    if (node) return put(result_, *node, std::move(value));
    value.assumed = true;
    put(result_, key, std::move(value));
  }

  void section(const char* name, const NumberRules& rules) {
    put_part(name, false, [&](const Node& node) { return normalise_section(context_, node, name, rules); });
  }

  void plugins() {
    List list;
    for (const auto& [name, at] : plugin_files(*root_.value, diagnostics_)) list.push_back(text_value(name));
    put(result_, "plugins", list_value(std::move(list)));
  }

  Value observed(const Node& node) {
    Value observed = normalise_section(context_, node, "observed", {});
    if (observed.map()) put_columns(context_, *observed.map(), node, "observed.columns");
    return observed;
  }

  Value output(const std::optional<Node>& node) {
    Value output = normalise_section(context_, node, "output", {});
    const std::optional<Node> given = node ? node->find("trajectories") : std::nullopt;
    Value trajectories = normalise_section(context_, given, "output.trajectories", {});
    trajectories.assumed = !given;
    if (output.map() && given) put(*output.map(), *given, std::move(trajectories));
    if (output.map() && !given) put(*output.map(), "trajectories", std::move(trajectories));
    const std::optional<Node> over_time = node ? node->find("series") : std::nullopt;
    if (output.map() && over_time) put(*output.map(), *over_time, series(*over_time));
    const std::optional<Node> maps = node ? node->find("maps") : std::nullopt;
    if (output.map() && maps) put(*output.map(), *maps, map_settings(*maps));
    return output;
  }

  /// `true`, `false`, or a section.
  Value map_settings(const Node& node) {
    if (node.value->boolean()) return *node.value;
    const std::string* word = node.value->text();
    if (!word) return normalise_section(context_, node, "output.maps", {});
    node.error(diagnostics_, fmt::format("expected `true`, `false` or a map, found {}{}", shown(*node.value),
                                         did_you_mean(*word, {"true", "false"})));
    return {};
  }

  Value series(const Node& node) {
    Value section = with_bodies(node, "output.series");
    if (const auto regions = node.find("regions"); regions && section.map())
      put(*section.map(), *regions, normalise_list_of(context_, *regions, "output.series.regions"));
    return section;
  }

  /// A section with a list of names of bodies.
  Value with_bodies(const Node& node, const char* name) {
    Value section = normalise_section(context_, node, name, {});
    const std::optional<Node> bodies = node.find("bodies");
    if (!section.map() || !bodies || !bodies->expect_list(diagnostics_)) return section;
    List names;
    for (const Node& item : bodies->items()) {
      if (!item.value->text())
        item.error(diagnostics_, fmt::format("is {}, expected the name of a body", item.value->kind()));
      Value of_body = text_value(item.value->text() ? *item.value->text() : "");
      of_body.at = item.value->at;
      names.push_back(std::move(of_body));
    }
    put(*section.map(), *bodies, list_value(std::move(names)));
    return section;
  }

  Map fields(const Node& node, std::string_view section, std::string_view prefix) {
    Map map;
    for (const ParamSpec& spec : section_spec(section).keys)
      put_all(map, normalise_params(context_, node, {spec}, rules_of_field(std::string(prefix) + spec.name)));
    return map;
  }

  Value fields_of_part(const Node& node, std::string_view section, std::string_view prefix) {
    if (!node.expect_map(diagnostics_)) return {};
    node.refuse_unknown_keys(section_spec(section).key_names(), diagnostics_);
    return map_value(fields(node, section, prefix));
  }

  Value blast(const Node& node) {
    const SoundnessOf soundness(context_, node.path);
    if (!node.expect_map(diagnostics_)) return {};
    node.refuse_unknown_keys(section_spec("blast").key_names(), diagnostics_);
    Map map;
    if (const auto explosive = node.find("explosive"))
      put(map, *explosive,
          explosive->value->text() ? text_value(*explosive->value->text())
                                   : fields_of_part(*explosive, "blast.explosive", "explosive."));
    if (const auto hole = node.find("hole")) put(map, *hole, fields_of_part(*hole, "blast.hole", "hole."));
    put_all(map, fields(node, "blast", ""));
    if (const auto rows = node.find("rows"))
      put(map, *rows, normalise_section(context_, *rows, "blast.rows", {}));
    if (const auto holes = node.find("holes")) put(map, *holes, normalise_holes(context_, *holes));
    if (const auto scatter = node.find("scatter"))
      put(map, *scatter, normalise_section(context_, *scatter, "blast.scatter", scatter_rules));
    if (const auto face = node.find("face")) put(map, *face, face_of(*face));
    return map_value(std::move(map));
  }

  Value face_of(const Node& node) {
    Value face = normalise_section(context_, node, "blast.face", {});
    if (face.map()) put_columns(context_, *face.map(), node, "blast.face.columns");
    return face;
  }

  DecodeContext& context_;
  Diagnostics& diagnostics_;
  const Node& root_;
  Map result_;
};

}  // namespace

Value normalise(DecodeContext& context, const Node& root) { return Normaliser(context, root).normalise(); }

void put_columns(DecodeContext& context, Map& map, const Node& section, std::string_view columns_section) {
  if (const auto columns = section.find("columns"))
    put(map, *columns, normalise_section(context, *columns, columns_section, {}));
}

Value normalise_list_of(DecodeContext& context, const Node& node, const std::string& section) {
  return normalise_list(context, node,
                        [&](const Node& item) { return normalise_section(context, item, section, {}); });
}

Value normalise_names(DecodeContext& context, const Node& node, const char* expected) {
  List list;
  for (const Node& item : node.is_list() ? node.items() : std::vector<Node>()) {
    const double* number = item.value->number();
    if (!number && !item.value->text())
      item.error(context.diagnostics, fmt::format("expected {}, found {}", expected, shown(*item.value)));
    Value name = number               ? text_value(shortest(*number))
                 : item.value->text() ? text_value(*item.value->text())
                                      : Value{};
    name.at = item.value->at;
    list.push_back(std::move(name));
  }
  if (list.empty())
    node.error(context.diagnostics,
               fmt::format("expected a list of {}s, found {}", expected, shown(*node.value)));
  return list_value(std::move(list));
}

std::vector<std::string> element_names(const std::optional<Node>& list) {
  std::vector<std::string> names;
  if (!list) return names;
  for (const Node& item : list->items())
    if (const auto name = item.find("name"); name && name->value->text())
      names.push_back(*name->value->text());
  return names;
}

MeasureNames measure_names(const Node& root, int dimension) {
  MeasureNames names{.dimension = dimension,
                     .bodies = element_names(root.find("bodies")),
                     .links = element_names(root.find("links")),
                     .hinges = {},
                     .groups = element_names(root.find("rocks")),
                     .gates = element_names(root.find("gates")),
                     .barriers = element_names(root.find("barriers")),
                     .clearances = element_names(root.find("clearance")),
                     .with_factor = {},
                     .exposures = element_names(root.find("exposure")),
                     .forest = root.find("forest").has_value()};
  if (const auto output = root.find("output"))
    if (const auto series = output->find("series")) {
      names.series = true;
      names.regions = element_names(series->find("regions"));
    }
  if (const auto links = root.find("links"))
    for (const Node& item : links->items())
      if (const auto name = item.find("name"), type = item.find("type");
          name && name->value->text() && type && type->value->text() && *type->value->text() == "hinge")
        names.hinges.push_back(*name->value->text());
  if (const auto clearances = root.find("clearance"))
    for (const Node& item : clearances->items())
      if (const auto name = item.find("name"); name && name->value->text() && item.find("factor"))
        names.with_factor.push_back(*name->value->text());
  return names;
}

void refuse_duplicate_names(DecodeContext& context, const Node& list) {
  std::map<std::string, int> line_of;
  for (const Node& item : list.items()) {
    const std::optional<Node> name = item.find("name");
    if (!name || !name->value->text()) continue;
    const auto [first, is_new] = line_of.emplace(*name->value->text(), name->value->at.line);
    if (is_new) continue;
    const std::string place = first->second > 0 ? fmt::format(" (line {})", first->second) : "";
    name->error(context.diagnostics,
                fmt::format("the name `{}` is taken by an earlier element{}", first->first, place));
  }
}

}  // namespace flyrock
