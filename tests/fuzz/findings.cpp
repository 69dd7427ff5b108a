#include "findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "document/printable.h"

namespace flyrock::fuzz {

namespace fs = std::filesystem;

namespace {

constexpr std::ptrdiff_t most_saved = 100;

void append_line(const Finding& finding, const fs::path& file) {
  std::ofstream(file, std::ios::app) << fmt::format("{} {} {} {}\n", finding.kind, finding.seed,
                                                    finding.number, printable(finding.what));
}

std::ptrdiff_t saved_of(const std::string& kind, const fs::path& folder) {
  return std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                       [&](const fs::directory_entry& entry) {
                         return entry.path().filename().string().starts_with(kind + "-");
                       });
}

}  // namespace

void save(const Finding& finding, const fs::path& from, const fs::path& folder) {
  fs::create_directories(folder);
  append_line(finding, folder / (finding.is_listed ? "listed.txt" : "findings.txt"));
  if (saved_of(finding.kind, folder) >= most_saved) return;
  const fs::path place = folder / fmt::format("{}-{}-{}", finding.kind, finding.seed, finding.number);
  std::error_code code;
  fs::remove_all(place, code);
  fs::copy(from, place, fs::copy_options::recursive, code);
  std::ofstream(place / "what.txt") << finding.what << "\n\n" << finding.lines << '\n' << finding.err;
}

void note_rocks(const Finding& finding, const fs::path& folder) {
  fs::create_directories(folder);
  append_line(finding, folder / "rock_faults.txt");
}

}  // namespace flyrock::fuzz
