// docs/files.md lists the files of each floor with the first sentence of their header. The lists are
// made from the headers: FLYROCK_UPDATE_DOCS=1 writes them anew.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace architecture_page {

namespace fs = std::filesystem;

const fs::path root = FLYROCK_SOURCE_DIR;
const fs::path page = root / "docs/files.md";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The first sentence of the first comment of a file, which may follow `#pragma once`.
std::string first_sentence(const fs::path& path) {
  std::ifstream file(path);
  std::string text;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("//")) {
      if (!text.empty() || !(line.empty() || line.starts_with("#pragma"))) break;
      continue;
    }
    const std::size_t start = line.find_first_not_of(" /");
    if (start == std::string::npos) break;
    text += (text.empty() ? "" : " ") + line.substr(start);
  }
  for (std::size_t end = text.find('.'); end != std::string::npos; end = text.find('.', end + 1))
    if (end + 1 == text.size() || text[end + 1] == ' ') return text.substr(0, end + 1);
  return text;
}

std::vector<fs::path> files_of(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The table of a folder: its headers and, of the report, its scripts.
std::string table_of(const std::string& folder) {
  std::string table = "| file | what it has |\n|---|---|\n";
  std::vector<fs::path> files = files_of(root / folder, ".h");
  const std::vector<fs::path> scripts = files_of(root / folder / "assets", ".js");
  files.insert(files.end(), scripts.begin(), scripts.end());
  for (const fs::path& file : files) {
    const std::string sentence = first_sentence(file);
    INFO(file << " does not begin with a comment that says what it has");
    CHECK(!sentence.empty());
    table += "| `" + file.filename().string() + "` | " + sentence + " |\n";
  }
  return table;
}

/// The page with its tables made anew.
std::string with_tables(const std::string& text, int& tables) {
  static const std::regex marker("<!-- files: ([\\w/]+) -->\n");
  const std::string end = "<!-- end -->";
  std::string result;
  auto from = text.begin();
  for (std::smatch match; std::regex_search(from, text.end(), match, marker);) {
    result.append(from, match[0].second);
    result += table_of(match[1]);
    from = std::search(match[0].second, text.end(), end.begin(), end.end());
    ++tables;
  }
  return result.append(from, text.end());
}

}  // namespace architecture_page

TEST_CASE("docs/files.md lists every header of every floor with its first sentence") {
  using namespace architecture_page;
  int tables = 0;
  const std::string text = text_of(page), made = with_tables(text, tables);
  if (std::getenv("FLYROCK_UPDATE_DOCS")) std::ofstream(page) << made;
  INFO("FLYROCK_UPDATE_DOCS=1 flyrock_unit_tests \"docs/files.md*\" writes it anew");
  CHECK(text == made);
  int folders = 0;
  for (const char* tree : {"engine", "lua"})
    for (const auto& entry : fs::directory_iterator(root / tree))
      folders += entry.is_directory() && !files_of(entry.path(), ".h").empty();
  CHECK(tables >= folders - 1);  // verify has a paragraph
}

TEST_CASE("collision/rules.h names the file of each rule") {
  using namespace architecture_page;
  const fs::path folder = root / "engine/collision";
  const std::string text = text_of(folder / "rules.h");
  const std::regex line("\nFind\\w+<[23]> ([\\w, ]+); +// ([\\w/]+)"), name("\\w+");
  int rules = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), line), end; found != end; ++found) {
    const std::string names = (*found)[1], file = (*found)[2];
    const std::string definitions = text_of(folder / (file + ".cpp"));
    for (std::sregex_iterator each(names.begin(), names.end(), name); each != end; ++each, ++rules) {
      INFO(each->str() << " in " << file);
      CHECK(std::regex_search(definitions, std::regex("\\n[^ /\\n][^\\n]* " + each->str() + "\\(")));
    }
  }
  CHECK(rules > 20);
}
