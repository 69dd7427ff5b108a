#include "scenario/layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "document/printable.h"
#include "document/wording.h"
#include "geometry/plan_line.h"
#include "geometry/plan_zone.h"
#include "plugin/params.h"
#include "scenario/normalise_params.h"
#include "scenario/schema.h"
#include "survey/vector_file.h"
#include "units/units.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

/// A value of `where` as an attribute is compared with it.
std::string text_of(const Value& value) {
  if (const std::string* text = value.text()) return *text;
  if (const bool* boolean = value.boolean()) return *boolean ? "true" : "false";
  if (const double* number = value.number()) return shortest(*number);
  return {};
}

bool is_equal(const std::string& attribute, const std::string& wanted) {
  if (attribute == wanted) return true;
  const auto a = parse_number(attribute), b = parse_number(wanted);
  return a && b && *a == *b;
}

void add_once(std::vector<std::string>& values, const std::string& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

/// "3 lines"
std::string count_text(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

constexpr const char* form_names[] = {"point", "line", "polygon"};

class LayerOf {
 public:
  LayerOf(DecodeContext& context, const Node& node) : context_(context), node_(node) {
    file_ = *node.find("layer")->value->text();
    const std::optional<Node> name = node.find("name");
    if (name) name_ = *name->value->text();
  }

  /// The parts that `where` leaves; nothing if something is wrong, which is reported. `crs`: of the places.
  std::optional<std::vector<VectorPart>> read(const std::string& crs) try {
    const fs::path path = fs::path(context_.folder) / file_;
    layer_ = read_vector_layer(
        path.string(), name_, crs,
        fmt::format("convert it with `ogr2ogr -t_srs EPSG:NUMBER layer.geojson {}`: zones take `geojson: "
                    "FILE`, and lines their points",
                    path.filename().string()));
    std::vector<VectorPart> parts = std::move(layer_.parts);
    if (const auto where = node_.find("where"))
      for (const Node& wanted : where->entries())
        if (!choose(parts, wanted)) return std::nullopt;
    if (parts.empty()) {
      refuse("has no feature");
      return std::nullopt;
    }
    return parts;
  } catch (const PluginError& error) {
    node_.error(context_.diagnostics, error.what());
    return std::nullopt;
  }

  /// Whether the layer has an attribute; if not, that is reported.
  bool has_attribute(const std::string& name) const {
    const bool has =
        std::find(layer_.attributes.begin(), layer_.attributes.end(), name) != layer_.attributes.end();
    if (!has)
      refuse(fmt::format("has no attribute `{}`{}", printable(name), suggestion(name, layer_.attributes)));
    return has;
  }

  void refuse(const std::string& text) const {
    node_.error(context_.diagnostics,
                fmt::format("{}: {} {}", file_,
                            layer_.name.empty() ? "it" : "`" + printable(layer_.name) + "`", text));
  }

  /// A line for `check`: what was read, and from which system.
  void tell(const std::string& what) {
    const std::string system = layer_.crs.empty()      ? "no system of its own"
                               : layer_.is_transformed ? fmt::format("{} made {}", layer_.crs, context_.crs)
                                                       : layer_.crs;
    std::string line = fmt::format("layer {} of {}: {}, {}", printable(layer_.name), file_, what, system);
    if (std::find(context_.tables.begin(), context_.tables.end(), line) == context_.tables.end())
      context_.tables.push_back(std::move(line));
  }

 private:
  /// Leaves the parts whose attribute has a value.
  bool choose(std::vector<VectorPart>& parts, const Node& wanted) const {
    if (!has_attribute(wanted.key)) return false;
    const std::string value = text_of(*wanted.value);
    std::vector<std::string> values;
    std::erase_if(parts, [&](const VectorPart& part) {
      const std::string* attribute = part.value_of(wanted.key);
      if (attribute && is_equal(*attribute, value)) return false;
      if (attribute) add_once(values, *attribute);
      return true;
    });
    if (parts.empty())
      refuse(fmt::format("has no feature whose `{}` is `{}`{}", printable(wanted.key), printable(value),
                         suggestion(value, values)));
    return !parts.empty();
  }

  DecodeContext& context_;
  const Node& node_;
  std::string file_, name_;
  VectorLayer layer_;
};

/// What points stand for: the outline of `inside`, the line of all others.
bool is_outline(const ParamSpec& spec) { return spec.name == "inside" || spec.name == "polygon"; }

bool is_closed(const std::vector<Vec3>& line) {
  return line.size() > 3 && line.front().head<2>() == line.back().head<2>();
}

/// The points of what a parameter takes: of one line, or of points in their order.
std::optional<std::vector<Vec3>> only_line(const LayerOf& layer, const std::vector<VectorPart>& parts,
                                           const ParamSpec& spec) {
  const bool all_points = std::all_of(parts.begin(), parts.end(),
                                      [](const VectorPart& p) { return p.form == FeatureForm::point; });
  if (all_points && parts.size() > 1) {
    std::vector<Vec3> places;
    for (const VectorPart& part : parts) places.push_back(part.lines.front().front());
    return places;
  }
  const VectorPart& first = parts.front();
  if (parts.size() > 1) {
    layer.refuse(fmt::format("has {} of these features, expected one {}: `where` chooses it by an attribute",
                             count_text(parts.size(), "part"), is_outline(spec) ? "polygon" : "line"));
    return std::nullopt;
  }
  if (is_outline(spec) ? first.form == FeatureForm::region || is_closed(first.lines.front())
                       : first.form == FeatureForm::line) {
    if (first.lines.size() > 1) {
      layer.refuse(
          "has a polygon with holes, expected one without: take it as a zone, and `zone: NAME` here");
      return std::nullopt;
    }
    std::vector<Vec3> places = first.lines.front();
    if (is_outline(spec) && first.form == FeatureForm::line) places.pop_back();
    return places;
  }
  layer.refuse(fmt::format("has a {}, expected a {}", form_names[static_cast<int>(first.form)],
                           is_outline(spec) ? "polygon" : "line"));
  return std::nullopt;
}

}  // namespace

void add_files_beside(DecodeContext& context, const std::string& file) {
  if (!lower(file).ends_with(".shp")) return;
  for (const char* ending : {"dbf", "shx", "prj", "cpg"}) {
    const fs::path beside = fs::path(file).replace_extension(ending);
    if (std::error_code code; fs::exists(fs::path(context.folder) / beside, code))
      context.files[beside.string()] = (fs::path(context.folder) / beside).string();
  }
}

bool is_layer(const Value& value) { return value.find("layer") != nullptr; }

Value normalise_layer(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const SectionSpec& keys = section_spec("layer");
  node.refuse_unknown_keys(keys.key_names(), context.diagnostics);
  const bool fits = spec.type == ParamType::plan_points || (context.dimension == 2 && spec.name == "points");
  if (!fits) {
    node.error(context.diagnostics,
               fmt::format("expected {}: a layer has places in plan", expected_text(spec)));
    return {};
  }
  const std::size_t errors = context.diagnostics.errors_given();
  Map map = normalise_params(context, node, keys.keys, {});
  if (const auto where = node.find("where")) {
    Map wanted;
    if (!where->expect_map(context.diagnostics)) return {};
    for (const Node& entry : where->entries()) {
      const std::string text = text_of(*entry.value);
      if (text.empty())
        entry.error(context.diagnostics, "expected the value of an attribute: a text or a number");
      put(wanted, entry, text_value(text));
    }
    put(map, *where, map_value(std::move(wanted)));
  }
  if (const auto each = node.find("each"); each && context.diagnostics.errors_given() == errors)
    each->error(
        context.diagnostics,
        "makes several zones, gates, barriers or exposures of one: here one feature is expected, which "
        "`where` chooses");
  if (context.diagnostics.errors_given() > errors) return {};
  add_files_beside(context, *node.find("layer")->value->text());
  return map_value(std::move(map));
}

std::vector<std::vector<double>> layer_points(DecodeContext& context, const Node& node,
                                              const ParamSpec& spec) {
  const bool is_profile = spec.type != ParamType::plan_points;
  LayerOf layer(context, node);
  const auto parts = layer.read(is_profile ? own_system : context.crs);
  if (!parts) return {};
  const auto places = only_line(layer, *parts, spec);
  if (!places) return {};
  if (is_profile && !parts->front().has_heights) {
    layer.refuse("has no heights, which a profile needs");
    return {};
  }
  layer.tell(count_text(places->size(), "point"));
  std::vector<std::vector<double>> points;
  std::vector<Vec2> plan;
  double distance = 0;
  for (const Vec3& place : *places) {
    if (!plan.empty()) distance += (place.head<2>() - plan.back()).norm();
    plan.emplace_back(place.head<2>());
    points.push_back(is_profile ? std::vector{distance, place.z()} : std::vector{place.x(), place.y()});
  }
  const std::string fault = is_profile            ? std::string()
                            : spec.name == "line" ? line_fault(plan)
                            : is_outline(spec)    ? polygon_fault(plan)
                                                  : std::string();
  if (fault.empty()) return points;
  layer.refuse(fault);
  return {};
}

std::vector<std::string> layer_values(DecodeContext& context, const Node& node,
                                      const std::string& attribute) {
  LayerOf layer(context, node);
  const auto parts = layer.read(any_system);
  std::vector<std::string> values;
  if (!parts || !layer.has_attribute(attribute)) return values;
  for (const VectorPart& part : *parts) {
    const std::string* value = part.value_of(attribute);
    if (!value || value->empty()) {
      layer.refuse(fmt::format("has a feature {} without `{}`: give it a value, or leave it out by `where`",
                               part.feature, printable(attribute)));
      return {};
    }
    add_once(values, *value);
  }
  return values;
}

std::vector<PlanPolygon> layer_region(DecodeContext& context, const Node& node) {
  LayerOf layer(context, node);
  const auto parts = layer.read(context.crs);
  std::vector<PlanPolygon> region;
  if (!parts) return region;
  for (const VectorPart& part : *parts) {
    const bool is_region =
        part.form == FeatureForm::region || (part.form == FeatureForm::line && is_closed(part.lines[0]));
    if (!is_region) {
      layer.refuse(fmt::format("has {}, expected polygons or closed lines",
                               part.form == FeatureForm::line ? "an open line" : "a point"));
      return {};
    }
    PlanPolygon polygon;
    for (const std::vector<Vec3>& line : part.lines) {
      PlanRing ring;
      for (const Vec3& place : line) ring.emplace_back(place.head<2>());
      if (ring.front() == ring.back()) ring.pop_back();
      if (const std::string wrong = polygon_fault(ring); !wrong.empty()) {
        layer.refuse(fmt::format("has a feature {} that is no region: {}", part.feature, wrong));
        return {};
      }
      if (polygon.outline.empty())
        polygon.outline = std::move(ring);
      else
        polygon.holes.push_back(std::move(ring));
    }
    region.push_back(std::move(polygon));
  }
  layer.tell(count_text(region.size(), "polygon"));
  return region;
}

}  // namespace flyrock
