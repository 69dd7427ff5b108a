#include "document/printable.h"

#include <fmt/format.h>

#include "document/odd_characters.h"

namespace flyrock {

namespace {

/// The length in bytes of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) > 0x9F;
  const bool beyond = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

/// C0 and C1 controls and DEL. A terminal obeys C1 controls as it obeys ESC.
bool is_control(std::string_view one) {
  const auto first = static_cast<unsigned char>(one[0]);
  return (one.size() == 1 && (first < 0x20 || first == 0x7F) && first != '\t') ||
         (one.size() == 2 && first == 0xC2 && static_cast<unsigned char>(one[1]) < 0xA0);
}

}  // namespace

std::string text_fault(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character(text);
    if (length == 0) return "is not UTF-8";
    const std::string_view one = text.substr(0, length);
    if (is_control(one) && one != "\n") return "holds the control character " + printable(one);
    text.remove_prefix(length);
  }
  return {};
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  while (!text.empty()) {
    if (shown.size() >= longest) return shown + "...";
    const std::size_t length = character(text);
    const std::string_view one = text.substr(0, std::max<std::size_t>(length, 1));
    if (const std::string code = length > 1 ? code_of_turning(one) : std::string(); !code.empty())
      shown += code;
    else if (length > 0 && !is_control(one))
      shown += one;
    else if (one == "\n")
      shown += "\\n";
    else
      for (const char byte : one) shown += fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
    text.remove_prefix(one.size());
  }
  return shown;
}

}  // namespace flyrock
