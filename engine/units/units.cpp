#include "units/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>

#include "units/unit_table.h"

namespace flyrock {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' '; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The length of the decimal number at the start of a text; 0 if there is none.
std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  const std::size_t whole = i;
  while (i < text.size() && is_digit(text[i])) ++i;
  std::size_t digits = i - whole;
  if (digits > 1 && text[whole] == '0') return 0;  // 010 could be octal, ten or a typing error
  if (i < text.size() && text[i] == '.') {
    const std::size_t point = i++;
    while (i < text.size() && is_digit(text[i])) ++i;
    digits += i - point - 1;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t exponent = i + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    const std::size_t first = exponent;
    while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
    if (exponent > first) i = exponent;  // otherwise the "e" begins a unit
  }
  return i;
}

/// The digits of a decimal number without a sign, from the first to the last that is not 0, and the power of
/// ten of the last one: "1230", "1.23e3" and "01230.0" are {"123", 1}.
std::pair<std::string, int> significant_digits(std::string_view text) {
  std::string digits;
  int power = 0;
  bool after_point = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.') {
      after_point = true;
    } else if (c == 'e' || c == 'E') {
      int exponent = 0;
      const std::size_t first = i + (text[i + 1] == '+' ? 2 : 1);
      std::from_chars(text.data() + first, text.data() + text.size(), exponent);
      power += exponent;
      break;
    } else {
      if (c != '0' || !digits.empty()) digits += c;
      if (after_point) --power;
    }
  }
  while (!digits.empty() && digits.back() == '0') {
    digits.pop_back();
    ++power;
  }
  return {digits, digits.empty() ? 0 : power};
}

const NamedUnit* find_unit(std::string_view name) {
  for (const NamedUnit& unit : unit_table())
    if (unit.name == name) return &unit;
  return nullptr;
}

double power(double base, double exponent) {
  if (exponent != std::floor(exponent)) return std::pow(base, exponent);
  double result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result *= base;
  return exponent < 0 ? 1 / result : result;
}

void multiply(Unit& product, const Unit& unit, double exponent) {
  constexpr double millionth = 1e6;
  const auto add = [&](double& sum, double of_unit) {
    sum = std::round((sum + exponent * of_unit) * millionth) / millionth;
  };
  product.factor *= power(unit.factor, exponent);
  add(product.dimension.metre, unit.dimension.metre);
  add(product.dimension.kilogram, unit.dimension.kilogram);
  add(product.dimension.second, unit.dimension.second);
  add(product.dimension.radian, unit.dimension.radian);
}

/// Replaces superscripts and the middle dot by their plain spelling.
std::string plain_spelling(std::string_view text) {
  std::string plain(text);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> spellings{
      {{"²", "^2"}, {"³", "^3"}, {"·", "*"}}};
  for (const auto& [from, to] : spellings)
    for (std::size_t at; (at = plain.find(from)) != std::string::npos;) plain.replace(at, from.size(), to);
  return plain;
}

/// The exponent of a factor: "2", "-2", "1.5", "(3/2)"; nothing if it is none.
std::optional<double> parse_exponent(std::string_view text) {
  if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::optional<double> above = parse_number(text.substr(0, slash));
  const std::optional<double> below = slash < text.size() ? parse_number(text.substr(slash + 1)) : 1.0;
  if (!above || !below || *above == 0 || !(std::abs(*above / *below) <= 9)) return std::nullopt;
  return *above / *below;
}

/// Where the exponent of a factor begins: after a `^`, or at the digits of its end with their minus.
std::size_t begin_of_exponent(std::string_view factor) {
  if (const std::size_t sign = factor.find('^'); sign != factor.npos) return sign + 1;
  std::size_t begin = factor.size();
  while (begin > 0 && (is_digit(factor[begin - 1]) || factor[begin - 1] == '.')) --begin;
  return begin > 0 && begin < factor.size() && factor[begin - 1] == '-' ? begin - 1 : begin;
}

/// Where the factor at `at` ends. A dot between digits belongs to an exponent (m^1.5), as do brackets
/// (m^(3/2)).
std::size_t end_of_factor(std::string_view text, std::size_t at) {
  bool in_brackets = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '(' || c == ')') in_brackets = c == '(';
    const bool is_point =
        c == '.' && at > 0 && is_digit(text[at - 1]) && at + 1 < text.size() && is_digit(text[at + 1]);
    if (!in_brackets && !is_point && (is_blank(c) || c == '*' || c == '.' || c == '/')) break;
  }
  return at;
}

/// Multiplies by one factor: "m3", "s^-2", "m^1.5", "ft-lb" or "1". False if its unit is unknown.
bool multiply_factor(Unit& product, std::string_view factor, int sign) {
  if (factor == "1") return true;
  const std::size_t begin = begin_of_exponent(factor);
  std::string_view name = factor.substr(0, begin);
  const bool has_exponent = begin < factor.size() || name.ends_with('^');
  const std::optional<double> exponent = has_exponent ? parse_exponent(factor.substr(begin)) : 1.0;
  if (name.ends_with('^')) name.remove_suffix(1);
  const NamedUnit* unit = find_unit(name);
  if (!unit || !exponent) return false;
  multiply(product, unit->unit, sign * *exponent);
  return true;
}

/// "2", or "^1.5".
std::string exponent_text(double exponent) {
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), exponent);
  return (exponent == std::floor(exponent) ? "" : "^") + std::string(digits.data(), end.ptr);
}

}  // namespace

std::string si_unit(const Dimension& dimension) {
  const std::array<std::pair<std::string_view, double>, 4> parts{{{"kg", dimension.kilogram},
                                                                  {"m", dimension.metre},
                                                                  {"rad", dimension.radian},
                                                                  {"s", dimension.second}}};
  std::string above, below;
  for (const auto& [name, exponent] : parts) {
    if (exponent == 0) continue;
    std::string& side = exponent > 0 ? above : below;
    if (!side.empty()) side += ' ';
    side += name;
    if (std::abs(exponent) != 1) side += exponent_text(std::abs(exponent));
  }
  const std::string numerator = above.empty() ? std::string("1") : above;
  return below.empty() ? numerator : numerator + "/" + below;
}

ReadableUnit readable_unit(const std::string& si) {
  constexpr double degree = 3.14159265358979323846 / 180;
  static const std::map<std::string, ReadableUnit> known{
      {"1", {"", 1}},        {"rad", {"deg", 1 / degree}}, {"kg m2/s2", {"kJ", 1e-3}},
      {"kg m/s2", {"N", 1}}, {"kg/s2", {"N/m", 1}},        {"kg/m s2", {"Pa", 1}}};
  const auto found = known.find(si);
  return found == known.end() ? ReadableUnit{si, 1} : found->second;
}

std::optional<Unit> parse_unit(std::string_view text, std::string* unknown) {
  const std::string plain = plain_spelling(trimmed(text));
  Unit product;
  int sign = 1;
  bool any = false;
  for (std::size_t i = 0; i < plain.size();) {
    const char c = plain[i];
    if (is_blank(c) || c == '*' || c == '.') {
      ++i;
    } else if (c == '/') {
      if (sign < 0 || !any) {  // a second `/` is ambiguous: a/(b c) or (a/b) c
        if (unknown) *unknown = plain;
        return std::nullopt;
      }
      sign = -1;
      any = false;
      ++i;
    } else {
      const std::size_t end = end_of_factor(plain, i);
      const std::string_view factor = std::string_view(plain).substr(i, end - i);
      if (!multiply_factor(product, factor, sign)) {
        if (unknown) *unknown = factor;
        return std::nullopt;
      }
      any = true;
      i = end;
    }
  }
  if (!any) {
    if (unknown) *unknown = plain;
    return std::nullopt;
  }
  return product;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const NamedUnit& unit : unit_table()) names.emplace_back(unit.name);
  return names;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.empty() || number_length(text) != text.size()) return std::nullopt;
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  // Use from_chars, because strtod uses the decimal point of the locale.
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool rounds_to_whole(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  const std::optional<double> value = parse_number(text);
  constexpr std::size_t always_exact = 15;  // a double holds every number of so many digits
  if (!value || text.size() <= always_exact || *value != std::floor(*value)) return false;
  std::array<char, 400> whole;
  const auto end =
      std::to_chars(whole.data(), whole.data() + whole.size(), *value, std::chars_format::fixed, 0);
  return significant_digits(text) != significant_digits({whole.data(), end.ptr});
}

std::optional<Quantity> parse_quantity(std::string_view text, QuantityError* error) {
  text = trimmed(text);
  const std::size_t length = number_length(text);
  const std::optional<double> value = parse_number(text.substr(0, length));
  if (!value) {
    if (error) *error = {};
    return std::nullopt;
  }
  Quantity quantity;
  quantity.value = *value;
  quantity.rounded = rounds_to_whole(text.substr(0, length));
  quantity.unit_text = trimmed(text.substr(length));
  if (quantity.unit_text.empty()) return quantity;
  std::string unknown;
  const std::optional<Unit> unit = parse_unit(quantity.unit_text, &unknown);
  if (!unit) {
    if (error) *error = {unknown, nearest_name(unknown, unit_names())};
    return std::nullopt;
  }
  quantity.has_unit = true;
  quantity.unit = *unit;
  return quantity;
}

}  // namespace flyrock
