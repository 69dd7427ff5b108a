#pragma once
// A session with its own folder for files that a test writes.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "host/session.h"

struct LuaFixture {
  flyrock::LuaSession session{FLYROCK_SHARE_DIR};
  std::filesystem::path folder;

  LuaFixture() {
    std::string name = (std::filesystem::temp_directory_path() / "flyrock-lua-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~LuaFixture() { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  }

  /// The messages of loading a plugin, one "file:line:column: path: text" in each line, in the order of the
  /// file.
  std::string load(const std::string& name) {
    flyrock::Diagnostics diagnostics;
    session.load_plugin((folder / name).string(), name, {}, diagnostics);
    return messages(diagnostics);
  }

  static std::string messages(const flyrock::Diagnostics& diagnostics) {
    std::vector<flyrock::Diagnostic> all = diagnostics.all();
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
    });
    std::string text;
    for (const auto& one : all)
      text += fmt::format("{}:{}:{}: {}{}{}\n", one.at.source ? one.at.source->name : "", one.at.line,
                          one.at.column, one.path, one.path.empty() ? "" : ": ", one.text);
    return text;
  }
};

/// A session with one plugin `m` of a kind, with the given fields of its manifest.
struct OnePlugin : LuaFixture {
  OnePlugin(const std::string& kind, const std::string& fields) {
    write("m.lua", "local fr = require 'flyrock'\nreturn fr.plugin { kind = '" + kind +
                       "', name = 'm', doc = 'd',\n" + fields + " }");
    INFO(fields);
    CHECK(load("m.lua") == "");
  }
};
