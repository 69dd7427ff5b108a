#include "document/odd_characters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace flyrock {

namespace {

enum class Look { visible, invisible, turns };

/// Consecutive characters of one kind.
struct OddCharacters {
  std::uint32_t first, last;
  Look look;
  const char* name;
  const char* instead;  ///< null: the character of ASCII that it is a wide form of
};

constexpr const char* remove_it = "remove it";
constexpr const char* write_blank = "write a blank";

// Names of the Unicode standard, in plain words.
constexpr OddCharacters odd_characters[] = {
    {0x00A0, 0x00A0, Look::invisible, "a no-break space", write_blank},
    {0x00AD, 0x00AD, Look::invisible, "a soft hyphen", remove_it},
    {0x034F, 0x034F, Look::invisible, "a joiner without a width", remove_it},
    {0x061C, 0x061C, Look::turns, "a mark of the direction of text", remove_it},
    {0x115F, 0x1160, Look::invisible, "a filler", remove_it},
    {0x1680, 0x1680, Look::invisible, "a space of another width", write_blank},
    {0x180E, 0x180E, Look::invisible, "a separator without a width", remove_it},
    {0x2000, 0x200A, Look::invisible, "a space of another width", write_blank},
    {0x200B, 0x200B, Look::invisible, "a space without a width", remove_it},
    {0x200C, 0x200D, Look::invisible, "a joiner without a width", remove_it},
    {0x200E, 0x200F, Look::turns, "a mark of the direction of text", remove_it},
    {0x2010, 0x2010, Look::visible, "a hyphen", "write `-`"},
    {0x2011, 0x2011, Look::visible, "a no-break hyphen", "write `-`"},
    {0x2012, 0x2012, Look::visible, "a figure dash", "write `-`"},
    {0x2013, 0x2013, Look::visible, "an en dash", "write `-`"},
    {0x2014, 0x2015, Look::visible, "a long dash", "write `-`"},
    {0x2018, 0x201B, Look::visible, "a typographic quote", "write `'`"},
    {0x201C, 0x201F, Look::visible, "a typographic quote", "write `\"`"},
    {0x2028, 0x2029, Look::invisible, "a separator of lines", "write a new line"},
    {0x202A, 0x202E, Look::turns, "a mark of the direction of text", remove_it},
    {0x202F, 0x202F, Look::invisible, "a narrow no-break space", write_blank},
    {0x205F, 0x205F, Look::invisible, "a space of another width", write_blank},
    {0x2060, 0x2064, Look::invisible, "a sign without a width", remove_it},
    {0x2066, 0x2069, Look::turns, "a mark of the direction of text", remove_it},
    {0x206A, 0x206F, Look::invisible, "a sign without a width", remove_it},
    {0x2212, 0x2212, Look::visible, "the minus sign", "write `-`"},
    {0x2800, 0x2800, Look::invisible, "an empty braille pattern", write_blank},
    {0x3000, 0x3000, Look::invisible, "a wide space", write_blank},
    {0x3164, 0x3164, Look::invisible, "a filler", remove_it},
    {0xFE00, 0xFE0F, Look::invisible, "a selector without a width", remove_it},
    {0xFE58, 0xFE58, Look::visible, "a small dash", "write `-`"},
    {0xFE63, 0xFE63, Look::visible, "a small hyphen", "write `-`"},
    {0xFEFF, 0xFEFF, Look::invisible, "a byte order mark", remove_it},
    {0xFF01, 0xFF5E, Look::visible, "a wide character", nullptr},
    {0xFFA0, 0xFFA0, Look::invisible, "a filler", remove_it},
};

/// The number of the UTF-8 character at the start of a text, and its length in bytes. Bytes that are not
/// UTF-8 have the number 0.
struct Character {
  std::uint32_t code = 0;
  std::size_t length = 1;
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  if (first < 0xC0) return {};
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t code = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  return {code, length};
}

const OddCharacters* find_odd(std::uint32_t code) {
  const auto found =
      std::find_if(std::begin(odd_characters), std::end(odd_characters),
                   [&](const OddCharacters& odd) { return odd.first <= code && code <= odd.last; });
  return found == std::end(odd_characters) ? nullptr : found;
}

std::string code_text(std::uint32_t code) { return fmt::format("<U+{:04X}>", code); }

}  // namespace

std::string code_of_invisible(std::string_view text) {
  const std::uint32_t code = first_character(text).code;
  const OddCharacters* odd = find_odd(code);
  return odd && odd->look != Look::visible ? code_text(code) : std::string();
}

std::string code_of_turning(std::string_view text) {
  const std::uint32_t code = first_character(text).code;
  const OddCharacters* odd = find_odd(code);
  return odd && odd->look == Look::turns ? code_text(code) : std::string();
}

std::string with_codes(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = first_character(text).length;
    const std::string code = code_of_invisible(text);
    shown += code.empty() ? text.substr(0, length) : std::string_view(code);
    text.remove_prefix(length);
  }
  return shown;
}

std::string odd_character_hint(std::string_view text) {
  while (!text.empty()) {
    const auto [code, length] = first_character(text);
    if (const OddCharacters* odd = find_odd(code)) {
      constexpr std::uint32_t from_wide = 0xFF01 - '!';
      return fmt::format("U+{:04X} is {}, {}", code, odd->name,
                         odd->instead ? odd->instead : fmt::format("write `{}`", char(code - from_wide)));
    }
    text.remove_prefix(length);
  }
  return {};
}

std::string hint_of_line(const Location& at) {
  if (!at.source || at.line < 1 || at.line > static_cast<int>(at.source->lines.size())) return {};
  const std::string hint = odd_character_hint(at.source->lines[static_cast<std::size_t>(at.line) - 1]);
  return hint.empty() ? hint : fmt::format(" ({})", hint);
}

}  // namespace flyrock
