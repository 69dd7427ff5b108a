#include "host/locate.h"

#include <fmt/format.h>

#include "host/lua_tokens.h"

namespace flyrock {

/// Walks over a table constructor and stores the places of its fields.
class ConstructorScanner {
 public:
  ConstructorScanner(const std::vector<LuaToken>& tokens, FieldPlaces& places)
      : tokens_(tokens), places_(places) {}

  void find_call(std::string_view function, int line) {
    for (; here().kind != LuaToken::Kind::end; ++at_) {
      if (here().kind != LuaToken::Kind::name || here().text != function) continue;
      const std::size_t brace = at_ + (ahead(1).is("(") ? 2 : 1);
      if (!tokens_[std::min(brace, tokens_.size() - 1)].is("{")) continue;
      if (here().line != line && ahead(1).line != line) continue;
      at_ = brace;
      constructor("");
      return;
    }
  }

 private:
  using Kind = LuaToken::Kind;
  const LuaToken& ahead(std::size_t by) const { return tokens_[std::min(at_ + by, tokens_.size() - 1)]; }
  const LuaToken& here() const { return ahead(0); }
  bool ended() const { return here().kind == Kind::end; }

  /// Reads from `{` to the end of its `}`.
  void constructor(const std::string& path) {
    ++at_;
    std::size_t position = 0;
    while (!ended() && !here().is("}")) {
      std::string field;
      const LuaToken key = here();
      if (here().kind == Kind::name && ahead(1).is("=")) {
        field = join_path(path, here().text);
        at_ += 2;
      } else if (here().is("[") && ahead(1).kind == Kind::text && ahead(2).is("]")) {
        field = join_path(path, ahead(1).text);
        at_ += 4;
      } else if (here().is("[") && ahead(1).kind == Kind::number && ahead(2).is("]")) {
        field = path + "[" + std::to_string(std::atol(ahead(1).text.c_str()) - 1) + "]";
        at_ += 4;
      } else {
        field = join_path(path, position++);
      }
      places_.keys_[field] = {key.line, key.column};
      places_.values_[field] = {here().line, here().column};
      expression(field);
      if (here().is(",") || here().is(";")) ++at_;
    }
    ++at_;
  }

  /// Reads to the end of a field's value.
  void expression(const std::string& path) {
    nested_constructor(path);
    int depth = 0;  // of brackets and blocks; commas inside do not end the field
    for (; !ended(); ++at_) {
      if (depth == 0 && (here().is(",") || here().is(";") || here().is("}"))) return;
      for (const char* open : {"(", "{", "[", "function", "do", "if", "repeat"}) depth += here().is(open);
      for (const char* close : {")", "}", "]", "end", "until"}) depth -= here().is(close);
    }
  }

  /// Reads `{ ... }`, `f { ... }` or `a.b({ ... })` if the value begins like this.
  void nested_constructor(const std::string& path) {
    const std::size_t start = at_;
    if (here().kind == Kind::name)
      for (++at_; here().is(".") && ahead(1).kind == Kind::name;) at_ += 2;
    const bool call = at_ > start && here().is("(");
    if (ahead(call).is("{")) {
      at_ += call;
      constructor(path);
      if (call && here().is(")")) ++at_;
    } else {
      at_ = start;
    }
  }

  const std::vector<LuaToken>& tokens_;
  FieldPlaces& places_;
  std::size_t at_ = 0;
};

FieldPlaces::FieldPlaces(std::shared_ptr<const Source> source, std::string_view function, int line)
    : source_(std::move(source)), line_(line) {
  const auto tokens = lua_tokens(source_->lines);
  ConstructorScanner(tokens, *this).find_call(function, line);
}

Location FieldPlaces::call() const { return {source_, line_, 1}; }

Location FieldPlaces::at(const std::map<std::string, Place>& places, const std::string& path) const {
  const auto found = places.find(path);
  return found == places.end() ? call() : Location{source_, found->second.line, found->second.column};
}

Location FieldPlaces::key(const std::string& path) const { return at(keys_, path); }
Location FieldPlaces::value(const std::string& path) const { return at(values_, path); }

std::string join_path(const std::string& path, std::size_t index) {
  return fmt::format("{}[{}]", path, index);
}

}  // namespace flyrock
