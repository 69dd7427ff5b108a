#include "cli/labs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "cli/command.h"
#include "document/wording.h"
#include "files/safe_file.h"
#include "host/share.h"

namespace flyrock::cli {

namespace fs = std::filesystem;

fs::path Lab::page() const { return fs::path(share_folder()) / "course" / (name + ".md"); }

fs::path Lab::scenario() const {
  const fs::path stem = fs::path(share_folder()) / "scenarios" / "course" / name;
  return fs::exists(stem.string() + ".lua") ? stem.string() + ".lua" : stem.string() + ".yaml";
}

std::vector<Lab> labs() {
  static const std::regex row(R"(\| *(\d+) *\| *\[[^\]]*\]\((\w+)\.md\) *\| *(.*?) *\|)");
  std::istringstream text(read_file(fs::path(share_folder()) / "course" / "README.md"));
  std::vector<Lab> list;
  std::smatch found;
  for (std::string line; std::getline(text, line);)
    if (std::regex_match(line, found, row)) list.push_back({found[1], found[2], found[3]});
  return list;
}

const Lab& lab_named(const std::string& name, const std::vector<Lab>& list) {
  std::vector<std::string> names;
  for (const Lab& lab : list) {
    if (lab.name == name) return lab;
    names.push_back(lab.name);
  }
  throw UsageError(fmt::format("unknown lab `{}`{}", name, suggestion(name, names)));
}

Verdicts verdicts_in(const fs::path& folder) {
  const auto summary = nlohmann::json::parse(read_file(folder / "summary.json"));
  Verdicts verdicts;
  for (const auto& expectation : summary.at("expectations")) {
    const auto& passed = expectation.at("passed");
    verdicts.not_judged += passed.is_null();
    if (passed.is_null()) continue;
    ++verdicts.judged;
    verdicts.held += passed.get<bool>();
  }
  return verdicts;
}

bool ended_without_results(int code, const fs::path& folder) {
  return code == bad_input || code == interrupted || !fs::exists(folder / "summary.json");
}

}  // namespace flyrock::cli
