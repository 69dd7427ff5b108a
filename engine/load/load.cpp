#include "load/load.h"

#include <filesystem>

#include "document/yaml_reader.h"
#include "files/safe_file.h"
#include "files/sha256.h"
#include "host/share.h"
#include "load/checksums.h"
#include "load/clearance_check.h"
#include "load/confined.h"
#include "load/greatest_throw.h"
#include "load/include.h"
#include "load/weight_check.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

Location in_file(const std::string& name) { return {std::make_shared<Source>(Source{name, {}}), 0, 0}; }

std::optional<Value> read_tree(const std::string& path, LuaSession& session, Diagnostics& diagnostics) {
  const std::string extension = fs::path(path).extension().string();
  if (extension == ".lua") return session.read_scenario(path, path, diagnostics);
  if (extension != ".yaml" && extension != ".yml") {
    diagnostics.error(in_file(path), "", "expected a scenario: a file .yaml, .yml or .lua");
    return std::nullopt;
  }
  try {
    std::string text;
    FileReader(path).append_to(
        text, most_yaml_bytes + 1);  // read only enough of a longer file to see that it is too long
    return read_yaml(text, path, diagnostics);
  } catch (const FileError& error) {
    diagnostics.error(in_file(path), "", error.what());
    return std::nullopt;
  }
}

void load_plugin_files(const Value& root, const fs::path& folder, LuaSession& session,
                       Diagnostics& diagnostics) {
  for (const auto& [file, at] : plugin_files(root, diagnostics))
    session.load_plugin((folder / file).string(), file, at, diagnostics);
}

std::uint64_t trials_of(const Value& root) {
  const Value* trials = root.find("trials");
  const double* number = trials ? trials->number() : nullptr;
  return number && *number >= 1 ? static_cast<std::uint64_t>(*number) : 1;
}

/// The files that parameters name, with their present content, because another terrain under the same name
/// makes another scenario.
std::vector<SourceHash> hashes_of(const std::map<std::string, std::string>& files, Diagnostics& diagnostics) {
  std::vector<SourceHash> hashes;
  for (const auto& [name, path] : files) try {
      hashes.push_back({name, sha256_of_file(path)});
    } catch (const FileError& error) {
      diagnostics.error(in_file(path), "", error.what());
    }
  return hashes;
}

/// The file of the run in which bodies start is what the run wrote.
void check_start(const Value& root, const fs::path& folder, Diagnostics& diagnostics) {
  const std::optional<Node> start = Node::root(root).find("start");
  if (!start) return;
  const Node from = *start->find("from");
  try {
    check_checksum(folder / *from.value->text(), last_states_name);
  } catch (const FileError& error) {
    from.error(diagnostics, error.what());
  }
}

std::string hash_of(const LoadedScenario& loaded) {
  std::string text = FLYROCK_ENGINE_VERSION "\n" + to_json(loaded.plan.resolved) + '\n';
  for (const auto* list : {&loaded.sources, &loaded.files})
    for (const SourceHash& source : *list) text += source.name + ' ' + source.sha256 + '\n';
  for (const LuaArgument& argument : loaded.session->arguments().asked())  // laws may depend on them
    text += argument.name + '=' + text_of(argument) + '\n';
  return sha256(text);
}

}  // namespace

std::optional<LoadedScenario> load_scenario(const std::string& path, const Overrides& overrides,
                                            Diagnostics& diagnostics, Prints prints,
                                            const LoadedScenario* before) {
  LoadedScenario loaded;
  loaded.session = std::make_unique<LuaSession>(share_folder());
  if (prints == Prints::collected) loaded.session->collect_prints();
  if (overrides.confined) loaded.session->refuse_natives();
  loaded.name = fs::path(path).stem().string();
  const std::size_t builtin = loaded.session->registry().size();
  loaded.session->arguments().give(overrides.arguments, diagnostics);
  std::optional<Value> tree = read_tree(path, *loaded.session, diagnostics);
  if (!tree) return std::nullopt;
  Value& root = loaded.root = std::move(*tree);
  loaded.defines_plugins = loaded.session->registry().size() > builtin;
  loaded.own_trials = trials_of(root);
  const fs::path folder = fs::path(path).parent_path();
  if (overrides.confined) {
    refuse_outer_files(root, folder, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
  }
  std::map<std::string, std::string> included;
  std::vector<Value> library;
  if (root.map())
    library = included_files(root, folder, fs::path(share_folder()) / "library", included, diagnostics);
  take_included(root, library, diagnostics);
  apply_overrides(root, overrides, diagnostics);
  // An override may change an included value, and name another one.
  if (!diagnostics.has_errors()) take_included(root, library, diagnostics);
  load_plugin_files(root, folder, *loaded.session, diagnostics);
  loaded.session->arguments().refuse_unasked(diagnostics);

  std::optional<Plan> plan = decode(root, loaded.session->registry(), folder.string(), diagnostics,
                                    before ? before->plan.points.front().terrain.grounds : nullptr);
  if (!plan || diagnostics.has_errors()) return std::nullopt;
  loaded.plan = std::move(*plan);
  loaded.plan.files.merge(included);
  // A run shorter than the scenario asks for may lack answers and lists them. A full run must give all
  // answers.
  check_clearances(root, loaded.plan, loaded.plan.points.front().trials_of_run() >= loaded.own_trials,
                   diagnostics);
  if (!before) check_start(root, folder, diagnostics);
  if (!before) {  // these build and fly rocks, once is enough
    warn_of_weights(root, loaded.plan, diagnostics);
    warn_of_short_throws(root, loaded.plan, diagnostics);
  }
  loaded.files = before ? before->files : hashes_of(loaded.plan.files, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  loaded.warnings = diagnostics.warnings();
  for (const auto& [name, text] : loaded.session->sources()) loaded.sources.push_back({name, sha256(text)});
  loaded.hash = hash_of(loaded);
  return loaded;
}

}  // namespace flyrock
