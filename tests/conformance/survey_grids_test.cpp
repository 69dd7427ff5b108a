// Grids as programs of surveys write them, compared with the heights that they were made from.

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "geotiff.h"
#include "random/stream.h"
#include "samples.h"
#include "survey_of.h"

using namespace flyrock;

namespace survey_grids_test {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double foot = 0.3048, us_foot = 1200.0 / 3937.0;

HeightGrid grid_of(const std::string& path, const SurveyKeys& keys = {}) {
  return std::get<HeightGrid>(survey_of("raster", path, keys).shape);
}

std::string grid_error(const std::string& content, const SurveyKeys& keys = {}) {
  return survey_error("raster", TemporaryFile("bad.asc", content), keys);
}

/// Heights of two decimals on hills, with voids in the middle, in a row and in the first cell.
HeightGrid random_grid(RandomStream& rng) {
  HeightGrid grid;
  grid.columns = static_cast<int>(rng.integer(5, 14));
  grid.rows = static_cast<int>(rng.integer(5, 14));
  grid.cell = std::array{0.5, 1.0, 2.0, 5.0, 12.5}[static_cast<std::size_t>(rng.integer(0, 4))];
  grid.corner = {std::round(rng.uniform(0, 3e6)) + 0.5 * grid.cell,
                 std::round(rng.uniform(0, 6e6)) + 0.5 * grid.cell};
  const double base = rng.uniform(0, 3000);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.heights.push_back(rng.uniform() < 0.1
                                 ? nothing
                                 : std::round(100 * (base - 0.4 * grid.cell * i + rng.uniform(0, 3))) / 100);
  if (rng.uniform() < 0.5) grid.heights[static_cast<std::size_t>((grid.rows - 1) * grid.columns)] = nothing;
  // Ground somewhere.
  for (const int k : {grid.columns + 1, grid.columns + 2, 2 * grid.columns + 1, 2 * grid.columns + 2})
    grid.heights[static_cast<std::size_t>(k)] = std::round(base);
  return grid;
}

void check_same_grid(const HeightGrid& read, const HeightGrid& made, double tolerance) {
  REQUIRE(read.columns == made.columns);
  REQUIRE(read.rows == made.rows);
  CHECK(std::abs(read.cell - made.cell) <= 1e-9 * made.cell);
  CHECK((read.corner - made.corner).norm() <= 1e-6);
  for (std::size_t k = 0; k < made.heights.size(); ++k) {
    REQUIRE(std::isnan(read.heights[k]) == std::isnan(made.heights[k]));
    if (!std::isnan(made.heights[k])) REQUIRE(std::abs(read.heights[k] - made.heights[k]) <= tolerance);
  }
}

template <class One>
One one_of(const std::vector<One>& all, RandomStream& rng) {
  return all[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
}

/// The grid as text, in one of the dialects of GIS.
std::string text_of(const HeightGrid& grid, RandomStream& rng) {
  const std::string end = rng.uniform() < 0.3 ? "\r\n" : "\n";
  std::string text = rng.uniform() < 0.2 ? "\xEF\xBB\xBF" : "", no_data;
  const double width = grid.cell * grid.columns, height = grid.cell * grid.rows;
  const Vec2 low = grid.corner - Vec2::Constant(0.5 * grid.cell);
  const auto line = [&](const std::string& key, double value) {
    text += fmt::format("{}{}{:.10g}{}", key, rng.uniform() < 0.5 ? " " : "    ", value, end);
  };
  const auto dialect = rng.integer(0, 4);
  const bool is_surfer = dialect == 4;
  if (dialect == 0 || dialect == 1) {  // ESRI, of corners and of centres
    const bool is_large = rng.uniform() < 0.5;
    line(is_large ? "NCOLS" : "ncols", grid.columns);
    line(is_large ? "NROWS" : "nrows", grid.rows);
    line(dialect == 0 ? "xllcorner" : "XLLCENTER", dialect == 0 ? low.x() : grid.corner.x());
    line(dialect == 0 ? "yllcorner" : "yllcenter", dialect == 0 ? low.y() : grid.corner.y());
    line("cellsize", grid.cell);
  } else if (dialect == 2) {  // GDAL, cells that are not squares to the last digit
    line("ncols", grid.columns);
    line("nrows", grid.rows);
    line("xllcorner", low.x());
    line("yllcorner", low.y());
    line("dx", grid.cell);
    line("dy", grid.cell);
  } else if (dialect == 3) {  // GRASS
    line("north:", low.y() + height);
    line("south:", low.y());
    line("east:", low.x() + width);
    line("west:", low.x());
    line("rows:", grid.rows);
    line("cols:", grid.columns);
    no_data = "*";
  } else {
    text = fmt::format("DSAA{}{} {}{}{:.10g} {:.10g}{}{:.10g} {:.10g}{}0 4000{}", end, grid.columns,
                       grid.rows, end, grid.corner.x(), grid.corner.x() + grid.cell * (grid.columns - 1), end,
                       grid.corner.y(), grid.corner.y() + grid.cell * (grid.rows - 1), end, end);
    no_data = rng.uniform() < 0.5 ? "1.70141e+038" : "1.70141E+38";
  }
  if (dialect < 3) {
    struct Void {
      const char *header, *cell;
    };
    // In the header as a double, in the cells as a float; nan; none, which means -9999.
    const Void as = one_of<Void>({{"-9999", "-9999"},
                                  {"-9999", "-9999.000"},
                                  {"-32768", "-32768"},
                                  {"-3.4028234663852886e+38", "-3.402823466e+38"},
                                  {"-3.40282e+38", "-3.4028234663852886e+38"},
                                  {"nan", "nan"},
                                  {"", "-9999"},
                                  {"-9999", "NaN"},
                                  {"-9999", "-nan(ind)"},
                                  {"-9999", "1.#QNAN"},
                                  {"-9999", "NA"},
                                  {"-9999", "nan(0x8000000000000)"}},
                                 rng);
    no_data = as.cell;
    if (*as.header)
      text += fmt::format("{} {}{}", rng.uniform() < 0.5 ? "NODATA_value" : "nodata_value", as.header, end);
  }
  const bool is_wrapped = rng.uniform() < 0.2;  // Surfer begins a new line after ten values
  for (int i = 0; i < grid.rows; ++i) {
    const int row = is_surfer ? i : grid.rows - 1 - i;
    for (int column = 0; column < grid.columns; ++column) {
      const double z = grid.at(column, row);
      text += std::isnan(z) ? no_data : fmt::format("{:.2f}", z);
      text += column + 1 == grid.columns || (is_wrapped && column % 4 == 3) ? end
              : rng.uniform() < 0.9                                         ? " "
                                                                            : "\t";
    }
  }
  return text;
}

bool has_gdal() {
  if (std::filesystem::exists(FLYROCK_MODULE_DIR "/flyrock_gdal.so")) return true;
  WARN("SKIPPED: built without GDAL");
  return false;
}

}  // namespace

TEST_CASE("a grid is the same ground in every dialect of text") {
  for (int seed = 0; seed < samples(400); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "grids", {});
    const HeightGrid made = random_grid(rng);
    const std::string text = text_of(made, rng);
    CAPTURE(text);
    const TemporaryFile file("dialect.asc", text);
    check_same_grid(grid_of(file.path), made, 1e-9);
  }
}

TEST_CASE("a grid may end without a line end, after a word of 256 letters it may not") {
  std::string text = "ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 1600; ++i)
    text += fmt::format("{}{}.25", i == 0 ? "" : i % 40 == 0 ? "\n" : " ", 400 + i % 37);
  const HeightGrid grid = grid_of(TemporaryFile("open.asc", text).path);
  REQUIRE(grid.heights.size() == 1600);
  CHECK(grid.heights[39] == 400.25 + 1599 % 37);
  CHECK(grid_error(text + std::string(300, '1')).find("a word of more than 256 letters") !=
        std::string::npos);
}

TEST_CASE("a grid of UTF-16 is refused with the cure") {
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("ncols 2\n")) wide += {c, '\0'};
  CHECK(grid_error(wide) == "1:1: the text is UTF-16: save the file as UTF-8 or ASCII");
}

TEST_CASE("cells count as squares to 1e-4, others are refused with the command that resamples") {
  const std::string head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\n", rows = "1 2 3\n4 5 6\n";
  const TemporaryFile nearly("nearly.asc", head + "dx 5.0001\ndy 5.0002\n" + rows);
  CHECK(grid_of(nearly.path).cell == Approx(5.00015));
  CHECK(grid_error(head + "dx 5\ndy 5.01\n" + rows) ==
        "7:1: the cells are 5 m by 5.01 m, expected squares: resample the grid, for example with `gdalwarp "
        "-tr 5 5`");
  CHECK(grid_error(head + "dx 5\n" + rows).find("the header ends here without `dy`") != std::string::npos);
  CHECK(grid_error("DSBB\0\0").find("this is a binary grid of Surfer") != std::string::npos);
  CHECK(grid_error(head + "cellsize 5\n1,5 2,5 3\n4 5 6\n")
            .find("the file has decimal commas; export it with points") != std::string::npos);
}

TEST_CASE("heights that no ground has are refused with value, count and no_data, with which they are voids") {
  for (const char* value : {"-32768", "-99999", "9999", "-3.4e38", "32767", "1e20"}) {
    const std::string content = fmt::format(
        "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n{0} 501 502 503\n{0} 501 502 503\n500 501 "
        "502 {0}\n",
        value);
    CAPTURE(value);
    const std::string error = grid_error(content);
    CHECK(error.find(" 3 cells are ") == 0);
    const std::size_t key = error.find("`no_data: ");
    REQUIRE(key != std::string::npos);
    const double named = std::stod(error.substr(key + 10));
    const TemporaryFile file("void.asc", content);
    const HeightGrid grid = grid_of(file.path, {{"no_data", named}});
    CHECK(std::count_if(grid.heights.begin(), grid.heights.end(), [](double z) { return std::isnan(z); }) ==
          3);
  }
}

TEST_CASE("a value far from all other heights is refused where it is a code of no data, else named") {
  const auto grid = [](const std::string& value) {
    return fmt::format(
        "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n{0} 501 502 503\n{0} 501 502 503\n500 501 "
        "502 503\n",
        value);
  };
  const auto notes_of = [&](const std::string& value, const SurveyKeys& keys = {}) {
    const TemporaryFile file("lonely.asc", grid(value));
    std::vector<std::string> notes = survey_of("raster", file.path, keys).report.notes;
    for (std::string& note : notes) note.erase(0, file.path.size() + 2);
    return notes;
  };
  const auto text = [](const char* height, const char* how, const char* value) {
    return fmt::format("2 cells are {} m, {} all others: write `no_data: {}` if these cells have no data",
                       height, how, value);
  };
  using Notes = std::vector<std::string>;
  CHECK(grid_error(grid("-999")) == " " + text("-999", "1499 m below", "-999"));
  CHECK(grid_error(grid("-999"), {{"unit", "ft"}}) == " " + text("-304.4952", "457 m below", "-999"));
  CHECK(notes_of("0") == Notes{text("0", "500 m below", "0")});
  CHECK(notes_of("8888") == Notes{text("8888", "8385 m above", "8888")});
  CHECK(notes_of("-999", {{"no_data", -999.0}}).empty());
  CHECK(notes_of("410").empty());
}

TEST_CASE("a cell more than 100 m from all cells about it is named, whatever its value") {
  const auto notes = [](const std::string& rows) {
    const TemporaryFile file("lone.asc",
                             "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\n" + rows);
    const std::vector<std::string> all = survey_of("raster", file.path).report.notes;
    return all.empty() ? "" : all.front().substr(file.path.size() + 2);
  };
  CHECK(notes("472 473 474 475\n472 0 474 475\n472 473 474 475\n") ==
        "1 cell lies more than 100 m above or below all cells about it; that at (103, 203) is 0 m, 472 m "
        "from the "
        "nearest: write `no_data: 0` if it has no data");
  CHECK(notes("472 473 474 475\n472 5000 474 475\n472 473 474 475\n")
            .find("is 5000 m, 4526 m from the nearest") != std::string::npos);
  CHECK(notes("472 473 474 475\n472 0 474 800\n472 473 474 475\n").find("2 cells lie more than 100 m") == 0);
  CHECK(notes("472 473 474 475\n472 0 474 800\n472 473 474 475\n").find("they have different values") !=
        std::string::npos);
  CHECK(notes("472 473 474 475\n472 473 474 304\n301 302 303 305\n").empty());  // a cliff
}

TEST_CASE("a projection beside a grid that has other heights, or is not understood, is read or refused") {
  const TemporaryFile file(
      "both.asc", "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n100 101\n102 103\n");
  const std::string path = std::filesystem::path(file.path).replace_extension(".prj").string();
  const auto with = [&](const std::string& text) { std::ofstream(path) << text; };
  with(
      "PROJCS[\"x\",GEOGCS[\"y\",UNIT[\"Degree\",0.017]],UNIT[\"Meter\",1.0]],VERTCS[\"h\",UNIT[\"Foot_US\","
      "0.3048006096012192]]");
  CHECK(grid_of(file.path).at(0, 0) == Approx(102 * us_foot));
  with("Projection STATEPLANE\nUnits FEET\nZunits FEET\n");
  CHECK(survey_error("raster", file).find("write `plan_unit: us_ft`") != std::string::npos);
  const Survey feet = survey_of("raster", file.path, {{"plan_unit", "us_ft"}});
  CHECK(std::get<HeightGrid>(feet.shape).at(0, 0) == Approx(102 * us_foot));
  CHECK(feet.report.is_converted);
  with("PROJCS[\"x\",UNIT[\"Foot_Clarke\",0.3047972654]]");
  CHECK(survey_error("raster", file).find("the file .prj beside it is not understood") != std::string::npos);
  std::filesystem::remove(path);
}

TEST_CASE("scale and unit make metres of heights, plan_unit of places") {
  const std::string content =
      "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n1000 1010\n1020 1030\n";
  const TemporaryFile file("feet.asc", content);
  CHECK(grid_of(file.path, {{"unit", "ft"}}).at(0, 0) == Approx(1020 * foot));
  CHECK(grid_of(file.path, {{"unit", "us_ft"}}).at(1, 1) == Approx(1010 * us_foot));
  CHECK(grid_of(file.path, {{"scale", 0.1}}).at(0, 0) == Approx(102));
  const HeightGrid plan = grid_of(file.path, {{"unit", "m"}, {"plan_unit", "ft"}});
  CHECK(plan.cell == Approx(10 * foot));
  CHECK((plan.corner - foot * Vec2(1005, 2005)).norm() < 1e-9);
  CHECK(plan.at(0, 0) == 1020);
}

TEST_CASE("the file .prj beside a grid gives its system, and its unit is not passed over") {
  const TemporaryFile file(
      "system.asc", "ncols 2\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n100 101\n102 103\n");
  const std::string path = std::filesystem::path(file.path).replace_extension(".prj").string();
  const auto with = [&](const std::string& text) { std::ofstream(path) << text; };
  with(
      "PROJCS[\"CH1903+ / "
      "LV95\",GEOGCS[\"CH1903+\",UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4150\"]],"
      "UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AUTHORITY[\"EPSG\",\"2056\"]]\n");
  CHECK(survey_of("raster", file.path).report.crs == "EPSG:2056");
  with("PROJCS[\"x\",GEOGCS[\"y\",UNIT[\"Degree\",0.017]],UNIT[\"Foot_US\",0.3048006096012192]]");
  CHECK(
      survey_error("raster", file).find("its coordinates are in US survey feet: write `plan_unit: us_ft`") !=
      std::string::npos);
  CHECK(survey_error("raster", file, {{"plan_unit", "us_ft"}}).find("write `unit: us_ft` or `unit: m`") !=
        std::string::npos);
  CHECK(grid_of(file.path, {{"plan_unit", "us_ft"}, {"unit", "m"}}).cell == Approx(10 * us_foot));
  std::filesystem::remove(path);
}

TEST_CASE("a void is filled where it is small, and the report says what was read") {
  const TemporaryFile file("fill.asc",
                           "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 2500\n1000 1001 1002 1003\n"
                           "1000 -9999 1002 1003\n1000 1001 1002 1003\n1000 1001 1002 1003\n");
  const Survey survey = survey_of("raster", file.path, {{"fill", 1.0}});
  CHECK(std::get<HeightGrid>(survey.shape).at(1, 2) == Approx(1001));
  CHECK(survey.report.size == "16 cells of 2500 m, 1,000 to 1,003 m");
  REQUIRE(survey.report.notes.size() == 1);
  CHECK(survey.report.notes[0] == file.path + ": filled 1 void of 1 cell in all");
  CHECK(std::isnan(grid_of(file.path).at(1, 2)));
}

TEST_CASE("a GeoTIFF is the ground that it means: scale, offset, unit, mask and no data") {
  if (!has_gdal()) return;
  for (int seed = 0; seed < samples(150); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "tiffs", {});
    HeightGrid made = random_grid(rng);
    for (double& z : made.heights) z = std::round(4 * z) / 4;  // exact in 32 bits
    GeoTiff tif;
    tif.cell = made.cell;
    tif.north_west = made.corner + made.cell * Vec2(-0.5, made.rows - 0.5);
    if (rng.uniform() < 0.5) tif.epsg = 2056;
    double metres = 1, scale = 1, offset = 0;
    if (rng.uniform() < 0.3) {
      tif.unit = one_of<std::string>({"ft", "feet", "foot", "US survey foot", "m", "metre"}, rng);
      metres = tif.unit[0] == 'm' ? 1 : tif.unit[0] == 'U' ? us_foot : foot;
    }
    if (rng.uniform() < 0.3) {
      tif.scale = "0.25";
      scale = 0.25;
    }
    if (rng.uniform() < 0.3) {
      tif.offset = "-100";
      offset = -100;
    }
    const bool has_mask = rng.uniform() < 0.4;
    tif.no_data =
        has_mask ? "" : one_of<std::string>({"-9999", "nan", "-3.4028234663852886e+38", "-3.40282e+38"}, rng);
    const float no_data = has_mask                 ? 400.0f  // a height like others
                          : tif.no_data == "nan"   ? std::nanf("")
                          : tif.no_data == "-9999" ? -9999.0f
                                                   : -std::numeric_limits<float>::max();
    for (int row = made.rows - 1; row >= 0; --row) {
      std::vector<float> values;
      std::vector<int> valid;
      for (int column = 0; column < made.columns; ++column) {
        const double z = made.at(column, row);
        valid.push_back(!std::isnan(z));
        values.push_back(std::isnan(z) ? no_data : static_cast<float>((z - offset) / scale));
      }
      tif.rows.push_back(values);
      if (has_mask) tif.mask.push_back(valid);
    }
    for (double& z : made.heights) z *= metres;
    const TemporaryFile file("random.tif", tif.bytes());
    const Survey survey = survey_of("raster", file.path);
    check_same_grid(std::get<HeightGrid>(survey.shape), made, 1e-4);
    CHECK(survey.report.crs == (tif.epsg ? "EPSG:2056" : ""));
  }
}

TEST_CASE("a GeoTIFF in degrees or feet, or with a void that is not tagged, is refused with the cure") {
  if (!has_gdal()) return;
  const auto error = [](const GeoTiff& tif, const SurveyKeys& keys = {}) {
    return survey_error("raster", TemporaryFile("bad.tif", tif.bytes()), keys);
  };
  const GeoTiff degrees{.rows = {{1, 2}, {3, 4}}, .cell = 0.001, .north_west = {7, 46}, .geographic = 4326};
  CHECK(error(degrees).find("is in degrees") != std::string::npos);
  GeoTiff metres = degrees;  // a tag of degrees on coordinates in metres
  metres.cell = 2;
  metres.north_west = {2600000, 1200000};
  const TemporaryFile file("metres.tif", metres.bytes());
  REQUIRE(survey_of("raster", file.path).report.notes.size() == 1);
  CHECK(survey_of("raster", file.path).report.notes[0].find("they are taken as metres") != std::string::npos);
  const GeoTiff feet{
      .rows = {{100, 200}, {300, 400}}, .cell = 10, .north_west = {900000, 200000}, .epsg = 2263};
  CHECK(error(feet).find("write `plan_unit: us_ft`") != std::string::npos);
  CHECK(error(feet, {{"plan_unit", "us_ft"}}).find("write `unit: us_ft` or `unit: m`") != std::string::npos);
  CHECK(error(feet, {{"plan_unit", "us_ft"}, {"unit", "us_ft"}}) == "no error");
  GeoTiff untagged = metres;
  untagged.rows = {{500, 501}, {-9999, -9999}, {500, 501}, {502, 503}};
  CHECK(error(untagged).find(" 2 cells are -9999 m, and 2 in all are below -1000 m") == 0);
  CHECK(error(untagged, {{"no_data", -9999.0}}) == "no error");
  untagged.scale = "0.1";  // the value is that of the file, not the height
  untagged.rows = {{5000, 5010}, {-32768, 5010}, {5000, 5010}, {5020, 5030}};
  CHECK(error(untagged).find("`no_data: -32768`") != std::string::npos);
  CHECK(error(untagged, {{"no_data", -32768.0}}) == "no error");
  GeoTiff oblong = metres;
  oblong.cell_y = 2.1;
  CHECK(error(oblong).find("its cells are 2 m by 2.1 m, expected squares: `gdalwarp -tr 2 2` resamples it") !=
        std::string::npos);
  oblong.cell_y = 2.0001;
  CHECK(error(oblong) == "no error");
}

TEST_CASE("a GeoTIFF is read by the module of GDAL, or its error names the package") {
  const std::string error = survey_error("raster", TemporaryFile("text.tif", "no image"));
  if (std::filesystem::exists(FLYROCK_MODULE_DIR "/flyrock_gdal.so"))
    CHECK(error.find("not recognized as a supported file format") != std::string::npos);
  else
    CHECK(error.find(
              " reading this format needs GDAL, which this flyrock does not have: install its package "
              "flyrock-gdal, take the archive with GDAL, or build flyrock again with libgdal-dev, or ") == 0);
}

TEST_CASE("a file that another terrain reads is refused with the name of that terrain") {
  const struct {
    const char *terrain, *file, *says;
  } wrong[] = {
      {"raster", "scan.LAS", "is a cloud of points: as ground, the terrain `points` reads it"},
      {"raster", "pit.obj", "is a surface of triangles: as ground, the terrain `mesh` reads it"},
      {"raster", "pit.dxf", "is a drawing of CAD: as ground, the terrain `mesh` reads its 3D faces"},
      {"mesh", "dem.tif", "is a grid of heights: as ground, the terrain `raster` reads it"},
      {"mesh", "scan.xyz", "is a cloud of points: as ground, the terrain `points` reads it"},
      {"mesh", "pit.dwg", "save it as DXF"},
      {"mesh", "pit.doc", "expected a file whose name ends in .obj, .ply or .stl"},
      {"points", "pit.ply", "is a surface of triangles: as ground, the terrain `mesh` reads it"},
      {"points", "scan.e57", "save it as LAS or XYZ"},
  };
  for (const auto& [terrain, file, says] : wrong) {
    const bool is_cloud = terrain == std::string("points");
    const std::string error =
        survey_error(terrain, TemporaryFile(file, "x"), is_cloud ? SurveyKeys{{"cell", 1.0}} : SurveyKeys{});
    INFO(terrain << " " << file << ": " << error);
    CHECK(error.find(says) != std::string::npos);
    CHECK(error.find("GDAL") == std::string::npos);
  }
}

}  // namespace survey_grids_test
