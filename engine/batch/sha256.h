#pragma once
// SHA-256 (FIPS 180-4): names a scenario or a plugin source by its content.

#include <string>
#include <string_view>

namespace flyrock {

/// The digest of `bytes` as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace flyrock
