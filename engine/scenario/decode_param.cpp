#include "scenario/decode_param.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "geometry/contactor.h"
#include "geometry/plan_zone.h"

namespace flyrock {

namespace {

void refuse(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::string expected = expected_text(spec);
  if (node.value->is_null()) return node.error(context.diagnostics, "is empty, expected " + expected);
  const bool is_name = spec.type == ParamType::choice && node.value->text();
  const std::string nearest = is_name ? nearest_name(*node.value->text(), spec.choices) : std::string();
  const std::string hint = nearest.empty() ? "" : fmt::format(", did you mean `{}`?", nearest);
  node.error(context.diagnostics, fmt::format("expected {}, found {}{}", expected, shown(*node.value), hint));
}

/// Whether a number may also be this word.
bool is_word_of(const ParamSpec& spec, const std::string& word) {
  return std::find(spec.choices.begin(), spec.choices.end(), word) != spec.choices.end();
}

void decode_boolean(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                    Value& resolved) {
  const bool* boolean = node.value->boolean();
  if (!boolean) return refuse(context, node, spec);
  value.numbers = {{*boolean ? 1.0 : 0.0, -1}};
  resolved.data = *boolean;
}

/// A choice of `off` and `on` also accepts false and true, as Lua writes them.
void decode_choice(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                   Value& resolved) {
  std::string text;
  if (const bool* boolean = node.value->boolean()) text = *boolean ? "on" : "off";
  if (node.value->text()) text = *node.value->text();
  if (std::find(spec.choices.begin(), spec.choices.end(), text) == spec.choices.end())
    return refuse(context, node, spec);
  value.text = text;
  resolved = text_value(text);
}

void decode_text(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                 Value& resolved) {
  const std::string* text = node.value->text();
  if (!text || (text->empty() && spec.required())) return refuse(context, node, spec);
  value.text = *text;
  resolved = text_value(*text);
}

/// Why a file cannot be read; empty if it can.
std::string file_fault(const std::filesystem::path& path, const std::string& name) {
  constexpr std::uintmax_t most_mebibytes = 4096;
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status))
    return fmt::format("there is no file `{}` in the scenario's folder", name);
  if (!std::filesystem::is_regular_file(status))
    return fmt::format("`{}` is a folder, a pipe or a device, expected a file", name);
  if (std::filesystem::file_size(path, code) > most_mebibytes << 20)
    return fmt::format("`{}` is larger than {} MiB", name, most_mebibytes);
  return {};
}

void decode_file(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                 Value& resolved) {
  const std::string* name = node.value->text();
  if (!name || name->empty()) return refuse(context, node, spec);
  const std::filesystem::path path = std::filesystem::path(context.folder) / *name;
  if (const std::string fault = file_fault(path, *name); !fault.empty())
    return node.error(context.diagnostics, fault);
  value.text = path.string();
  context.files[*name] = value.text;
  resolved = text_value(*name);
}

void decode_vector(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                   ParamValue& value, Value& resolved) {
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  const std::vector<Node> items = node.items();
  if (static_cast<int>(items.size()) != context.dimension)
    return node.error(context.diagnostics, fmt::format("has {} components, expected {} in {}D", items.size(),
                                                       context.dimension, context.dimension));
  ParamSpec component = spec;
  component.type = ParamType::number;
  List list;
  for (const Node& item : items) {
    std::optional<DecodedNumber> decoded = decode_number(context, item, component, rules);
    value.numbers.push_back(decoded ? decoded->number : Number{});
    if (decoded) list.push_back(std::move(decoded->resolved));
  }
  resolved = list_value(std::move(list));
}

/// A point [x, y] or [x, y, z]; empty if it is wrong, which is reported.
std::vector<double> decode_point(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::vector<Node> items = node.items();
  const int coordinates = spec.type == ParamType::plan_points ? 2 : context.dimension;
  if (static_cast<int>(items.size()) != coordinates) {
    node.error(context.diagnostics, fmt::format("expected a point of {} coordinates", coordinates));
    return {};
  }
  ParamSpec coordinate = spec;
  coordinate.type = ParamType::number;
  std::vector<double> point;
  for (const Node& item : items)
    if (auto si = decode_quantity(context, item, spec.dimension, {}, expected_text(coordinate)))
      point.push_back(*si);
  return point.size() == items.size() ? point : std::vector<double>();
}

/// The corners of a polygon in 3D, in coordinates of its own plane. Empty if they span no plane, or leave it
/// by more than a millionth of the polygon's size.
std::vector<Vec2> flattened(const std::vector<std::vector<double>>& points) {
  std::vector<Vec3> corners;
  for (const std::vector<double>& point : points) corners.emplace_back(point[0], point[1], point[2]);
  Vec3 twice_area = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice_area += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
    size = std::max(size, (corners[i] - corners[0]).norm());
  }
  if (twice_area.norm() <= 1e-12 * size * size) return {};
  const Vec3 normal = twice_area.normalized();
  const Eigen::Matrix3d frame = contact_frame(normal);
  std::vector<Vec2> flat;
  for (const Vec3& corner : corners) {
    const Vec3 p = frame.transpose() * (corner - corners[0]);
    if (std::abs(p[0]) > 1e-6 * size) return {};
    flat.emplace_back(p[1], p[2]);
  }
  return flat;
}

/// Why points are not the outline of a convex polygon; empty if they are.
std::string outline_fault(const std::vector<std::vector<double>>& points, int dimension) {
  std::vector<Vec2> vertices;
  if (dimension == 2)
    for (const std::vector<double>& point : points) vertices.emplace_back(point[0], point[1]);
  else if (vertices = flattened(points); vertices.empty())
    return "expected the corners of a polygon that lie in one plane and not on one line";
  return make_convex(vertices);
}

/// Decodes points. The points of a parameter called `inside`, and in 2D `vertices`, are the outline of a
/// convex polygon. They are checked here for every plugin, because their place in the file is known here.
void decode_points(DecodeContext& context, const Node& node, const ParamSpec& spec, ParamValue& value,
                   Value& resolved) {
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  List list;
  bool good = true;
  for (const Node& item : node.items()) {
    std::vector<double> point = decode_point(context, item, spec);
    good = good && !point.empty();
    List coordinates;
    for (double coordinate : point) coordinates.push_back(number_value(coordinate, spec.dimension));
    list.push_back(list_value(std::move(coordinates)));
    value.points.push_back(std::move(point));
  }
  const bool in_plan = spec.type == ParamType::plan_points;
  if (good && in_plan && (spec.name == "inside" || spec.name == "polygon")) {
    std::vector<Vec2> corners;
    for (const std::vector<double>& point : value.points) corners.emplace_back(point[0], point[1]);
    if (const std::string fault = polygon_fault(corners); !fault.empty())
      node.error(context.diagnostics, fault);
  }
  if (good && !in_plan && (spec.name == "inside" || (spec.name == "vertices" && context.dimension == 2)))
    if (const std::string fault = outline_fault(value.points, context.dimension); !fault.empty())
      node.error(context.diagnostics, fault);
  resolved = list_value(std::move(list));
}

}  // namespace

void decode_param(DecodeContext& context, const Node& node, const ParamSpec& spec, const NumberRules& rules,
                  ParamValue& value, Value& resolved) {
  value.given = true;
  switch (spec.type) {
    case ParamType::spin:
      if (context.dimension == 3) return decode_vector(context, node, spec, rules, value, resolved);
      [[fallthrough]];
    case ParamType::number:
      if (const std::string* word = node.value->text(); word && is_word_of(spec, *word)) {
        value.text = *word;
        resolved = text_value(*word);
        return;
      }
      [[fallthrough]];
    case ParamType::integer:
      if (std::optional<DecodedNumber> decoded = decode_number(context, node, spec, rules)) {
        value.numbers = {decoded->number};
        resolved = std::move(decoded->resolved);
      }
      return;
    case ParamType::boolean:
      return decode_boolean(context, node, spec, value, resolved);
    case ParamType::choice:
      return decode_choice(context, node, spec, value, resolved);
    case ParamType::text:
      return decode_text(context, node, spec, value, resolved);
    case ParamType::file:
      return decode_file(context, node, spec, value, resolved);
    case ParamType::vector:
      return decode_vector(context, node, spec, rules, value, resolved);
    case ParamType::points:
    case ParamType::plan_points:
      return decode_points(context, node, spec, value, resolved);
  }
}

bool take_default(const ParamSpec& spec, int dimension, ParamValue& value, Value& resolved) {
  if (spec.default_number && spec.type == ParamType::spin && dimension == 3) {
    value.numbers.assign(3, {*spec.default_number, -1});
    resolved = list_value(List(3, number_value(*spec.default_number, spec.dimension)));
  } else if (spec.default_number) {
    value.numbers = {{*spec.default_number, -1}};
    resolved = number_value(*spec.default_number, spec.dimension);
    if (spec.type == ParamType::boolean) resolved.data = *spec.default_number != 0;
  } else if (spec.default_text) {
    value.text = *spec.default_text;
    resolved = text_value(*spec.default_text);
  } else if (spec.default_vector) {
    List list;
    for (double component : *spec.default_vector) {
      value.numbers.push_back({component, -1});
      list.push_back(number_value(component, spec.dimension));
    }
    resolved = list_value(std::move(list));
  } else {
    return false;
  }
  value.given = true;
  return true;
}

}  // namespace flyrock
