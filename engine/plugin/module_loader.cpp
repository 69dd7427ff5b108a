#include "plugin/module_loader.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "plugin/in_child.h"
#include "plugin/module.h"
#include "plugin/shared_object.h"

namespace flyrock {

std::string load_module(const std::string& path, FactoryTable& table) {
  std::string fault;
  void* handle = open_shared_object(path, fault);
  if (!handle) return fmt::format("cannot open the module {}: {}", path, fault);
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

std::string load_module_guarded(const std::string& path, FactoryTable& table) {
  constexpr unsigned seconds =
      10;  // an object is open in milliseconds; the loader may not end on damaged tables
  const auto open = [&] {
    FactoryTable unused;
    load_module(path, unused);  // the parent process reports its error
  };
  if (!succeeds_in_child(open, seconds))
    return fmt::format(
        "cannot open the module {}: it is damaged: the loader fails on it; copy or build it again", path);
  return load_module(path, table);
}

}  // namespace flyrock
