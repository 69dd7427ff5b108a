// The report in a browser. Needs Chromium (make deps-browser) and Plotly (make deps); says SKIPPED without
// them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <tuple>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace {

bool can_draw() {
  return std::system("command -v chromium > /dev/null") == 0 &&
         fs::exists(FLYROCK_SHARE_DIR "/report/plotly-cartesian.min.js");
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) ++found;
  return found;
}

struct Opened {
  std::string page;     ///< as the scripts left it
  std::string console;  ///< what it wrote to its console
  double seconds = 0;   ///< with the start of the browser
};

/// `flags`: of the browser; by default it has no WebGL.
Opened open_page(const Folder& folder, const fs::path& opened,
                 const std::string& flags = "--disable-gpu --disable-3d-apis") {
  const fs::path page = folder.path() / ".page", log = folder.path() / ".log";
  const std::string line = "timeout 120 chromium --headless --no-sandbox --window-size=1280,4000 " + flags +
                           " --enable-logging=stderr --user-data-dir='" +
                           (folder.path() / ".browser").string() + "' --dump-dom 'file://" + opened.string() +
                           "' >'" + page.string() + "' 2>'" + log.string() + "'";
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system(line.c_str());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  REQUIRE(WIFEXITED(status));
  REQUIRE(WEXITSTATUS(status) == 0);
  std::string console, text;
  for (std::ifstream lines(log); std::getline(lines, text);)
    if (text.find(":CONSOLE") != std::string::npos && text.find("willReadFrequently") == std::string::npos)
      console += text + '\n';  // without a hint about the speed of Plotly's letters in 3D
  return {read(page), console, seconds};
}

/// The captions of a page, without what is folded.
std::vector<std::string> captions_of(const std::string& page) {
  static const std::regex caption("<div class=\"caption\"><p>([^<]*)</p>");
  std::vector<std::string> list;
  for (auto found = std::sregex_iterator(page.begin(), page.end(), caption); found != std::sregex_iterator();
       ++found)
    list.push_back((*found)[1]);
  return list;
}

/// At most two sentences; the rest stands behind a fold.
void check_captions(const std::string& page) {
  static const std::regex end_of_sentence("[.!?]( |$)");
  CHECK(page.find("<p class=\"caption\"") == std::string::npos);
  const std::vector<std::string> captions = captions_of(page);
  CHECK_FALSE(captions.empty());
  for (const std::string& text : captions) {
    INFO(text);
    CHECK(std::distance(std::sregex_iterator(text.begin(), text.end(), end_of_sentence),
                        std::sregex_iterator()) <= 2);
  }
}

/// What a reader sees of a page: without its scripts, its data and the scenario.
std::string without_sources(std::string page) {
  for (const auto& [open, close] :
       {std::pair{"<script", "</script>"}, {"<style", "</style>"}, {"<pre", "</pre>"}})
    for (std::size_t at = 0; (at = page.find(open)) != std::string::npos;)
      page.erase(at, page.find(close, at) - at);
  return page;
}

/// Opens all folds and names the tables that are wider than the page in a window of 1280 pixels.
const char* const find_wide_tables = R"(<script>
for (const fold of document.querySelectorAll("details")) fold.open = true;
document.body.dataset.cut = [...document.querySelectorAll(".scroll")].filter((box) => box.scrollWidth > box.clientWidth)
  .map((box) => `${box.closest("section").id} ${box.scrollWidth}`).join(", ");
</script>
)";

/// Every section's plot holds a picture, no table is too wide, and the browser complained of nothing. At
/// least `plots` of them. Returns the seconds that the page took, with the start of the browser.
double check_drawn(const Folder& folder, const std::string& result, std::size_t plots) {
  std::string page = read(folder.path() / result / "report.html");
  const std::size_t end = page.rfind("</body>");
  REQUIRE(end != std::string::npos);
  page.insert(end, find_wide_tables);
  const Opened report = open_page(folder, folder.path() / folder.write("opened.html", page));
  CHECK(report.console == "");
  const std::size_t drawn = count(report.page, "<div class=\"plot js-plotly-plot\"");
  CHECK(drawn >= plots);
  CHECK(count(report.page, "<div class=\"plot\"") == 0);  // what a script did not draw
  CHECK(count(report.page, "class=\"plot-container plotly\"") == drawn);
  check_captions(report.page);
  const std::size_t cut = report.page.find("data-cut=\"");
  REQUIRE(cut != std::string::npos);
  CHECK(report.page.substr(cut, report.page.find('"', cut + 10) - cut + 1) == "data-cut=\"\"");
  // The last section stands: no script ended before.
  CHECK(report.page.find("<h2>How to reproduce this</h2>") != std::string::npos);
  WARN(result << ": " << drawn << " plots, " << report.seconds << " s with the start of the browser");
  return report.seconds;
}

}  // namespace

TEST_CASE("A browser draws every plot of a report and complains of nothing", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  const std::string scenario = "run " FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d.yaml --quiet ";
  REQUIRE(call(folder, scenario + "-o one").code == 0);  // its 1000 trials
  // Under 3 s on a machine that has nothing else to do: the machine of the tests has, which may take five
  // times as long.
  const double start =
      open_page(folder, folder.path() / folder.write("empty.html", "<!DOCTYPE html><title>Empty</title>"))
          .seconds;
  CHECK(check_drawn(folder, "one", 6) - start < 15);
  CHECK(fs::file_size(folder.path() / "one/report.html") < 10'000'000);
  REQUIRE(call(folder, scenario + "-o sweep --trials 50 --set terrain.berm=\"{ sweep: [6 m, 8 m, 10 m] }\" "
                                  "--set materials.haul_floor.friction=\"{ type: coulomb, mu: { sweep: [0.4, "
                                  "0.5, 0.6, 0.7] } }\"")
              .code == 0);
  check_drawn(folder, "sweep", 7);
}

TEST_CASE("A page prints the sweep point that its reader chose", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  std::string scenario = bench_with("mu: 0.6", "mu: { sweep: [0.3, 0.6, 0.9] }");
  scenario.replace(scenario.find("trials: 4"), 9, "trials: 60");
  folder.write("s.yaml", scenario);
  REQUIRE(call(folder, "run s.yaml --quiet -o r").code == 0);
  std::string page = read(folder.path() / "r/report.html");
  // As a reader does: chooses the last point, then prints.
  page.insert(page.rfind("</body>"), R"(<script>
{
  const select = document.querySelector("select[aria-label='Sweep point']");
  select.value = "2";
  select.dispatchEvent(new Event("change"));
  window.dispatchEvent(new Event("beforeprint"));
}
</script>
)");
  const Opened printed = open_page(folder, folder.path() / folder.write("printed.html", page));
  CHECK(printed.console == "");
  const auto summary = nlohmann::json::parse(read(folder.path() / "r/summary.json"));
  const auto p95 = [&](int point, int digits = 4) {
    const double value = summary.at("points").at(point).at("rocks").at(0).at("runout").at("p95");
    std::ostringstream text;  // as the page shows it
    text << std::setprecision(digits) << value;
    return text.str();
  };
  REQUIRE(p95(0) != p95(2));
  const std::string seen = without_sources(printed.page);
  const std::size_t drawing = seen.find("<h2>Section to scale</h2>"), inputs = seen.find("<h2>Inputs</h2>");
  REQUIRE(drawing < inputs);
  const std::string first = seen.substr(drawing, inputs - drawing);
  INFO(first);
  CHECK(first.find("Shown: all rocks, point 2: materials.rock.friction.mu = 0.9.") != std::string::npos);
  CHECK(first.find("95 % of all rocks stop within " + p95(2) + " m") != std::string::npos);
  CHECK(first.find("within " + p95(0) + " m") == std::string::npos);
  // On paper the line above the sections says what is shown, in place of the menu.
  CHECK(seen.find("<p class=\"shown\">Shown: all rocks, point 2: materials.rock.friction.mu = 0.9.</p>") !=
        std::string::npos);
  CHECK(count(seen, "Shown: all rocks, point 0") == 0);
  CHECK(count(seen, "class=\"tile\"") == 4);
  CHECK(seen.find("95 of 100 stop within</p><p class=\"value\">" + p95(2, 3) + " m</p>") !=
        std::string::npos);
}

TEST_CASE("A page that has no room for all sweep points says how many it shows", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  REQUIRE(call(folder,
               "run " FLYROCK_SOURCE_DIR "/scenarios/quarry/blasting_area.yaml --quiet -o area --trials 200 "
               "--set blast.hole.length=\"{ sweep: [11 m, 12 m, 13 m] }\" --set blast.burden=\"{ sweep: [2.5 "
               "m, 2.7 m, 2.9 m] }\" "
               "--set rocks.1.launch.drill_angle=\"70 deg\"")
              .code == 0);
  check_drawn(folder, "area", 5);
  const std::string page = open_page(folder, folder.path() / "area/report.html").page;
  CHECK(page.find("4 of 9 sweep points shown.") != std::string::npos);
  CHECK(page.find(">points 4 to 7</option>") != std::string::npos);
  CHECK(page.find(">point 8</option>") != std::string::npos);
  // No rock of 200 is censored: at most 1 - 0.025^(1/200) of them are.
  CHECK(page.find(">censored (95 %)</th>") != std::string::npos);
  CHECK(page.find(">0 % (0 to 1.83)</td>") != std::string::npos);
}

TEST_CASE("The page of the method ballistic speaks of first landings", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  REQUIRE(call(folder,
               "run " FLYROCK_SOURCE_DIR "/scenarios/quarry/stemming_ejection.yaml --quiet -o r --trials 200")
              .code <= 1);
  check_drawn(folder, "r", 5);
  const std::string page = without_sources(open_page(folder, folder.path() / "r/report.html").page);
  for (const char* said :
       {"<h2>First landing</h2>", "<h2>What the first landing depends on</h2>", ">first landed</td>"})
    CHECK(page.find(said) != std::string::npos);
  CHECK(count(page, "class=\"tile\"") == 0);  // a table answers the questions of the scenario
  for (const char* wrong : {"unout", "stopped", "came to rest", " rad<"}) {
    INFO(wrong);
    CHECK(page.find(wrong) == std::string::npos);
  }
}

namespace {

/// Names the words of the first page that an edge cuts: of the list beside the plan, and in the drawings.
const char* const find_cut_words = R"(<script>{
const cut = [];
for (const item of document.querySelectorAll(".key li, #questions td"))
  if (item.getBoundingClientRect().right > document.documentElement.clientWidth || item.scrollWidth > item.clientWidth + 1) cut.push(item.textContent);
for (const word of document.querySelectorAll(".plans text")) {
  const box = word.getBoundingClientRect(), sheet = word.ownerSVGElement.getBoundingClientRect();
  if (box.left < sheet.left - 1 || box.right > sheet.right + 1 || box.top < sheet.top - 1 || box.bottom > sheet.bottom + 1) cut.push(word.textContent);
}
document.body.dataset.cut = cut.join("; ");
}</script>
)";

}  // namespace

TEST_CASE("The first page of a permit has one sentence, a table, and a plan whose frame holds every landing",
          "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  REQUIRE(call(folder,
               "run " FLYROCK_SOURCE_DIR
               "/scenarios/quarry/permit.yaml --quiet -o r --trials 20 --set rocks.0.per_hole=10 --set "
               "rocks.1.per_hole=5 --set document.signature=true --set exposure.0.limit_per_year=0.01")
              .code == 0);
  const auto summary = nlohmann::json::parse(read(folder.path() / "r/summary.json"));
  std::string page = read(folder.path() / "r/report.html");
  page.insert(page.rfind("</body>"), find_cut_words);
  const fs::path opened = folder.path() / folder.write("opened.html", page);
  for (const char* width : {"1400", "800"}) {
    INFO(width << " pixels");
    const Opened drawn = open_page(
        folder, opened, "--disable-gpu --disable-3d-apis --window-size=" + std::string(width) + ",2000");
    CHECK(drawn.console == "");
    CHECK(drawn.page.find("data-cut=\"\"") != std::string::npos);
    const std::string seen = std::regex_replace(without_sources(drawn.page), std::regex("&nbsp;"), " ");
    // One sentence, then a row a question, then the drawing; percentiles stand after it.
    const std::size_t sentence = seen.find(summary.at("first_sentence").get<std::string>().substr(0, 40)),
                      table = seen.find("<table>"), drawing = seen.find("<svg"),
                      percentiles = seen.find("that 95 % of the rocks do not exceed"),
                      signature = seen.find("Date and signature");
    CHECK((sentence < table && table < drawing && drawing < percentiles && percentiles < signature));
    for (const auto& question : summary.at("points")[0].at("questions"))
      for (const char* cell : {"asks", "per_blast", "interval"}) {
        const std::string text = question.at(cell);
        INFO(text);
        CHECK(seen.find(">" + text + "</td>") != std::string::npos);
      }
    // All 24 holes have their number; the frame of the site holds every landing.
    CHECK(count(seen, "class=\"hole\"") == 24);
    CHECK(count(seen, "class=\"crest\"") >= 1);
    const std::string frame = "class=\"site\" data-frame=\"";
    const std::size_t site = seen.find(frame);
    REQUIRE(site != std::string::npos);
    std::istringstream numbers(seen.substr(site + frame.size()));
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    REQUIRE(numbers >> x0 >> x1 >> y0 >> y1);
    const auto outside = query(folder.path() / "r/results.db",
                               "SELECT count(*) FROM rocks WHERE stop_x_m NOT BETWEEN " + std::to_string(x0) +
                                   " AND " + std::to_string(x1) + " OR stop_y_m NOT BETWEEN " +
                                   std::to_string(y0) + " AND " + std::to_string(y1));
    CHECK(outside.at(0) == "0");
    // Hashes of what the run used.
    CHECK(seen.find("plugins/velocity/gurney/plugin.lua") != std::string::npos);
    CHECK(seen.find("plugins/velocity/lundborg/plugin.lua") == std::string::npos);
  }
}

TEST_CASE("A browser opens the report of a run in which rocks failed, all or some", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "fails", form = "newton",
  doc = "Fails in flight, above a mass.", source = "a test",
  params = { mass = fr.number { default = 0, min = 0, unit = "kg", doc = "of the lightest rock that fails" } },
  impact = function(p, contact)
    if contact.time > 0 and contact.mass > p.mass then error("too heavy") end
    return 0.4, 0
  end,
}
)");
  std::string text =
      "plugins: [law.lua]\n" + bench_with("{ type: newton, en: 0.3 }", "{ type: fails, mass: 200 }");
  text.replace(text.find("trials: 4"), 9, "trials: 40");
  text.replace(text.find("diameter: 0.5"), 13, "diameter: { uniform: [0.4, 0.7] }");
  text.replace(text.find("time: 60 s"), 10, "time: 3 s");
  folder.write("some.yaml", text);
  CHECK(call(folder, "run some.yaml --quiet -o some").code == 3);
  check_drawn(folder, "some", 5);  // too few rocks to rank inputs
  CHECK(call(folder, "run some.yaml --quiet -o all --set materials.rock.restitution.mass=0").code == 3);
  check_drawn(folder, "all", 1);
  CHECK(call(folder,
             "run some.yaml --quiet -o sweep --set materials.rock.restitution.mass=\"{ sweep: [0, 200] }\"")
            .code == 3);
  check_drawn(folder, "sweep", 1);
}

TEST_CASE("A browser with WebGL draws the ground and the paths of a 3D run, and keys turn the view",
          "[slow]") {
  if (!can_draw() || !fs::exists(FLYROCK_SHARE_DIR "/report/plotly-gl3d.min.js")) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  REQUIRE(call(folder,
               "run " FLYROCK_SOURCE_DIR
               "/plugins/terrain/mesh/example.yaml --quiet -o r --set barriers='[{ name: fence, line: "
               "[[30, -9], [31, 0], [30, 9]], height: 1 m, capacity: 10 kJ }]' --set gates='[{ name: track, "
               "line: [[33, -9], [33, 9]] }]'")
              .code == 0);
  std::string page = read(folder.path() / "r/report.html");
  CHECK(page.size() < 5'000'000);
  page.insert(
      page.rfind("</body>"),
      "<script>{ const node = document.querySelector('.space'), eye = () => ({ "
      "...node.layout.scene.camera.eye }),"
      " key = (key) => node.dispatchEvent(new KeyboardEvent('keydown', { key }));"
      " const at = [eye()]; for (const name of ['ArrowLeft', '+', 'Home']) { key(name); at.push(eye()); }"
      " const far = at.map((e) => Math.hypot(e.x, e.y, e.z)), same = (a, b) => Math.abs(a - b) < 1e-9;"
      " document.body.dataset.turned = [!same(at[0].x, at[1].x), same(far[0], far[1]), far[2] < 0.95 * "
      "far[1],"
      " same(at[0].x, at[3].x), node.data.map((t) => t.type === 'mesh3d' ? t.name : '').join('')].join(' '); "
      "}</script>\n");
  const fs::path with_keys = folder.path() / folder.write("keys.html", page);
  const Opened drawn = open_page(folder, with_keys, "--use-angle=swiftshader --enable-unsafe-swiftshader");
  CHECK(drawn.console == "");
  CHECK(drawn.page.find("data-turned=\"true true true true slopefacefence\"") != std::string::npos);
  CHECK(drawn.page.find("The ground is drawn with its own 12 triangles.") != std::string::npos);
  check_captions(drawn.page);
  // Without WebGL the plan and the long section stand.
  const Opened plain = open_page(folder, folder.path() / "r/report.html");
  CHECK(plain.console == "");
  CHECK(plain.page.find("This browser has no WebGL.") != std::string::npos);
  CHECK(count(plain.page, "<div class=\"plot js-plotly-plot\"") >= 3);
  // The plan names the heights of its contours, and the lines of gates and barriers.
  CHECK(plain.page.find(">height every ") != std::string::npos);
  CHECK(std::regex_search(plain.page, std::regex("class=\"annotation-text\"[^>]*>[0-9.-]+ m<")));
  for (const char* name : {">fence<", ">track<"}) CHECK(plain.page.find(name) != std::string::npos);
}

namespace {

/// A cell of a map: the middle, the value that gives its colour, and the one that it tells.
struct MapCell {
  double x, y, value, told;
};

std::vector<MapCell> map_cells(const std::vector<std::string>& lines) {
  std::vector<MapCell> cells;
  for (const std::string& line : lines) {
    MapCell cell{};
    REQUIRE(std::sscanf(line.c_str(), "%lf|%lf|%lf|%lf", &cell.x, &cell.y, &cell.value, &cell.told) == 4);
    cells.push_back(cell);
  }
  std::sort(cells.begin(), cells.end(),
            [](const MapCell& a, const MapCell& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  return cells;
}

/// Chooses maps one after the other. The page then ends with what each shows: the cells of its plot, and the
/// ends and marks of its colours.
const char* const choose_maps = R"(<script>{
const maps = document.getElementById("maps"), pictures = new Set();
const choose = (select, value) => { select.value = value; select.dispatchEvent(new Event("change")); };
for (const [colours, point, raster] of [["linear", 0, "Nr_passages"], ["linear", 0, "E_max"], ["linear", 1, "E_max"], ["linear", 1, "Ph_p95"], ["logarithmic", 0, "E_max"], ["own", 0, "E_max"]]) {
  choose(maps.querySelector('[aria-label="Colours"]'), colours);
  choose(document.querySelector('[aria-label="Sweep point"]'), point);
  choose(maps.querySelector('[aria-label="Raster"]'), raster);
  const map = maps.querySelector(".plot").data.findLast((trace) => trace.type === "heatmap");  // on the relief
  const lines = map.z.flatMap((row, i) => row.flatMap((value, j) =>
    (value === null ? [] : [`${map.x0 + j * map.dx}|${map.y0 + i * map.dy}|${value}|${map.customdata[i][j]}`])));
  const marks = (map.colorbar.tickvals ?? []).map((at, i) => `${at}|${map.colorbar.ticktext[i]}`);
  pictures.add([...maps.querySelectorAll(".heatmaplayer image")].at(-1).href.baseVal);
  const told = document.createElement("pre");
  told.textContent = `map ${raster} of ${point}, ${colours}: ${maps.querySelector(".note").textContent}\n${map.zmin} ${map.zmax} ${marks.join(" ")}\n${lines.join("\n")}\n`;
  document.body.append(told);
}
document.body.dataset.pictures = pictures.size;
}</script>
)";

}  // namespace

TEST_CASE("A browser draws the maps of a 3D run, each with the numbers of results.db", "[slow]") {
  if (!can_draw()) {
    WARN("SKIPPED: no Chromium or no Plotly");
    return;
  }
  const Folder folder;
  REQUIRE(
      call(folder,
           "run " FLYROCK_SOURCE_DIR
           "/plugins/terrain/mesh/example.yaml --quiet -o r --trials 20 --set output.maps='{ cell: 1 m }' "
           "--set materials.soil.friction.mu='{ sweep: [0.5, 0.8] }'")
          .code == 0);
  std::string page = read(folder.path() / "r/report.html");
  page.insert(page.rfind("</body>"), choose_maps);
  const Opened drawn = open_page(folder, folder.path() / folder.write("choices.html", page));
  CHECK(drawn.console == "");
  CHECK(drawn.page.find("data-pictures=\"5\"") != std::string::npos);  // "own" is one of the others
  for (const auto& [raster, point, colours] : {std::tuple{"Nr_passages", 0, "linear"},
                                               {"E_max", 0, "linear"},
                                               {"E_max", 1, "linear"},
                                               {"Ph_p95", 1, "linear"},
                                               {"E_max", 0, "logarithmic"},
                                               {"E_max", 0, "own"}}) {
    const std::string number = std::to_string(point);
    const std::string head =
        "<pre>map " + (raster + (" of " + number)) + ", " + colours + std::string(": Shown: ");
    INFO(head);
    const std::size_t start = drawn.page.find(head);
    REQUIRE(start != std::string::npos);
    std::istringstream told(drawn.page.substr(start, drawn.page.find("</pre>", start) - start));
    std::string note, scale;
    std::getline(told, note);
    std::getline(told, scale);
    std::vector<std::string> lines;
    for (std::string line; std::getline(told, line);) lines.push_back(line);
    const std::vector<MapCell> shown = map_cells(lines);
    const std::vector<MapCell> stored = map_cells(query(
        folder.path() / "r/results.db",
        std::string("SELECT x_m + (maps.\"column\" + 0.5) * cell_m, y_m + (maps.\"row\" + 0.5) * cell_m, ") +
            raster + ", 0 FROM maps JOIN map_grids USING (point) WHERE point = " + number));
    CHECK(note.find("point " + number + ": materials.soil.friction.mu = ") != std::string::npos);
    CHECK(note.find("; cells of 1 m, " + std::to_string(stored.size()) + " cells with rocks.") !=
          std::string::npos);
    REQUIRE(shown.size() == stored.size());
    REQUIRE(shown.size() > 100);
    const auto by_value = [](const MapCell& a, const MapCell& b) { return a.value < b.value; };
    const auto [least, most] = std::minmax_element(stored.begin(), stored.end(), by_value);
    REQUIRE(least->value > 0);
    const bool is_logarithmic = colours == std::string("logarithmic") ||
                                (colours == std::string("own") && most->value > 100 * least->value);
    const auto of_colour = [&](double value) { return is_logarithmic ? std::pow(10, value) : value; };
    std::size_t equal = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
      equal += shown[i].x == stored[i].x && shown[i].y == stored[i].y &&
               of_colour(shown[i].value) == Approx(stored[i].value).epsilon(6e-4) &&
               shown[i].told == Approx(stored[i].value).epsilon(6e-4);  // the page has four digits
    CHECK(equal == shown.size());
    // The colours reach from the least value, or from 0, to the greatest, and the marks stand at what they
    // say.
    std::istringstream ends(scale);
    double from = 0, to = 0, at = 0, text = 0;
    REQUIRE(ends >> from >> to);
    CHECK(of_colour(to) == Approx(most->value).epsilon(6e-4));
    CHECK((is_logarithmic ? of_colour(from) : from) ==
          Approx(is_logarithmic ? least->value : 0).epsilon(6e-4));
    std::size_t marks = 0;
    for (std::string mark; ends >> mark; ++marks) {
      REQUIRE(std::sscanf(mark.c_str(), "%lf|%lf", &at, &text) == 2);
      CHECK(std::pow(10, at) == Approx(text));
      CHECK((at >= from - 1e-6 && at <= to + 1e-6));
    }
    CHECK((is_logarithmic ? marks >= 2 : marks == 0));
  }
  // The triangles of this ground are larger than the map; their contours stand, and are named.
  const std::string section = drawn.page.substr(drawn.page.find("<section id=\"maps\""));
  CHECK(std::regex_search(section, std::regex("class=\"annotation-text\"[^>]*>10 m<")));
}
