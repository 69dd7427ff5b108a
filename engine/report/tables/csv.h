#pragma once
// Fields of a CSV line (RFC 4180).

#include <string>

namespace flyrock {

/// The text, quoted if necessary.
std::string csv_text(const std::string& text);
/// The shortest decimal that reads back as the same double; empty for NaN and infinity.
std::string csv_number(double number);

}  // namespace flyrock
