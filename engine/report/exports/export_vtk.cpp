#include "report/exports/export_vtk.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/safe_file.h"
#include "report/exports/export_obj.h"
#include "report/exports/vtk_file.h"
#include "report/exports/vtk_ground.h"
#include "report/exports/vtk_meshes.h"
#include "report/exports/vtk_shapes.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_contacts.h"
#include "report/tables/stored_paths.h"
#include "report/tables/stored_scene.h"

namespace flyrock {

namespace {

namespace fs = std::filesystem;

/// Collects moments as VTK points with their data.
class PointData {
 public:
  void add(const StoredMoment& m) {
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
std::vector<VtkArray> cell_data(const std::vector<StoredPath>& paths) {
  std::vector<VtkArray> arrays = {{"trial", {}}, {"rock", {}}, {"runout_m", {}}, {"diameter_m", {}}};
  for (const StoredPath& path : paths) {
    arrays[0].values.push_back(static_cast<double>(path.trial));
    arrays[1].values.push_back(static_cast<double>(path.rock));
    arrays[2].values.push_back(path.runout);
    arrays[3].values.push_back(path.diameter);
  }
  return arrays;
}

void write_lines(const fs::path& file, const std::vector<StoredPath>& paths, const std::string& crs) {
  PointData points;
  for (const StoredPath& path : paths) {
    for (const StoredMoment& moment : path.moments) points.add(moment);
    points.end_line();
  }
  write_vtp(file, std::move(points).with(cell_data(paths)), crs);
}

double end_of(const std::vector<StoredPath>& paths) {
  double end = 0;
  for (const StoredPath& path : paths) end = std::max(end, path.moments.back().time);
  return end;
}

void write_contacts(const fs::path& index, double end, const std::vector<StoredContact>& contacts,
                    const std::string& crs) {
  write_vtp_series(index, end, most_vtk_steps, crs, [&](double time) {
    VtkPoints now;
    VtkArray forces{"force_N", {}, 3}, normals{"normal", {}, 3};
    for (const StoredContact& contact : contacts)
      if (const StoredForce* force = contact.at(time)) {
        now.points.push_back(force->place);
        forces.values.insert(forces.values.end(), force->force.begin(), force->force.end());
        normals.values.insert(normals.values.end(), force->normal.begin(), force->normal.end());
      }
    now.of_points = {std::move(forces), std::move(normals)};
    return now;
  });
}

/// The force network: a line for each contact that carries a force.
void write_network(const fs::path& index, double end, const std::vector<StoredContact>& contacts,
                   const std::string& crs) {
  write_vtp_series(index, end, most_vtk_steps, crs, [&](double time) {
    VtkPoints now;
    VtkArray forces{"normal_force_N", {}};
    for (const StoredContact& contact : contacts)
      if (const StoredForce* force = contact.at(time)) {
        const std::vector<Vec3> line = contact.line(*force, time);
        now.points.insert(now.points.end(), line.begin(), line.end());
        now.line_ends.push_back(now.points.size());
        forces.values.push_back(force->along_normal());
      }
    now.of_cells = {std::move(forces)};
    return now;
  });
}

void write_series(const fs::path& index, const std::vector<StoredPath>& paths, const std::string& crs) {
  write_vtp_series(index, end_of(paths), most_vtk_steps, crs, [&](double time) {
    PointData points;
    for (const StoredPath& path : paths) points.add(path.at(time));
    return std::move(points).with(cell_data(paths));
  });
}

}  // namespace

std::vector<fs::path> export_vtk(const fs::path& results, const fs::path& folder) {
  const SqliteReader database(results);
  const std::string crs = stored_crs(database);
  StoredPaths stored(database);
  std::vector<fs::path> files;
  for (auto paths = stored.next_point(); !paths.empty(); paths = stored.next_point()) {
    if (files.empty()) make_folder(folder);
    const std::int64_t point = paths.front().point;
    files.push_back(folder / fmt::format("trajectories-p{}.vtp", point));
    write_lines(files.back(), paths, crs);
    files.push_back(folder / fmt::format("rocks-p{}.pvd", point));
    write_series(files.back(), paths, crs);
    files.push_back(folder / fmt::format("shapes-p{}.pvd", point));
    write_shapes(files.back(), database, paths);
    if (const VtkPoints blocks = stored_blocks(database, point); !blocks.polygon_ends.empty()) {
      files.push_back(folder / fmt::format("blocks-p{}.vtp", point));
      write_vtp(files.back(), blocks, crs);
    }
    const fs::path meshes = folder / fmt::format("meshes-p{}.pvd", point);
    if (write_meshes(meshes, database, point, crs)) files.push_back(meshes);
    if (const auto contacts = stored_contacts(database, point, 0, paths); !contacts.empty()) {
      files.push_back(folder / fmt::format("contacts-p{}.pvd", point));
      write_contacts(files.back(), end_of(paths), contacts, crs);
      files.push_back(folder / fmt::format("network-p{}.pvd", point));
      write_network(files.back(), end_of(paths), contacts, crs);
    }
    files.push_back(folder / fmt::format("ground-p{}.vtp", point));
    write_vtp(files.back(), stored_ground_surface(database, point), crs);
  }
  return files;
}

}  // namespace flyrock
