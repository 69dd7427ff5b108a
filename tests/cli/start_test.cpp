// Bodies that start where those of another run ended.

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "same_result.h"

namespace flyrock::start_test {

using namespace flyrock::test;

/// The numbers of a line of a table, in the order of its columns; of texts 0.
std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');)
    numbers.push_back(std::strtod(cell.c_str(), nullptr));
  return numbers;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::istringstream text(read(file));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

const std::string brick = R"(flyrock: 1
dimension: 3
method: nscd
gravity: 0
terrain: { type: plane, material: rock }
materials: { rock: { restitution: { type: newton, en: 0 } } }
bodies:
  - { name: brick, shape: { type: box, size: [0.3, 0.2, 0.1] }, density: 2700, material: rock, position: [0, 0, 5],
      velocity: [1, 0.5, 0.25], spin: [0.1, 2, 0.3] }
)";

TEST_CASE("a brick that tumbles for 1 s, and from there for 1 s, ends as one that tumbles for 2 s") {
  const Folder folder;
  folder.write("whole.yaml", brick + "stop: { time: 2 s }\n");
  folder.write("first.yaml", brick + "stop: { time: 1 s }\n");
  folder.write("second.yaml", brick + "stop: { time: 1 s }\nstart: { from: out/first }\n");
  for (const char* name : {"whole", "first", "second"}) {
    const Output run = call(folder, std::string("run --quiet ") + name + ".yaml");
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  const std::vector<std::string> whole = lines_of(folder.path() / "out/whole/last_states.csv");
  const std::vector<std::string> second = lines_of(folder.path() / "out/second/last_states.csv");
  REQUIRE(whole.size() == 2);
  REQUIRE(second.size() == 2);
  CHECK(whole[0] ==
        "point,trial,body,mass_kg,shape,time_s,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,spin_x_rad_s,spin_y_rad_s,"
        "spin_z_rad_s,angle_rad,kinetic_energy_J,qw,qx,qy,qz");
  const std::vector<double> a = numbers_of(whole[1]), b = numbers_of(second[1]);
  REQUIRE(a.size() == 21);
  REQUIRE(b.size() == 21);
  for (std::size_t k = 6; k < a.size(); ++k) {
    INFO(k);
    CHECK(std::abs(a[k] - b[k]) < 1e-12 * (1 + std::abs(a[k])));
  }
  CHECK(std::abs(a[6] - 2) < 1e-12);
}

const std::string pile = R"(flyrock: 1
dimension: 2
method: nscd
trials: 6
terrain: { type: profile, points: [[-2, 0.5], [-1, 0], [1, 0], [2, 0.5]], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.5 } } }
shapes: { stone: { type: polygon, vertices: [[-0.1, -0.08], [0.12, -0.06], [0.05, 0.1], [-0.08, 0.09]] } }
stop: { time: 3 s }
bodies:
  - { name: a, shape: stone, density: 2700, material: rock, position: [0, 0.2], orientation: { uniform: [0, 6 rad] } }
  - { name: b, shape: stone, density: 2700, material: rock, position: [0.1, 0.5] }
  - { name: c, shape: stone, density: 2700, material: rock, position: [0, 0.8], orientation: { uniform: [0, 6 rad] } }
)";

TEST_CASE("bodies go on from a pile at rest: those that nothing meets stay there") {
  const Folder folder;
  folder.write("pile.yaml", pile);
  folder.write("rest.yaml", pile + "start: { from: out/pile, trial: 5 }\n");
  REQUIRE(call(folder, "run --quiet pile.yaml").code == 0);
  const Output run = call(folder, "run --quiet rest.yaml --trials 1");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const std::vector<std::string> before = lines_of(folder.path() / "out/pile/last_states.csv");
  const std::vector<std::string> after = lines_of(folder.path() / "out/rest/last_states.csv");
  REQUIRE(before.size() == 19);
  REQUIRE(after.size() == 4);
  for (std::size_t body = 1; body < 4; ++body) {
    const std::vector<double> a = numbers_of(before[15 + body]), b = numbers_of(after[body]);
    INFO(before[15 + body] << "\n" << after[body]);
    for (const std::size_t k : {6, 7, 11}) CHECK(std::abs(a[k] - b[k]) < 1e-6);
  }
}

TEST_CASE(
    "a ball into a pile of another run gives the same bytes over 1, 2 and 8 threads, and after a kill") {
  const Folder folder;
  folder.write("pile.yaml", pile);
  folder.write("ball.yaml",
               pile +
                   "  - { name: ball, shape: { type: disk, radius: 0.1 }, density: 2700, material: rock, "
                   "position: [0, 2], velocity: [{ uniform: [-1, 1] }, -5] }\n"
                   "start: { from: out/pile, trial: 1, bodies: [a, b, c] }\n");
  REQUIRE(call(folder, "run --quiet pile.yaml").code == 0);
  for (const char* threads : {"1", "2", "8"}) {
    const Output run = call(folder, std::string("run ball.yaml --quiet -o j") + threads + " -j" + threads);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  check_same(folder, "j1", "j2");
  check_same(folder, "j1", "j8");
  // As a run leaves it that was killed while it wrote its results.
  fs::copy(folder.path() / "j1", folder.path() / "killed", fs::copy_options::recursive);
  fs::remove(folder.path() / "killed/last_states.csv");
  REQUIRE(call(folder, "run ball.yaml --quiet -o killed --resume").code == 0);
  check_same(folder, "j1", "killed");
}

TEST_CASE("a start in a run that is damaged or of another scenario is refused in one line") {
  const Folder folder;
  folder.write("pile.yaml", pile);
  folder.write("on.yaml", pile + "start: { from: r }\n");
  REQUIRE(call(folder, "run --quiet pile.yaml -o r").code == 0);
  CHECK(call(folder, "check on.yaml").code == 0);
  const std::string states = read(folder.path() / "r/last_states.csv");
  std::string other = states;
  other[other.find(",b,") + 1] = 'd';
  folder.write("r/last_states.csv", other);
  const Output damaged = call(folder, "run on.yaml --quiet -o s");
  CHECK(damaged.code == 2);
  CHECK(damaged.err.find("on.yaml:") == 0);
  CHECK(damaged.err.find("b") != std::string::npos);
  CHECK_FALSE(folder.has("s"));
  folder.write("r/last_states.csv", states);
  // Another run in the same folder makes another scenario of what starts in it.
  REQUIRE(call(folder, "run on.yaml --quiet -o s").code == 0);
  REQUIRE(call(folder, "run pile.yaml --quiet -o r --force --seed 5").code == 0);
  const Output resumed = call(folder, "run on.yaml --quiet -o s --resume");
  CHECK(resumed.code == 2);
  CHECK(resumed.err.find("another scenario") != std::string::npos);
}

}  // namespace flyrock::start_test
