#pragma once
// Fields of a CSV line (RFC 4180).

#include <string>

namespace flyrock {

/// Quoted where it has to be.
std::string csv_text(const std::string& text);
/// The shortest decimal that reads back as the same double; empty where there is no number.
std::string csv_number(double number);

}  // namespace flyrock
