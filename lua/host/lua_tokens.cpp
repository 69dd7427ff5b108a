#include "host/lua_tokens.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

namespace flyrock {

namespace {

class Scanner {
 public:
  explicit Scanner(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) text_ += line + '\n';
  }

  std::vector<LuaToken> scan() {
    if (peek() == '#') skip_line();  // as Lua does, for "#!/usr/bin/lua"
    for (;;) {
      skip_blank();
      LuaToken token = next();
      tokens_.push_back(token);
      if (token.kind == LuaToken::Kind::end) return std::move(tokens_);
    }
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  char take() {
    const char c = text_[at_++];
    column_ = c == '\n' ? 1 : column_ + 1;
    line_ += c == '\n';
    return c;
  }

  void skip_line() {
    while (peek() && peek() != '\n') take();
  }

  void skip_blank() {
    while (peek()) {
      if (std::isspace(static_cast<unsigned char>(peek()))) {
        take();
      } else if (peek() == '-' && peek(1) == '-') {
        take(), take();
        if (const int level = long_bracket(); level >= 0)
          read_long(level);
        else
          skip_line();
      } else {
        return;
      }
    }
  }

  /// The number of equals signs of a long bracket that begins here, or -1.
  int long_bracket() const {
    if (peek() != '[') return -1;
    std::size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    return peek(1 + level) == '[' ? static_cast<int>(level) : -1;
  }

  std::string read_long(int level) {
    const std::string close = fmt::format("]{:=>{}}]", "", level);
    for (int i = 0; i < level + 2; ++i) take();
    std::string text;
    while (peek() && text_.compare(at_, close.size(), close) != 0) text += take();
    for (std::size_t i = 0; i < close.size() && peek(); ++i) take();
    return text;
  }

  std::string read_quoted(char quote) {
    std::string text;
    take();
    while (peek() && peek() != quote) {
      if (peek() == '\\') text += take();
      if (peek()) text += take();
    }
    if (peek()) take();
    return text;
  }

  LuaToken next() {
    using Kind = LuaToken::Kind;
    LuaToken token{Kind::end, "", line_, column_};
    const auto word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    if (!peek()) return token;
    if (std::isdigit(static_cast<unsigned char>(peek()))) {
      token.kind = Kind::number;
      // The sign of an exponent belongs to the number; a minus after other letters does not.
      while (word(peek()) || peek() == '.' ||
             (std::strchr("+-", peek()) && std::strchr("eEpP", token.text.back())))
        token.text += take();
    } else if (word(peek())) {
      token.kind = Kind::name;
      while (word(peek())) token.text += take();
    } else if (peek() == '"' || peek() == '\'') {
      token.kind = Kind::text;
      token.text = read_quoted(peek());
    } else if (const int level = long_bracket(); level >= 0) {
      token.kind = Kind::text;
      token.text = read_long(level);
    } else {
      token.kind = Kind::symbol;
      token.text = take();
      if (peek() == '=' && std::strchr("=<>~", token.text[0]))
        token.text += take();  // `==` is one word and differs from `=`
    }
    return token;
  }

  std::string text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  std::vector<LuaToken> tokens_;
};

}  // namespace

std::vector<LuaToken> lua_tokens(const std::vector<std::string>& lines) { return Scanner(lines).scan(); }

}  // namespace flyrock
