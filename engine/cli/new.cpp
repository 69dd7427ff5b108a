// flyrock new: copies a scenario, a lab or the template of a plugin, to start from.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "cli/offers.h"
#include "document/wording.h"
#include "files/safe_file.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

bool is_scenario(const fs::path& file) { return file.extension() == ".yaml" || file.extension() == ".lua"; }

/// A scenario with the files beside it that it names.
std::vector<fs::path> with_its_files(const fs::path& scenario) {
  const std::string text = read_file(scenario);
  std::vector<fs::path> files{scenario};
  for (const fs::directory_entry& entry : fs::directory_iterator(scenario.parent_path()))
    if (entry.is_regular_file() && entry.path() != scenario &&
        text.find(entry.path().filename().string()) != std::string::npos &&
        (!is_scenario(entry.path()) || text.find("plugins") != std::string::npos))
      files.push_back(entry.path());
  std::sort(files.begin() + 1, files.end());
  return files;
}

/// Copies files into a folder in which none of them exists yet. Throws InputError before it copies any.
void copy_new(const std::vector<fs::path>& files, const fs::path& folder) {
  std::error_code error;
  for (const fs::path& file : files)
    if (const fs::path to = folder / file.filename(); fs::exists(to, error))
      throw InputError(fmt::format("{}: exists already and is left as it is", to.string()));
  error.clear();  // what cannot be asked cannot be made either
  fs::create_directories(folder, error);
  for (const fs::path& file : files) {
    const fs::path to = folder / file.filename();
    if (!error) fs::copy(file, to, fs::copy_options::recursive, error);
    if (error) throw InputError(fmt::format("{}: cannot be written: {}", to.string(), error.message()));
    fmt::print("{}\n", to.string());
  }
}

}  // namespace

int new_file(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("DIR"),
                        "the folder to copy to, never over a file; default the present one");
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  const auto list = offers();
  std::vector<std::string> names;
  for (const auto& [name, path] : list) names.push_back(name);
  if (line.words.empty()) {
    for (const std::string& name : names) fmt::print("{}\n", name);
    return done;
  }
  const std::string& wanted = line.words[0];
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found == names.end())
    throw UsageError(fmt::format("there is no `{}`{}; `flyrock new` lists what there is", wanted,
                                 suggestion(wanted, names)));
  const fs::path from = list[static_cast<std::size_t>(found - names.begin())].second;
  const fs::path folder = line.has("output") ? fs::path(line.text("output")) : fs::path(".");
  if (folder.empty()) throw UsageError("--output: expected a folder");
  copy_new(wanted.find('/') == std::string::npos ? std::vector<fs::path>{from} : with_its_files(from),
           folder);
  return done;
}

}  // namespace flyrock::cli
