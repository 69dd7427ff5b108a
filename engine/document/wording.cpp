#include "document/wording.h"

#include <fmt/format.h>

#include "units/units.h"

namespace flyrock {

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
  const std::string nearest = nearest_name(word, candidates);
  return nearest.empty() ? "" : fmt::format(", did you mean `{}`?", nearest);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t few = 12;
  if (std::string hint = did_you_mean(word, candidates); !hint.empty()) return hint;
  if (candidates.empty() || candidates.size() > few) return {};
  return ", expected " + choice_text(candidates);
}

}  // namespace flyrock
