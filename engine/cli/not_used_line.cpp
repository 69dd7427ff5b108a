#include "cli/not_used_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace flyrock::cli {

std::string not_used_line(const std::vector<std::string>& entries) {
  if (entries.empty()) return {};
  constexpr std::size_t most_named = 3;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(entries.size(), most_named); ++i)
    names.push_back(entries[i].substr(0, entries[i].find(" (")));
  const std::string more =
      entries.size() > most_named ? fmt::format(" and {} more", entries.size() - most_named) : "";
  return fmt::format("not used: {}{} {} nothing (the report says why)\n", fmt::join(names, ", "), more,
                     entries.size() == 1 ? "changes" : "change");
}

std::string not_used_list(const std::vector<std::string>& entries) {
  std::string text;
  for (const std::string& entry : entries) text += fmt::format("not used: {}\n", entry);
  return text;
}

}  // namespace flyrock::cli
