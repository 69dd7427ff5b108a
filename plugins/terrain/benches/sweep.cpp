#include "plugins/terrain/benches/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plugin/params.h"

namespace flyrock::plugins {

namespace {

constexpr std::size_t most_vertices = 4'000'000;

/// How many pieces of about a cell a stretch is cut into.
int pieces(double length, const std::optional<Roughness>& roughness) {
  return roughness ? static_cast<int>(std::clamp(std::round(length / roughness->spectrum.cell), 1.0, 1e7))
                   : 1;
}

bool is_rough(BenchPart part) { return part == BenchPart::face || part == BenchPart::berm; }

/// Heights for rows x columns places. The field is larger than these by some lengths.
std::vector<double> rough_heights(int rows, int columns, const Roughness& roughness, RandomStream& rng) {
  constexpr double most = 1.6e7;
  const double margin = 4 * roughness.spectrum.length / roughness.spectrum.cell;
  const double waves = (rows == 1 ? 1 : rows + margin) * (columns + margin);
  if (!(waves <= most))
    throw ParameterError(fmt::format(
        "plugin benches: roughness of cell {:.6g} m and length {:.6g} m needs {:.3g} waves, expected "
        "at most {:.3g}: a greater cell or a smaller length",
        roughness.spectrum.cell, roughness.spectrum.length, waves, most));
  return gaussian_field(rows, columns, roughness.spectrum, rng);
}

/// The section with its rough stretches cut into pieces; `stretch` is the stretch that each piece is of.
struct Rows {
  std::vector<Vec2> points;
  std::vector<int> stretch;
  std::vector<int> row_of_point;  ///< of the section
};

Rows rows_of(const Section& section, const std::optional<Roughness>& roughness) {
  Rows rows;
  rows.points.push_back(section.points[0]);
  rows.row_of_point.push_back(0);
  for (int s = 0; s < static_cast<int>(section.part.size()); ++s) {
    const Vec2 &a = section.points[s], &b = section.points[s + 1];
    const int n = is_rough(section.part[s]) ? pieces((b - a).norm(), roughness) : 1;
    if (rows.points.size() + static_cast<std::size_t>(n) > most_vertices)
      throw ParameterError("plugin benches: roughness asks for too many cells, expected a greater `cell`");
    for (int i = 1; i < n; ++i) rows.points.push_back(a + static_cast<double>(i) / n * (b - a));
    rows.points.push_back(b);
    rows.stretch.insert(rows.stretch.end(), n, s);
    rows.row_of_point.push_back(static_cast<int>(rows.points.size()) - 1);
  }
  return rows;
}

/// Whether the stretches at a row are all rough: elsewhere the row is where a smooth part begins.
bool is_rough_row(const Rows& rows, const Section& section, int row) {
  const int stretches = static_cast<int>(rows.stretch.size());
  return (row == 0 || is_rough(section.part[rows.stretch[row - 1]])) &&
         (row == stretches || is_rough(section.part[rows.stretch[row]]));
}

/// The unit normal of a stretch, up or out of the face: the left of its direction.
Vec2 normal_of(const Section& section, int stretch) {
  return perpendicular((section.points[stretch + 1] - section.points[stretch]).normalized());
}

Vec2 normal_at(const Rows& rows, const Section& section, int row) {
  Vec2 sum = Vec2::Zero();
  if (row > 0) sum += normal_of(section, rows.stretch[row - 1]);
  if (row < static_cast<int>(rows.stretch.size())) sum += normal_of(section, rows.stretch[row]);
  return sum.normalized();
}

/// Appends a point and the part of the stretch to it. An overhang becomes upright; an upright stretch has no
/// points between its ends.
void append(Profile& profile, Vec2 point, int part) {
  if (!profile.points.empty()) {
    point.x() = std::max(point.x(), profile.points.back().x());
    while (profile.points.size() > 1 && profile.points.back().x() == point.x() &&
           profile.points[profile.points.size() - 2].x() == point.x()) {
      profile.points.pop_back();
      profile.part.pop_back();
    }
    if (profile.points.back() == point) return;
    profile.part.push_back(part);
  }
  profile.points.push_back(point);
}

/// The crest line in plan with the normals of its segments and the mitres of its points: a parallel line at
/// the distance o to the right has the points p + o mitre.
struct Line {
  std::vector<Vec2> points, normal, mitre;
  std::vector<double> length;

  explicit Line(std::vector<Vec2> given) : points(std::move(given)) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec2 along = points[i + 1] - points[i];
      length.push_back(along.norm());
      if (!(length[i] > 1e-6))
        throw ParameterError(
            fmt::format("plugin benches: the point ({:.10g}, {:.10g}) of line stands twice in a row",
                        points[i].x(), points[i].y()));
      normal.push_back(-perpendicular(along / length[i]));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2& before = normal[i == 0 ? 0 : i - 1];
      const Vec2& after = normal[std::min(i, normal.size() - 1)];
      const double straight = 1 + before.dot(after);
      if (!(straight > 0.01))
        throw ParameterError(
            fmt::format("plugin benches: line turns by more than 168 deg at ({:.10g}, {:.10g}), expected a "
                        "corner with a mitre",
                        points[i].x(), points[i].y()));
      mitre.push_back((before + after) / straight);
    }
  }

  Vec2 at(std::size_t point, double offset) const { return points[point] + offset * mitre[point]; }
};

/// A mitred edge shrinks inside of a corner. It must neither vanish nor cross another one.
void check_edges(const Section& section, const Line& line) {
  const int segments = static_cast<int>(line.length.size());
  for (int row = 0; row < static_cast<int>(section.points.size()); ++row) {
    const double offset = section.points[row].x();
    const int stretch = offset <= 0 ? 0 : row - 1;  // the stretch that reaches as far as this edge
    const auto refuse = [&](int point, const std::string& why) {
      throw ParameterError(
          fmt::format("plugin benches: the corner of line at ({:.10g}, {:.10g}) swallows {}: {}",
                      line.points[point].x(), line.points[point].y(), stretch_name(section, stretch), why));
    };
    for (int i = 0; i < segments; ++i) {
      const Vec2 along = line.at(i + 1, offset) - line.at(i, offset);
      const Vec2 straight = (line.points[i + 1] - line.points[i]) / line.length[i];
      const double left = along.dot(straight);
      if (left > 0) continue;
      // The end whose mitre takes more of the edge.
      const double at_begin = offset * line.mitre[i].dot(straight),
                   at_end = -offset * line.mitre[i + 1].dot(straight);
      refuse(at_begin > at_end ? i : i + 1,
             fmt::format("{:.6g} m from the uppermost crest its edge would be {:.6g} m long", offset, left));
    }
    for (int i = 0; i < segments; ++i)
      for (int k = i + 2; k < segments; ++k) {
        const Vec2 a = line.at(i, offset), b = line.at(i + 1, offset), c = line.at(k, offset),
                   d = line.at(k + 1, offset);
        const bool crosses =
            cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
        if (crosses) refuse(k, fmt::format("{:.6g} m from the uppermost crest its edges cross", offset));
      }
  }
}

/// The points of a line cut into pieces: segment and share of it.
struct Column {
  int segment;
  double share;  ///< 0 at its begin
};

std::vector<Column> columns_of(const Line& line, const std::optional<Roughness>& roughness) {
  std::vector<Column> columns;
  for (int i = 0; i < static_cast<int>(line.length.size()); ++i) {
    const int n = pieces(line.length[i], roughness);
    if (columns.size() + static_cast<std::size_t>(n) > most_vertices)
      throw ParameterError("plugin benches: roughness asks for too many cells, expected a greater `cell`");
    for (int k = 0; k < n; ++k) columns.push_back({i, static_cast<double>(k) / n});
  }
  columns.push_back({static_cast<int>(line.length.size()) - 1, 1});
  return columns;
}

Vec3 place_of(const Line& line, const Column& column, const Vec2& point) {
  const auto from = static_cast<std::size_t>(column.segment);
  const Vec2 a = line.at(from, point.x()), b = line.at(from + 1, point.x());
  const Vec2 p = column.share == 0 ? a : column.share == 1 ? b : Vec2(a + column.share * (b - a));
  return {p.x(), p.y(), point.y()};
}

/// The unit normal of the surface where rows and columns of the grid meet: the mean over the stretches and
/// segments that meet there.
Vec3 normal_of(const Rows& rows, const Section& section, const Line& line, const Column& column, int row) {
  std::vector<Vec2> outward = {line.normal[column.segment]};
  if (column.share == 0 && column.segment > 0) outward.push_back(line.normal[column.segment - 1]);
  Vec3 sum = Vec3::Zero();
  for (const int piece : {row - 1, row}) {
    if (piece < 0 || piece >= static_cast<int>(rows.stretch.size())) continue;
    const Vec2 up = normal_of(section, rows.stretch[piece]);
    for (const Vec2& out : outward) sum += Vec3(up.x() * out.x(), up.x() * out.y(), up.y());
  }
  return sum.normalized();
}

}  // namespace

Profile profile_of(const Section& section, const std::optional<Roughness>& roughness, RandomStream& rng) {
  const Rows rows = rows_of(section, roughness);
  Profile profile;
  profile.parts = section.parts;
  for (std::size_t k = 0; k < section.crests.size(); ++k)
    profile.faces.push_back({section.points[section.toes[k]], section.points[section.crests[k]]});
  const int count = static_cast<int>(rows.points.size());
  std::vector<double> heights;
  if (roughness) heights = rough_heights(1, count, *roughness, rng);
  for (int row = 0; row < count; ++row) {
    Vec2 point = rows.points[row];
    if (roughness && is_rough_row(rows, section, row))
      point += roughness->sd * heights[row] * normal_at(rows, section, row);
    append(profile, point, row == 0 ? 0 : section.index_of(section.part[rows.stretch[row - 1]]));
  }
  return profile;
}

Mesh mesh_of(const Section& section, const std::vector<Vec2>& points,
             const std::optional<Roughness>& roughness, RandomStream& rng) {
  const Line line(points);
  check_edges(section, line);
  const Rows rows = rows_of(section, roughness);
  const std::vector<Column> columns = columns_of(line, roughness);
  const int row_count = static_cast<int>(rows.points.size()), column_count = static_cast<int>(columns.size());
  if (static_cast<double>(row_count) * column_count > static_cast<double>(most_vertices))
    throw ParameterError(
        fmt::format("plugin benches: roughness asks for {} x {} cells, expected a greater `cell`", row_count,
                    column_count));
  std::vector<double> heights;
  if (roughness) heights = rough_heights(row_count, column_count, *roughness, rng);

  Mesh mesh;
  mesh.parts = section.parts;
  for (int row = 0; row < row_count; ++row)
    for (int column = 0; column < column_count; ++column) {
      Vec3 place = place_of(line, columns[column], rows.points[row]);
      if (roughness && is_rough_row(rows, section, row))
        place += roughness->sd * heights[static_cast<std::size_t>(row) * column_count + column] *
                 normal_of(rows, section, line, columns[column], row);
      mesh.vertices.push_back(place);
    }
  for (int row = 0; row + 1 < row_count; ++row) {
    const int part = section.index_of(section.part[rows.stretch[row]]);
    for (int column = 0; column + 1 < column_count; ++column) {
      // Seen from above: outwards along the section is a to b, along the line a to d.
      const int a = row * column_count + column, b = a + column_count, c = b + 1, d = a + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      mesh.part.insert(mesh.part.end(), 2, part);
    }
  }
  for (std::size_t k = 0; k < section.crests.size(); ++k) {
    Mesh::Face face;
    face.name = fmt::format("bench_{}", k + 1);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec2 &crest = section.points[section.crests[k]], &toe = section.points[section.toes[k]];
      const Vec2 top = line.at(i, crest.x()), low = line.at(i, toe.x());
      face.crest.emplace_back(top.x(), top.y(), crest.y());
      face.toe.emplace_back(low.x(), low.y(), toe.y());
    }
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

}  // namespace flyrock::plugins
