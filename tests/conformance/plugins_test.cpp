// Every registered plugin, found by itself, keeps what plugin/conformance.h says.

#include <catch2/catch.hpp>

#include "host/session.h"
#include "plugin/conformance.h"

using namespace flyrock;

TEST_CASE("every registered plugin conforms") {
  const LuaSession session(FLYROCK_SHARE_DIR);
  for (int k = 0; k < plugin_kinds; ++k) {
    const auto kind = static_cast<PluginKind>(k);
    const auto plugins = session.registry().of_kind(kind);
    INFO("kind " << name_of(kind));
    CHECK_FALSE(plugins.empty());
    for (const Plugin* plugin : plugins) {
      INFO("plugin " << plugin->spec.name);
      CHECK_FALSE(plugin->spec.doc.empty());
      for (const ParamSpec& param : plugin->spec.params) {
        INFO("parameter " << param.name);
        CHECK_FALSE(param.doc.empty());
      }
      CHECK(conformance(*plugin).faults == std::vector<std::string>{});
    }
  }
}
