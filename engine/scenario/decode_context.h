#pragma once
// What the two steps from a document to a scenario share. The first step normalises the document: it reports
// wrong types, units, limits and unknown or missing keys, converts every number to SI units and fills in
// defaults. The tree that it makes is the one that `show` prints. The second step decodes that tree into the
// typed scenario, and checks what names and values mean together.
//
// A value that is wrong is null in the normalised tree. Decoding reads it as 0, as empty text or as a
// constant 0, so that the rest of the scenario can still be checked before it is refused.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "blast/blast.h"
#include "document/node.h"
#include "plugin/registry.h"
#include "scenario/ground_store.h"

namespace flyrock {

/// The value of a key of a normalised map, unless it is a default that the document does not give.
inline std::optional<Node> find_given(const Node& map, std::string_view key) {
  std::optional<Node> node = map.find(key);
  if (node && node->value->assumed) node.reset();
  return node;
}

/// For one point of a sweep.
struct DecodeContext {
  const Registry& registry;
  std::string folder;  ///< of the scenario; files that it names are relative to it
  Diagnostics& diagnostics;
  const std::set<std::string>& swept;  ///< paths of the axes of the sweep
  /// An earlier step, as the loading of plugins, has reported errors. An unknown name is then not reported,
  /// because its plugin may be the one that failed.
  bool earlier_errors = false;
  int dimension = 2;
  std::vector<Draw> draws = {};
  int group = -1;  ///< the group of rocks (or body) that is decoded; -1: none
  struct SweptNumber {
    double si = 0;
    std::string unit;  ///< SI
  };
  std::map<std::string, SweptNumber> swept_values =
      {};                                         ///< by path; the axes found so far whose value is a number
  std::map<std::string, std::string> files = {};  ///< that parameters name: name as written -> full path
  std::set<std::string> unsound = {};  ///< paths of plugins and sections in which an error was found
  std::shared_ptr<GroundStore> grounds = nullptr;  ///< of all points
  std::vector<BlastField> forced_fields = {};      ///< of the blast, that a branch sets for each hole
  bool has_holes = false;                          ///< the blast has measured holes, at places of their own
  double north = pi / 2;                           ///< rad, from +x towards +y: where bearing 0 points
  std::string crs = {};                            ///< of the terrain, "EPSG:2056"; empty: it has none
  std::map<std::string, Value> shapes = {};        ///< of the document, by name, normalised
  std::vector<std::string> tables = {};            ///< a line for each table that was read

  bool is_sound(const std::string& path) const { return !unsound.contains(path); }
};

/// Marks `path` as unsound (DecodeContext::unsound) if an error is reported while this object lives.
class SoundnessOf {
 public:
  SoundnessOf(DecodeContext& context, std::string path)
      : context_(context), path_(std::move(path)), errors_(context.diagnostics.errors_given()) {}
  ~SoundnessOf() {
    if (context_.diagnostics.errors_given() != errors_) context_.unsound.insert(path_);
  }
  SoundnessOf(const SoundnessOf&) = delete;
  SoundnessOf& operator=(const SoundnessOf&) = delete;

 private:
  DecodeContext& context_;
  const std::string path_;
  const std::size_t errors_;
};

}  // namespace flyrock
