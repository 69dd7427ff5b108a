#include "sandbox/print_log.h"

#include <fmt/format.h>

namespace flyrock {

void PrintLog::add(const std::string& place, std::string_view text,
                   std::string (*printable)(std::string_view)) {
  for (int lines = 0; lines <= lines_of_a_place; ++lines) {
    const std::size_t end = text.find('\n');
    add_line(place, printable(text.substr(0, end)));
    if (end == text.npos) return;
    text.remove_prefix(end + 1);
  }
}

void PrintLog::add(const PrintLog& later) {
  for (const Line& line : later.lines_) add_line(line.place, line.text);
}

std::vector<std::string> PrintLog::take() {
  std::vector<std::string> texts;
  for (Line& line : lines_) texts.push_back(std::move(line.text));
  lines_.clear();
  return texts;
}

void PrintLog::add_line(const std::string& place, std::string text) {
  if (count_.size() >= most_places && !count_.contains(place)) return;
  int& count = count_[place];
  if (count > lines_of_a_place) return;
  if (++count > lines_of_a_place)
    text = fmt::format("{}{}print: after {} lines the others of this place are dropped", place,
                       place.empty() ? "" : ": ", lines_of_a_place);
  lines_.push_back({place, std::move(text)});
}

}  // namespace flyrock
