#include "scenario/decode_face.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "document/table.h"
#include "geometry/terrain_shape.h"
#include "plugin/models.h"
#include "scenario/leaning_holes.h"
#include "scenario/table_cells.h"
#include "survey/point_cloud.h"

namespace flyrock {

namespace {

constexpr std::array face_sources = {"mesh", "points", "profiles"};
constexpr int curve_steps = 50;

bool is_known_field(const Blast& blast, BlastField field) { return !std::isnan(blast[field]); }

/// The mesh of a file, read as a terrain of triangles is.
std::unique_ptr<const FaceSurvey> survey_of_mesh(DecodeContext& context, const Node& node,
                                                 const std::string& file) {
  const Plugin* plugin = context.registry.find(PluginKind::terrain, "mesh");
  if (!plugin) return nullptr;
  PluginUse use;
  use.plugin = plugin;
  use.path = node.path;
  for (const ParamSpec& spec : plugin->spec.params) {
    ParamValue& value = use.values.emplace_back();
    value.text = spec.name == "file" ? file : spec.default_text.value_or("");
    if (spec.default_number) value.numbers = {{*spec.default_number, -1}};
    value.given = true;
  }
  use.slots = dense_slots(use.values);
  try {
    const auto model = make_instance<TerrainModel>(use, 3);
    std::vector<double> values;
    for (const Number& number : use.slots) values.push_back(number.constant);
    RandomStream rng(0, "face", {});
    const TerrainShape3 shape = model->build_3d(values, rng);
    return std::make_unique<const FaceSurvey>(std::get<Mesh>(shape));
  } catch (const std::exception& error) {
    node.error(context.diagnostics, error.what());
    return nullptr;
  }
}

std::vector<TableColumn> point_columns() {
  std::vector<TableColumn> columns;
  for (const char* name : {"x", "y", "z"})
    columns.push_back({.name = name, .dimension = dimension::length, .required = true});
  return columns;
}

/// The heads of `columns` that a table with these columns has: a face may have several tables.
std::map<std::string, std::string> heads_among(std::map<std::string, std::string> heads,
                                               const std::vector<TableColumn>& columns) {
  std::erase_if(heads, [&](const auto& head) {
    return std::none_of(columns.begin(), columns.end(),
                        [&](const TableColumn& column) { return column.name == head.first; });
  });
  return heads;
}

/// The points of a scan of the face; empty if something is wrong, which is reported.
std::vector<Vec3> points_of_cloud(DecodeContext& context, const Node& node, const std::string& file,
                                  std::optional<int> of_class) {
  try {
    PointCloud cloud = read_point_cloud("points", file, of_class);
    if (!cloud.plan_unit.empty() && cloud.plan_unit != "m")
      throw PluginError(
          fmt::format("points: {}: its coordinates are in feet, expected metres: `pdal` projects it", file));
    context.tables.push_back(fmt::format("points of the face of {}: {} of {} points", *node.value->text(),
                                         cloud.points.size(), cloud.all));
    return std::move(cloud.points);
  } catch (const PluginError& error) {
    node.error(context.diagnostics, error.what());
    return {};
  }
}

std::unique_ptr<const FaceSurvey> survey_of_points(DecodeContext& context, const Node& node,
                                                   const std::string& file,
                                                   const std::map<std::string, std::string>& heads,
                                                   std::optional<int> of_class) {
  std::vector<Vec3> points;
  if (is_point_cloud(file)) {
    points = points_of_cloud(context, node, file, of_class);
    if (points.empty()) return nullptr;
  } else {
    if (of_class) node.error(context.diagnostics, "is a table, which has no classes: leave `class` out");
    const auto table = read_table_of(context, "points of the face", file, point_columns(), heads, node);
    if (!table) return nullptr;
    for (std::size_t row = 0; row < table->rows(); ++row)
      points.emplace_back(*table->number(row, "x"), *table->number(row, "y"), *table->number(row, "z"));
  }
  try {
    return std::make_unique<const FaceSurvey>(points);
  } catch (const std::invalid_argument& error) {
    node.error(context.diagnostics, error.what());
    return nullptr;
  }
}

/// The depths from `from` to `to` where the burden is not known, as text: "7.2 to 8 m"; empty if it is.
std::string unknown_depths(const BurdenCurve& curve, double from, double to) {
  std::string text;
  for (std::size_t i = 0; i < curve.depth.size();) {
    std::size_t end = i;
    while (end < curve.depth.size() && !curve.is_known[end]) ++end;
    if (end == i) {
      ++i;
      continue;
    }
    const double low = std::max(curve.depth[i], from), high = std::min(curve.depth[end - 1], to);
    if (low < high) text += fmt::format("{}{:.2f} to {:.2f} m", text.empty() ? "" : ", ", low, high);
    i = end;
  }
  return text;
}

std::vector<double> depths_of_curve(double length) {
  std::vector<double> depths;
  for (int i = 0; i <= curve_steps; ++i) depths.push_back(length * i / curve_steps);
  return depths;
}

}  // namespace

Vec3 FaceOfBlast::Axis::at(double depth) const {
  if (track.empty()) return collar + depth * direction;
  const auto after =
      std::find_if(track.begin(), track.end(), [&](const AtDepth& p) { return p.depth > depth; });
  const auto last = std::max(after == track.end() ? after - 1 : after, track.begin() + 1);
  const AtDepth &a = *(last - 1), &b = *last;
  return a.place + (depth - a.depth) / (b.depth - a.depth) * (b.place - a.place);
}

std::vector<Vec3> FaceOfBlast::Axis::between(double from, double to) const {
  std::vector<Vec3> line{at(from)};
  for (const AtDepth& corner : track)
    if (corner.depth > from && corner.depth < to) line.push_back(corner.place);
  line.push_back(at(to));
  return line;
}

FaceOfBlast::Axis FaceOfBlast::axis_of(const Hole& hole, BlastWriter& blast) const {
  Axis axis;
  if (const auto found = tracks_.find(hole.name); found != tracks_.end()) {
    axis.track = found->second;
    if (axis.track.front().depth > 0 && !std::isnan(hole.x + hole.y + hole.z))
      axis.track.insert(axis.track.begin(), {0, Vec3(hole.x, hole.y, hole.z), 0});
    if (axis.track.size() < 2) throw std::invalid_argument("its track has one place, expected two or more");
    return axis;
  }
  if (survey_ && std::isnan(hole.x + hole.y + hole.z))
    throw std::invalid_argument("needs `x`, `y` and `z` of its collar for its distance to the face");
  if (!std::isnan(hole.x + hole.y + hole.z)) axis.collar = Vec3(hole.x, hole.y, hole.z);
  const bool leans =
      blast.has(BlastField::hole_dip) && std::abs(blast.read(BlastField::hole_dip) - pi / 2) > 1e-9;
  const bool deviates = blast.read_or_zero(BlastField::hole_deviation) != 0;
  const double azimuth = blast.read(BlastField::hole_azimuth);
  if (!leans && !deviates) return axis;
  if (std::isnan(azimuth))
    throw std::invalid_argument(
        fmt::format("has a `{}`, which needs its `azimuth`, or a `track`", leans ? "dip" : "deviation"));
  const Vec3 toward(std::cos(azimuth), std::sin(azimuth), 0);
  const double dip = blast[BlastField::hole_dip], deviation = blast[BlastField::hole_deviation];
  axis.direction = leans ? Vec3(std::cos(dip) * toward - std::sin(dip) * Vec3::UnitZ())
                         : Vec3((deviation * toward - Vec3::UnitZ()).normalized());
  return axis;
}

/// The horizontal direction at right angles to the row of a hole, to the side to which it leans.
Vec3 FaceOfBlast::across_row(const Hole& hole, BlastWriter& blast, const std::vector<Hole>& holes) const {
  const double azimuth = blast.read_or_zero(BlastField::hole_azimuth);
  const Vec3 toward(std::cos(azimuth), std::sin(azimuth), 0);
  Vec3 farthest = Vec3::Zero();
  for (const Hole& other : holes) {
    const Vec3 along(other.x - hole.x, other.y - hole.y, 0);
    if (other.row == hole.row && along.allFinite() && along.norm() > farthest.norm()) farthest = along;
  }
  if (farthest.norm() == 0) return toward;
  const Vec3 across = Vec3(farthest.y(), -farthest.x(), 0).normalized();
  return across.dot(toward) < 0 ? Vec3(-across) : across;
}

BurdenCurve FaceOfBlast::curve_of_survey(const Axis& axis, const Blast& blast) const {
  BurdenCurve curve;
  for (const double depth : depths_of_curve(blast[BlastField::hole_length])) {
    const FaceSurvey::Nearest nearest = survey_->nearest(axis.at(depth));
    curve.depth.push_back(depth);
    curve.burden.push_back(nearest.distance);
    curve.is_known.push_back(nearest.is_inside);
  }
  return curve;
}

BurdenCurve FaceOfBlast::curve_of_profile(const Hole& hole, const Axis& axis, const Blast& blast,
                                          const Vec3& across) const {
  const std::vector<AtDepth>& profile = profiles_.at(hole.name);
  BurdenCurve curve;
  for (const double depth : depths_of_curve(blast[BlastField::hole_length])) {
    double least = infinite;
    for (std::size_t i = 1; i < profile.size(); ++i) {
      const auto place = [&](const AtDepth& p) { return Vec3(axis.at(p.depth) + p.distance * across); };
      const Vec3 here = axis.at(depth);
      least = std::min(least, segment_distance(here, here, place(profile[i - 1]), place(profile[i])));
    }
    curve.depth.push_back(depth);
    curve.burden.push_back(least);
    curve.is_known.push_back(depth >= profile.front().depth && depth <= profile.back().depth);
  }
  return curve;
}

void FaceOfBlast::put_burden(std::size_t index, Blast& completed, BlastPlan& plan) const {
  Hole& hole = plan.pattern.measured[index];
  int front = hole.row;
  for (const Hole& other : plan.pattern.measured) front = std::min(front, other.row);
  plan.face->curves.resize(plan.pattern.measured.size());
  if (hole.row != front) return;  // its rock moves towards the row in front
  if (!survey_ && !profiles_.contains(hole.name)) throw std::invalid_argument("has no profile of the face");
  if (!is_known_field(completed, BlastField::hole_length) ||
      !is_known_field(completed, BlastField::hole_stemming))
    throw std::invalid_argument(
        "needs two of its length, stemming and charge_length for its distance to the face");
  BlastWriter writer(completed, &plan.sources[index]);
  const Axis axis = axis_of(hole, writer);
  const std::vector<Vec3> charge =
      axis.between(writer.read(BlastField::hole_stemming), writer.read(BlastField::hole_length));
  double least = infinite;
  BurdenCurve& curve = plan.face->curves[index];
  if (survey_) {
    least = survey_->distance_to(charge);
    curve = curve_of_survey(axis, completed);
  } else {
    const Vec3 across = across_row(hole, writer, plan.pattern.measured);
    const std::vector<AtDepth>& profile = profiles_.at(hole.name);
    for (std::size_t i = 1; i < profile.size(); ++i)
      for (std::size_t k = 1; k < charge.size(); ++k)
        least =
            std::min(least, segment_distance(charge[k - 1], charge[k],
                                             axis.at(profile[i - 1].depth) + profile[i - 1].distance * across,
                                             axis.at(profile[i].depth) + profile[i].distance * across));
    curve = curve_of_profile(hole, axis, completed, across);
  }
  curve.charge_from = completed[BlastField::hole_stemming];
  curve.charge_to = completed[BlastField::hole_length];
  if (!(least > 0)) throw std::invalid_argument("its charge reaches the face: the least distance is 0 m");
  hole.own[BlastField::burden] = least;
  writer.put(BlastField::burden, least);
}

bool FaceOfBlast::leans_away(const Hole& hole, const Blast& completed) const {
  const std::optional<Vec2> lean = lean_of(completed);
  const Vec3 collar(hole.x, hole.y, hole.z);
  if (!survey_ || !lean || !collar.allFinite() || tracks_.contains(hole.name)) return false;
  const Vec3 below = collar - completed[BlastField::hole_length] / 2 * Vec3::UnitZ();
  constexpr double step = 0.5;  // m
  const Vec3 beside = below + step * Vec3(lean->x(), lean->y(), 0);
  return survey_->nearest(beside).distance > survey_->nearest(below).distance;
}

std::unique_ptr<const FaceOfBlast> read_face(DecodeContext& context, const Node& blast, BlastPlan& plan) {
  const std::optional<Node> node = blast.find("face");
  if (!node || !node->value->map()) return nullptr;
  const Section section = decode_section(context, *node, "blast.face");
  std::vector<std::string> given;
  for (const char* source : face_sources)
    if (section.given(source)) given.emplace_back(source);
  if (given.size() != 1) {
    node->error(context.diagnostics,
                given.empty() ? "expected one of `mesh`, `points` and `profiles`"
                              : fmt::format("has `{}` and `{}`, expected one of them", given[0], given[1]));
    return nullptr;
  }
  const std::size_t before = context.diagnostics.errors_given();
  auto face = std::make_unique<FaceOfBlast>();
  // Rows by hole: a depth, and a distance or a place.
  const std::map<std::string, std::string> heads = heads_of(*node);
  const auto read_depths = [&](const char* key, std::vector<std::string> numbers, auto& to) {
    std::vector<TableColumn> columns{
        {.name = "hole", .dimension = dimension::none, .is_text = true, .required = true}};
    for (const std::string& name : numbers)
      columns.push_back({.name = name, .dimension = dimension::length, .required = true});
    const Node at = *node->find(key);
    const auto table =
        read_table_of(context, key, section.text(key), columns, heads_among(heads, columns), at);
    if (!table) return;
    for (std::size_t row = 0; row < table->rows(); ++row) {
      const std::string name(table->text(row, "hole"));
      const auto is_it = [&](const Hole& hole) { return hole.name == name; };
      if (std::none_of(plan.pattern.measured.begin(), plan.pattern.measured.end(), is_it)) {
        context.diagnostics.error(table->at(row, "hole"), at.path,
                                  fmt::format("there is no hole `{}`", name));
        continue;
      }
      FaceOfBlast::AtDepth entry{*table->number(row, "depth")};
      if (const auto distance = table->number(row, "distance")) entry.distance = *distance;
      if (table->has("x"))
        entry.place = {*table->number(row, "x"), *table->number(row, "y"), *table->number(row, "z")};
      auto& rows = to[name];
      if (!rows.empty() && !(entry.depth > rows.back().depth))
        context.diagnostics.error(table->at(row, "depth"), at.path,
                                  fmt::format("the depths of hole {} do not grow: {:.6g} m after {:.6g} m",
                                              name, entry.depth, rows.back().depth));
      rows.push_back(entry);
    }
    for (const auto& [name, rows] : to)
      if (rows.size() < 2 && std::string_view(key) == "profiles")
        at.error(context.diagnostics,
                 fmt::format("the profile of hole {} has one place, expected two or more", name));
  };
  if (section.given("track")) read_depths("track", {"depth", "x", "y", "z"}, face->tracks_);
  if (given[0] == "mesh") face->survey_ = survey_of_mesh(context, *node->find("mesh"), section.text("mesh"));
  if (given[0] == "points")
    face->survey_ = survey_of_points(
        context, *node->find("points"), section.text("points"), heads_among(heads, point_columns()),
        section.given("class") ? std::optional(section.integer("class")) : std::nullopt);
  if (given[0] == "profiles") read_depths("profiles", {"depth", "distance"}, face->profiles_);
  if (context.diagnostics.errors_given() != before) return nullptr;
  SurveyedFace& facts = plan.face.emplace();
  if (face->survey_) {
    facts.noise = face->survey_->noise();
    facts.error = face->survey_->error_of_least();
  }
  return face;
}

void warn_of_gaps(DecodeContext& context, const Node& blast, const BlastPlan& plan) {
  const Node node = *blast.find("face");
  constexpr int most_named = 10;
  int named = 0, others = 0;
  for (std::size_t i = 0; i < plan.face->curves.size(); ++i) {
    const BurdenCurve& curve = plan.face->curves[i];
    if (curve.depth.empty()) continue;
    const Blast& hole = plan.holes[i];
    const double floor =
        curve.charge_to -
        (is_known_field(hole, BlastField::hole_subdrilling) ? hole[BlastField::hole_subdrilling] : 0.0);
    const std::string depths = unknown_depths(curve, curve.charge_from, floor);
    if (depths.empty()) continue;
    if (++named > most_named) {
      ++others;
      continue;
    }
    context.diagnostics.warning(
        node.key_at, node.path,
        fmt::format(
            "the survey ends beside hole {}, at depths of {} along its charge: its burden may be less there",
            plan.pattern.measured[i].name, depths));
  }
  if (others > 0)
    context.diagnostics.warning(node.key_at, node.path,
                                fmt::format("the survey ends beside {} more holes", others));
}

}  // namespace flyrock
