// flyrock export --to gltf: what a viewer of 3D models reads.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>

#include "program.h"
#include "rows.h"

namespace flyrock::gltf_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T number;
  REQUIRE(at + sizeof(T) <= bytes.size());
  std::memcpy(&number, bytes.data() + at, sizeof(T));
  return number;
}

/// A .glb file, read by the words of the specification.
struct Scene {
  Json json;
  std::string bytes;

  explicit Scene(const fs::path& path) {
    const std::string file = read(path);
    REQUIRE(file.substr(0, 4) == "glTF");
    REQUIRE(number_at<std::uint32_t>(file, 4) == 2);
    REQUIRE(number_at<std::uint32_t>(file, 8) == file.size());
    const auto length = number_at<std::uint32_t>(file, 12);
    REQUIRE(file.substr(16, 4) == "JSON");
    json = Json::parse(file.substr(20, length));
    REQUIRE(number_at<std::uint32_t>(file, 20 + length) == file.size() - 28 - length);
    REQUIRE(file.substr(24 + length, 4) == std::string("BIN\0", 4));
    bytes = file.substr(28 + length);
    CHECK(json["buffers"][0]["byteLength"].get<std::size_t>() <= bytes.size());
  }

  /// The numbers of an accessor; their least and greatest are those that it says.
  template <class T>
  std::vector<double> numbers(int accessor) const {
    const Json& one = json["accessors"][static_cast<std::size_t>(accessor)];
    const Json& view = json["bufferViews"][one["bufferView"].get<std::size_t>()];
    const std::size_t components = one["type"] == "SCALAR" ? 1 : one["type"] == "VEC3" ? 3 : 4;
    const std::size_t count = one["count"].get<std::size_t>() * components;
    REQUIRE(view["byteLength"].get<std::size_t>() == count * sizeof(T));
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(
          static_cast<double>(number_at<T>(bytes, view["byteOffset"].get<std::size_t>() + i * sizeof(T))));
    for (std::size_t i = 0; one.contains("min") && i < count; ++i) {
      CHECK(numbers[i] >= one["min"][i % components].get<double>());
      CHECK(numbers[i] <= one["max"][i % components].get<double>());
    }
    return numbers;
  }

  /// The times and numbers of a channel of a node.
  std::pair<std::vector<double>, std::vector<double>> keys(std::size_t node, const std::string& path) const {
    const Json& motion = json["animations"][0];
    for (const Json& channel : motion["channels"])
      if (channel["target"]["node"] == node && channel["target"]["path"] == path) {
        const Json& sampler = motion["samplers"][channel["sampler"].get<std::size_t>()];
        return {numbers<float>(sampler["input"].get<int>()), numbers<float>(sampler["output"].get<int>())};
      }
    return {};
  }

  /// Of a mesh of triangles that are seen from outside.
  double volume(std::size_t mesh) const {
    const Json& part = json["meshes"][mesh]["primitives"][0];
    CHECK(part["mode"] == 4);
    const auto places = numbers<float>(part["attributes"]["POSITION"].get<int>());
    const auto corners = numbers<std::uint32_t>(part["indices"].get<int>());
    const auto place = [&](std::size_t i) {
      return Eigen::Vector3d(places.data() + 3 * static_cast<std::size_t>(corners[i]));
    };
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
      sum += place(i).dot(place(i + 1).cross(place(i + 2))) / 6;
    return sum;
  }
};

std::vector<double> row_of(std::string text) {
  std::replace(text.begin(), text.end(), '|', ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

}  // namespace

TEST_CASE("a viewer gets the ground and the rocks, which move from stored point to stored point") {
  const Folder folder;
  folder.write("slope.obj",
               "v 2600000 1200000 40\nv 2600080 1200000 0\nv 2600080 1200060 0\nv 2600000 1200060 40\nf 1 2 "
               "3\nf 1 3 4\n");
  folder.write("s.yaml", R"(flyrock: 1
dimension: 3
method: nscd
trials: 2
terrain: { type: mesh, file: slope.obj, crs: EPSG:2056, material: rock }
materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.5 } } }
rocks:
  - name: box
    density: 2700
    shape: { type: box, size: [0.6, 0.5, 0.4] }
    release: { x: 2600004, y: 1200030, above_ground: 3 m }
    launch: { type: fixed, velocity: [3 m/s, 0 m/s, 0 m/s], spin: [4, 5, 6] }
stop: { time: 3 s }
)");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output exported = call(folder, "export r --to gltf");
  INFO(exported.err);
  REQUIRE(exported.code == 0);
  CHECK(exported.out == "r/gltf/motion-p0.glb\n");
  const Scene scene(folder.path() / "r/gltf/motion-p0.glb");
  CHECK(scene.json["extras"] == Json({{"origin_m", {2600000.0, 1200000.0, 0.0}}, {"crs", "EPSG:2056"}}));
  const Json& nodes = scene.json["nodes"];
  REQUIRE(nodes.size() == 4);
  CHECK(nodes[0]["children"] == Json({1, 2, 3}));
  const Eigen::Quaterniond to_y_up(
      nodes[0]["rotation"][3].get<double>(), nodes[0]["rotation"][0].get<double>(),
      nodes[0]["rotation"][1].get<double>(), nodes[0]["rotation"][2].get<double>());
  CHECK((to_y_up * Eigen::Vector3d(1, 2, 3) - Eigen::Vector3d(1, 3, -2)).norm() < 1e-12);
  CHECK(nodes[1]["name"] == "ground");
  for (const std::size_t node : {2, 3}) {
    const auto trial = nodes[node]["extras"]["trial"].get<int>();
    CHECK(trial == static_cast<int>(node) - 2);
    CHECK(scene.volume(nodes[node]["mesh"].get<std::size_t>()) == Approx(0.6 * 0.5 * 0.4).epsilon(1e-5));
    const auto [times, places] = scene.keys(node, "translation");
    const auto [turn_times, turns] = scene.keys(node, "rotation");
    REQUIRE(times.size() > 10);
    CHECK(turn_times == times);
    REQUIRE(places.size() == 3 * times.size());
    std::size_t key = 0;
    for (const std::string& text :
         query(folder.path() / "r/results.db",
               "SELECT time_s, x_m, y_m, z_m, qw, qx, qy, qz FROM trajectories WHERE trial = " +
                   std::to_string(trial) + " ORDER BY time_s")) {
      const std::vector<double> row = row_of(text);
      if (key > 0 && static_cast<float>(row[0]) <= static_cast<float>(times[key - 1])) --key;
      REQUIRE(key < times.size());
      CHECK(times[key] == Approx(row[0]).margin(1e-6));
      const Eigen::Vector3d place(places.data() + 3 * key);
      CHECK((place + Eigen::Vector3d(2600000, 1200000, 0) - Eigen::Vector3d(row[1], row[2], row[3])).norm() <
            1e-5);
      const Eigen::Quaterniond turn(row[4], row[5], row[6], row[7]);
      CHECK(std::abs(turn.coeffs().dot(Eigen::Vector4d(turns.data() + 4 * key))) == Approx(1).epsilon(1e-6));
      ++key;
    }
    CHECK(key == times.size());
    for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] > times[i - 1]);
  }
}

TEST_CASE("in 2D a viewer sees each turn of a disk that spins, and the ground as lines") {
  const Folder folder;
  folder.write("s.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-50, 0], [50, 0]], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.5 } } }
bodies:
  - { name: plate, density: 2700, shape: { type: polygon, vertices: [[-0.5, -0.1], [0.5, -0.1], [0.5, 0.1], [-0.5, 0.1]] }, position: [0, 20], velocity: [1, 0], spin: 60 }
stop: { time: 1.5 s }
)");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to gltf -o g").code == 0);
  const Scene scene(folder.path() / "g/motion-p0.glb");
  CHECK_FALSE(scene.json["nodes"][0].contains("rotation"));
  CHECK(scene.json["meshes"][0]["primitives"][0]["mode"] == 1);
  const auto [times, turns] = scene.keys(2, "rotation");
  REQUIRE(times.size() > 40);
  double angle = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const Eigen::Quaterniond before(Eigen::Vector4d(turns.data() + 4 * (i - 1)));
    const Eigen::AngleAxisd step(before.conjugate() *
                                 Eigen::Quaterniond(Eigen::Vector4d(turns.data() + 4 * i)));
    CHECK(step.angle() < 1.6);
    angle += step.angle() * step.axis().z();
  }
  CHECK(angle == Approx(60 * 1.5).epsilon(1e-4));
}

}  // namespace flyrock::gltf_test
