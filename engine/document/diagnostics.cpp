#include "document/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "document/odd_characters.h"
#include "document/printable.h"

namespace flyrock {

namespace {

std::string source_name(const Diagnostic& diagnostic) {
  return diagnostic.at.source ? diagnostic.at.source->name : std::string();
}

/// "file:line:column: ", or the known part of it.
std::string place(const Diagnostic& diagnostic) {
  const std::string name = with_codes(printable(source_name(diagnostic)));
  if (name.empty()) return {};
  if (diagnostic.at.line == 0) return name + ": ";
  return fmt::format("{}:{}:{}: ", name, diagnostic.at.line, diagnostic.at.column);
}

/// The quoted line and a caret below the column. Columns count characters, not bytes. A tab is repeated, so
/// that the caret is in the right column at any tab width. Empty if the line cannot be shown in a terminal.
std::string quotation(const Location& at) {
  if (!at.source || at.line < 1 || at.line > static_cast<int>(at.source->lines.size())) return {};
  constexpr std::size_t longest = 200;
  const std::string& line = at.source->lines[at.line - 1];
  if (line.size() > longest || printable(line) != line) return {};
  std::string blanks;
  int column = 1;
  for (char c : line) {
    if (column >= at.column) break;
    if ((c & 0xC0) == 0x80) continue;  // a later byte of the same UTF-8 character
    blanks += c == '\t' ? '\t' : ' ';
    ++column;
  }
  return "  " + line + "\n  " + blanks + "^\n";
}

std::string message(const Diagnostic& diagnostic) {
  return diagnostic.path.empty() ? diagnostic.text : diagnostic.path + ": " + diagnostic.text;
}

/// The message in one line.
std::string headline(const Diagnostic& diagnostic) {
  const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
  return fmt::format("{}{}: {}\n", place(diagnostic), severity, message(diagnostic));
}

}  // namespace

void Diagnostics::error(const Location& at, const std::string& path, const std::string& text) {
  ++errors_given_;
  add({Severity::error, at, path, text});
}

void Diagnostics::warning(const Location& at, const std::string& path, const std::string& text) {
  add({Severity::warning, at, path, text});
}

void Diagnostics::unusual(const Location& at, const std::string& path, const std::string& text) {
  add({Severity::unusual, at, path, text});
}

void Diagnostics::be_strict() {
  for (Diagnostic& diagnostic : all_) {
    if (diagnostic.severity != Severity::unusual) continue;
    diagnostic.severity = Severity::error;
    ++errors_given_;
  }
}

void Diagnostics::add(Diagnostic diagnostic) {
  const std::string hint = odd_character_hint(diagnostic.path + diagnostic.text);
  diagnostic.path = with_codes(printable(diagnostic.path));
  diagnostic.text = with_codes(printable(diagnostic.text));
  if (diagnostic.severity == Severity::error && !hint.empty()) diagnostic.text += fmt::format(" ({})", hint);
  if (known_.insert(headline(diagnostic)).second) all_.push_back(std::move(diagnostic));
}

std::vector<std::string> Diagnostics::warnings() const {
  std::vector<std::string> list;
  for (const Diagnostic& diagnostic : all_)
    if (diagnostic.severity != Severity::error) list.push_back(message(diagnostic));
  return list;
}

std::string Diagnostics::to_text() const {
  std::vector<const Diagnostic*> sorted;
  for (const Diagnostic& diagnostic : all_) sorted.push_back(&diagnostic);
  auto key = [](const Diagnostic* d) { return std::make_tuple(source_name(*d), d->at.line, d->at.column); };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Diagnostic* a, const Diagnostic* b) { return key(a) < key(b); });
  std::string text;
  constexpr std::size_t most = 100;
  for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i) text += flyrock::to_text(*sorted[i]);
  if (sorted.size() > most) text += fmt::format("and {} more\n", sorted.size() - most);
  return text;
}

std::string to_text(const Diagnostic& diagnostic) { return headline(diagnostic) + quotation(diagnostic.at); }

}  // namespace flyrock
