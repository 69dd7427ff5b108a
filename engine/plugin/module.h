#pragma once
// The entry points of a shared object with native plugins.

#include <Eigen/Core>

#include "plugin/contact_law.h"
#include "plugin/models.h"
#include "plugin/registry.h"

namespace flyrock {

/// Data that the host compares before it calls any function of a shared object.
struct ModuleTag {
  char magic[8];
  int abi;
  int compiler;   ///< __GNUC__
  int alignment;  ///< EIGEN_MAX_ALIGN_BYTES
  char version[16];
  bool operator==(const ModuleTag&) const = default;
};
inline constexpr int module_abi = 11;
constexpr ModuleTag module_tag() {
  return {{'f', 'l', 'y', 'r', 'o', 'c', 'k', 0},
          module_abi,
          __GNUC__,
          EIGEN_MAX_ALIGN_BYTES,
          FLYROCK_ENGINE_VERSION};
}

}  // namespace flyrock

/// Every module defines both: FLYROCK_MODULE(table) { table[{kind, "name"}] = ...; return nullptr; }
/// The function returns an error text, or nullptr.
#define FLYROCK_MODULE(table)                                                                    \
  extern "C" __attribute__((visibility("default"))) const flyrock::ModuleTag flyrock_module_tag; \
  const flyrock::ModuleTag flyrock_module_tag = flyrock::module_tag();                           \
  extern "C" __attribute__((visibility("default"))) const char* flyrock_module_register(         \
      flyrock::FactoryTable& table)
