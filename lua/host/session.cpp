#include "host/session.h"

#include <fmt/format.h>

#include <filesystem>

#include "host/host.h"

namespace flyrock {

namespace fs = std::filesystem;

LuaSession::LuaSession(const std::string& share) : host_(std::make_unique<Host>(share)) {
  const fs::path folder = fs::path(share) / "plugins";
  if (!fs::is_directory(folder))
    throw std::runtime_error(
        fmt::format("flyrock's plugins are missing: no folder {}; reinstall, or name the folder that "
                    "has them in FLYROCK_DATA",
                    folder.string()));
  std::vector<fs::path> manifests;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "plugin.lua") manifests.push_back(entry.path());
  std::sort(manifests.begin(), manifests.end());
  Diagnostics diagnostics;
  for (const fs::path& manifest : manifests)
    host_->load_builtin(manifest.string(), manifest.lexically_relative(share).string(), diagnostics);
  if (diagnostics.has_errors())
    throw std::runtime_error("flyrock's own plugins are broken:\n" + diagnostics.to_text());
}

LuaSession::~LuaSession() = default;

void LuaSession::load_plugin(const std::string& path, const std::string& shown, const Location& at,
                             Diagnostics& diagnostics) {
  if (fs::is_directory(path))
    host_->load_plugin((fs::path(path) / "plugin.lua").string(), (fs::path(shown) / "plugin.lua").string(),
                       at, diagnostics);
  else
    host_->load_plugin(path, shown, at, diagnostics);
}

std::optional<Value> LuaSession::read_scenario(const std::string& path, const std::string& shown,
                                               Diagnostics& diagnostics) {
  return host_->read_scenario(path, shown, diagnostics);
}

LuaArguments& LuaSession::arguments() { return host_->arguments(); }
const LuaArguments& LuaSession::arguments() const { return host_->arguments(); }

void LuaSession::collect_prints() { host_->state().collect_prints(); }
PrintLog LuaSession::take_prints() { return host_->state().take_prints(); }

const Registry& LuaSession::registry() const { return host_->registry(); }
const std::vector<LuaSession::SourceText>& LuaSession::sources() const { return host_->sources(); }

}  // namespace flyrock
