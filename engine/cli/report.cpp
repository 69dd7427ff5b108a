// Draws report.html again from the data in results.db, with the scripts of this flyrock.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "batch/safe_file.h"
#include "cli/result_folder.h"
#include "host/share.h"
#include "report/database.h"
#include "report/html.h"
#include "report/motion_data.h"

namespace flyrock::cli {

namespace {

/// The page for the data in the database. Throws UnreadableFile.
std::string page_of(const std::filesystem::path& database) {
  try {
    auto data = nlohmann::ordered_json::parse(stored_report(database));
    add_motion(data, database);
    return report_html(data, std::filesystem::path(share_folder()) / "report");
  } catch (const nlohmann::json::exception&) {
    throw UnreadableFile(
        fmt::format("{} is damaged: the stored data of its report are not valid", database.string()));
  }
}

}  // namespace

int report(const Command& command, const Arguments& arguments) {
  const CommandLine line =
      parse(command, boost::program_options::options_description("options"), arguments, 1, 1);
  if (line.help) return done;
  const std::filesystem::path folder = finished_result(line.words[0]), page = folder / "report.html";
  write_file(page, page_of(folder / "results.db"));
  fmt::print("report: {}\n", page.string());
  return done;
}

}  // namespace flyrock::cli
