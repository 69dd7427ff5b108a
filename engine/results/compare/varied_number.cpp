#include "results/compare/varied_number.h"

#include <fmt/format.h>

#include <cmath>

#include "units/units.h"

namespace flyrock {

namespace {

/// Nine digits: the text is what is run, so no digit is lost between a search and its fitted scenario.
std::string nine_digits(double value) { return fmt::format("{:.9g}", value); }

}  // namespace

std::string VariedNumber::text_at(double share) const {
  const std::string number = nine_digits(low + share * (high - low));
  return unit.empty() ? number : number + " " + unit;
}

double VariedNumber::si_at(double share) const { return parse_quantity(text_at(share)).value().si(); }

std::optional<VariedNumber> read_varied(const std::string& text, std::string& fault) {
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || equals == 0 || colon == std::string::npos || colon < equals) {
    fault = "expected PATH=LOW:HIGH, as in materials.ground.friction.mu=0.3:0.7";
    return std::nullopt;
  }
  VariedNumber varied;
  varied.path = text.substr(0, equals);
  const auto low = parse_quantity(text.substr(equals + 1, colon - equals - 1)),
             high = parse_quantity(text.substr(colon + 1));
  if (!low || !high) {
    fault = fmt::format("`{}` is no number with a unit that flyrock knows",
                        low ? text.substr(colon + 1) : text.substr(equals + 1, colon - equals - 1));
    return std::nullopt;
  }
  if (!(low->unit.dimension == high->unit.dimension)) {
    fault = "its two ends have units of different kinds";
    return std::nullopt;
  }
  varied.unit = low->unit_text;
  varied.si_factor = low->unit.factor;
  varied.si = si_unit(low->unit.dimension);
  varied.low = low->value;
  varied.high = low->unit_text == high->unit_text ? high->value : high->si() / low->unit.factor;
  if (!(varied.low < varied.high) || !std::isfinite(varied.low) || !std::isfinite(varied.high)) {
    fault = "expected a least value below the greatest one";
    return std::nullopt;
  }
  return varied;
}

}  // namespace flyrock
