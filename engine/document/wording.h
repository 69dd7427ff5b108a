#pragma once
// Words that messages about YAML and about Lua share.

#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// "a.b" from "a" and "b"; "b" from "" and "b".
std::string join_path(const std::string& path, std::string_view step);

/// The names of the items of a list.
template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& item : list) names.emplace_back(item.name);
  return names;
}

/// "`a`", "`a` or `b`", "`a`, `b` or `c`".
std::string choice_text(const std::vector<std::string>& names);

/// ", did you mean `x`?" with the candidate nearest to a word; empty if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// The same. If no candidate is near, ", expected " and all candidates, if they are few enough to read.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace flyrock
