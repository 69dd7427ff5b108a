#include "report/exports/export_dxf.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "files/safe_file.h"
#include "report/exports/dxf_file.h"
#include "report/exports/export_geojson.h"
#include "report/tables/database.h"
#include "report/tables/sqlite.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// -------------------------------------------------------------------------------------------- plans (3D)

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

Vec3 vertex_of(const Json& position) {
  return {position.at(0).get<double>(), position.at(1).get<double>(),
          position.size() > 2 ? position.at(2).get<double>() : 0};
}

std::vector<Vec3> vertices_of(const Json& positions) {
  std::vector<Vec3> places;
  for (const Json& position : positions) places.push_back(vertex_of(position));
  return places;
}

/// A point, a line, or the rings of polygons, whose last place is the first one again.
void add_geometry(DxfFile& drawing, const std::string& layer, const Json& geometry) {
  const Json& coordinates = geometry.at("coordinates");
  if (geometry.at("type") == "Point") return drawing.add_point(layer, vertex_of(coordinates));
  if (geometry.at("type") == "LineString") return drawing.add_line(layer, vertices_of(coordinates));
  for (const Json& polygon : coordinates)
    for (const Json& ring : polygon) {
      std::vector<Vec3> places = vertices_of(ring);
      places.pop_back();
      drawing.add_line(layer, places, true);
    }
}

/// The layers of a GIS as those of drawings, a drawing for each point: area-p0.geojson goes to AREA of
/// results-p0.dxf.
std::vector<fs::path> write_plans(const fs::path& results, const fs::path& folder) {
  std::map<std::size_t, DxfFile> drawings;
  for (const fs::path& file : export_geojson(results, folder)) {
    const std::string stem = file.stem().string();
    const std::size_t cut = stem.rfind("-p");
    DxfFile& drawing = drawings[std::stoul(stem.substr(cut + 2))];
    std::ifstream stream(file);
    const Json layer = Json::parse(stream);
    for (const Json& feature : layer.at("features")) {
      const std::string limit = feature.at("properties").value("limit", std::string());
      if (!feature.at("geometry").is_null())
        add_geometry(drawing, upper(limit.empty() ? stem.substr(0, cut) : limit), feature.at("geometry"));
    }
    fs::remove(file);
  }
  std::vector<fs::path> files;
  for (const auto& [point, drawing] : drawings) {
    files.push_back(folder / fmt::format("results-p{}.dxf", point));
    write_file(files.back(), drawing.text());
  }
  return files;
}

// ----------------------------------------------------------------------------------------- sections (2D)

/// What one sweep point shows in a section.
class Section {
 public:
  Section(const SqliteReader& database, std::int64_t point) : database_(database), point_(point) {
    Query place(database, rows_of("x_m, y_m", "ground"));
    while (place.next()) ground_.emplace_back(place.real(0), place.real(1), 0);
  }

  std::string drawn(const std::vector<StoredPath>& paths, const Json& summary) {
    if (ground_.size() > 1) drawing_.add_line("GROUND", ground_);
    for (const StoredPath& path : paths) {
      std::vector<Vec3> places;
      for (const StoredMoment& moment : path.moments) places.push_back(moment.place);
      drawing_.add_line("PATHS", places);
    }
    add_ends();
    for (const Json& gate : summary.at("gates")) add_upright("GATES", gate.at("x").get<double>(), 0);
    for (const Json& barrier : summary.at("barriers"))
      add_upright("BARRIERS", barrier.at("x").get<double>(), barrier.at("height_m").get<double>());
    add_envelope("ENVELOPE_P50", "height_p50_m");
    add_envelope("ENVELOPE_P95", "height_p95_m");
    add_envelope("ENVELOPE_MAX", "height_max_m");
    return drawing_.text();
  }

 private:
  std::string rows_of(const char* columns, const char* table) const {
    return fmt::format("SELECT {} FROM {} WHERE point = {}", columns, table, point_);
  }

  void add_ends() {
    Query rock(database_, rows_of("stop_x_m, stop_y_m", "rocks") + " AND stop_reason != 'not_started'");
    while (rock.next())
      if (rock.type(0) != SQLITE_NULL) drawing_.add_point("ENDS", Vec3(rock.real(0), rock.real(1), 0));
  }

  /// The height of the ground, at an upright face of its top; none beside it.
  std::optional<double> height_at(double x) const {
    std::optional<double> height;
    for (std::size_t i = 1; i < ground_.size(); ++i) {
      const Vec3 &a = ground_[i - 1], &b = ground_[i];
      if (x < a.x() || x > b.x()) continue;
      const double share = b.x() > a.x() ? (x - a.x()) / (b.x() - a.x()) : 0;
      const double here = b.x() > a.x() ? a.y() + share * (b.y() - a.y()) : std::max(a.y(), b.y());
      height = std::max(height.value_or(here), here);
    }
    return height;
  }

  void add_upright(const char* layer, double x, double height) {
    const auto foot = height_at(x);
    if (!foot) return;
    if (height > 0)
      drawing_.add_line(layer, std::vector{Vec3(x, *foot, 0), Vec3(x, *foot + height, 0)});
    else
      drawing_.add_point(layer, Vec3(x, *foot, 0));
  }

  /// A line for each run of neighbouring bins that rocks pass.
  void add_envelope(const char* layer, const char* column) {
    Query bin(database_, rows_of(fmt::format("x_m, width_m, {}", column).c_str(), "envelopes") +
                             " AND \"group\" = '' ORDER BY x_m");
    std::vector<Vec3> places;
    double end = 0;
    const auto finish = [&] {
      if (places.size() > 1) drawing_.add_line(layer, places);
      places.clear();
    };
    while (bin.next()) {
      const double begin = bin.real(0), width = bin.real(1);
      if (begin > end + width / 2) finish();
      end = begin + width;
      if (const auto foot = height_at(begin + width / 2))
        places.emplace_back(begin + width / 2, *foot + bin.real(2), 0);
    }
    finish();
  }

  const SqliteReader& database_;
  std::int64_t point_;
  std::vector<Vec3> ground_;
  DxfFile drawing_;
};

std::vector<fs::path> write_sections(const SqliteReader& database, const Json& points,
                                     const fs::path& folder) {
  make_folder(folder);
  StoredPaths stored(database);
  std::vector<StoredPath> paths = stored.next_point();
  std::vector<fs::path> files;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto point = static_cast<std::int64_t>(p);
    const bool has_paths = !paths.empty() && paths.front().point == point;
    const std::vector<StoredPath> here = has_paths ? std::exchange(paths, {}) : std::vector<StoredPath>();
    files.push_back(folder / fmt::format("results-p{}.dxf", p));
    write_file(files.back(), Section(database, point).drawn(here, points[p]));
    if (has_paths) paths = stored.next_point();
  }
  return files;
}

}  // namespace

std::vector<fs::path> export_dxf(const fs::path& results, const fs::path& folder) try {
  const SqliteReader database(results);
  const Json summary = Json::parse(stored_report(results)).at("summary");
  if (summary.at("dimension") == 3) return write_plans(results, folder);
  return write_sections(database, summary.at("points"), folder);
} catch (const nlohmann::json::exception&) {
  throw UnreadableFile(
      fmt::format("{} is damaged: the data of its report are not those of a result", results.string()));
}

}  // namespace flyrock
