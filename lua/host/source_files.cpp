#include "host/source_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <lua.hpp>
#include <sstream>

namespace flyrock {

namespace {

/// The name of a chunk in messages. Lua cuts long names at the front.
std::string chunk_label(const std::string& name) {
  constexpr std::size_t room = LUA_IDSIZE - 1;
  constexpr std::string_view dots = "...";
  if (name.size() <= room) return name;
  return std::string(dots) + name.substr(name.size() - (room - dots.size()));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

std::optional<std::string> read_bytes(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none))
    return std::nullopt;  // reading a pipe or a device may never end
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string_view LuaFile::code() const {
  std::string_view code = text;
  if (code.starts_with("\xEF\xBB\xBF")) code.remove_prefix(3);
  if (code.starts_with('#')) code.remove_prefix(std::min(code.find('\n'), code.size()));
  return code;
}

const LuaFile* SourceFiles::read(const std::string& path, const std::string& shown, std::string& fault) {
  constexpr std::uintmax_t largest = 4 << 20;
  std::error_code none;
  if (const auto size = std::filesystem::file_size(path, none); !none && size > largest) {
    fault = fmt::format("`{}` is larger than 4 MiB", shown);
    return nullptr;
  }
  auto text = read_bytes(path);
  if (!text) {
    fault = fmt::format("cannot read `{}`", shown);
    return nullptr;
  }
  LuaFile file;
  file.path = path;
  file.folder = std::filesystem::path(path).parent_path().string();
  file.source = std::make_shared<Source>(Source{shown, lines_of(*text)});
  file.text = std::move(*text);
  files_.push_back(std::make_unique<LuaFile>(std::move(file)));
  return files_.back().get();
}

const LuaFile* SourceFiles::of_chunk(const std::string& chunk) const {
  for (auto file = files_.rbegin(); file != files_.rend();
       ++file)  // for a file that was read again: the last text
    if (chunk == "@" + (*file)->source->name) return file->get();
  return nullptr;
}

std::optional<std::pair<Location, std::string>> SourceFiles::split_message(const std::string& message) const {
  for (auto it = files_.rbegin(); it != files_.rend(); ++it) {
    const LuaFile* file = it->get();
    const std::string prefix = chunk_label(file->source->name) + ":";
    if (message.compare(0, prefix.size(), prefix) != 0) continue;
    const std::size_t end = message.find(": ", prefix.size());
    const std::string line = message.substr(prefix.size(), end - prefix.size());
    if (end == message.npos || line.empty() || line.size() > 9 ||
        line.find_first_not_of("0123456789") != line.npos)
      continue;
    return std::pair(Location{file->source, std::stoi(line), 1}, message.substr(end + 2));
  }
  return std::nullopt;
}

}  // namespace flyrock
