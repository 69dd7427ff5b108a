#include "report/export_vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "batch/safe_file.h"
#include "math/round_step.h"
#include "report/sqlite.h"
#include "report/vtk_file.h"
#include "world/observe.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

constexpr double most_steps = 500;

struct Moment {
  double time, speed, energy, mode;
  Vec3 place;
};

/// The stored path of one rock.
struct Path {
  std::int64_t point, trial, rock;
  double runout, diameter;
  std::vector<Moment> moments;
};

double mode_number(const std::string& name) {
  const auto found = std::find(travel_mode_names.begin(), travel_mode_names.end(), name);
  return static_cast<double>(found - travel_mode_names.begin());
}

/// The paths of the sweep point at whose first row `row` is. `more` tells whether a row follows them.
std::vector<Path> read_point(Query& row, bool& more) {
  std::vector<Path> paths;
  for (; more && (paths.empty() || paths.back().point == row.whole(0)); more = row.next()) {
    if (paths.empty() || paths.back().trial != row.whole(1) || paths.back().rock != row.whole(2))
      paths.push_back(
          {row.whole(0), row.whole(1), row.whole(2), row.real(3), std::cbrt(6 * row.real(4) / pi), {}});
    const Vec3 velocity(row.real(9), row.real(10), row.real(11));
    paths.back().moments.push_back({row.real(5),
                                    velocity.norm(),
                                    row.real(12),
                                    mode_number(row.text(13)),
                                    {row.real(6), row.real(7), row.real(8)}});
  }
  return paths;
}

/// Linear between the stored moments. The mode is the one in which the rock arrives at the later moment.
Moment moment_at(const Path& path, double time) {
  const auto later = std::lower_bound(path.moments.begin(), path.moments.end(), time,
                                      [](const Moment& m, double t) { return m.time < t; });
  if (later == path.moments.end()) return path.moments.back();
  if (later == path.moments.begin()) return *later;
  const Moment &a = *std::prev(later), &b = *later;
  const double share = (time - a.time) / (b.time - a.time);
  return {time, a.speed + share * (b.speed - a.speed), a.energy + share * (b.energy - a.energy), b.mode,
          a.place + share * (b.place - a.place)};
}

/// Collects moments as VTK points with their data.
class PointData {
 public:
  void add(const Moment& m) {
    data_.points.push_back(m.place);
    times_.values.push_back(m.time);
    speeds_.values.push_back(m.speed);
    energies_.values.push_back(m.energy);
    modes_.values.push_back(m.mode);
  }
  void end_line() { data_.line_ends.push_back(data_.points.size()); }
  VtkPoints with(std::vector<VtkArray> of_cells) && {
    data_.of_points = {std::move(times_), std::move(speeds_), std::move(energies_), std::move(modes_)};
    data_.of_cells = std::move(of_cells);
    return std::move(data_);
  }

 private:
  VtkPoints data_;
  VtkArray times_{"time_s", {}}, speeds_{"speed_m_s", {}}, energies_{"energy_J", {}}, modes_{"mode", {}};
};

/// One cell for each path.
std::vector<VtkArray> cell_data(const std::vector<Path>& paths) {
  std::vector<VtkArray> arrays = {{"trial", {}}, {"rock", {}}, {"runout_m", {}}, {"diameter_m", {}}};
  for (const Path& path : paths) {
    arrays[0].values.push_back(static_cast<double>(path.trial));
    arrays[1].values.push_back(static_cast<double>(path.rock));
    arrays[2].values.push_back(path.runout);
    arrays[3].values.push_back(path.diameter);
  }
  return arrays;
}

void write_lines(const fs::path& file, const std::vector<Path>& paths) {
  PointData points;
  for (const Path& path : paths) {
    for (const Moment& moment : path.moments) points.add(moment);
    points.end_line();
  }
  write_vtp(file, std::move(points).with(cell_data(paths)));
}

void write_series(const fs::path& index, const std::vector<Path>& paths) {
  double end = 0;
  for (const Path& path : paths) end = std::max(end, path.moments.back().time);
  const double step = round_step(end / most_steps);
  const auto steps = static_cast<int>(std::ceil(end / step));
  const fs::path folder = index.parent_path() / index.stem();
  make_folder(folder);
  std::vector<VtkMoment> series;
  for (int i = 0; i <= steps; ++i) {
    const double time = step * i;
    PointData points;
    for (const Path& path : paths) points.add(moment_at(path, time));
    const std::string name = fmt::format("{:04}.vtp", i);
    write_vtp(folder / name, std::move(points).with(cell_data(paths)));
    series.push_back({time, (index.stem() / name).generic_string()});
  }
  write_pvd(index, series);
}

/// One line for each segment, because each segment has its own part.
VtkPoints profile_lines(const SqliteReader& database, std::int64_t point) {
  Query row(database,
            fmt::format("SELECT x_m, y_m, part FROM ground WHERE point = {} ORDER BY rowid", point));
  VtkPoints lines;
  VtkArray parts{"part", {}};
  Vec3 before = Vec3::Zero();
  for (bool first = true; row.next(); first = false) {
    const Vec3 place(row.real(0), row.real(1), 0);
    if (!first) {
      lines.points.insert(lines.points.end(), {before, place});
      lines.line_ends.push_back(lines.points.size());
    }
    if (row.type(2) != SQLITE_NULL) parts.values.push_back(row.real(2));
    before = place;
  }
  lines.of_cells = {std::move(parts)};
  return lines;
}

VtkPoints ground_triangles(const SqliteReader& database, std::int64_t ground) {
  VtkPoints surface;
  VtkArray parts{"part", {}};
  Query vertex(
      database,
      fmt::format("SELECT x_m, y_m, z_m FROM ground_vertices WHERE ground = {} ORDER BY rowid", ground));
  while (vertex.next()) surface.points.emplace_back(vertex.real(0), vertex.real(1), vertex.real(2));
  Query triangle(
      database,
      fmt::format("SELECT a, b, c, part FROM ground_triangles WHERE ground = {} ORDER BY rowid", ground));
  while (triangle.next()) {
    surface.triangles.push_back({triangle.whole(0), triangle.whole(1), triangle.whole(2)});
    parts.values.push_back(triangle.real(3));
  }
  surface.of_cells = {std::move(parts)};
  return surface;
}

void write_ground(const fs::path& file, const SqliteReader& database, std::int64_t point) {
  Query ground(database, fmt::format("SELECT ground FROM points WHERE point = {}", point));
  const bool in_space = ground.next() && ground.type(0) != SQLITE_NULL;
  write_vtp(file, in_space ? ground_triangles(database, ground.whole(0)) : profile_lines(database, point));
}

}  // namespace

std::vector<fs::path> export_vtk(const fs::path& results, const fs::path& folder) {
  const SqliteReader database(results);
  Query rows(database,
             "SELECT t.point, t.trial, t.rock, runout_m, volume_m3, t.time_s, x_m, y_m, z_m, vx_m_s, vy_m_s, "
             "vz_m_s, "
             "kinetic_energy_J, mode FROM trajectories t JOIN rocks USING (point, trial, rock) ORDER BY "
             "t.point, t.trial, t.rock");
  std::vector<fs::path> files;
  bool more = rows.next();
  if (more) make_folder(folder);
  while (more) {
    const std::vector<Path> paths = read_point(rows, more);
    const std::int64_t point = paths.front().point;
    files.push_back(folder / fmt::format("trajectories-p{}.vtp", point));
    write_lines(files.back(), paths);
    files.push_back(folder / fmt::format("rocks-p{}.pvd", point));
    write_series(files.back(), paths);
    files.push_back(folder / fmt::format("ground-p{}.vtp", point));
    write_ground(files.back(), database, point);
  }
  return files;
}

}  // namespace flyrock
