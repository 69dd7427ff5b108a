// `include`: materials and explosives of other files and of flyrock's library.

#include <catch2/catch.hpp>
#include <regex>

#include "blast/blast.h"
#include "cli/program.h"

namespace flyrock::include_test {

using namespace flyrock::test;

const std::string including = R"(flyrock: 1
dimension: 2
method: lumped_mass
trials: 20
include: [site.yaml, highwall.yaml]
terrain: { type: benches, count: 1, height: 10 m, face_angle: 65 deg, berm: 8 m, floor: 80 m, materials: { face: sandstone, berm: ours, floor: theirs } }
materials: { ours: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.5 } } }
rocks: [{ name: r, density: 2700, shape: { type: disk, radius: 0.3 }, release: { from: face } }]
stop: { time: 60 s }
)";

const std::string site = R"(materials:
  ours: { restitution: { type: newton, en: 0.9 }, friction: { type: coulomb, mu: 0.1 } }
  theirs: { source: measured, restitution: { type: newton, en: 0.2 }, friction: { type: coulomb, mu: 0.6 } }
  unused: { restitution: { type: newton, en: 0.1 }, friction: { type: coulomb, mu: 0.6 } }
explosives:
  emulsion: { source: data sheet, density: 1150 kg/m3, detonation_velocity: 5200 m/s }
)";

TEST_CASE("a scenario takes what it names from included files, and its own materials win") {
  const Folder folder;
  folder.write("s.yaml", including);
  folder.write("site.yaml", site);
  const Output shown = call(folder, "show s.yaml --json");
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  const auto has = [&](const char* text) { return shown.out.find(text) != std::string::npos; };
  CHECK(has("\"en\": 0.3"));
  CHECK_FALSE(has("\"en\": 0.9"));
  CHECK(has("\"theirs\""));
  CHECK(has("\"rocfall\""));
  CHECK_FALSE(has("\"unused\""));
  CHECK_FALSE(has("\"talus\""));
  CHECK_FALSE(has("include"));
  // The same numbers written out give the same rocks; the file is in the manifest, and another one is another
  // scenario.
  REQUIRE(call(folder, "run s.yaml --quiet -o a").code == 0);
  folder.write("out.yaml", call(folder, "show s.yaml").out);
  REQUIRE(call(folder, "run out.yaml --quiet -o b").code == 0);
  CHECK(read(folder.path() / "a/rocks.csv") == read(folder.path() / "b/rocks.csv"));
  CHECK(read(folder.path() / "a/manifest.json").find("\"site.yaml\"") != std::string::npos);
  REQUIRE(call(folder, "run s.yaml --quiet --trials 20 --shard 1/2 -o part").code == 0);
  folder.write("site.yaml", site + "# changed\n");
  CHECK(call(folder, "run s.yaml --quiet --shard 1/2 --resume -o part").code == 2);
  CHECK(call(folder, "check s.yaml --set materials.theirs.restitution.en=2").code == 2);
}

TEST_CASE("an explosive of an included file takes the place of its name") {
  const Folder folder;
  folder.write("site.yaml", site);
  folder.write("b.yaml", R"(flyrock: 1
dimension: 2
method: ballistic
include: [site.yaml]
terrain: { type: profile, points: [[-50, 10], [0, 10], [3, 0], [500, 0]] }
blast: { explosive: emulsion, hole: { diameter: 102 mm }, burden: 2.7 m, rock_density: 2700 kg/m3, breakout_angle: 90 deg }
rocks: [{ name: r, density: 2700, shape: { type: disk, radius: 0.1 }, release: { position: [1, 9] }, launch: { type: gurney } }]
stop: { time: 60 s }
)");
  const Output shown = call(folder, "show b.yaml --json");
  INFO(shown.err);
  REQUIRE(shown.code == 0);
  CHECK(shown.out.find("\"density\": 1150") != std::string::npos);
  // A name on the command line is looked up in the files too, and then has keys of its own.
  folder.write("site.yaml", site + "  slurry: { density: 1210 kg/m3, detonation_velocity: 5100 m/s }\n");
  CHECK(call(folder, "show b.yaml --json --set blast.explosive=slurry").out.find("\"density\": 1210") !=
        std::string::npos);
  CHECK(call(folder, "show b.yaml --json --set blast.explosive.density=1230").out.find("\"density\": 1230") !=
        std::string::npos);
}

TEST_CASE("each explosive of the library can be used, and says its source") {
  const Folder folder;
  const std::string library = read(FLYROCK_SOURCE_DIR "/lua/library/blasting.yaml");
  static const std::regex entry("\n  (\\w+):\n    source: \"[^\"]+\"\n");
  int explosives = 0;
  for (auto found = std::sregex_iterator(library.begin(), library.end(), entry);
       found != std::sregex_iterator(); ++found) {
    const std::string name = (*found)[1];
    // Nobody states the velocity of this one; the fit to blasts reads its density only.
    const Output check = call(
        folder, "check " FLYROCK_SOURCE_DIR
                "/scenarios/quarry/explosives.yaml --set "
                "blast.explosive=" +
                    name +
                    (name == "centra_gold"
                         ? " --set rocks.0.launch='{ type: bench_fit, rock: granite, elevation: 20 deg }'"
                         : ""));
    INFO(name << check.err);
    CHECK(check.code == 0);
    ++explosives;
  }
  CHECK(explosives == 5);
}

TEST_CASE("what cannot be included is said at its place") {
  const Folder folder;
  folder.write("site.yaml", "materials: { ours: 3 }\n");
  folder.write("wrong.yaml", "rocks: []\n");
  const auto error_of = [&](const std::string& list) {
    std::string text = including;
    const std::string key = "[site.yaml, highwall.yaml]";
    text.replace(text.find(key), key.size(), list);
    folder.write("s.yaml", text);
    const Output output = call(folder, "check s.yaml");
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(error_of("[higwall.yaml]")
            .find("s.yaml:5:11: error: include.0: there is no file `higwall.yaml` beside the "
                  "scenario or in flyrock's library, did you mean `highwall.yaml`?") == 0);
  CHECK(error_of("[3]").find("expected the name of a file, found `3`") != std::string::npos);
  CHECK(error_of("highwall.yaml").find("include: ") != std::string::npos);
  CHECK(error_of("[site.yaml]").find("site.yaml:1:20: error: materials.ours: ") != std::string::npos);
  CHECK(error_of("[wrong.yaml]").find("wrong.yaml:1:1: error: rocks: ") != std::string::npos);
}

}  // namespace flyrock::include_test
