#include "cli/command_docs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "cli/dispatch.h"
#include "cli/labs.h"
#include "cli/offers.h"
#include "host/session.h"
#include "host/share.h"

namespace flyrock::cli {

namespace {

bool is_choice(const std::string& word) {
  return word.find('|') != std::string::npos &&
         std::none_of(word.begin(), word.end(), [](unsigned char c) { return std::isupper(c) || c == '/'; });
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

std::vector<std::string> plugin_names() {
  const LuaSession session(share_folder());
  std::vector<std::string> names;
  for (int k = 0; k < plugin_kinds; ++k) {
    const auto kind = static_cast<PluginKind>(k);
    for (const std::string& name : session.registry().names(kind))
      names.push_back(fmt::format("{}/{}", name_of(kind), name));
  }
  return names;
}

}  // namespace

std::vector<CommandDoc> command_docs() {
  std::vector<CommandDoc> docs;
  for (const Command& command : all_commands()) {
    CommandDoc& doc = docs.emplace_back(CommandDoc{command.name, command.usage, command.summary, {}});
    Command asked = command;
    asked.described = &doc.options;
    asked.call(asked, {});
  }
  return docs;
}

std::string word_of(const std::string& usage) {
  const std::vector<std::string> words = split(usage, ' ');
  if (words.size() < 2 || words[1].starts_with("-") || words[1].starts_with("[-")) return {};
  std::string word = words[1];
  std::erase_if(word, [](char c) { return c == '[' || c == ']' || c == '.'; });
  return word == "options" ? "" : word;
}

WordKind kind_of_word(const std::string& word) {
  if (is_choice(word)) return WordKind::choice;
  const auto has = [&](const char* part) { return word.find(part) != std::string::npos; };
  if (has("KIND")) return WordKind::plugin;
  if (has("SCENARIO") || has("STUDENT")) return WordKind::scenario;
  if (word == "LAB") return WordKind::lab;
  if (word == "PATH") return WordKind::offer;
  if (word == "COMMAND") return WordKind::command;
  if (has("FILE") || has("PROBLEM")) return WordKind::file;
  if (has("DIR")) return WordKind::folder;
  return WordKind::free;
}

std::vector<std::string> names_for(const std::string& word) {
  std::vector<std::string> names;
  switch (kind_of_word(word)) {
    case WordKind::choice:
      return split(word, '|');
    case WordKind::plugin:
      return plugin_names();
    case WordKind::lab:
      for (const Lab& lab : labs()) names.push_back(lab.name);
      return names;
    case WordKind::offer:
      for (const auto& [name, path] : offers()) names.push_back(name);
      return names;
    case WordKind::command:
      for (const Command& command : all_commands()) names.emplace_back(command.name);
      return names;
    default:
      return names;
  }
}

}  // namespace flyrock::cli
