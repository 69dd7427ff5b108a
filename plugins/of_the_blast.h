#pragma once
// The errors of blast formulas, for the models that use them.

#include <stdexcept>
#include <string>

#include "plugin/contact_law.h"

namespace flyrock::plugins {

/// The result of a blast formula. Its errors are rethrown with the plugin's name.
template <class Formula>
auto of_the_blast(const std::string& plugin, Formula formula) {
  try {
    return formula();
  } catch (const std::invalid_argument& fault) {
    throw PluginError("plugin " + plugin + ": " + fault.what());
  }
}

}  // namespace flyrock::plugins
