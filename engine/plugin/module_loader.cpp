#include "plugin/module_loader.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "plugin/module.h"

namespace flyrock {

std::string load_module(const std::string& path, FactoryTable& table) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return fmt::format("cannot open the module {}: {}", path, dlerror());
  const auto* tag = static_cast<const ModuleTag*>(dlsym(handle, "flyrock_module_tag"));
  if (!tag) return fmt::format("{} is not a flyrock module: it has no flyrock_module_tag", path);
  const ModuleTag own = module_tag();
  if (std::string(tag->magic, sizeof tag->magic) != std::string(own.magic, sizeof own.magic))
    return fmt::format("{} is not a flyrock module: its tag is foreign", path);
  if (!(*tag == own))
    return fmt::format(
        "{} was built for another flyrock: ABI {}, compiler {}, Eigen alignment {}, version {}; expected {}, "
        "{}, {}, {}",
        path, tag->abi, tag->compiler, tag->alignment, tag->version, own.abi, own.compiler, own.alignment,
        own.version);
  using Register = const char* (*)(FactoryTable&);
  auto register_factories = reinterpret_cast<Register>(dlsym(handle, "flyrock_module_register"));
  if (!register_factories) return fmt::format("{} has no flyrock_module_register", path);
  if (const char* error = register_factories(table)) return fmt::format("{}: {}", path, error);
  return {};
}

}  // namespace flyrock
