#include "document/table_head.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flyrock {

namespace {

constexpr std::string_view apart = " \t_-.";       // within names
constexpr std::string_view ends = " \t_-.,:;([{";  // after a name
constexpr std::string_view no_unit = " \t_-.,:;";  // at both ends of a unit

/// Other names that a column has in every table.
struct OtherNames {
  std::string_view column;
  std::vector<std::string> names;
};

const std::vector<std::string>& common_names(std::string_view column) {
  static const std::vector<std::string> none;
  static const std::vector<OtherNames> list = {
      {"x", {"easting", "east", "x_collar", "collar_x", "x_coord", "x_coordinate", "e"}},
      {"y", {"northing", "north", "y_collar", "collar_y", "y_coord", "y_coordinate", "n"}},
      {"z", {"rl", "elevation", "z_collar", "collar_z", "z_coord", "z_coordinate", "elev"}},
      {"hole", {"hole_id", "id", "no", "nr", "number", "hole_number", "blasthole", "blasthole_id"}},
      {"name", {"id", "no", "nr", "number"}},
      {"time", {"delay", "delay_time", "firing_time"}},
  };
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const OtherNames& one) { return one.column == column; });
  return found == list.end() ? none : found->names;
}

/// Names of units as people write them, in small letters.
constexpr std::array unit_words = {
    std::pair{"metre", "m"},        std::pair{"metres", "m"},       std::pair{"meter", "m"},
    std::pair{"meters", "m"},       std::pair{"mtr", "m"},          std::pair{"mtrs", "m"},
    std::pair{"millimetre", "mm"},  std::pair{"millimetres", "mm"}, std::pair{"millimeter", "mm"},
    std::pair{"millimeters", "mm"}, std::pair{"centimetre", "cm"},  std::pair{"centimetres", "cm"},
    std::pair{"centimeter", "cm"},  std::pair{"centimeters", "cm"}, std::pair{"kilometre", "km"},
    std::pair{"kilometres", "km"},  std::pair{"kilometer", "km"},   std::pair{"kilometers", "km"},
    std::pair{"foot", "ft"},        std::pair{"feet", "ft"},        std::pair{"inch", "in"},
    std::pair{"inches", "in"},      std::pair{"yard", "yd"},        std::pair{"yards", "yd"},
    std::pair{"degree", "deg"},     std::pair{"degrees", "deg"},    std::pair{"degs", "deg"},
    std::pair{"radian", "rad"},     std::pair{"radians", "rad"},    std::pair{"gons", "gon"},
    std::pair{"second", "s"},       std::pair{"seconds", "s"},      std::pair{"sec", "s"},
    std::pair{"secs", "s"},         std::pair{"millisecond", "ms"}, std::pair{"milliseconds", "ms"},
    std::pair{"msec", "ms"},        std::pair{"msecs", "ms"},       std::pair{"minute", "min"},
    std::pair{"minutes", "min"},    std::pair{"gram", "g"},         std::pair{"grams", "g"},
    std::pair{"kilogram", "kg"},    std::pair{"kilograms", "kg"},   std::pair{"kilo", "kg"},
    std::pair{"kilos", "kg"},       std::pair{"kgs", "kg"},         std::pair{"tonnes", "t"},
    std::pair{"pound", "lb"},       std::pair{"pounds", "lb"},      std::pair{"lbs", "lb"},
    std::pair{"percent", "%"},      std::pair{"mps", "m/s"},        std::pair{"per", "/"},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_in(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

std::string_view without_ends(std::string_view text, std::string_view set) {
  const std::size_t first = text.find_first_not_of(set);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(set) - first + 1);
}

/// What stands after a name, without its brackets and without the word `in`.
std::string_view unit_part(std::string_view rest) {
  constexpr std::array<std::pair<char, char>, 3> brackets = {{{'(', ')'}, {'[', ']'}, {'{', '}'}}};
  for (std::string_view before; before != rest;) {
    before = rest;
    rest = without_ends(rest, no_unit);
    for (const auto& [open, close] : brackets)
      if (rest.size() > 1 && rest.front() == open && rest.back() == close)
        rest = rest.substr(1, rest.size() - 2);
    if (rest.size() > 3 && lower(rest.substr(0, 2)) == "in" && is_in(rest[2], " \t_")) rest = rest.substr(3);
  }
  return rest;
}

/// A text of units with the words of people replaced: "kilograms per metre" becomes "kg/m".
std::string in_units(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end == i) {
      plain += text[i++];
      continue;
    }
    const std::string_view word = text.substr(i, end - i);
    const std::string small = lower(word);
    const auto known = std::find_if(unit_words.begin(), unit_words.end(),
                                    [&](const auto& one) { return small == one.first; });
    plain += known == unit_words.end() ? word : std::string_view(known->second);
    i = end;
  }
  for (std::size_t slash; (slash = plain.find('/')) != std::string::npos;) {  // no blanks about it
    std::size_t from = slash, to = slash + 1;
    while (from > 0 && is_in(plain[from - 1], " _")) --from;
    while (to < plain.size() && is_in(plain[to], " _")) ++to;
    plain.replace(from, to - from, "\x01");
  }
  std::replace(plain.begin(), plain.end(), '\x01', '/');
  return plain;
}

/// Where a name ends in a head that begins with it; 0 if none does.
std::size_t end_of_name(std::string_view head, std::string_view name) {
  std::size_t at = 0;
  for (const char c : name) {
    if (is_in(c, apart)) continue;
    while (at < head.size() && is_in(head[at], apart)) ++at;
    if (at >= head.size() || lower(head.substr(at, 1))[0] != c) return 0;
    ++at;
  }
  return at == head.size() || is_in(head[at], ends) ? at : 0;
}

/// The words after a name that make no other name of it: `hole no.`, `row number`.
bool is_numbering(std::string_view rest) {
  constexpr std::array words = {"id", "no", "nr", "number", "name", "#"};
  return std::find(words.begin(), words.end(), lower(rest)) != words.end();
}

/// The unit of what follows the name of a column; nothing where that is no unit of its numbers.
std::optional<HeadUnit> unit_after(std::string_view rest, const TableColumn& column) {
  const std::string_view part = unit_part(rest);
  if (part.empty()) return HeadUnit{{1, column.dimension}, ""};
  if (column.dimension == dimension::none && is_numbering(part)) return HeadUnit{};
  return column.is_text ? std::nullopt : unit_of_head(rest, column.dimension);
}

}  // namespace

std::optional<HeadUnit> unit_of_head(std::string_view end, const Dimension& dimension) {
  const std::string_view part = unit_part(end);
  for (const std::string& spelling : {std::string(part), lower(part)}) {
    const std::string plain = in_units(spelling);
    std::vector<std::string> readings;
    for (std::size_t cut = plain.find('_'); cut != std::string::npos; cut = plain.find('_', cut + 1)) {
      readings.push_back(plain);
      readings.back()[cut] = '/';
    }
    readings.push_back(plain);
    for (std::string& reading : readings) {
      std::replace(reading.begin(), reading.end(), '_', ' ');
      if (const auto unit = parse_unit(reading); unit && unit->dimension == dimension)
        return HeadUnit{*unit, reading};
    }
  }
  return std::nullopt;
}

HeadMatch match_head(std::string_view head, std::span<const TableColumn> columns,
                     const std::map<std::string, std::string>& mapped) {
  HeadMatch match;
  std::size_t longest = 0, longest_begun = 0;
  for (const TableColumn& column : columns) {
    if (mapped.contains(column.name)) continue;
    std::vector<std::string> names{column.name};
    names.insert(names.end(), column.also.begin(), column.also.end());
    if (column.is_common) {
      const std::vector<std::string>& common = common_names(column.name);
      names.insert(names.end(), common.begin(), common.end());
    }
    for (std::size_t n = 0; n < names.size(); ++n) {
      const std::size_t end = end_of_name(head, names[n]);
      if (end == 0) continue;
      const std::string_view rest = head.substr(end);
      if (const auto unit = unit_after(rest, column)) {
        if (end > longest) {
          longest = end;
          match.column = &column;
          match.unit = *unit;
          match.name = n;
        }
      } else if (end > longest_begun && (n == 0 || (!column.is_text && names[n].size() > 1))) {
        longest_begun = end;
        match.begun = &column;
        match.rest = without_ends(rest, no_unit);
      }
    }
  }
  if (match.column) match.begun = nullptr;
  return match;
}

HeadUnit unit_at_end(std::string_view head, const Dimension& dimension) {
  for (std::size_t i = 1; i < head.size(); ++i)
    if (is_in(head[i], ends))
      if (const auto unit = unit_of_head(head.substr(i), dimension)) return *unit;
  return {{1, dimension}, ""};
}

}  // namespace flyrock
