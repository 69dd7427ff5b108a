// flyrock joints: sets of joints from a survey, and what they mean for a face.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/command.h"
#include "cli/terminal.h"
#include "files/safe_file.h"
#include "report/page/joints_page.h"
#include "scenario/layer_table.h"
#include "units/units.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

constexpr double deg = pi / 180;

po::options_description joints_options() {
  po::options_description options("options");
  const auto text = [](const char* value) { return po::value<std::string>()->value_name(value); };
  options.add_options()("sets", text("K"), "how many sets, 1 to 6; default: by BIC")(
      "face", text("DIP/DIRECTION"),
      "of a face, in degrees: which planes could let it fail; needs --friction")(
      "friction", text("ANGLE"), "friction angle of the joints, such as \"35 deg\"; needs --face")(
      "lateral", text("ANGLE"),
      "greatest difference between the directions of a plane and the face; default 20 deg")(
      "scanline", text("TREND/PLUNGE"),
      "the line along which planes were met, in degrees, where the table has none")(
      "blind", text("ANGLE"), "planes with a smaller angle to their scanline are left out; default 15 deg")(
      "seed", text("N"), "of the random starts and the bootstrap; default 1")(
      "output,o", text("DIR"),
      "folder of joints.html, joints.json and sets.yaml; default out/<survey>-joints");
  return options;
}

/// An angle with or without its unit; without one it is in degrees.
double angle_of(const std::string& text, const std::string& option, double low, double high) {
  const auto refuse = [&] {
    return UsageError(
        fmt::format("--{}: `{}`, expected an angle from {} to {} deg", option, text, low, high));
  };
  double degrees = 0;
  if (const auto quantity = parse_quantity(text); quantity && quantity->has_unit) {
    if (quantity->unit.dimension != dimension::angle) throw refuse();
    degrees = quantity->si() / deg;
  } else {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), degrees);
    if (code != std::errc() || end != text.data() + text.size()) throw refuse();
  }
  if (!(degrees >= low && degrees <= high)) throw refuse();
  return degrees * deg;
}

/// "70/180": two angles in degrees.
std::pair<double, double> pair_of(const std::string& text, const std::string& option, double low, double high,
                                  bool direction_first) {
  const std::size_t slash = text.find('/');
  if (slash == text.npos)
    throw UsageError(fmt::format("--{}: `{}`, expected two angles in degrees: {}", option, text,
                                 direction_first ? "TREND/PLUNGE" : "DIP/DIRECTION"));
  const std::string first = text.substr(0, slash), second = text.substr(slash + 1);
  const double direction = angle_of(direction_first ? first : second, option, 0, 360);
  const double dip = angle_of(direction_first ? second : first, option, low, high);
  return {dip, direction};
}

SurveyOptions read_options(const CommandLine& line) {
  SurveyOptions options;
  if (line.has("sets")) {
    options.sets = static_cast<int>(std::min<std::uint64_t>(whole_number(line.text("sets"), "--sets", 1), 7));
    if (options.sets > 6) throw UsageError("--sets: expected 1 to 6");
  }
  if (line.has("face") != line.has("friction"))
    throw UsageError("--face and --friction: expected both or none");
  if (line.has("lateral") && !line.has("face")) throw UsageError("--lateral: needs --face");
  if (line.has("face")) {
    SlopeFace& face = options.face.emplace();
    std::tie(face.dip, face.direction) = pair_of(line.text("face"), "face", 0, 90, false);
    face.friction = angle_of(line.text("friction"), "friction", 0, 90);
    face.lateral = line.has("lateral") ? angle_of(line.text("lateral"), "lateral", 0, 90) : 20 * deg;
  }
  if (line.has("scanline")) {
    const auto [plunge, trend] = pair_of(line.text("scanline"), "scanline", -90, 90, true);
    options.scanline = line_of(trend, plunge);
  }
  options.blind = line.has("blind") ? angle_of(line.text("blind"), "blind", 0, 89) : 15 * deg;
  if (line.has("seed")) options.seed = whole_number(line.text("seed"), "--seed", 0);
  return options;
}

/// The planes of a table. What is wrong is told; then nothing.
std::optional<std::vector<SurveyedPlane>> read_survey(const std::string& path) {
  Diagnostics diagnostics;
  const Value nothing;
  const Node where = Node::root(nothing);
  const TableColumn columns[] = {{.name = "dip", .dimension = dimension::angle, .required = true},
                                 {.name = "dip_direction", .dimension = dimension::angle, .required = true},
                                 {.name = "position", .dimension = dimension::length},
                                 {.name = "scanline_trend", .dimension = dimension::angle},
                                 {.name = "scanline_plunge", .dimension = dimension::angle},
                                 {.name = "trace_length", .dimension = dimension::length},
                                 {.name = "weight", .dimension = dimension::none}};
  const auto table = read_any_table(path, columns, {}, where, diagnostics);
  std::vector<SurveyedPlane> planes;
  const auto number = [&](std::size_t row, const char* column, double low, double high) {
    const auto value = table->number(row, column);
    if (value && !(*value >= low && *value <= high * (1 + 1e-12)))
      diagnostics.error(
          table->at(row, column), "",
          fmt::format("`{}` is {:.6g} deg, expected {:g} to {:g} deg; write angles with their unit: "
                      "`{}_deg`",
                      column, *value / deg, low / deg, high / deg, column));
    return value;
  };
  for (std::size_t row = 0; table && row < table->rows(); ++row) {
    SurveyedPlane& plane = planes.emplace_back();
    plane.dip = number(row, "dip", 0, 90 * deg).value_or(0);
    plane.direction = number(row, "dip_direction", 0, 360 * deg).value_or(0);
    plane.position = table->number(row, "position");
    const auto trend = number(row, "scanline_trend", 0, 360 * deg);
    const auto plunge = number(row, "scanline_plunge", -90 * deg, 90 * deg);
    if (trend) plane.scanline = line_of(*trend, plunge.value_or(0));
    if (plunge && !trend)
      diagnostics.error(table->at(row, "scanline_plunge"), "", "`scanline_plunge` needs `scanline_trend`");
    plane.weight = table->number(row, "weight").value_or(1);
    plane.trace = table->number(row, "trace_length");
    if (plane.trace && !(*plane.trace > 0))
      diagnostics.error(table->at(row, "trace_length"), "", "`trace_length` must be above 0");
    if (!(plane.weight > 0)) diagnostics.error(table->at(row, "weight"), "", "`weight` must be above 0");
  }
  tell("{}", diagnostics.to_text());
  if (!table || diagnostics.has_errors()) return std::nullopt;
  return planes;
}

}  // namespace

int joints(const Command& command, const Arguments& arguments) {
  const CommandLine line = parse(command, joints_options(), arguments, 1, 1);
  if (line.help) return done;
  const std::string& path = line.words[0];
  const SurveyOptions options = read_options(line);
  const fs::path folder = line.has("output") ? fs::path(line.text("output"))
                                             : fs::path("out") / (fs::path(path).stem().string() + "-joints");
  if (folder.empty()) throw UsageError("--output: expected a folder");
  const auto planes = read_survey(path);
  if (!planes) return bad_input;
  const std::string file = fs::path(path).filename().string();
  JointSurvey survey;
  try {
    survey = survey_of(*planes, options);
  } catch (const std::invalid_argument& fault) {
    throw InputError(fmt::format("{}: {}", path, fault.what()));
  }
  make_folder(folder);
  write_file(folder / "sets.yaml", sets_yaml(file, survey));
  write_file(folder / "joints.json", joints_data(survey, options).dump(2) + "\n");
  write_file(folder / "joints.html", joints_page(file, survey, options));
  for (const std::string& sentence : survey_sentences(survey, options)) fmt::print("{}\n", sentence);
  fmt::print("page: {}\n", (folder / "joints.html").string());
  return done;
}

}  // namespace flyrock::cli
