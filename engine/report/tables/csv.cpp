#include "report/tables/csv.h"

#include <cmath>

#include "document/value.h"

namespace flyrock {

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(double number) { return std::isfinite(number) ? shortest(number) : ""; }

}  // namespace flyrock
