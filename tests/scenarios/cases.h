#pragma once
// Scenarios and the expected messages about them, side by side in one file:
//
//   === face_angle.yaml
//   <the scenario>
//   --- says
//   <the exact text of the messages>
//
// Text before the first case says what the messages are about. The scenarios may name files in the same
// folder.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace flyrock::test {

struct MessageCase {
  std::string name;  ///< a file name; messages begin with it
  std::string input, says;
};

struct CaseFile {
  std::string about;
  std::vector<MessageCase> cases;
};

/// FLYROCK_UPDATE_EXPECT=1 writes the messages anew; look at the difference before it is committed.
inline bool updates() { return std::getenv("FLYROCK_UPDATE_EXPECT") != nullptr; }

inline CaseFile read_cases(const std::filesystem::path& path) {
  std::ifstream file(path);
  CaseFile result;
  std::string* text = &result.about;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("=== ")) {
      result.cases.push_back({line.substr(4), {}, {}});
      text = &result.cases.back().input;
    } else if (line == "--- says") {
      if (result.cases.empty()) throw std::runtime_error("no case before `--- says`");
      text = &result.cases.back().says;
    } else {
      *text += line + '\n';
    }
  }
  for (MessageCase& one : result.cases)  // an empty line separates it from the next case
    if (one.says.ends_with("\n\n")) one.says.pop_back();
  return result;
}

inline void write_cases(const std::filesystem::path& path, const CaseFile& file) {
  std::ofstream out(path);
  out << file.about;
  for (std::size_t i = 0; i < file.cases.size(); ++i) {
    const MessageCase& one = file.cases[i];
    out << (i > 0 ? "\n" : "") << "=== " << one.name << '\n' << one.input << "--- says\n" << one.says;
  }
}

}  // namespace flyrock::test
