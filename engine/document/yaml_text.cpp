#include "document/yaml_text.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "document/printable.h"

namespace flyrock {

std::shared_ptr<const Source> source_of(const std::string& text, const std::string& name) {
  auto source = std::make_shared<Source>();
  source->name = name;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    source->lines.push_back(std::move(line));
  }
  return source;
}

bool has_foreign_bytes(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < source->lines.size(); ++i)
    if (const std::string fault = text_fault(source->lines[i]); !fault.empty()) {
      diagnostics.error({source, static_cast<int>(i) + 1, 1}, "",
                        fmt::format("the line {}, expected a text file saved as UTF-8", fault));
      return true;
    }
  return false;
}

bool has_tab_indentation(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  bool found = false;
  for (std::size_t i = 0; i < source->lines.size(); ++i) {
    const std::string& line = source->lines[i];
    const std::size_t tab = line.find('\t');
    const std::size_t first = line.find_first_not_of(" \t");
    if (tab == std::string::npos || first == std::string::npos || tab > first || line[first] == '#') continue;
    diagnostics.error({source, static_cast<int>(i) + 1, static_cast<int>(tab) + 1}, "",
                      "a tab in the indentation, YAML takes blanks only");
    found = true;
  }
  return found;
}

std::string quote_fault(const Source& source, int line, int byte) {
  static const std::regex key(R"(^\s*(- )?[A-Za-z_]\w*\s*:.*)");
  const auto lines = static_cast<int>(source.lines.size());
  if (line < 0 || line >= lines || byte < 0) return {};
  auto at = static_cast<std::size_t>(byte);
  if (at >= source.lines[line].size()) return {};
  const char quote = source.lines[line][at++];
  if (quote != '"' && quote != '\'') return {};
  for (int l = line; l < lines; ++l, at = 0) {
    const std::string& text = source.lines[l];
    if (l > line && std::regex_match(text, key))
      return fmt::format("the quote {} is not closed before the key on line {}", quote, l + 1);
    for (; at < text.size(); ++at) {
      if (quote == '"' && text[at] == '\\')
        ++at;  // the next character stands for itself
      else if (text[at] == quote && quote == '\'' && at + 1 < text.size() && text[at + 1] == quote)
        ++at;  // two quotes stand for one
      else if (text[at] == quote)
        return {};
    }
  }
  return fmt::format("the quote {} is not closed", quote);
}

}  // namespace flyrock
