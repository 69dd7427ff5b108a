#include "scenario/normalise_param.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "document/workbook.h"
#include "geometry/contactor.h"
#include "geometry/plan_line.h"
#include "geometry/plan_zone.h"
#include "scenario/layer.h"
#include "scenario/normalise_records.h"
#include "scenario/normalise_shapes.h"

namespace flyrock {

namespace {

/// Reports that a value is not what the parameter takes.
Value refuse(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::string expected = expected_text(spec);
  static const std::vector<std::string> booleans{"true", "false"};
  const std::vector<std::string>& names = spec.type == ParamType::boolean ? booleans : spec.choices;
  const bool is_name = !names.empty() && node.value->text();
  node.error(context.diagnostics, node.value->is_null()
                                      ? "is empty, expected " + expected
                                      : fmt::format("expected {}, found {}{}", expected, shown(*node.value),
                                                    is_name ? did_you_mean(*node.value->text(), names) : ""));
  return {};
}

/// Whether a number may also be this word, or a choice this text.
bool is_choice_of(const ParamSpec& spec, const std::string& text) {
  return std::find(spec.choices.begin(), spec.choices.end(), text) != spec.choices.end();
}

/// A choice of `off` and `on` also accepts false and true, as Lua writes them.
Value normalise_choice(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  std::string text;
  if (const bool* boolean = node.value->boolean()) text = *boolean ? "on" : "off";
  if (node.value->text()) text = *node.value->text();
  return is_choice_of(spec, text) ? text_value(text) : refuse(context, node, spec);
}

Value normalise_text(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::string* text = node.value->text();
  return text && !(text->empty() && spec.required()) ? text_value(*text) : refuse(context, node, spec);
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

Value normalise_file(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::string* name = node.value->text();
  if (!name || name->empty()) return refuse(context, node, spec);
  const std::string file = sheet_name(*name).file;
  const std::filesystem::path path = std::filesystem::path(context.folder) / file;
  if (const std::string fault = file_fault(path, file); !fault.empty()) {
    node.error(context.diagnostics, fault);
    return {};
  }
  context.files[file] = path.string();
  add_files_beside(context, file);
  return text_value(*name);
}

Value normalise_vector(DecodeContext& context, const Node& node, const ParamSpec& spec,
                       const NumberRules& rules) {
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  const std::vector<Node> items = node.items();
  if (static_cast<int>(items.size()) != context.dimension) {
    node.error(context.diagnostics,
               fmt::format("has {} component{}, expected {}", items.size(), items.size() == 1 ? "" : "s",
                           context.dimension == 2 ? "2: [x, y]" : "3: [x, y, z]"));
    return {};
  }
  ParamSpec component = spec;
  component.type = ParamType::number;
  List list;
  for (const Node& item : items) list.push_back(normalise_number(context, item, component, rules));
  return list_value(std::move(list));
}

/// A point [x, y] or [x, y, z]; empty if it is wrong, which is reported.
std::vector<double> point_of(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  const std::vector<Node> items = node.items();
  const int coordinates = spec.type == ParamType::plan_points ? 2 : context.dimension;
  if (static_cast<int>(items.size()) != coordinates) {
    node.error(context.diagnostics, fmt::format("expected a point of {} coordinates", coordinates));
    return {};
  }
  ParamSpec coordinate = spec;
  coordinate.type = ParamType::number;
  std::vector<double> point;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const auto si = quantity_of(context, items[k], spec.dimension, {}, expected_text(coordinate));
    if (!si) continue;
    const std::string fault = k < spec.fields.size() ? limit_fault(spec.fields[k], *si, *si) : std::string();
    if (fault.empty())
      point.push_back(*si);
    else
      items[k].error(context.diagnostics, fmt::format("is {}, {}", shown(*items[k].value), fault));
  }
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

/// The points of a parameter called `inside`, and in 2D `vertices`, are the outline of a convex polygon. They
/// are checked here for every plugin, because their place in the file is known here.
std::string points_fault(const std::vector<std::vector<double>>& points, const ParamSpec& spec,
                         int dimension) {
  if (spec.type == ParamType::plan_points) {
    std::vector<Vec2> corners;
    for (const std::vector<double>& point : points) corners.emplace_back(point[0], point[1]);
    if (spec.name == "line") return line_fault(corners);
    return spec.name == "inside" || spec.name == "polygon" ? polygon_fault(corners) : std::string();
  }
  const bool is_outline = spec.name == "inside" || (spec.name == "vertices" && dimension == 2);
  return is_outline ? outline_fault(points, dimension) : std::string();
}

Value normalise_points(DecodeContext& context, const Node& node, const ParamSpec& spec) {
  if (is_layer(*node.value)) return normalise_layer(context, node, spec);
  if (!node.is_list() || node.value->is_null()) return refuse(context, node, spec);
  List list;
  std::vector<std::vector<double>> points;
  bool good = true;
  for (const Node& item : node.items()) {
    points.push_back(point_of(context, item, spec));
    good = good && !points.back().empty();
    List coordinates;
    for (double coordinate : points.back()) coordinates.push_back(number_value(coordinate, spec.dimension));
    list.push_back(list_value(std::move(coordinates)));
  }
  if (good)
    if (const std::string fault = points_fault(points, spec, context.dimension); !fault.empty())
      node.error(context.diagnostics, fault);
  return list_value(std::move(list));
}

}  // namespace

Value normalise_param(DecodeContext& context, const Node& node, const ParamSpec& spec,
                      const NumberRules& rules) {
  switch (spec.type) {
    case ParamType::spin:
      if (context.dimension == 3) return normalise_vector(context, node, spec, rules);
      [[fallthrough]];
    case ParamType::number:
      if (const std::string* word = node.value->text(); word && is_choice_of(spec, *word))
        return text_value(*word);
      [[fallthrough]];
    case ParamType::integer:
      return normalise_number(context, node, spec, rules);
    case ParamType::boolean:
      return node.value->boolean() ? *node.value : refuse(context, node, spec);
    case ParamType::choice:
      return normalise_choice(context, node, spec);
    case ParamType::text:
      return normalise_text(context, node, spec);
    case ParamType::file:
      return normalise_file(context, node, spec);
    case ParamType::vector:
      return normalise_vector(context, node, spec, rules);
    case ParamType::points:
    case ParamType::plan_points:
      return normalise_points(context, node, spec);
    case ParamType::shapes:
      return normalise_shapes(context, node, rules);
    case ParamType::records:
      return normalise_records(context, node, spec, rules);
    case ParamType::law:
      return normalise_law(context, node, spec);
  }
  return {};
}

std::optional<Value> default_value(const ParamSpec& spec, int dimension) {
  if (spec.default_text) return text_value(*spec.default_text);
  if (spec.default_vector) {
    if (static_cast<int>(spec.default_vector->size()) != dimension) return std::nullopt;  // of another one
    List list;
    for (double component : *spec.default_vector) list.push_back(number_value(component, spec.dimension));
    return list_value(std::move(list));
  }
  if (!spec.default_number) return std::nullopt;
  Value value = number_value(*spec.default_number, spec.dimension);
  if (spec.type == ParamType::boolean) value.data = *spec.default_number != 0;
  if (spec.type == ParamType::spin && dimension == 3) return list_value(List(3, value));
  return value;
}

}  // namespace flyrock
