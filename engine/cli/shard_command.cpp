#include "cli/shard_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace flyrock::cli {

std::string shell_word(const std::string& word) {
  const std::string harmless = "/._-+=:,%@";
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [&](const unsigned char c) {
    return std::isalnum(c) || harmless.find(static_cast<char>(c)) != std::string::npos;
  });
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string override_words(const Overrides& overrides) {
  std::string words;
  for (const std::string& set : overrides.set) words += " --set " + shell_word(set);
  for (const std::string& argument : overrides.arguments) words += " --arg " + shell_word(argument);
  if (overrides.seed) words += fmt::format(" --seed {}", *overrides.seed);
  if (overrides.trials) words += fmt::format(" --trials {}", *overrides.trials);
  return words;
}

namespace {

std::string analysis_words(const AnalysisRequest& analysis) {
  std::string words;
  for (const std::string& of : analysis.of) words += " --of " + shell_word(of);
  if (!analysis.inputs.empty()) words += " --inputs " + shell_word(analysis.inputs);
  for (const std::string& group : analysis.groups) words += " --group " + shell_word(group);
  if (!analysis.line.empty()) words += " --line " + shell_word(analysis.line);
  return words;
}

}  // namespace

std::string command_of(const Request& request, const Shard& shard) {
  const std::string near = std::filesystem::proximate(request.scenario).string();
  std::string command = request.analysis ? "flyrock sensitivity " : "flyrock run ";
  command += shell_word(near.starts_with("..") ? request.scenario : near);
  if (request.analysis) command += analysis_words(*request.analysis);
  command += override_words(request.overrides);
  if (shard.of > 1) command += fmt::format(" --shard {}/{}", shard.number, shard.of);
  return command;
}

}  // namespace flyrock::cli
