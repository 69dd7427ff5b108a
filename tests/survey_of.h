#pragma once
// Terrains from files, for tests: what was read, and what is wrong with a file.

#include "conformance/plugin_use.h"
#include "survey/surveyed_terrain.h"
#include "temporary_file.h"

namespace flyrock {

inline const LuaSession& survey_plugins() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

struct Survey {
  TerrainShape3 shape;
  SurveyReport report;
};

using SurveyKeys = std::map<std::string, Given>;

/// `plugin`: raster or mesh. `keys`: beside `file`.
inline Survey survey_of(const std::string& plugin, const std::string& path, SurveyKeys keys = {}) {
  keys["file"] = path.c_str();
  const auto made = make<TerrainModel>(survey_plugins(), PluginKind::terrain, plugin, keys, 3);
  RandomStream rng(1, "terrain", {});
  Survey survey{made.model->build_3d(made.values, rng), {}};
  survey.report = dynamic_cast<const SurveyedTerrain&>(*made.model).report();
  return survey;
}

/// The text of the error without the name of the plugin and the folder; "no error" without one.
inline std::string survey_error(const std::string& plugin, const TemporaryFile& file,
                                const SurveyKeys& keys = {}) {
  try {
    survey_of(plugin, file.path, keys);
  } catch (const PluginError& error) {
    const std::string text = error.what(), start = ": " + file.path + ":";
    const std::size_t at = text.find(start);
    return at == text.npos ? text : text.substr(at + start.size());
  }
  return "no error";
}

}  // namespace flyrock
