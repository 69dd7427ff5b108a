#include "judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "document/printable.h"

namespace flyrock::fuzz {

namespace {

constexpr std::string_view error_mark = "error: ";

bool begins_with_place(const std::string& line) {
  const std::size_t mark = line.find(": error: ");
  if (mark == std::string::npos) return false;
  // Two numbers, each behind a colon, between the name of the file and the mark.
  std::size_t at = mark;
  for (int number = 0; number < 2; ++number) {
    const std::size_t end = at;
    while (at > 0 && std::isdigit(static_cast<unsigned char>(line[at - 1]))) --at;
    if (at == end || at == 0 || line[at - 1] != ':') return false;
    --at;
  }
  return at > 0;
}

bool begins_with_name(const std::string& line) {
  return line.starts_with(error_mark) || line.find(": error: ") != std::string::npos;
}

/// The lines that say what is wrong: quoted lines of the input, which are indented, and warnings are none.
std::vector<std::string> error_lines(const std::string& err) {
  std::vector<std::string> lines;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);)
    if (!line.starts_with(' ') && !line.starts_with('\t') && line.find(error_mark) != std::string::npos &&
        line.find(": warning: ") == std::string::npos)
      lines.push_back(line);
  return lines;
}

/// Texts of libraries and of the language, which name nothing that a user wrote.
std::string library_text(const std::string& err) {
  constexpr std::array texts = {
      "json.exception",   "HDF5-DIAG",          "basic_string",     "std::",   "bad_alloc", "vector::_M",
      "terminate called", "malformed database", "filesystem error", "map::at", "stoi",      "stod"};
  for (const char* text : texts)
    if (err.find(text) != std::string::npos) return text;
  return {};
}

/// Whether a run ended with rocks that failed, and says so.
bool says_faults(const std::string& err) {
  return err.find("error: point ") != std::string::npos ||
         err.find("the run ended early") != std::string::npos;
}

bool has_code(const std::string& command, int code, const std::string& err) {
  if (code == cli::done || code == cli::bad_input) return true;
  if (code == cli::expectation_failed) return command == "run" || command == "merge" || command == "solve";
  return code == cli::faults && (command == "run" || command == "merge") && says_faults(err);
}

}  // namespace

std::string fault_of(const cli::Arguments& arguments, int code, const std::string& err, ErrorForm form) {
  const std::string command = arguments.empty() ? "" : arguments.front();
  const std::vector<std::string> errors = error_lines(err);
  const std::string first = errors.empty() ? "" : errors.front();
  if (!has_code(command, code, err))
    return fmt::format("exit code {} of {}: {}", code, command, first.empty() ? err : first);
  if (const std::string text = library_text(err); !text.empty())
    return fmt::format("text of a library ({}): {}", text, first);
  std::string one_line = err;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  if (const std::string text = text_fault(one_line); !text.empty()) return "the error text " + text;
  if (code == cli::bad_input) {
    if (errors.empty()) return "bad input without an error";
    for (const std::string& line : errors)
      if (form == ErrorForm::placed ? !begins_with_place(line) : !begins_with_name(line))
        return "without a line: " + line;
  } else if (code != cli::faults && !errors.empty()) {
    return fmt::format("exit code {} with an error: {}", code, first);
  }
  return {};
}

}  // namespace flyrock::fuzz
