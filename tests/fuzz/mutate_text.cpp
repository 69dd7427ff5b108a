#include "mutate_text.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <limits>

namespace flyrock::fuzz {

namespace {

enum class TokenKind { blank, number, word, quoted, sign };

struct Token {
  TokenKind kind = TokenKind::sign;
  std::string text;
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t'; }

/// The end of the token that begins at `at`, and its kind.
std::pair<std::size_t, TokenKind> token_end(const std::string& text, std::size_t at) {
  const auto skip = [&](std::size_t from, auto belongs) {
    while (from < text.size() && belongs(text[from])) ++from;
    return from;
  };
  const char c = text[at];
  if (is_blank(c)) return {skip(at, is_blank), TokenKind::blank};
  if (is_digit(c)) return {skip(at, [](char d) { return is_letter(d) || d == '.'; }), TokenKind::number};
  if (is_letter(c)) return {skip(at, is_letter), TokenKind::word};
  if (c == '"' || c == '\'') {
    const std::size_t end = text.find_first_of(std::string(1, c) + "\n", at + 1);
    if (end != std::string::npos && text[end] == c) return {end + 1, TokenKind::quoted};
  }
  return {at + 1, TokenKind::sign};
}

std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const auto [end, kind] = token_end(text, at);
    tokens.push_back({kind, text.substr(at, end - at)});
    at = end;
  }
  return tokens;
}

std::string replacement(const Token& token, const Dictionary& dictionary, Dice& dice) {
  switch (token.kind) {
    case TokenKind::number:
      return dice.pick(dictionary.numbers);
    case TokenKind::word:
      return dice.one_in(2) ? dice.pick(dictionary.words) : dice.pick(dictionary.keys);
    case TokenKind::quoted:
      return '"' + (dice.one_in(2) ? dice.pick(dictionary.texts) : dice.pick(dictionary.words)) + '"';
    case TokenKind::blank:
      return dice.one_in(2) ? "\n" : " ";
    case TokenKind::sign:
      break;
  }
  static const std::vector<const char*> signs = {"{", "}", "[", "]",  "(", ")", ",", ":", "=",
                                                 "-", ".", "#", "..", "<", "~", "&", "*"};
  return dice.pick(signs);
}

void change_token(std::string& text, const Dictionary& dictionary, Dice& dice) {
  std::vector<Token> tokens = tokens_of(text);
  if (tokens.empty()) return;
  // Numbers, words and texts say something; blanks and signs are touched less often.
  Token* token = &dice.pick(tokens);
  for (int i = 0; i < 3 && (token->kind == TokenKind::blank || token->kind == TokenKind::sign); ++i)
    token = &dice.pick(tokens);
  switch (dice.below(8)) {
    case 0:
      token->text.clear();
      break;
    case 1:
      token->text += token->text;
      break;
    case 2:
      std::swap(token->text, dice.pick(tokens).text);
      break;
    case 3:
      token->text = dice.pick(dictionary.numbers);
      break;
    default:
      token->text = replacement(*token, dictionary, dice);
      break;
  }
  text.clear();
  for (const Token& each : tokens) text += each.text;
}

void change_line(std::string& text, Dice& dice) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    lines.push_back(text.substr(at, end + 1 - at));
    at = end + 1;
  }
  if (lines.empty()) return;
  std::string& line = dice.pick(lines);
  switch (dice.below(3)) {
    case 0:
      line.clear();
      break;
    case 1:
      line += line;
      break;
    default:
      std::swap(line, dice.pick(lines));
      break;
  }
  text.clear();
  for (const std::string& each : lines) text += each;
}

/// The 8 bytes of a number, little-endian.
std::string word_of(std::uint64_t number) {
  std::string bytes;
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(number >> (8 * i));
  return bytes;
}

std::string nasty_word(Dice& dice) {
  using Limits = std::numeric_limits<double>;
  static const std::vector<std::uint64_t> words = {0,
                                                   1,
                                                   255,
                                                   0x7fffffff,
                                                   0x80000000,
                                                   0xffffffff,
                                                   std::uint64_t{1} << 29,
                                                   std::uint64_t{1} << 40,
                                                   std::uint64_t{1} << 63,
                                                   ~std::uint64_t{0},
                                                   std::bit_cast<std::uint64_t>(Limits::quiet_NaN()),
                                                   std::bit_cast<std::uint64_t>(Limits::infinity()),
                                                   std::bit_cast<std::uint64_t>(-1e300),
                                                   std::bit_cast<std::uint64_t>(Limits::denorm_min())};
  return word_of(dice.pick(words));
}

void change_bytes(std::string& bytes, Dice& dice, std::size_t from) {
  if (bytes.size() <= from) return;
  const std::size_t at = from + dice.below(bytes.size() - from);
  const std::size_t length = 1 + dice.below(std::min<std::size_t>(64, bytes.size() - at));
  switch (dice.below(8)) {
    case 0:
      bytes[at] = static_cast<char>(dice.below(256));
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.insert(at, bytes.substr(at, length));
      break;
    case 3:
      bytes.insert(at, 1 + dice.below(16), static_cast<char>(dice.below(256)));
      break;
    case 4:
      bytes.replace(at, 8, nasty_word(dice));
      break;
    case 5:
      bytes.resize(at);
      break;
    default:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.below(8)));
      break;
  }
}

}  // namespace

void mutate_text(std::string& text, const Dictionary& dictionary, Dice& dice) {
  do {
    if (dice.one_in(5))
      change_line(text, dice);
    else
      change_token(text, dictionary, dice);
  } while (dice.one_in(3));
}

void mutate_bytes(std::string& bytes, Dice& dice, std::size_t from) {
  do change_bytes(bytes, dice, from);
  while (dice.one_in(3));
}

}  // namespace flyrock::fuzz
