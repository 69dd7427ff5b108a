// What the pages show works: each page is followed in a folder of its own, as a reader would.
//   - A block whose first line is a comment with nothing but a file name is written to that file.
//   - A block ```sh is run, and must end with exit code 0; its lines that start with `make` are left out.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "program.h"

using namespace flyrock::test;

namespace {

struct Block {
  std::string language, text;
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), ""});
    } else if (inside) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

/// The file that a block names: "-- laws/my_law.lua", "# my.yaml", "// damped.cpp"; else an empty text.
std::string file_of(const Block& block) {
  static const std::regex name("(?:--|#|//) ([a-z0-9_/]+\\.[a-z]+)\n");
  std::smatch match;
  const bool found = std::regex_search(block.text, match, name, std::regex_constants::match_continuous);
  return found ? match[1].str() : "";
}

/// A file that can be read as it stands, and is therefore to be named: the commands of its page use it.
bool is_whole(const Block& block) {
  if (block.language == "yaml") return block.text.find("flyrock: 1") != std::string::npos;
  return block.language == "lua" && block.text.find("return fr.") != std::string::npos;
}

std::string without_make(const std::string& commands) {
  std::istringstream lines(commands);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("make")) kept += line + '\n';
  return kept;
}

std::vector<fs::path> pages() {
  const fs::path source = FLYROCK_SOURCE_DIR;
  std::vector<fs::path> list = {source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(source / "scenarios"))
    if (fs::exists(entry.path() / "README.md")) list.push_back(entry.path() / "README.md");
  std::sort(list.begin(), list.end());
  return list;
}

void follow(const fs::path& page) {
  const Folder folder;
  fs::copy(FLYROCK_SOURCE_DIR "/scenarios", folder.path() / "scenarios", fs::copy_options::recursive);
  const fs::path bin = fs::path(FLYROCK_BINARY).parent_path();
  const std::string setting = "set -eu\nPATH='" + bin.string() +
                              "':$PATH FLYROCK='" FLYROCK_SOURCE_DIR "' FLYROCK_BUILD='" +
                              bin.parent_path().string() + "'\n";
  for (const Block& block : blocks_of(read(page))) {
    INFO(page << ":\n" << block.text);
    const std::string file = file_of(block);
    if (is_whole(block)) CHECK_FALSE(file.empty());
    if (!file.empty()) {
      fs::create_directories((folder.path() / file).parent_path());
      folder.write(file, block.text);
    }
    if (block.language != "sh") continue;
    folder.write("commands.sh", setting + without_make(block.text));
    const std::string line = "cd '" + folder.path().string() + "' && sh commands.sh >output 2>&1 </dev/null";
    const int code = std::system(line.c_str());
    INFO(read(folder.path() / "output"));
    CHECK(code == 0);
  }
}

/// Whether a program runs these lines: the packages that a recipe loads.
bool runs(const Folder& folder, const std::string& program, const std::string& option,
          const std::string& lines) {
  return shell(folder, program + " " + option + " '" + lines + "'").code == 0;
}

/// The lines of a recipe that load its packages.
std::string loads_of(const Block& block) {
  std::istringstream lines(block.text);
  std::string loads;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("import ") || line.starts_with("library(")) loads += line + '\n';
  return loads;
}

/// The words of a page that stand as code, from one heading to another.
std::set<std::string> code_words(const std::string& page, const std::string& from, const std::string& to) {
  const std::size_t begin = page.find(from);
  REQUIRE(begin != std::string::npos);
  const std::string text = page.substr(begin, page.find(to, begin) - begin);
  static const std::regex code("`([^`]*)`"), word("\\w+");
  std::set<std::string> words;
  for (auto span = std::sregex_iterator(text.begin(), text.end(), code); span != std::sregex_iterator();
       ++span) {
    const std::string inside = (*span)[1];
    for (auto found = std::sregex_iterator(inside.begin(), inside.end(), word);
         found != std::sregex_iterator(); ++found)
      words.insert(found->str());
  }
  return words;
}

/// The names of all fields, at any depth. Those of `at` are paths of the scenario.
void collect_fields(const nlohmann::json& value, std::set<std::string>& fields) {
  for (const auto& [key, inner] : value.items()) {
    if (value.is_object()) fields.insert(key);
    if (inner.is_structured() && key != "at") collect_fields(inner, fields);
  }
}

/// A row of the README's table of launch models: "| `gurney` | 35.3 | 295 (289 to 306) |".
struct ModelRow {
  std::string launch, speed, p95, lower, upper;
};

std::vector<ModelRow> model_rows(const std::string& readme) {
  static const std::regex row("\\| `(\\w+)`[^|]*\\| ([0-9.]+) \\| ([0-9]+) \\(([0-9]+) to ([0-9]+)\\) \\|");
  std::vector<ModelRow> rows;
  for (auto found = std::sregex_iterator(readme.begin(), readme.end(), row); found != std::sregex_iterator();
       ++found)
    rows.push_back({(*found)[1], (*found)[2], (*found)[3], (*found)[4], (*found)[5]});
  return rows;
}

}  // namespace

TEST_CASE("docs/results.md names every field of summary.json") {
  const Folder folder;
  const std::string scenarios = FLYROCK_SOURCE_DIR "/scenarios/";
  folder.write("law.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "fails", form = "newton",
  doc = "Fails in flight.", source = "a test",
  params = {},
  impact = function(p, contact)
    if contact.time > 0 then error("always") end
    return 0.4, 0
  end,
}
)");
  std::string failing = bench_with("{ type: newton, en: 0.3 }", "{ type: fails }");
  failing.replace(failing.find("trials: 4"), 9, "trials: 40");
  folder.write("failing.yaml", "plugins: [law.lua]\n" + failing);
  const std::pair<std::string, int> runs[] = {
      {scenarios + "course/fences.yaml --trials 20", 0},         // gates and barriers
      {scenarios + "quarry/blasting_area.yaml --trials 20", 0},  // blast, clearance by azimuth, reach
      {"failing.yaml", 3},                                       // faults, ended early
  };
  const std::set<std::string> named =
      code_words(read(FLYROCK_SOURCE_DIR "/docs/results.md"), "\n## summary.json\n", "\n## Chunks\n");
  std::set<std::string> fields;
  for (const auto& [arguments, code] : runs) {
    INFO(arguments);
    REQUIRE(call(folder, "run " + arguments + " --quiet --force -o r").code == code);
    collect_fields(nlohmann::json::parse(read(folder.path() / "r/summary.json")), fields);
  }
  for (const char* rare :
       {"gate", "barrier", "area", "reach", "blast", "ended_early", "not_asked", "fault_line"})
    CHECK(fields.count(rare) == 1);
  for (const std::string& field : fields) {
    INFO(field);
    CHECK(named.count(field) == 1);
  }
}

TEST_CASE("docs/architecture.md and docs/files.md name source files that exist") {
  std::vector<std::string> files;
  for (const char* tree : {"engine", "lua", "plugins", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FLYROCK_SOURCE_DIR) / tree))
      files.push_back("/" + entry.path().string());
  static const std::regex source("`((?:\\w+/)*\\w+\\.(?:h|cpp|ipp|js))`");
  const std::string page =
      read(FLYROCK_SOURCE_DIR "/docs/architecture.md") + read(FLYROCK_SOURCE_DIR "/docs/files.md");
  int named = 0;
  for (auto found = std::sregex_iterator(page.begin(), page.end(), source); found != std::sregex_iterator();
       ++found) {
    const std::string name = (*found)[1];
    if (name == "lua.h") continue;  // Lua's own
    INFO(name);
    CHECK(std::any_of(files.begin(), files.end(),
                      [&](const std::string& file) { return file.ends_with("/" + name); }));
    ++named;
  }
  CHECK(named > 100);
}

TEST_CASE("The Ninh Dan page has the distances that the program computes", "[slow]") {
  const Folder folder;
  const std::string blast =
      "run " FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d.yaml --quiet --force -o r";
  const std::vector<ModelRow> rows = model_rows(read(FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/README.md"));
  REQUIRE(rows.size() == 3);
  for (const ModelRow& row : rows) {
    INFO(row.launch);
    const std::string keys = row.launch == "bench_fit"        ? ", rock: limestone, form: linear"
                             : row.launch == "richards_moore" ? ", k: 27"
                                                              : "";
    REQUIRE(call(folder, blast + " --set rocks.0.launch='{ type: " + row.launch + keys +
                             ", elevation: { normal: { mean: 20 deg, sd: 10 deg } } }'")
                .code <= 1);  // gurney goes beyond what is expected
    const auto summary = nlohmann::json::parse(read(folder.path() / "r/summary.json"));
    const auto& fly_rock = summary.at("points").at(0).at("rocks").at(1);
    REQUIRE(fly_rock.at("group") == "fly_rock");
    CHECK(fmt::format("{:.1f}", fly_rock.at("launch_speed").at("p50").get<double>()) == row.speed);
    const auto& runout = fly_rock.at("runout");
    CHECK(fmt::format("{:.0f}", runout.at("p95").get<double>()) == row.p95);
    CHECK(fmt::format("{:.0f}", runout.at("intervals").at("p95").at(0).get<double>()) == row.lower);
    CHECK(fmt::format("{:.0f}", runout.at("intervals").at("p95").at(1).get<double>()) == row.upper);
  }
}

TEST_CASE("The reference is what the manifests say: make reference") {
  const Folder folder;
  int kinds = 0;
  const fs::path reference = FLYROCK_SOURCE_DIR "/docs/reference";
  for (const auto& entry : fs::directory_iterator(reference / "shapes"))
    CHECK(call(folder, "plugins shape/" + entry.path().stem().string() + " --svg").out == read(entry.path()));
  for (const auto& entry : fs::directory_iterator(FLYROCK_SOURCE_DIR "/plugins/shape"))
    if (entry.is_directory())
      CHECK(fs::exists(reference / "shapes" / (entry.path().filename().string() + ".svg")));
  for (const auto& entry : fs::directory_iterator(reference)) {
    if (entry.is_directory()) continue;
    const std::string kind = entry.path().stem().string();
    CHECK(call(folder, "plugins " + kind + " --markdown").out == read(entry.path()));
    ++kinds;
  }
  CHECK(kinds == 8);
}

TEST_CASE("No page, manifest or scenario takes a distance model on its own for where people stand") {
  const fs::path source = FLYROCK_SOURCE_DIR;
  const std::vector<std::string> models = {"richards_moore", "mckenzie", "lundborg"};
  const auto names_a_model = [&](const std::string& text) {
    return std::any_of(models.begin(), models.end(),
                       [&](const std::string& model) { return text.find(model) != std::string::npos; });
  };
  int with_clearance = 0;
  for (const char* tree : {"scenarios", "plugins"})
    for (const auto& entry : fs::recursive_directory_iterator(source / tree)) {
      const std::string text = entry.is_regular_file() ? read(entry.path()) : "";
      static const std::regex section("\n *clearance *[:=]"), factor("\\bfactor *[:=] *[0-9]");
      if (!names_a_model(text) || !std::regex_search(text, section)) continue;
      INFO(entry.path());
      CHECK_FALSE(std::regex_search(text, std::regex("name *[:=] *\"?people")));
      CHECK_FALSE(std::regex_search(text, factor));  // it would make the distance one of people
      CHECK(text.find("docs/which-model.md") != std::string::npos);
      ++with_clearance;
    }
  CHECK(with_clearance == 5);
  for (const std::string& model : models)
    CHECK(read(source / "plugins/velocity" / model / "plugin.lua").find("No distance for people") !=
          std::string::npos);

  const std::string page = read(source / "docs/which-model.md");
  const std::size_t row = page.find("| where people stand |");
  REQUIRE(row != std::string::npos);
  CHECK_FALSE(names_a_model(page.substr(row, page.find('\n', row) - row)));
  for (const char* count : {"239 to 263 of 264", "254 of 264", "64 to 75 %", "the worst hole"})
    CHECK(page.find(count) != std::string::npos);
}

TEST_CASE("every page is in the navigation of the site, and the navigation has no other") {
  const fs::path source = FLYROCK_SOURCE_DIR;
  const std::string site = read(source / "mkdocs.yml");
  const std::size_t begin = site.find("\nnav:\n");
  REQUIRE(begin != std::string::npos);
  static const std::regex file("\\S+\\.md");
  std::set<std::string> named, there = {"CHANGELOG.md"};
  for (auto found = std::sregex_iterator(site.begin() + static_cast<long>(begin), site.end(), file);
       found != std::sregex_iterator(); ++found)
    CHECK(named.insert(found->str()).second);
  for (const fs::path& page : pages()) there.insert(fs::relative(page, source).string());
  for (const std::string& page : there) {
    INFO(page << " needs a line under nav in mkdocs.yml");
    CHECK(named.count(page) == 1);
  }
  for (const std::string& page : named) {
    INFO(page << " is in mkdocs.yml");
    CHECK(there.count(page) == 1);
  }
}

TEST_CASE("the syllabus has a row for each lab of the course") {
  const std::string page = read(FLYROCK_SOURCE_DIR "/docs/course/README.md");
  const std::string syllabus = page.substr(page.find("\n## Syllabus\n"));
  static const std::regex lab("\\| \\d+ \\| \\[(\\w+)\\]"), row("\n\\| (\\w+) \\| \\d+ \\| ");
  std::vector<std::string> labs, rows;
  for (auto found = std::sregex_iterator(page.begin(), page.end(), lab); found != std::sregex_iterator();
       ++found)
    labs.push_back((*found)[1]);
  for (auto found = std::sregex_iterator(syllabus.begin(), syllabus.end(), row);
       found != std::sregex_iterator(); ++found)
    rows.push_back((*found)[1]);
  CHECK(labs.size() == 29);
  CHECK(rows == labs);
}

TEST_CASE("The pages do what they say", "[slow]") {
  for (const fs::path& page : pages()) follow(page);
}

TEST_CASE("README's permit command answers each question of its section", "[heavy]") {
  for (const Block& block : blocks_of(read(FLYROCK_SOURCE_DIR "/README.md"))) {
    if (block.text.find("quarry/permit") == std::string::npos) continue;
    const Folder folder;
    const fs::path bin = fs::path(FLYROCK_BINARY).parent_path();
    const std::string commands = block.text.substr(0, block.text.find_last_not_of('\n') + 1);
    const Output run = shell(folder, "PATH='" + bin.string() + "':$PATH; " + commands);
    INFO(run.out << run.err);
    REQUIRE(run.code == 0);
    const auto summary = nlohmann::json::parse(read(folder.path() / "out/permit/summary.json"));
    const auto& questions = summary.at("points")[0].at("questions");
    CHECK(questions.size() == 5);  // the distance, the customary one, house, road, shot-firer
    for (const auto& question : questions) {
      INFO(question.dump());
      CHECK(question.at("per_blast").get<std::string>().find("one in ") != std::string::npos);
      CHECK(question.at("interval").get<std::string>().find(" to ") != std::string::npos);
    }
    CHECK(run.out.find("One blast in 20 throws a rock beyond ") != std::string::npos);
    return;
  }
  FAIL("README has no permit");
}

TEST_CASE("the recipes for other programs run where these are installed", "[slow]") {
  const Folder folder;
  const Output run = call(
      folder, "run " FLYROCK_SOURCE_DIR
              "/scenarios/rockfall/natural_slope.lua --trials 20 --set terrain.crs=EPSG:2056 -o out/slope "
              "--quiet");
  INFO(run.err);
  REQUIRE(run.code == 0);
  REQUIRE(call(folder, "export out/slope --to vtk").code == 0);
  int recipes = 0;
  std::string skipped;
  for (const Block& block : blocks_of(read(FLYROCK_SOURCE_DIR "/docs/results-elsewhere.md"))) {
    if (block.language != "python" && block.language != "r") continue;
    ++recipes;
    const std::string file = file_of(block);
    REQUIRE_FALSE(file.empty());
    CHECK(std::count(block.text.begin(), block.text.end(), '\n') <= 26);
    const auto [program, option] =
        block.language == "r" ? std::pair("Rscript", "-e") : std::pair("python3", "-c");
    if (!runs(folder, program, option, loads_of(block))) {
      skipped += "SKIPPED: " + file + " needs " + program + " with\n" + loads_of(block);
      continue;
    }
    folder.write(file, block.text);
    const Output done = shell(folder, std::string(program) + " " + file);
    INFO(file << "\n" << done.out << done.err);
    REQUIRE(done.code == 0);
    REQUIRE_FALSE(done.out.empty());
  }
  REQUIRE(recipes == 3);
  if (!skipped.empty()) WARN(skipped);  // last, because CTest takes this word for the outcome of the test
}

TEST_CASE("The README says what its first command gives", "[slow]") {
  const Folder folder;
  REQUIRE(call(folder, "run " FLYROCK_SOURCE_DIR "/scenarios/ninh_dan/benches_2d.yaml --quiet -o r").code ==
          0);
  const auto summary = nlohmann::json::parse(read(folder.path() / "r/summary.json"));
  const auto& group = summary.at("points").at(0).at("rocks").at(1);
  REQUIRE(group.at("group") == "fly_rock");
  const auto& runout = group.at("runout");
  const auto metres = [](const nlohmann::json& value) { return fmt::format("{:.3g}", value.get<double>()); };
  const std::string words = fmt::format(
      "95 of 100 rocks stop within {} m (95 % interval {} to {} m), 99 within {} m, the farthest at {} m.",
      metres(runout.at("p95")), metres(runout.at("intervals").at("p95").at(0)),
      metres(runout.at("intervals").at("p95").at(1)), metres(runout.at("p99")), metres(runout.at("max")));
  const std::string readme =
      std::regex_replace(read(FLYROCK_SOURCE_DIR "/README.md"), std::regex("\\s+"), " ");
  INFO(words);
  CHECK(readme.find(words) != std::string::npos);
}
