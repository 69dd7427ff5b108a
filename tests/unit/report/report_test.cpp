#include <stdlib.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "document/yaml_reader.h"
#include "files/safe_file.h"
#include "report/page/html.h"
#include "report/page/report_data.h"
#include "report/page/runout_data.h"
#include "report/page/scenario_text.h"
#include "report/page/tracks.h"
#include "report/page/used_sources.h"
#include "report/tables/summary_data.h"
#include "report/tables/tables.h"
#include "results/say/answer.h"
#include "unit/results/fake_results.h"
#include "units/units.h"

using namespace flyrock;

namespace {

Results results_of(const Plan& plan, std::uint64_t trials, const ReaderOfPoint& reader = {}) {
  const std::size_t points = plan.points.size();
  Results results = make_results(plan, fake::rows(trials, static_cast<int>(points)),
                                 {std::vector<std::uint64_t>(points, trials), true, "", {}}, reader);
  for (PointResult& point : results.points) point.terrain = fake::bench();
  return results;
}

ReaderOfPoint reader_of(ReportData& data) {
  return [&data](std::size_t point, const std::vector<RunoutExtent>& runouts) {
    return data.reader(point, runouts);
  };
}

nlohmann::ordered_json data_of(const Plan& plan, std::uint64_t trials) {
  LoadedScenario scenario;
  scenario.plan = plan;
  const std::vector<Rows> rows = fake::rows(trials, static_cast<int>(plan.points.size()));
  ReportData data(scenario);
  for (std::size_t p = 0; p < rows.size(); ++p)
    rows[p](Part::whole, [&](const TrialRecords& chunk) { data.add(static_cast<int>(p), chunk, chunk); });
  const Results results = results_of(plan, trials, reader_of(data));
  return data.finish(results, ground_pictures(results.points));
}

RunoutData runouts(const std::vector<Bounded>& values, double greatest) {
  RunoutData data({.count = values.size(), .greatest = greatest});
  do {
    for (const Bounded& value : values) data.add(value, 1);
  } while (data.needs_another_pass());
  return data;
}

const std::filesystem::path assets = std::filesystem::path(FLYROCK_SHARE_DIR) / "report";

std::string first_lines(const std::string& text, int count) {
  std::size_t at = 0;
  for (int i = 0; i < count; ++i) at = text.find('\n', at) + 1;
  return text.substr(0, at);
}

}  // namespace

TEST_CASE("the scripts of the page share one scope: each name is defined once") {
  const std::regex definition("(?:^|\\n)(?:const|let|function) ([A-Za-z_0-9]+)");
  std::map<std::string, std::string> script_of;
  for (const auto& entry : std::filesystem::directory_iterator(assets)) {
    if (entry.path().extension() != ".js" || entry.path().filename().string().ends_with(".min.js")) continue;
    const std::string text = read_file(entry.path()), name = entry.path().filename().string();
    for (std::sregex_iterator i(text.begin(), text.end(), definition), end; i != end; ++i) {
      INFO((*i)[1] << " in " << name << " and " << script_of[(*i)[1]]);
      CHECK(script_of[(*i)[1]].empty());
      script_of[(*i)[1]] = name;
    }
  }
  CHECK(script_of.size() > 100);
}

TEST_CASE("rocks.csv has a row per rock with the shortest decimals") {
  Plan plan = fake::plan(1);
  std::vector<RockRecord> rocks = fake::records(1).rocks;
  RockRecord& rock = rocks[0];
  rock = {};
  rock.mass = 0.1;
  rock.volume = 1.0 / 3;
  rock.launch_elevation = pi / 2;
  rock.reason = StopReason::timed_out;
  rock.censored = true;
  rock.max_energy = 1e22;
  rock.impacts = 4;
  const std::string csv = rocks_csv_header(plan) + rocks_csv_rows(plan, 0, rocks);
  CHECK(first_lines(csv, 2) ==
        "point,trial,rock,group,mass_kg,volume_m3,launch_speed_m_s,launch_elevation_deg,stop_reason,censored,"
        "runout_m,max_distance_m,stop_x_m,stop_y_m,flight_range_m,bounce_height_m,max_speed_m_s,max_energy_J,"
        "impacts,time_s\n"
        "0,0,0,blocks,0.1,0.3333333333333333,0,90,timed_out,1,0,0,0,0,0,0,0,1e+22,4,0\n");
  CHECK(csv.find("\"loose, small\"") != std::string::npos);
  rock.runout = std::numeric_limits<double>::quiet_NaN();
  rock.stop_x = -std::numeric_limits<double>::infinity();
  CHECK(first_lines(rocks_csv_rows(plan, 0, rocks), 1) ==
        "0,0,0,blocks,0.1,0.3333333333333333,0,90,timed_out,1,,0,,0,0,0,0,1e+22,4,0\n");
}

TEST_CASE("summary.json holds statistics, censoring, expectations and warnings") {
  Plan plan = fake::plan(200);
  Expectation below, between;
  below.measure = "rocks.runout.p50";
  below.kind = ExpectKind::below;
  below.value = 280;
  between.measure = "rocks.runout.max";
  between.kind = ExpectKind::between;
  between.value = 1;
  between.high = 2;
  plan.points[0].expect = {below, between};
  const auto data = summary_data(plan, results_of(plan, 200));
  const auto& all = data["points"][0]["rocks"][0];
  CHECK(all["group"].is_null());
  CHECK(all["count"] == 400);
  CHECK(all["censored"] == 0.01);
  CHECK(all["stop_reasons"]["left_domain"] == 4);
  CHECK(all["share_intervals"]["censored"][1].is_null());  // in two trials of 200, with two rocks each
  CHECK(all["share_intervals"]["timed_out"][0] == 0);
  CHECK(all["share_intervals"]["timed_out"][1].get<double>() == Approx(1 - std::pow(0.025, 1.0 / 200)));
  CHECK(data["points"][0]["censored"][0]["rocks"] == 4);
  CHECK(data["points"][0]["censored"][0]["reason"] == "left_domain");
  CHECK(all["runout"]["lower_bounds"].back() == "p99");
  CHECK(data["expectations"].size() == 2);
  CHECK(data["expectations"][0]["expected"] == 280);
  CHECK(data["expectations"][1]["expected"] == nlohmann::ordered_json::array({1.0, 2.0}));
  CHECK(data["expectations"][1]["passed"] == false);
  CHECK(data["expectations"][1]["reason"] ==
        "censored rocks fall into it: the computed value is only a lower bound");
  CHECK(data["warnings"].empty());  // what changes nothing does not hide a warning
  CHECK(data["not_asked"][0] == "material mud: nothing touched it, none of its laws was asked");
  CHECK(data["not_used"][0] == "blast.spacing (bench_fit does not read it)");
  CHECK(data["complete"] == true);
}

TEST_CASE("A law of a material that was met, and never asked, is a warning") {
  Plan plan = fake::plan(1);
  Plugin newton;
  newton.spec.name = "newton";
  plan.points[0].materials[0].restitution = PluginUse{&newton, {}, {}, ""};
  plan.points[0].materials[0].friction = PluginUse{&newton, {}, {}, ""};
  PointResult result;
  result.totals.materials = {{.contacts = 3, .restitution = 0, .friction = 3}, {.contacts = 1}};
  CHECK(laws_never_asked(plan, {result}) ==
        std::vector<std::string>{"material rock: its restitution newton was never asked"});
}

TEST_CASE("Problems that did not converge are a warning that can be held against the tolerance") {
  const Plan plan = fake::plan(1);
  TrialRecords records = fake::records(1, 0);
  records.totals.quality.not_converged = 2;
  records.totals.quality.problems = 1000;
  records.totals.quality.not_converged_residual = 1.5e-6;
  const Results results = make_results(plan, {rows_of(records)}, {{1}, true, "", {}});
  const std::string expected =
      "solver: 2 of 1000 contact problems did not converge; relative to the approach speed their greatest "
      "residual is "
      "1.5e-06, solver.tolerance is 1e-07";
  CHECK(std::count(results.warnings.begin(), results.warnings.end(), expected) == 1);
}

TEST_CASE("The answer names the censored share first of all") {
  const Plan plan = fake::plan(200);
  const std::string text = answer(plan, results_of(plan, 200));
  CHECK(text.find("The runout that 95 % of the rocks do not exceed is blocks >= ") == 0);
  CHECK(text.find(", loose, small >= ") != std::string::npos);  // each group, because a mixture says little
  CHECK(text.find("1 % (too few trials for an interval: about 1000) of the rocks are censored") !=
        std::string::npos);
  CHECK(answer(plan, make_results(plan, {rows_of({})}, {{0}, true, "", {}})) == "No rock was released.");
}

TEST_CASE("The assumptions are those of the method") {
  Plan plan = fake::plan(1);
  CHECK(assumptions(plan).find(
            "each rock alone, rocks do not meet each other, no drag of the air; contacts by non-smooth") !=
        std::string::npos);
  plan.points[0].method = Method::ballistic;
  CHECK(assumptions(plan).find("Assumed: a vertical section (2D), each rock is a point whose path ends where "
                               "it first meets the ground") == 0);
  CHECK(assumptions(plan).find("no drag of the air.") != std::string::npos);
  for (RockGroup& group : plan.points[0].rocks) group.air.emplace();
  CHECK(assumptions(plan).find("drag of the air as on a sphere of equal volume.") != std::string::npos);
  CHECK(assumptions(plan).find("contact") == std::string::npos);
}

TEST_CASE("The same results give the same page, safe against its own data") {
  const Plan plan = fake::plan(50, 2);
  const std::string page = report_html(data_of(plan, 50), assets);
  CHECK(page == report_html(data_of(plan, 50), assets));
  CHECK(page.find("<h1>A &lt;/script&gt; &amp; &lt;b&gt;test&lt;/b&gt;</h1>") != std::string::npos);
  const std::size_t data = page.find("<script type=\"application/json\"");
  const std::size_t end = page.find("</script>", data);
  CHECK(page.find('<', data + 1) == end);  // no "<" within the data
  CHECK(page.find("http-equiv") == std::string::npos);
  CHECK(page.find(" src=") > page.find("id=\"data\""));  // nothing is fetched before the data
  CHECK(page.size() < 10'000'000);
}

TEST_CASE("A page without plots says so, and how to get them") {
  const Plan plan = fake::plan(1);
  std::string name = (std::filesystem::temp_directory_path() / "flyrock-assets-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  std::filesystem::copy(assets, folder);
  const std::string note = "<p class=\"note\">Plots are missing, because flyrock was built without Plotly";
  std::filesystem::remove(folder / "plotly-cartesian.min.js");
  const std::string page = report_html(data_of(plan, 1), folder);
  CHECK(page.find(note) < page.find("<div id=\"report\">"));
  CHECK(page.find("<code>make deps</code>") != std::string::npos);
  std::ofstream(folder / "plotly-cartesian.min.js") << "window.Plotly = {};";
  CHECK(report_html(data_of(plan, 1), folder).find(note) == std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("The first line of a page with rocks that diverged says so, above everything") {
  const Plan plan = fake::plan(50);
  CHECK(report_html(data_of(plan, 50), assets).find("class=\"alarm\"") == std::string::npos);
  TrialRecords records = fake::records(50);
  for (const std::size_t rock : {7, 9, 12}) {
    records.rocks[rock].reason = StopReason::diverged;
    records.rocks[rock].fault = "below the ground";
  }
  records.rocks[20].reason = StopReason::plugin_error;
  records.rocks[20].fault = "plugin <b>: failed";
  LoadedScenario scenario;
  scenario.plan = plan;
  ReportData data(scenario);
  data.add(0, records, records);
  Results results = make_results(plan, {rows_of(records)}, {{50}, true, "", {}}, reader_of(data));
  results.points[0].terrain = fake::bench();
  const std::string page = report_html(data.finish(results, ground_pictures(results.points)), assets);
  const std::string line =
      "<main>\n<p class=\"alarm\">3 of 100 rocks diverged and 1 failed: below the ground (trial 3, rock 1); "
      "plugin &lt;b&gt;: failed "
      "(trial 10, rock 0). They are in no number of this report: find the cause before you use it.</p>\n<h1>";
  CHECK(page.find(line) != std::string::npos);
}

TEST_CASE("The page shows the angles of a scenario in degrees that read back as the same number") {
  const auto shown = [](const std::string& text) {
    Value scenario, angle;
    angle.data = text;
    scenario.data = Map{{"title", {}, angle}, {"angle", {}, angle}};
    return scenario_text(scenario);
  };
  for (const char* degrees : {"70 deg", "33 deg", "-12.5 deg", "0 deg", "0.001 deg", "359.9 deg"}) {
    const std::string resolved = shortest(parse_quantity(degrees)->si()) + " rad";
    CHECK(shown(resolved) == "title: " + resolved + "\nangle: " + degrees + "\n");
  }
  for (int i = 1; i <= 1000; ++i) {
    const double angle = i * 0.0012345678901234;
    const std::string text = shown(shortest(angle) + " rad");
    const std::string written = text.substr(text.find("angle: ") + 7);
    INFO(written);
    CHECK(parse_quantity(written.substr(0, written.size() - 1))->si() == angle);
  }
  CHECK(shown("2 m/s") == "title: 2 m/s\nangle: 2 m/s\n");
}

TEST_CASE("A page without its style sheet is an error that names it") {
  const Plan plan = fake::plan(1);
  CHECK_THROWS_WITH(report_html(data_of(plan, 1), "/nowhere"),
                    Catch::Contains("cannot read /nowhere/report.css"));
}

TEST_CASE("A histogram and its curve count every rock once") {
  std::vector<Bounded> values;
  for (int i = 0; i < 5000; ++i) values.push_back({0.05 * i, i % 1000 == 999});
  const auto data = runouts(values, 0.05 * 4999).data();
  std::uint64_t known = 0, censored = 0;
  for (const auto& count : data["known"]) known += count.get<std::uint64_t>();
  for (const auto& count : data["censored"]) censored += count.get<std::uint64_t>();
  CHECK(known == 4995);
  CHECK(censored == 5);
  CHECK(data["step"] == 10);
  CHECK(data["share"].back() == 0);
  CHECK(data["x"].size() == data["share"].size());
  CHECK(data["x"].size() < 600);
  CHECK(data["known_to"] == 49950);
  CHECK(runouts({}, 0).data()["known"].size() == 1);
  CHECK(runouts({{0, false}, {0, false}}, 0).data()["known"][0] == 2);
}

TEST_CASE("A thinned path keeps its corners and its ends") {
  std::vector<Vec3> path, turn;
  for (int i = 0; i <= 100; ++i) path.emplace_back(i, i <= 50 ? i : 100 - i, 0);
  CHECK(simplify(path, 1e-6) == std::vector<std::size_t>{0, 50, 100});
  for (const Vec3& p : path) turn.emplace_back(p.x(), 0, p.y());
  CHECK(simplify(turn, 1e-6) == std::vector<std::size_t>{0, 50, 100});  // level, but it turns in plan
  CHECK(simplify({}, 1).empty());
  CHECK(simplify({{1, 1, 0}}, 1) == std::vector<std::size_t>{0});
  // A closed path: its ends coincide, and the farthest point is kept.
  CHECK(simplify({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 0.1) == std::vector<std::size_t>{0, 1, 2});
}

namespace document_test {

std::string page_with(const nlohmann::ordered_json& document) {
  const nlohmann::ordered_json summary = {
      {"title", "t"},       {"fault_line", ""}, {"answer", "One. Two."}, {"first_sentence", "One."},
      {"assumptions", "a"}, {"dimension", 2},   {"document", document}};
  return report_html({{"summary", summary}}, std::string(FLYROCK_SHARE_DIR) + "/report");
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace document_test

using document_test::has;

TEST_CASE("the head of a page names who checked it and its revision, and lines to sign on are asked for") {
  const nlohmann::ordered_json texts = {{"author", "A <b>"}, {"checked_by", "C"}, {"revision", "B"}};
  const std::string plain = document_test::page_with(texts);
  CHECK(has(plain, "<b>Author</b> A &lt;b&gt; · <b>Checked by</b> C · <b>Revision</b> B</p>"));
  CHECK_FALSE(has(plain, "Date and signature"));
  nlohmann::ordered_json to_sign = texts;
  to_sign["signature"] = true;
  const std::string page = document_test::page_with(to_sign);
  CHECK(has(page, "<p>Author: A &lt;b&gt;</p><p>Date and signature</p>"));
  CHECK(has(page, "<p>Checked by: C</p><p>Date and signature</p>"));
  CHECK_FALSE(has(page, "<b>Signature</b>"));
}

TEST_CASE("the first sentence of the answer stands alone, the rest after the drawing") {
  const std::string page = document_test::page_with({{"author", "A"}});
  CHECK(has(page, "<p class=\"answer\">One.</p>\n<div id=\"questions\"></div>"));
  CHECK(has(page, "<p class=\"rest\">Two.</p>"));
}

TEST_CASE(
    "the hashes of a page are those of the plugins that the scenario names, and of all that a user wrote") {
  LoadedScenario loaded;
  Diagnostics diagnostics;
  loaded.plan.resolved =
      *read_yaml(R"(rocks: [{ launch: { type: gurney }, shape: { type: { sweep: [sphere, box] } } }]
terrain: { type: mine }
blast: { lundborg: 3 }
)",
                 "s.yaml", diagnostics);
  for (const char* name : {"plugins/velocity/gurney/plugin.lua", "plugins/velocity/lundborg/plugin.lua",
                           "plugins/shape/sphere/plugin.lua", "plugins/shape/box/plugin.lua",
                           "plugins/shape/cone/plugin.lua", "my_terrain.lua", "plugins/mine.lua"})
    loaded.sources.push_back({name, "0"});
  std::vector<std::string> used;
  for (const SourceHash& source : used_sources(loaded)) used.push_back(source.name);
  CHECK(used == std::vector<std::string>{"plugins/velocity/gurney/plugin.lua",
                                         "plugins/shape/sphere/plugin.lua", "plugins/shape/box/plugin.lua",
                                         "my_terrain.lua", "plugins/mine.lua"});
}
