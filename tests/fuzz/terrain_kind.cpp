// Files of ground with the quirks of programs: each is read as it is meant, or refused with a cure that
// helps.

#include <fmt/format.h>

#include "corpus.h"
#include "kind.h"
#include "terrain_judge.h"

namespace flyrock::fuzz {

namespace {

std::string scenario_of(const TerrainFile& file, const std::string& keys) {
  const std::string place = file.dimension == 2 ? fmt::format("x: {}", file.start.x())
                                                : fmt::format("x: {}, y: {}", file.start.x(), file.start.y());
  return fmt::format(
      "flyrock: 1\ndimension: {}\nmethod: lumped_mass\ntrials: 1\n"
      "terrain: {{ {}{}{}, material: m }}\n{}"
      "materials: {{ m: {{ friction: {{ type: coulomb, mu: 0.6 }} }} }}\n"
      "rocks:\n  - {{ name: r, density: 2700, shape: {{ type: {} }}, release: {{ {}, above_ground: 2 m }} "
      "}}\n"
      "stop: {{ time: 60 s }}\n",
      file.dimension, file.terrain, keys.empty() ? "" : ", ", keys, file.other,
      file.dimension == 2 ? "disk, radius: 0.2" : "sphere, radius: 0.2", place);
}

class TerrainFiles : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    const TerrainFile file = make_terrain_file(dice);
    std::string keys;
    if (!file.fault.empty()) {
      if (check(file, keys, call) == cli::done)
        return call.blame("a file with a fault is read: " + file.fault);
      if (!call.captures()) return;  // its words are on the terminal
      if (call.err().find("reading this format needs GDAL") != std::string::npos) return;
      if (call.err().find(file.fault) == std::string::npos)
        return call.blame("the refusal does not say: " + file.fault);
      if (file.cure.empty()) return;
      keys = told_cure(call.err(), file.cure);
      if (keys.empty()) return call.blame("the refusal does not tell to write: " + file.cure);
    }
    if (check(file, keys, call) != cli::done) {
      if (call.err().find("reading this format needs GDAL") != std::string::npos) return;
      return call.blame(keys.empty() ? "a sound file is refused" : "refused with its cure, too: " + keys);
    }
    call.blame(fault_of_ground(file, "s.yaml"));
  }

 private:
  static int check(const TerrainFile& file, const std::string& keys, Calls& call) {
    write_here("s.yaml", scenario_of(file, keys));
    return call({"check", "s.yaml"}, ErrorForm::placed);
  }
};

}  // namespace

std::unique_ptr<Kind> make_terrain_kind() { return std::make_unique<TerrainFiles>(); }

}  // namespace flyrock::fuzz
