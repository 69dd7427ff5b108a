#pragma once
// GeoPackages for tests: the tables that OGC 12-128r15 asks for, and layers of lines in a local system.

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace geopackages {

struct Line {
  std::string id;
  std::vector<std::array<double, 2>> points;
};

template <class T>
void append_bytes(std::string& bytes, T number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A line as the standard's binary: its head, and well-known binary with the low byte first.
inline std::string binary_of(const Line& line) {
  std::string bytes = std::string("GP\0\1", 4);
  append_bytes<std::int32_t>(bytes, -1);  // the undefined system of a plan
  bytes += '\1';
  append_bytes<std::uint32_t>(bytes, 2);  // a line
  append_bytes<std::uint32_t>(bytes, static_cast<std::uint32_t>(line.points.size()));
  for (const auto& point : line.points)
    for (const double coordinate : point) append_bytes(bytes, coordinate);
  return bytes;
}

/// Writes a layer of lines with the attribute `id`.
inline void write_lines(const std::filesystem::path& path, const std::string& layer,
                        const std::vector<Line>& lines) {
  sqlite3* file = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &file) == SQLITE_OK);
  const auto execute = [&](const std::string& sql) {
    INFO(sql);
    REQUIRE(sqlite3_exec(file, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  };
  execute(R"(PRAGMA application_id = 1196444487; PRAGMA user_version = 10300;
CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
INSERT INTO gpkg_spatial_ref_sys VALUES ('Undefined cartesian SRS', -1, 'NONE', -1, 'undefined', NULL);
INSERT INTO gpkg_spatial_ref_sys VALUES ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', NULL);
CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT, description TEXT,
  last_change DATETIME NOT NULL, min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER);
CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL);)");
  execute(fmt::format(
      R"(INSERT INTO gpkg_contents VALUES ('{0}', 'features', '{0}', '', '2026-01-01T00:00:00.000Z',
  NULL, NULL, NULL, NULL, -1);
INSERT INTO gpkg_geometry_columns VALUES ('{0}', 'geom', 'LINESTRING', -1, 0, 0);
CREATE TABLE {0} (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom LINESTRING, id TEXT);)",
      layer));
  for (const Line& line : lines) {
    sqlite3_stmt* row = nullptr;
    const std::string sql = fmt::format("INSERT INTO {} (geom, id) VALUES (?, ?)", layer);
    const std::string bytes = binary_of(line);
    REQUIRE(sqlite3_prepare_v2(file, sql.c_str(), -1, &row, nullptr) == SQLITE_OK);
    sqlite3_bind_blob(row, 1, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    sqlite3_bind_text(row, 2, line.id.c_str(), -1, SQLITE_TRANSIENT);
    REQUIRE(sqlite3_step(row) == SQLITE_DONE);
    sqlite3_finalize(row);
  }
  sqlite3_close(file);
}

}  // namespace geopackages
