#pragma once
// The types of scenarios and plugins for LuaLS, the language server of Lua: what an editor shows and
// completes in Lua files. From the sections of the schema, the manifests and the fields that plugins read.

#include <string>

#include "plugin/registry.h"

namespace flyrock::cli {

std::string lua_annotations(const Registry& registry);

}  // namespace flyrock::cli
