#pragma once
// The kinds of inputs that are mutated.

#include <array>
#include <memory>
#include <string_view>

#include "calls.h"
#include "dice.h"

namespace flyrock::fuzz {

/// A kind of input. It runs in the child of a batch; the current folder is its own and empty.
class Kind {
 public:
  virtual ~Kind() = default;
  /// Writes a mutant into the current folder and calls the commands that read it.
  virtual void attempt(Dice& dice, Calls& call) = 0;
};

std::unique_ptr<Kind> make_yaml_kind();        ///< YAML scenarios and the files that they name
std::unique_ptr<Kind> make_lua_kind();         ///< Lua scenarios
std::unique_ptr<Kind> make_plugin_kind();      ///< manifests and laws in Lua
std::unique_ptr<Kind> make_chunk_kind();       ///< shards: chunk files, request.json, manifest.json
std::unique_ptr<Kind> make_problem_kind();     ///< friction problems in HDF5; null if the build has no HDF5
std::unique_ptr<Kind> make_result_kind();      ///< results.db, manifest.json, summary.json
std::unique_ptr<Kind> make_arguments_kind();   ///< words of the command line
std::unique_ptr<Kind> make_scene_kind();       ///< random scenes, judged by their motion
std::unique_ptr<Kind> make_hole_table_kind();  ///< tables of holes, judged by what is read of them
std::unique_ptr<Kind> make_sheet_kind();       ///< workbooks with a table of holes, damaged
std::unique_ptr<Kind> make_layer_kind();       ///< layers of zones and clouds of points, damaged
std::unique_ptr<Kind> make_terrain_kind();     ///< files of ground, judged by what is read of them

struct KindEntry {
  std::string_view name;
  std::unique_ptr<Kind> (*make)();
  int share;  ///< percent of the time and of the mutants; 0: only if it is asked for
};

inline constexpr std::array<KindEntry, 12> kinds = {{
    {"yaml", make_yaml_kind, 30},
    {"lua", make_lua_kind, 15},
    {"plugin", make_plugin_kind, 15},
    {"chunk", make_chunk_kind, 10},
    {"hdf5", make_problem_kind, 10},
    {"result", make_result_kind, 10},
    {"arguments", make_arguments_kind, 10},
    {"scenes", make_scene_kind, 0},
    {"terrain", make_terrain_kind, 0},
    {"tables", make_hole_table_kind, 0},
    {"sheets", make_sheet_kind, 0},
    {"layers", make_layer_kind, 0},
}};

}  // namespace flyrock::fuzz
