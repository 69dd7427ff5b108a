// flyrock explain: the contact problem of one impact or step, as one would solve it by hand.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "cli/distributing_text.h"
#include "cli/explain_text.h"
#include "cli/loading.h"
#include "cli/runners.h"
#include "cli/solutions_text.h"
#include "files/safe_file.h"
#include "report/pictures/line_plot.h"
#include "solver/hdf5_file.h"
#include "solver/routh.h"
#include "units/units.h"

namespace flyrock::cli {

namespace po = boost::program_options;

namespace {

ExplainRequest request_of(const CommandLine& line) {
  if (line.has("impact") == line.has("step")) throw UsageError("expected one of --impact N and --step N");
  const char* which = line.has("impact") ? "impact" : "step";
  return {line.has("impact"), whole_number(line.text(which), fmt::format("--{}", which), 1)};
}

double exponent_of(const std::string& text) {
  const std::optional<double> exponent = parse_number(text);
  if (!exponent || !(*exponent >= 1 && *exponent <= 10))
    throw UsageError(fmt::format("--distributing is `{}`, expected an exponent from 1 to 10", text));
  return *exponent;
}

/// An index below `count`.
std::uint64_t index_of(const CommandLine& line, const std::string& option, std::uint64_t count) {
  const std::uint64_t index = whole_number(line.text(option), "--" + option, 0);
  if (index >= count) throw UsageError(fmt::format("--{} is {}, expected 0 to {}", option, index, count - 1));
  return index;
}

void save(const Explanation& explanation, const std::string& file, const std::string& title) {
  if (explanation.contacts.empty()) throw InputError("there is no problem to save: nothing is in contact");
  std::visit([&](const auto& stored) { write_fclib(file, stored.problem, stored.start, title); },
             explanation.problem);
}

/// Routh's diagram of the first contact of an impact. Throws InputError where there is none.
RouthDiagram routh_of(const Explanation& explanation) {
  if (explanation.dimension != 2 || explanation.contacts.empty())
    throw InputError("--routh draws a contact in 2D");
  const ExplainedContact& contact = explanation.contacts.front();
  const Eigen::Index n = explanation.w.rows() - explanation.rows;
  if (explanation.step > 0 || contact.before[0] >= 0 ||
      !explanation.w.topRightCorner(explanation.rows, n).isZero())
    throw InputError("--routh draws an impact whose first contact approaches, and is coupled to no other");
  return routh_diagram(explanation.w.topLeftCorner<2, 2>(), contact.before.head<2>(), contact.mu,
                       contact.law.e_n);
}

/// As SVG, or as CSV by the name of the file: the path, then the ends of the three laws.
void write_routh(const Explanation& explanation, const std::string& file, const std::string& title) {
  const RouthDiagram diagram = routh_of(explanation);
  const double mu = explanation.contacts.front().mu, end = diagram.path.back().impulse[0];
  const std::array<std::pair<const char*, const RouthPoint*>, 5> marks = {
      {{"end of slip", &diagram.slip_end},
       {"end of compression", &diagram.compression_end},
       {"newton", &diagram.newton},
       {"poisson", &diagram.poisson},
       {"energy", &diagram.energy}}};
  const std::array<std::pair<const char*, const std::vector<RouthPoint>*>, 2> lines = {
      {{"line of sticking", &diagram.sticking},
       {"line of greatest compression", &diagram.greatest_compression}}};
  if (std::filesystem::path(file).extension() == ".csv") {
    std::string csv = "at,pn_N_s,pt_N_s,vn_m_s,vt_m_s\n";
    const auto row = [&](const char* name, const RouthPoint& point) {
      csv += fmt::format("{},{},{},{},{}\n", name, point.impulse[0], point.impulse[1], point.velocity[0],
                         point.velocity[1]);
    };
    for (const RouthPoint& point : diagram.path) row("path", point);
    for (const auto& [name, point] : marks) row(name, *point);
    for (const auto& [name, line] : lines)
      for (const RouthPoint& point : *line) row(name, point);
    write_file(file, csv);
    return;
  }
  Plot plot{"Routh's diagram", "P_n [N s]", "P_t [N s]", {}};
  Curve path{"path", {}, {}, false};
  for (const RouthPoint& point : diagram.path) {
    path.x.push_back(point.impulse[0]);
    path.y.push_back(point.impulse[1]);
  }
  plot.curves.push_back(path);
  plot.curves.push_back({"bounds of friction", {end, 0, end}, {mu * end, 0, -mu * end}, true});
  const std::array<const char*, 2> meanings = {"line of sticking: v_t = 0",
                                               "line of greatest compression: v_n = 0"};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Curve line{meanings[i], {}, {}, true};
    for (const RouthPoint& point : *lines[i].second) {
      line.x.push_back(point.impulse[0]);
      line.y.push_back(point.impulse[1]);
    }
    if (!line.x.empty()) plot.curves.push_back(line);
  }
  // A mark is a short upright line.
  const double size = 0.04 * std::max(mu * end, 1e-3 * end);
  const std::array<const char*, 5> words = {
      "slip ends", "compression ends", "Newton ends: v_n = -e v_n before", "Poisson ends: P_n = (1 + e) P_c",
      "energy ends: work of restitution e^2 that of compression"};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Eigen::Vector2d& impulse = marks[i].second->impulse;
    plot.curves.push_back(
        {words[i], {impulse[0], impulse[0]}, {impulse[1] - size, impulse[1] + size}, false});
  }
  write_file(file, svg_of(title, {plot}));
}

}  // namespace

int explain(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("impact", po::value<std::string>()->value_name("N"),
                        "the N-th impact of the trial, from 1")(
      "step", po::value<std::string>()->value_name("N"), "the N-th step of the trial, from 1")(
      "point", po::value<std::string>()->default_value("0")->value_name("P"), "sweep point")(
      "trial", po::value<std::string>()->default_value("0")->value_name("T"), "trial")(
      "json", "as JSON, with all sweeps")("save", po::value<std::string>()->value_name("FILE.hdf5"),
                                          "writes the problem in the layout of FCLIB, for `flyrock solve`");
  options.add_options()("routh", po::value<std::string>()->value_name("FILE.svg|csv"),
                        "draws the path of the impact in the plane of its impulses, or writes it as CSV");
  options.add_options()(
      "distributing", po::value<std::string>()->value_name("EXPONENT"),
      "the impact by the law of Liu, Zhao and Brogliato, with springs of this exponent (1.5: Hertz)");
  options.add_options()("solutions",
                        "all complementary states of up to 12 contacts, feasible or not, and Lemke's path");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const ExplainRequest request = request_of(line);
  if (line.has("save") && !has_hdf5())
    throw InputError("--save needs a flyrock that was built with HDF5 (Debian: libhdf5-dev)");
  std::optional<LoadedScenario> loaded = load(line.words[0], overrides_of(line), false);
  if (!loaded) return bad_input;
  const std::uint64_t point = index_of(line, "point", loaded->plan.points.size());
  const Scenario& scenario = loaded->plan.points[point];
  const std::uint64_t trial = index_of(line, "trial", scenario.trials);
  if (scenario.method != Method::nscd)
    throw InputError("its method has no contact problems: only `nscd` solves them");
  std::optional<Runners> runners = try_runners(*loaded, 1);
  if (!runners) return bad_input;

  Explainer explainer(request);
  (*runners)[point]->explain(trial, explainer);
  const char* kind = request.impact ? "impact" : "step";
  if (!explainer.found())
    throw UsageError(fmt::format(
        "--{} is {}, but trial {} has {}", kind, request.number, trial,
        explainer.seen() == 0 ? fmt::format("no {}", kind) : fmt::format("{} of them", explainer.seen())));
  const std::string title = fmt::format("{} {} of trial {} of {}", kind, request.number, trial,
                                        std::filesystem::path(line.words[0]).filename().string());
  if (line.has("save")) save(*explainer.found(), line.text("save"), title);
  if (line.has("routh")) write_routh(*explainer.found(), line.text("routh"), title);
  std::optional<std::vector<IslandSolutions>> solutions;
  if (line.has("solutions")) solutions = solutions_of(*explainer.found());
  std::optional<std::vector<DistributedIsland>> distributed;
  if (line.has("distributing"))
    distributed = distribute(*explainer.found(), exponent_of(line.text("distributing")));
  if (line.has("json")) {
    nlohmann::ordered_json json = json_of(*explainer.found());
    if (solutions) json["solutions"] = json_of(*solutions);
    if (distributed) json["distributing"] = json_of(*distributed);
    fmt::print("{}\n", json.dump(1));
  } else {
    fmt::print("{}", text_of(*explainer.found(), title));
    if (solutions) fmt::print("{}", text_of(*explainer.found(), *solutions));
    if (distributed) fmt::print("{}", text_of(*explainer.found(), *distributed));
  }
  return done;
}

}  // namespace flyrock::cli
