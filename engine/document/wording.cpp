#include "document/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::array<std::string_view, 4> words_for_yes{"y", "yes", "true", "on"};
constexpr std::array<std::string_view, 4> words_for_no{"n", "no", "false", "off"};

/// What a word says where people answer with yes or no, in any case of its letters: `No`, `OFF`. YAML 1.1
/// read all of these as booleans. Nothing for other words.
std::optional<bool> yes_or_no(std::string_view word) {
  const std::string small = lower(word);
  if (std::find(words_for_yes.begin(), words_for_yes.end(), small) != words_for_yes.end()) return true;
  if (std::find(words_for_no.begin(), words_for_no.end(), small) != words_for_no.end()) return false;
  return std::nullopt;
}

/// The candidate that means the same as `word`; else the one with the nearest spelling, but none that means
/// the contrary: `no` is spelled almost as `on`.
std::string meant_name(std::string_view word, std::vector<std::string> candidates) {
  const std::optional<bool> answer = yes_or_no(word);
  if (!answer) return nearest_name(word, candidates);
  for (const std::string& candidate : candidates)
    if (yes_or_no(candidate) == answer) return candidate;
  std::erase_if(candidates, [](const std::string& candidate) { return yes_or_no(candidate).has_value(); });
  return nearest_name(word, candidates);
}

}  // namespace

std::string join_path(const std::string& path, std::string_view step) {
  std::string joined = path;
  if (!path.empty()) joined += '.';
  return joined += step;
}

std::string choice_text(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}`{}`", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string nearest = meant_name(word, candidates);
  return nearest.empty() ? "" : fmt::format(", did you mean `{}`?", nearest);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t few = 12;
  if (std::string hint = did_you_mean(word, candidates); !hint.empty()) return hint;
  if (candidates.empty() || candidates.size() > few) return {};
  return ", expected " + choice_text(candidates);
}

}  // namespace flyrock
