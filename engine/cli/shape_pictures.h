#pragma once
// The picture of a shape: the rocks of its example.

#include <optional>
#include <string>

#include "plugin/spec.h"

namespace flyrock::cli {

/// The example of a plugin, beside its manifest, whose name counts from `folder`; empty if there is none.
std::string example_of(const PluginSpec& spec, const std::string& folder);

/// The picture (report/pictures/shape_picture.h) of the first rocks of the example of the shape `name`, as
/// they start in trial 0. Nothing if the example has errors, which are printed. Throws InputError if none can
/// start.
std::optional<std::string> picture_of(const std::string& name, const std::string& example);

}  // namespace flyrock::cli
