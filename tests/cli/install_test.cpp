// What is installed works by itself: without the build tree, and with the templates of plugins that are built
// against it alone.
#include <catch2/catch.hpp>
#include <regex>

#include "program.h"

namespace flyrock::install_test {

using namespace flyrock::test;

/// A scenario in 2D that uses a plugin of each kind by the names of the templates.
const std::string all_kinds = R"(flyrock: 1
dimension: 2
method: nscd
trials: 3
plugins: [restitutionX, frictionX, rollingX, unilateralX, velocityX, populationX, shapeX, terrainX]
terrain: { type: my_terrain, drop: 15 m, material: rock }
materials:
  rock:
    restitution: { type: my_restitution, en: 0.4 }
    friction: { type: my_friction, mu: { uniform: [0.5, 0.7] } }
    rolling: { type: my_rolling, share: 0.04 }
    unilateral: { type: my_condition, pull: 1 N }
blast: { burden: 2.7 m, hole: { diameter: 102 mm }, explosive: { density: 850 kg/m3 } }
rocks:
  - name: r
    type: my_population
    most: 4
    density: 2700 kg/m3
    shape: { type: my_shape, size: { uniform: [0.3 m, 0.6 m] } }
    release: { along: [[1, 18], [1, 30]] }
    launch: { type: my_launch, k: 3 m/s }
stop: { time: 60 s }
)";

std::string all_kinds_with(const std::string& ending) {
  std::string text = all_kinds;
  for (std::size_t at; (at = text.find('X')) != std::string::npos;) text.replace(at, 1, ending);
  return text;
}

const std::vector<std::string> kinds = {"restitution", "friction",   "rolling", "unilateral",
                                        "velocity",    "population", "shape",   "terrain"};

/// Links of pages to files that are not there.
std::vector<std::string> dead_links(const fs::path& pages) {
  const std::regex link(R"(\]\(([^)\s#:]+)(#[^)]*)?\))");
  std::vector<std::string> dead;
  for (const auto& entry : fs::recursive_directory_iterator(pages)) {
    if (entry.path().extension() != ".md") continue;
    const std::string text = read(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found)
      if (!fs::exists(entry.path().parent_path() / found->str(1)))
        dead.push_back(entry.path().filename().string() + ": " + found->str(1));
  }
  return dead;
}

TEST_CASE("the installed program runs by itself, and templates of every kind are built against it",
          "[slow]") {
  const Folder folder;
  const std::string build = fs::path(FLYROCK_BINARY).parent_path().parent_path().string();
  const Output install = shell(folder, "cmake --install '" + build + "' --prefix there/usr");
  INFO(install.err);
  REQUIRE(install.code == 0);
  CHECK_FALSE(folder.has("there/usr/include/flyrock/solver"));
  for (const char* file :
       {"man/man1/flyrock.1", "man/man1/flyrock-run.1", "bash-completion/completions/flyrock",
        "zsh/site-functions/_flyrock", "flyrock/scenario.schema.json", "flyrock/annotations/flyrock.lua",
        "flyrock/library/highwall.yaml"}) {
    INFO(file);
    CHECK(folder.has(std::string("there/usr/share/") + file));
  }
  for (const char* part : {"plotly.js", "libeigen3-dev", "libtinyobjloader-dev"})
    CHECK(folder.has(std::string("there/usr/share/doc/flyrock/licences/") + part));
  CHECK(dead_links(folder.path() / "there/usr/share/doc/flyrock").empty());
  // Moved as a whole, it still finds its parts.
  fs::rename(folder.path() / "there", folder.path() / "moved");
  const std::string flyrock = "'" + (folder.path() / "moved/usr/bin/flyrock").string() + "' ";
  CHECK(shell(folder, flyrock + "course --list").code == 0);

  // What `new` writes, in Lua and in C++, gives the same bytes.
  std::string project = "cmake_minimum_required(VERSION 3.25)\nproject(all LANGUAGES CXX)\n";
  for (const std::string& kind : kinds) {
    REQUIRE(shell(folder, flyrock + "new " + kind).code == 0);
    REQUIRE(shell(folder, flyrock + "new " + kind + "-native").code == 0);
    project += "add_subdirectory(" + kind + "-native)\n";
  }
  folder.write("CMakeLists.txt", project);
  const Output made =
      shell(folder, "cmake -S . -B build -DCMAKE_PREFIX_PATH=\"$PWD/moved/usr\" && cmake --build build -j 2");
  INFO(made.out << made.err);
  REQUIRE(made.code == 0);
  folder.write("lua.yaml", all_kinds_with(".lua"));
  folder.write("native.yaml", all_kinds_with("-native"));
  for (const char* name : {"lua", "native"}) {
    const Output run = shell(folder, flyrock + "run " + name + ".yaml -o " + name);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  CHECK(read(folder.path() / "native/rocks.csv") == read(folder.path() / "lua/rocks.csv"));
  for (const std::string& kind : kinds) {
    const Output check = shell(folder, flyrock + "check " + kind + "-native");
    INFO(kind << check.out << check.err);
    CHECK(check.code == 0);
    CHECK(check.out.find("a sound plugin") != std::string::npos);
  }

  // A module of another version is refused in one line.
  const Output other =
      shell(folder,
            "sed -i 's/0[.]1[.]0/0.0.9/' moved/usr/lib/cmake/flyrock/flyrock-config.cmake && cmake --build "
            "build --clean-first --target my_restitution && " +
                flyrock + "check native.yaml");
  CHECK(other.code == 2);
  CHECK(other.err.find("version") != std::string::npos);
}

/// `archive.sh` with the build of this program, unpacked into `folder`/`name`.
void unpack_archive(const Folder& folder, const std::string& name, const std::string& with) {
  const std::string build = fs::path(FLYROCK_BINARY).parent_path().parent_path().string();
  const Output packed =
      shell(folder, "'" FLYROCK_SOURCE_DIR "/engine/archive.sh' '" + build + "' packed " + with);
  INFO(packed.out << packed.err);
  REQUIRE(packed.code == 0);
  CHECK(packed.err.empty());  // each library has its licence
  REQUIRE(shell(folder, "mkdir '" + name + "' && tar xzf packed/flyrock-*.tar.gz -C '" + name +
                            "' --strip-components=1")
              .code == 0);
  fs::remove_all(folder.path() / "packed");
}

TEST_CASE("the archive runs with its own libraries only, and gives the same bytes", "[heavy]") {
  const Folder folder;
  unpack_archive(folder, "a place", "");
  REQUIRE(shell(folder, "ln -s 'a place/bin/flyrock' link && ln -s ../link 'a place/second'").code == 0);
  // No library of the system, by the list that the loader itself gives.
  const Output list =
      shell(folder,
            "cd 'a place' && libexec/flyrock --inhibit-cache --library-path \"$PWD/lib/system\" "
            "--list lib/flyrock/program");
  REQUIRE(list.code == 0);
  std::istringstream lines(list.out);
  int libraries = 0;
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    if (line.find("linux-vdso") != std::string::npos) continue;
    CHECK((line.find("/a place/") != std::string::npos || line.find("libexec/flyrock") != std::string::npos));
    ++libraries;
  }
  CHECK(libraries > 5);
  // By a link to a link, with a law in Lua and a shard, and for a cluster.
  const std::string scenario =
      std::string(FLYROCK_SOURCE_DIR) + "/scenarios/quarry/fence_design.yaml --trials 20 --quiet";
  REQUIRE(call(folder, "run " + scenario + " -o here").code == 0);
  const Output run = shell(folder, "'a place/second' run " + scenario + " -o there");
  INFO(run.out << run.err);
  REQUIRE(run.code == 0);
  CHECK(read(folder.path() / "there/rocks.csv") == read(folder.path() / "here/rocks.csv"));
  CHECK(shell(folder, "./link course own_law").code == 0);
  CHECK(shell(folder, "./link submit " + std::string(FLYROCK_SOURCE_DIR) +
                          "/scenarios/quarry/fence_design.yaml --slurm -n 2 -o jobs")
            .code == 0);
  CHECK(read(folder.path() / "jobs/array.sbatch").find("/a place/bin/flyrock' run ") != std::string::npos);
}

/// A drawing with one line on the layer бровка, in the character set of old Russian Windows.
std::string cyrillic_drawing() {
  return "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1251\n0\nENDSEC\n"
         "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n\xE1\xF0\xEE\xE2\xEA\xE0\n90\n2\n70\n0\n"
         "10\n2600004\n20\n1200010\n10\n2600004\n20\n1200050\n0\nENDSEC\n0\nEOF\n";
}

TEST_CASE("the archive with GDAL needs no GDAL, PROJ or character sets of the system", "[heavy]") {
  if (skips_without_gdal()) return;
  const Folder folder;
  // A root of nothing but a shell with its C library, the archive and a site.
  if (shell(folder, "mkdir -p root/proc && unshare --map-root-user --mount mount --rbind /proc root/proc")
          .code != 0) {
    std::cout << "SKIPPED: mounts of its own are not allowed here\n";
    return;
  }
  unpack_archive(folder, "root/flyrock", "gdal");
  REQUIRE(
      shell(
          folder,
          "mkdir root/bin && cp /bin/sh root/bin && for file in $(ldd /bin/sh | grep -o '/[^ ]*'); do mkdir "
          "-p root/${file%/*} && cp -L $file root/$file; done")
          .code == 0);
  const std::string listed = read(folder.path() / "root/flyrock/share/doc/flyrock/licences/packages.txt");
  for (const char* package : {"libgdal32 ", "libproj25 ", "proj-data ", "libpoppler"})
    CHECK(listed.find(package) != std::string::npos);

  folder.write("slope.obj",
               "v 2600000 1200000 40\nv 2600080 1200000 0\nv 2600080 1200060 0\nv 2600000 1200060 40\n"
               "f 1 2 3\nf 1 3 4\n");
  folder.write("crest.dxf", cyrillic_drawing());
  folder.write("road.geojson",  // in degrees
               R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
               R"({"type":"LineString","coordinates":[[7.43930,46.95110],[7.43932,46.95158]]}}]})");
  folder.write("site.yaml", R"(flyrock: 1
dimension: 3
method: lumped_mass
trials: 20
terrain: { type: mesh, file: slope.obj, crs: EPSG:2056, material: rock }
materials: { rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.4 } } }
rocks:
  - name: loose
    density: 2700 kg/m3
    shape: { type: sphere, radius: 0.3 m }
    release: { along: { layer: crest.dxf, name: бровка }, above_ground: 1 m }
    launch: { type: fixed, velocity: [8 m/s, 0 m/s, 0 m/s] }
gates: [{ name: road, line: { layer: road.geojson } }]
stop: { time: 60 s }
)");
  folder.write("commands", "set -e\nflyrock run site.yaml -o out --quiet\nflyrock export out --to gpkg\n");
  const std::string bin = fs::path(FLYROCK_BINARY).parent_path();
  REQUIRE(shell(folder, "cp slope.obj crest.dxf road.geojson site.yaml commands root && PATH='" + bin +
                            "':$PATH sh commands")
              .code == 0);
  const Output run = shell(
      folder,
      "unshare --map-root-user --mount sh -c 'mount --rbind /proc root/proc && exec env -i PATH=/flyrock/bin "
      "\"$(command -v chroot)\" root /bin/sh commands'");
  INFO(run.out << run.err);
  REQUIRE(run.code == 0);
  for (const char* file : {"out/rocks.csv", "out/gpkg/results-p0.gpkg"})
    CHECK(read(folder.path() / "root" / file) == read(folder.path() / file));
}

}  // namespace flyrock::install_test
