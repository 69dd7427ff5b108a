// Words of the command line: options with numbers and texts that are none, and values of --set.

#include "corpus.h"
#include "host/session.h"
#include "host/share.h"
#include "kind.h"
#include "mutate_text.h"
#include "mutate_tree.h"

namespace flyrock::fuzz {

namespace {

const char* const fences_file = "tests/fuzz/corpus/scenarios/fences.yaml";

/// A command line with "?" where a mutated value goes; what is in its place in a sound one.
struct Template {
  cli::Arguments words;
  const char* sound;
};

const std::vector<Template>& templates() {
  static const std::vector<Template> list = {
      // `check`, not `run`: a number of trials that is sound may be 1e9.
      {{"check", "s.yaml", "--trials", "?"}, "2"},
      {{"check", "s.yaml", "--seed", "?"}, "7"},
      {{"check", "s.yaml", "--set", "?"}, "stop.time=1"},
      {{"check", "s.yaml", "--set", "?"}, "rocks.blocks.density=2700"},
      {{"check", "s.yaml", "--set", "?"}, "gates.0.x=12"},
      {{"run", "s.yaml", "-o", "out", "--quiet", "-j", "?"}, "2"},
      {{"run", "s.yaml", "-o", "out", "--quiet", "--seed", "?"}, "7"},
      {{"run", "s.yaml", "-o", "out", "--quiet", "-j", "1", "--shard", "?"}, "1/2"},
      {{"run", "s.yaml", "-o", "out", "--quiet", "-j", "1", "--only", "?"}, "point=0,trial=1"},
      {{"show", "s.yaml", "--set", "?"}, "terrain.material=rock"},
      {{"explain", "s.yaml", "--impact", "?"}, "1"},
      {{"explain", "s.yaml", "--step", "1", "--trial", "?"}, "0"},
      {{"animate", "out", "--point", "?"}, "0"},
      {{"export", "out", "--to", "?"}, "csv"},
      {{"export", "?", "--to", "csv"}, "out"},
      {{"report", "?"}, "out"},
      {{"merge", "?", "-o", "merged"}, "out"},
      {{"status", "?"}, "out"},
      {{"plugins", "?"}, "restitution/newton"},
      {{"law", "?", "-o", "law.svg"}, "friction/coulomb"},
      {{"law", "restitution/newton", "-o", "law.svg", "--set", "?"}, "en=0.5"},
      {{"solve", "p.hdf5", "--tolerance", "?"}, "1e-8"},
      {{"solve", "p.hdf5", "--max-iterations", "?"}, "100"},
      {{"solve", "p.hdf5", "--solver", "?"}, "nlgs"},
      {{"?", "s.yaml"}, "check"},
      {{"check", "s.yaml", "?"}, "--strict"},
  };
  return list;
}

class Words : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    write_here("s.yaml", scenario_);
    const Template& chosen = dice.pick(templates());
    const std::string value = mutant_of(chosen.sound, dice);
    cli::Arguments words = chosen.words;
    for (std::string& word : words)
      if (word == "?") word = value;
    if (may_take_long(words.front())) return;
    call(words, ErrorForm::named);
  }

 private:
  std::string mutant_of(const std::string& sound, Dice& dice) const {
    const std::size_t equals = sound.find('=');
    switch (dice.below(5)) {
      case 0:
        return dice.pick(dictionary_.numbers);
      case 1:
        return dice.pick(dictionary_.texts);
      case 2:
        if (equals == std::string::npos) break;
        return sound.substr(0, equals + 1) + dice.pick(dictionary_.numbers);
      case 3:
        if (equals == std::string::npos) break;
        return dice.pick(dictionary_.keys) + sound.substr(equals);
      default:
        break;
    }
    std::string value = sound;
    dice.one_in(2) ? mutate_text(value, dictionary_, dice) : mutate_bytes(value, dice);
    // An argument ends at its first zero byte.
    return value.substr(0, value.find('\0'));
  }

  /// The verification suite runs a minute.
  static bool may_take_long(const std::string& command) { return command == "verify"; }

  Dictionary dictionary_ = make_dictionary(LuaSession(share_folder()).registry());
  std::string scenario_ = read_source(fences_file);
};

}  // namespace

std::unique_ptr<Kind> make_arguments_kind() { return std::make_unique<Words>(); }

}  // namespace flyrock::fuzz
