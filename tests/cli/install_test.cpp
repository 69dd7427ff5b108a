// What is installed works by itself: without the build tree, and with plugins that are built against it
// alone.
#include <catch2/catch.hpp>

#include "program.h"

namespace flyrock::install_test {

using namespace flyrock::test;

const std::string installed_slope = R"(flyrock: 1
dimension: 2
method: nscd
trials: 3
plugins: [LAW]
terrain: { type: profile, points: [[-5, 20], [0, 20], [20, 0], [100, 0]], material: rock }
materials:
  rock:
    restitution: { type: TYPE, en: 0.4 }
    friction: { type: coulomb, mu: 0.6 }
rocks:
  - name: r
    density: 2700 kg/m3
    shape: { type: polygon, sides: 6, diameter: 0.5 m }
    release: { position: [1, 25] }
stop: { time: 60 s }
)";

std::string installed_slope_with(const std::string& type, const std::string& law) {
  std::string text = installed_slope;
  text.replace(text.find("TYPE"), 4, type);
  text.replace(text.find("[LAW]"), 5, law);
  return text;
}

void write_installed_plugin(const Folder& folder) {
  fs::create_directories(folder.path() / "own");
  folder.write("own/plugin.lua", R"(local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "own", doc = "Newton's law again.", source = "a test", form = "newton",
  params = { en = fr.number { min = 0, max = 1, doc = "restitution" } },
  native = "own",
}
)");
  folder.write("own/own.cpp", R"(#include "plugin/module.h"

namespace {

class Own : public flyrock::RestitutionLaw {
 public:
  explicit Own(flyrock::Params& params) : en_(params.slot("en")) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "own"; }
  flyrock::Restitution impact(flyrock::Values values, const flyrock::ContactState&) const override {
    return {values[en_], 0, flyrock::RestitutionForm::newton, false};
  }

 private:
  int en_;
};

}  // namespace

FLYROCK_MODULE(table) {
  table[{flyrock::PluginKind::restitution, "own"}] = flyrock::FactoryOf<flyrock::RestitutionLaw>(
      [](flyrock::Params& params) { return std::make_unique<Own>(params); });
  return nullptr;
}
)");
  folder.write("own/CMakeLists.txt", R"(cmake_minimum_required(VERSION 3.25)
project(own LANGUAGES CXX)
find_package(flyrock 0.1.0 REQUIRED)
flyrock_add_plugin(own own.cpp)
)");
}

TEST_CASE("the installed program runs by itself, and a plugin is built against what is installed", "[slow]") {
  const Folder folder;
  const std::string build = fs::path(FLYROCK_BINARY).parent_path().parent_path().string();
  const Output install = shell(folder, "cmake --install '" + build + "' --prefix there/usr");
  INFO(install.err);
  REQUIRE(install.code == 0);
  CHECK_FALSE(folder.has("there/usr/include/flyrock/solver"));
  // Moved as a whole, it still finds its parts.
  fs::rename(folder.path() / "there", folder.path() / "moved");
  const std::string flyrock = "'" + (folder.path() / "moved/usr/bin/flyrock").string() + "' ";
  folder.write("newton.yaml", installed_slope_with("newton", "[]"));
  const Output run = shell(folder, flyrock + "run newton.yaml -o newton");
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(shell(folder, flyrock + "course --list").code == 0);

  write_installed_plugin(folder);
  const Output made = shell(
      folder, "cmake -S own -B own/build -DCMAKE_PREFIX_PATH=\"$PWD/moved/usr\" && cmake --build own/build");
  INFO(made.out << made.err);
  REQUIRE(made.code == 0);
  REQUIRE(folder.has("own/own.so"));
  folder.write("own.yaml", installed_slope_with("own", "[own]"));
  const Output own = shell(folder, flyrock + "run own.yaml -o own_run");
  INFO(own.err);
  REQUIRE(own.code == 0);
  CHECK(read(folder.path() / "own_run/rocks.csv") == read(folder.path() / "newton/rocks.csv"));

  // The program in the build tree has the same tag; another version has not.
  const Output other =
      shell(folder,
            "sed -i 's/0[.]1[.]0/0.0.9/' moved/usr/lib/cmake/flyrock/flyrock-config.cmake && cmake --build "
            "own/build --clean-first && " +
                flyrock + "check own.yaml");
  CHECK(other.code == 2);
  CHECK(other.err.find("version") != std::string::npos);
}

}  // namespace flyrock::install_test
