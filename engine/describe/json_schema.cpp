#include "describe/json_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "describe/schema_values.h"
#include "plugin/gain.h"
#include "scenario/normalise_params.h"
#include "scenario/schema.h"
#include "scenario/sweep.h"

namespace flyrock::cli {

namespace {

using Json = SchemaValues::Json;

/// Which numbers of a section may be distributions.
using Varies = std::function<bool(const std::string&)>;
bool all_vary(const std::string&) { return true; }
bool none_varies(const std::string&) { return false; }

/// The keys of an object.
struct Keys {
  Json properties = Json::object();
  Json required = Json::array();

  void add(const std::string& name, Json schema, bool is_required = false) {
    properties[name] = std::move(schema);
    if (is_required) required.push_back(name);
  }
  Json object() const { return SchemaValues::object(properties, required); }
};

/// A section with a `type` that is no plugin.
struct OtherType {
  std::string type;
  Keys keys;
};

Json array_of(Json item, std::size_t least = 0) {
  Json list = {{"type", "array"}, {"items", std::move(item)}};
  if (least) list["minItems"] = least;
  return list;
}

/// Exactly one of these keys.
Json one_of(const std::vector<std::string>& keys) {
  Json branches = Json::array();
  for (const std::string& key : keys) branches.push_back({{"required", Json::array({key})}});
  return branches;
}

/// A name, which may be a number.
Json name_or_number() { return {{"type", Json::array({"string", "number"})}}; }

Json has(const std::string& key) { return {{"required", Json::array({key})}}; }

const ParamSpec& key_of_section(std::string_view section, std::string_view name) {
  const std::vector<ParamSpec>& keys = section_spec(section).keys;
  return *std::find_if(keys.begin(), keys.end(), [&](const ParamSpec& key) { return key.name == name; });
}

/// The schema of scenarios in 2D, or in 3D.
class DocumentSchema {
 public:
  DocumentSchema(const Registry& registry, SchemaValues& values, int dimension)
      : registry_(registry), values_(values), dimension_(dimension), coordinates_(dimension) {}

  Json document();

 private:
  ValuePlace place(bool varies) const { return {coordinates_, varies, may_sweep_}; }
  /// The name of a definition of this dimension.
  std::string named(const std::string& name) const { return fmt::format("{}_{}D", name, dimension_); }
  std::string section_name(const std::string& name) const;
  void put(Keys& keys, const ParamSpec& spec, bool varies);
  void put_section(Keys& keys, const std::string& name, const Varies& varies = none_varies);
  void put_earthworks(Keys& keys, const PluginSpec& spec);
  Keys section(const std::string& name, const Varies& varies = none_varies);
  void put_params(Keys& keys, const PluginSpec& plugin);
  void or_over_time(Keys& keys, const ParamSpec& spec);
  Json plugin(PluginKind kind, const Keys& beside = {}, const std::string& by_default = {},
              std::vector<OtherType> others = {});
  Json swept_section(const std::string& name, Json schema);

  Json terrain();
  Json zones();
  Json materials();
  Json between(const char* name);
  Json blast();
  Json branches();
  Json rocks();
  Json release();
  Json shape(bool of_table);
  Json turn();
  Json bodies();
  Json places(const std::string& name, const std::string& in_place_of_line);
  Json forest();
  Json observed();
  Json output();
  Json expect();
  Json answer();
  void define_parts();
  Json part(const char* name, const std::function<Json()>& make);

  const Registry& registry_;
  SchemaValues& values_;
  int dimension_;
  int coordinates_;  ///< of vectors
  bool may_sweep_ = false;
};

/// The section of this dimension.
std::string DocumentSchema::section_name(const std::string& name) const {
  if (dimension_ == 2) return name;
  for (const SectionSpec& spec : section_specs())
    if (spec.name == name + " 3D") return name + " 3D";
  return name;
}

void DocumentSchema::put(Keys& keys, const ParamSpec& spec, bool varies) {
  ValuePlace here = place(varies);
  if (spec.name == "name") here.may_sweep = false;  // names identify rows of results
  keys.add(spec.name, values_.parameter(spec, here), spec.required_in(dimension_));
}

/// The value of a key may be a table over time. Gravity is a vector there, too.
void DocumentSchema::or_over_time(Keys& keys, const ParamSpec& spec) {
  ParamSpec time;
  time.dimension = dimension::time;
  time.min = 0;
  Json of_row = values_.parameter(spec, place(false));
  if (spec.name == "gravity") {
    ParamSpec vector = spec;
    vector.type = ParamType::vector;
    vector.min.reset();
    of_row = {{"anyOf", Json::array({of_row, values_.parameter(vector, place(false))})}};
  }
  Json row = {{"type", "array"},
              {"items", Json::array({values_.parameter(time, place(false)), std::move(of_row)})},
              {"minItems", 2},
              {"maxItems", 2}};
  Json& value = keys.properties[spec.name];
  value = {
      {"anyOf", Json::array({std::move(value),
                             SchemaValues::object({{"table", array_of(std::move(row), 2)}}, {"table"})})}};
}

void DocumentSchema::put_section(Keys& keys, const std::string& name, const Varies& varies) {
  for (const ParamSpec& spec : section_spec(section_name(name)).keys) put(keys, spec, varies(spec.name));
}

Keys DocumentSchema::section(const std::string& name, const Varies& varies) {
  Keys keys;
  put_section(keys, name, varies);
  return keys;
}

/// The parameters of a plugin; those of a group are an object.
void DocumentSchema::put_params(Keys& keys, const PluginSpec& plugin) {
  const bool may_gain = plugin.find(allow_gain) >= 0;
  if (const auto bearing = bearing_beside(plugin.params)) put(keys, *bearing, true);
  for (std::size_t i = 0; i < plugin.params.size(); ++i) {
    ParamSpec spec = plugin.params[i];
    if (may_gain && is_limit_of_gain(plugin, spec)) spec.max.reset();  // allow_gain lifts it
    const std::string group(spec.group());
    if (group.empty()) {
      put(keys, spec, true);
      if (plugin.kind == PluginKind::friction && plugin.name == "coulomb" && spec.name == "mu")
        or_over_time(keys, spec);
      continue;
    }
    if (i > 0 && plugin.params[i - 1].group() == group) continue;
    Keys grouped;
    for (ParamSpec one : plugin.params)
      if (one.group() == group) {
        one.name = one.own_name();
        put(grouped, one, true);
      }
    keys.add(group, grouped.object());
  }
}

/// A use of a plugin of this kind: one branch for each type, with the keys `beside` in each.
Json DocumentSchema::plugin(PluginKind kind, const Keys& beside, const std::string& by_default,
                            std::vector<OtherType> others) {
  Json branches = Json::array(), known = Json::array();
  const auto branch = [&](const std::string& type, Keys keys, const std::string& doc) {
    known.push_back(type);
    keys.add("type", {{"const", type}}, type != by_default);
    Json schema = keys.object();
    if (!doc.empty()) schema["description"] = doc;
    branches.push_back(std::move(schema));
  };
  for (const Plugin* one : registry_.of_kind(kind)) {
    if (one->spec.dimension && one->spec.dimension != dimension_) {
      known.push_back(one->spec.name);
      continue;
    }
    Keys keys = beside;
    if (kind == PluginKind::terrain && dimension_ == 2) put_earthworks(keys, one->spec);
    put_params(keys, one->spec);
    branch(one->spec.name, std::move(keys), one->spec.doc);
  }
  for (OtherType& other : others) branch(other.type, std::move(other.keys), "");
  const Json own = {{"type", "string"}, {"not", {{"enum", known}}}};
  Json swept = {{"type", "object"}, {"required", Json::array({"sweep"})}};
  Json type = own;
  if (may_sweep_) type = {{"anyOf", Json::array({own, swept})}};
  branches.push_back({{"type", "object"},
                      {"properties", {{"type", type}}},
                      {"required", Json::array({"type"})},
                      {"description", fmt::format("a {} of your own", name_of(kind))}});
  return {{"oneOf", std::move(branches)}};
}

/// A definition of a section with a `type`, or a sweep of such sections.
Json DocumentSchema::swept_section(const std::string& name, Json schema) {
  const Json one = values_.define(named(name), std::move(schema));
  return values_.or_sweep(one, place(false));
}

/// A text of a rotation in 3D: about an axis, or a quaternion.
Json DocumentSchema::turn() {
  Json about_axis = section("orientation", all_vary).object();
  ParamSpec component;
  const Json number = values_.parameter(component, place(true));
  Json quaternion = array_of(number, 4);
  quaternion["maxItems"] = 4;
  return values_.define(named("orientation"),
                        {{"anyOf", Json::array({std::move(about_axis), std::move(quaternion)})}});
}

/// The parts of a compound.
void DocumentSchema::define_parts() {
  may_sweep_ = true;
  Keys beside = section("rocks.shape.parts", all_vary);
  if (dimension_ == 3) beside.add("turn", turn());
  Json parts = array_of(plugin(PluginKind::shape, beside), 1);
  parts["maxItems"] = 1000;
  values_.define(named("parts"), std::move(parts));
}

/// A ditch and a bund on the profile of a terrain that has none of its own.
void DocumentSchema::put_earthworks(Keys& keys, const PluginSpec& spec) {
  for (const char* key : {"ditch", "bund"})
    if (std::none_of(spec.params.begin(), spec.params.end(),
                     [&](const ParamSpec& param) { return param.group() == key; }))
      keys.add(key, section(fmt::format("terrain.{}", key)).object());
}

Json DocumentSchema::terrain() {
  Keys beside = section("terrain");
  beside.add("material", values_.or_sweep(SchemaValues::some_text(), place(false)));
  beside.add("materials",
             {{"type", "object"},
              {"additionalProperties", values_.or_sweep(SchemaValues::some_text(), place(false))}});
  beside.add("zones", zones());
  beside.add("faces", array_of(section("terrain.faces").object()));
  std::vector<OtherType> others;
  if (dimension_ == 2) {
    OtherType cut{"section", beside};
    put_section(cut.keys, "terrain: section");
    put_earthworks(cut.keys, {});
    cut.keys.add("of", SchemaValues::reference("ground_3D"), true);
    others.push_back(std::move(cut));
  } else {
    values_.define("ground_3D", plugin(PluginKind::terrain));
  }
  return swept_section("terrain", plugin(PluginKind::terrain, beside, "", std::move(others)));
}

Json DocumentSchema::zones() {
  if (dimension_ == 2) return array_of(section("terrain.zones").object());
  Json branches = Json::array();
  for (const char* key : {"polygon", "geojson", "raster", "group"})
    branches.push_back(section(fmt::format("terrain.zones: {}", key)).object());
  return array_of({{"oneOf", std::move(branches)}});
}

Json DocumentSchema::materials() {
  Keys material;
  for (const PluginKind kind :
       {PluginKind::restitution, PluginKind::friction, PluginKind::rolling, PluginKind::unilateral})
    material.add(std::string(name_of(kind)), swept_section(std::string(name_of(kind)), plugin(kind)));
  material.add("roughness", section("materials.roughness", all_vary).object());
  return {{"type", "object"},
          {"propertyNames", {{"pattern", "^[A-Za-z0-9_-]+$"}}},
          {"additionalProperties", material.object()}};
}

/// A list of what is between two.
Json DocumentSchema::between(const char* name) {
  Keys keys = section(name);
  Json two = array_of(SchemaValues::some_text(), 2);
  two["maxItems"] = 2;
  keys.add("between", std::move(two), true);
  return array_of(keys.object());
}

Json DocumentSchema::blast() {
  Keys keys = section("blast", all_vary);
  keys.add("explosive", {{"anyOf", Json::array({values_.or_sweep(SchemaValues::some_text(), place(false)),
                                                section("blast.explosive", all_vary).object()})}});
  keys.add("hole", section("blast.hole", all_vary).object());
  keys.add("rows", section("blast.rows").object());
  Keys table = section("blast.holes");
  table.add("columns", section("blast.holes.columns").object());
  Keys hole = section("blast.holes: list");
  hole.properties["hole"]["type"] = {"string", "number"};  // a name may be a number
  hole.properties["hole"].erase("anyOf");
  keys.add("holes", {{"anyOf", Json::array({table.object(), array_of(hole.object(), 1)})}});
  keys.add("scatter", section("blast.scatter", all_vary).object());
  Keys face = section("blast.face");
  face.add("columns", section("blast.face.columns").object());
  keys.add("face", face.object());
  return keys.object();
}

Json DocumentSchema::branches() {
  Keys keys = section("branches");
  keys.add("set", {{"type", "object"}, {"minProperties", 1}}, true);
  keys.add("holes", array_of(name_or_number(), 1));
  return array_of(keys.object());
}

Json DocumentSchema::release() {
  const std::string stem = "rocks.release: ";
  Json branches = Json::array();
  for (const SectionSpec& spec : section_specs()) {
    const std::string name(spec.name);
    if (!name.starts_with(stem)) continue;
    const bool is_3d = name.ends_with("3D");
    if (dimension_ == 2 ? is_3d : !is_3d && section_name(name) != name) continue;
    Keys keys;
    for (const ParamSpec& key : spec.keys) put(keys, key, true);
    branches.push_back(keys.object());
    if (keys.properties.contains("on_ground"))
      branches.back()["anyOf"] = Json::array({has("above_ground"), has("on_ground")});
  }
  return values_.define(named("release"), {{"oneOf", std::move(branches)}});
}

Json DocumentSchema::shape(bool of_table) {
  std::vector<OtherType> others;
  if (of_table) others.push_back({std::string(from_lengths), section("rocks.shape: from_lengths")});
  return swept_section(of_table ? "shape_of_rocks" : "shape",
                       plugin(PluginKind::shape, {}, "", std::move(others)));
}

/// A shape, or the name of one of `shapes`.
Json or_name(Json shape) { return {{"anyOf", Json::array({std::move(shape), SchemaValues::some_text()})}}; }

Json DocumentSchema::rocks() {
  Keys group = section("rocks", [](const std::string& key) { return key != "weight"; });
  group.add("columns", section("rocks.columns").object());
  for (const char* key : {"rows", "holes"}) group.add(key, array_of(name_or_number(), 1));
  group.add("air", {{"anyOf", Json::array({Json{{"const", "none"}}, section("air", all_vary).object()})}});
  group.add("shape", or_name(shape(true)));
  group.add("release", release());
  group.add("launch", swept_section("launch", plugin(PluginKind::velocity)));
  group.add("launch_by_size", section("rocks.launch_by_size", all_vary).object());
  if (dimension_ == 3) group.add("orientation", turn());
  Json use = plugin(PluginKind::population, group, std::string(default_population));
  for (Json& branch : use["oneOf"]) {
    branch["oneOf"] = one_of({"density", "mass"});
    if (branch["properties"]["type"].value("const", "") != default_population) continue;
    branch["required"].push_back("shape");  // other populations may decide both
    branch["anyOf"] = one_of({"release", "per_hole", "table"});
    branch["dependencies"] = {{"columns", Json::array({"table"})},
                              {"rows", Json::array({"per_hole"})},
                              {"holes", Json::array({"per_hole"})}};
  }
  return array_of(values_.define(named("rocks"), std::move(use)), 1);
}

Json DocumentSchema::bodies() {
  Keys keys = section("bodies", all_vary);
  or_over_time(keys, key_of_section(section_name("bodies"), "force"));
  Keys driven = section("bodies.driven");
  or_over_time(driven, key_of_section("bodies.driven", "velocity"));
  keys.add("driven", driven.object());
  keys.add("shape", or_name(shape(false)), true);
  if (dimension_ == 3) keys.add("orientation", turn());
  Json body = keys.object();
  Json fixed = {{"properties", {{"fixed", {{"const", true}}}}}, {"required", Json::array({"fixed"})}};
  body["anyOf"] = Json::array({has("density"), has("mass"), has("driven"), std::move(fixed)});
  body["not"] = {{"required", Json::array({"density", "mass"})}};
  return array_of(values_.define(named("body"), std::move(body)), 1);
}

/// A list of gates, barriers or exposures: in 3D at a place or along a line.
Json DocumentSchema::places(const std::string& name, const std::string& in_place_of_line) {
  Json one = section(name).object();
  if (dimension_ == 3) one["oneOf"] = one_of({in_place_of_line, "line"});
  return array_of(std::move(one));
}

Json DocumentSchema::forest() {
  Keys file = section("forest: file");
  file.add("columns", section("forest.columns").object());
  file.add("species", array_of(section("forest.species").object()));
  const Keys drawn = section("forest: density", [](const std::string& key) {
    return key == "diameter" || key == "height" || key == "turn";
  });
  return {{"oneOf", Json::array({file.object(), drawn.object()})}};
}

Json DocumentSchema::observed() {
  Keys keys = section("observed");
  keys.add("columns", section("observed.columns").object());
  return keys.object();
}

Json DocumentSchema::output() {
  Keys keys = section("output");
  keys.add("trajectories", section("output.trajectories").object());
  Keys series = section("output.series");
  series.add("bodies", array_of(SchemaValues::some_text()));
  series.add("regions", array_of(section("output.series.regions").object()));
  keys.add("series", series.object());
  keys.add("maps", {{"anyOf", Json::array({Json{{"type", "boolean"}}, section("output.maps").object()})}});
  return keys.object();
}

/// What measures are compared with: numbers in the unit of the measure, which the schema does not know.
Json compared() {
  return {{"anyOf",
           Json::array({Json{{"type", "number"}}, Json{{"type", "string"}, {"pattern", "^[+-]?[0-9.]"}}})}};
}

Json DocumentSchema::expect() {
  Keys keys = section("expect");
  for (const char* key : {"equals", "tolerance", "relative", "below", "above", "exact"})
    keys.add(key, compared());
  Json range = array_of(compared(), 2);
  range["maxItems"] = 2;
  keys.add("between", std::move(range));
  keys.add("at", {{"type", "object"}});
  Json one = keys.object();
  one["oneOf"] = one_of({"equals", "below", "above", "between"});
  one["dependencies"] = {{"tolerance", Json::array({"equals"})},
                         {"relative", Json::array({"equals"})},
                         {"order_in", Json::array({"exact"})},
                         {"exact", Json::array({"order_in"})}};
  return array_of(std::move(one));
}

Json DocumentSchema::answer() {
  Keys limit = section("answer.such_that");
  for (const char* key : {"below", "above"}) limit.add(key, compared());
  Json one = limit.object();
  one["oneOf"] = one_of({"below", "above"});
  Keys keys = section("answer");
  keys.add("such_that", array_of(std::move(one)));
  return keys.object();
}

/// A part of the document, in which sweeps stand where decoding takes them.
Json DocumentSchema::part(const char* name, const std::function<Json()>& make) {
  may_sweep_ = may_be_swept(std::string(name) + ".x");
  return make();
}

Json DocumentSchema::document() {
  define_parts();
  Keys keys;
  for (const ParamSpec& spec : section_spec("").keys) {
    may_sweep_ = may_be_swept(spec.name);
    put(keys, spec, spec.name == "gravity");
    if (spec.name == "gravity") or_over_time(keys, spec);
  }
  keys.properties["dimension"] = {{"const", dimension_}, {"description", "2: a vertical plane; 3: space"}};
  keys.properties["flyrock"] = {{"const", 1}, {"description", "format version"}};
  const auto add = [&](const char* name, bool is_required, const std::function<Json()>& make) {
    keys.add(name, part(name, make), is_required);
  };
  const auto plain = [&](const char* name, const Varies& varies = none_varies) {
    add(name, false, [&] { return section(name, varies).object(); });
  };
  add("include", false, [] { return array_of(SchemaValues::some_text()); });
  add("plugins", false, [] { return array_of(SchemaValues::some_text()); });
  plain("document");
  plain("air", all_vary);
  add("terrain", true, [&] { return terrain(); });
  add("materials", false, [&] { return materials(); });
  add("pairs", false, [&] { return between("pairs"); });
  add("blast", false, [&] { return blast(); });
  add("branches", false, [&] { return branches(); });
  add("shapes", false, [&] {
    return Json{{"type", "object"}, {"additionalProperties", plugin(PluginKind::shape)}};
  });
  add("rocks", false, [&] { return rocks(); });
  add("bodies", false, [&] { return bodies(); });
  add("links", false, [&] { return between("links"); });
  add("barriers", false, [&] { return places("barriers", "x"); });
  add("gates", false, [&] { return places("gates", "x"); });
  if (dimension_ == 3) add("forest", false, [&] { return forest(); });
  add("clearance", false, [&] {
    Json one = section("clearance").object();
    // The point about which sectors lie, and the kernel of the least area.
    one["dependencies"] = {
        {"x", Json::array({"sectors"})}, {"y", Json::array({"sectors"})}, {"radius", Json::array({"area"})}};
    return array_of(std::move(one));
  });
  add("exposure", false, [&] {
    coordinates_ = 2;  // places in plan
    Json list = places("exposure", "at");
    coordinates_ = dimension_;
    return list;
  });
  add("observed", false, [&] { return observed(); });
  plain("solver");
  plain("settle");
  add("start", false, [&] {
    Keys start = section("start");
    start.add("bodies", array_of(SchemaValues::some_text()));
    return start.object();
  });
  add("stop", true, [&] { return section("stop").object(); });
  add("output", false, [&] { return output(); });
  add("sweep", false, [&] {
    Keys of_sweep = section("sweep");
    of_sweep.add("rows", array_of({{"type", "object"}}));
    return of_sweep.object();
  });
  add("expect", false, [&] { return expect(); });
  add("answer", false, [&] { return answer(); });

  Json schema = keys.object();
  schema["oneOf"] = one_of({"rocks", "bodies"});
  schema["if"] = {{"properties", {{"method", {{"const", "ballistic"}}}}}};
  // What bounces and slides has materials.
  schema["else"] = {
      {"anyOf", Json::array({has("materials"), has("include")})},
      {"properties",
       {{"terrain", {{"anyOf", Json::array({has("material"), has("materials"), has("sweep")})}}}}}};
  return schema;
}

}  // namespace

nlohmann::ordered_json scenario_schema(const Registry& registry) {
  SchemaValues values;
  Json space = DocumentSchema(registry, values, 3).document();
  Json plane = DocumentSchema(registry, values, 2).document();
  const Json is_3d = {{"properties", {{"dimension", {{"const", 3}}}}},
                      {"required", Json::array({"dimension"})}};
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "A scenario of flyrock"},
          {"if", is_3d},
          {"then", values.define("scenario_3D", std::move(space))},
          {"else", values.define("scenario_2D", std::move(plane))},
          {"definitions", values.definitions()}};
}

}  // namespace flyrock::cli
