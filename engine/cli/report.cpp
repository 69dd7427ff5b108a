// Draws report.html again from the data in results.db, with the scripts of this flyrock; beside another run,
// and as a PDF.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/result_folder.h"
#include "cli/run_program.h"
#include "files/safe_file.h"
#include "host/share.h"
#include "report/page/against.h"
#include "report/page/html.h"
#include "report/page/motion_data.h"
#include "report/tables/database.h"

namespace flyrock::cli {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
namespace po = boost::program_options;

Json json_in(const fs::path& file) { return Json::parse(read_file(file)); }

/// What changed since the run in another result folder.
Json since(const fs::path& other, const fs::path& folder) {
  const Json manifests[] = {json_in(other / "manifest.json"), json_in(folder / "manifest.json")};
  const Json summaries[] = {json_in(other / "summary.json"), json_in(folder / "summary.json")};
  return against_data({manifests[0], summaries[0]}, {manifests[1], summaries[1]});
}

/// The page for the data in the database. Throws UnreadableFile.
std::string page_of(const fs::path& folder, const std::optional<fs::path>& other) {
  const fs::path database = folder / "results.db";
  try {
    Json data = Json::parse(stored_report(database));
    add_motion(data, database);
    if (other) data["against"] = since(*other, folder);
    return report_html(data, fs::path(share_folder()) / "report");
  } catch (const nlohmann::json::exception&) {
    throw UnreadableFile(
        fmt::format("{} is damaged: the stored data of its report are not valid", database.string()));
  }
}

/// The first browser that PATH leads to and that prints without a screen. Throws UsageError without one.
std::string browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome", "microsoft-edge"})
    if (has_program(name)) return name;
  throw UsageError(
      "--pdf needs a browser (Debian: chromium); or open report.html in one and print it to a file");
}

/// Prints a page. The browser keeps its profile in a folder of its own, which is removed.
void print(const std::string& browser, const fs::path& page, const fs::path& pdf) {
  const fs::path profile = pdf.parent_path() / ".browser";
  const bool printed =
      run_program({browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                   "--log-level=3", "--virtual-time-budget=20000", "--user-data-dir=" + profile.string(),
                   "--print-to-pdf=" + pdf.string(), "file://" + fs::absolute(page).string()},
                  true);  // browsers write warnings of their own
  std::error_code ignored;
  fs::remove_all(profile, ignored);
  if (!printed || !fs::exists(pdf))
    throw InputError(fmt::format("{}: {} cannot print it", pdf.string(), browser));
}

}  // namespace

int report(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("against", po::value<std::string>()->value_name("DIR"),
                        "also say what changed since the run in this result folder")(
      "pdf", "also print the page to report.pdf, by a browser");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const std::string printer = line.has("pdf") ? browser() : "";
  const fs::path folder = finished_result(line.words[0]), page = folder / "report.html";
  std::optional<fs::path> other;
  if (line.has("against")) other = finished_result(line.text("against"));
  write_file(page, page_of(folder, other));
  fmt::print("report: {}\n", page.string());
  if (printer.empty()) return done;
  const fs::path pdf = folder / "report.pdf";
  print(printer, page, pdf);
  fmt::print("pdf: {}\n", pdf.string());
  return done;
}

}  // namespace flyrock::cli
