// flyrock report and flyrock export: what is made of a result later.

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace {

/// Two sweep points, a gate and a barrier.
std::string fenced() {
  return bench_with("mu: 0.6", "mu: { sweep: [0.5, 0.7] }") +
         "gates: [{ name: road, x: 6 }]\nbarriers: [{ name: fence, x: 9, height: 3, capacity: 5 kJ }]\n"
         "expect: [{ measure: rocks.count, equals: 4 }]\n";
}

std::size_t lines_in(const fs::path& file) {
  const std::string text = read(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

/// A box, a tetrahedron and a ball that fly and turn, in 3D.
const std::string thrown = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, normal: [0.2, 0, 1], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.5 } } }
bodies:
  - { name: box, density: 2700, material: rock, shape: { type: box, size: [0.6, 0.5, 0.4] }, position: [0, 0, 3], velocity: [3, 1, 1], spin: [4, 5, 6], orientation: { axis: [1, 2, 3], angle: 40 deg } }
  - { name: tetrahedron, density: 2700, material: rock, shape: { type: polyhedron, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] }, position: [0, 4, 3], velocity: [3, 1, 1], spin: [1, -5, 2] }
  - { name: ball, density: 2700, material: rock, shape: { type: sphere, radius: 0.3 }, position: [0, 8, 3], velocity: [3, 1, 1] }
stop: { time: 2 s }
)";

constexpr double pi = 3.14159265358979323846;

std::vector<double> numbers_in(std::string text) {
  std::replace(text.begin(), text.end(), '|', ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

/// Time and file of each step of a .pvd.
std::vector<std::pair<double, std::string>> series_of(const fs::path& index) {
  const std::string text = read(index);
  const std::regex entry("timestep=\"([^\"]+)\" part=\"0\" file=\"([^\"]+)\"");
  std::vector<std::pair<double, std::string>> series;
  for (std::sregex_iterator at(text.begin(), text.end(), entry); at != std::sregex_iterator(); ++at)
    series.emplace_back(std::stod((*at)[1]), (*at)[2]);
  return series;
}

/// The polygons of a .vtp.
struct Surfaces {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<double> rock;  ///< of each face

  double volume(int of) const {
    double volume = 0;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 2; rock[f] == of && i < faces[f].size(); ++i)
        volume += points[faces[f][0]].dot(points[faces[f][i - 1]].cross(points[faces[f][i]])) / 6;
    return volume;
  }
  double distance_to_vertices(int of, const Eigen::Vector3d& place) const {
    double least = 1e300;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const std::size_t corner : faces[f])
        if (rock[f] == of) least = std::min(least, (points[corner] - place).norm());
    return least;
  }
};

Surfaces read_surfaces(const fs::path& file) {
  const std::string text = read(file);
  const auto array = [&](const std::string& after) {
    const std::size_t begin = text.find('>', text.find(after)) + 1;
    return numbers_in(text.substr(begin, text.find('<', begin) - begin));
  };
  Surfaces surfaces;
  const std::vector<double> places = array("NumberOfComponents=\"3\""), corners = array("\"connectivity\"");
  for (std::size_t i = 0; i + 2 < places.size(); i += 3)
    surfaces.points.emplace_back(places[i], places[i + 1], places[i + 2]);
  std::size_t first = 0;
  for (const double end : array("\"offsets\"")) {
    surfaces.faces.emplace_back();
    for (; first < static_cast<std::size_t>(end); ++first)
      surfaces.faces.back().push_back(static_cast<std::size_t>(corners[first]));
  }
  surfaces.rock = array("Name=\"rock\"");
  return surfaces;
}

}  // namespace

TEST_CASE("The report is built again with the same bytes") {
  const Folder folder;
  folder.write("s.yaml", fenced());
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const std::string page = read(folder.path() / "r/report.html");
  fs::remove(folder.path() / "r/report.html");
  fs::remove(folder.path() / "s.yaml");  // the result is enough
  const Output again = call(folder, "report r");
  INFO(again.err);
  CHECK(again.code == 0);
  CHECK(again.out == "report: r/report.html\n");
  CHECK(read(folder.path() / "r/report.html") == page);
}

TEST_CASE("Every table of a result is exported as CSV") {
  const Folder folder;
  folder.write("s.yaml", fenced());
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output csv = call(folder, "export r --to csv -o tables");
  INFO(csv.err);
  REQUIRE(csv.code == 0);
  const fs::path db = folder.path() / "r/results.db";
  for (const std::string& table :
       query(db,
             "SELECT name FROM sqlite_master WHERE type IN ('table', 'view') AND name "
             "NOT IN ('drawn', 'input_paths', 'report', 'rows_of_rock') AND name NOT LIKE '%\\_rows' ESCAPE "
             "'\\' "
             "ORDER BY name")) {
    INFO(table);
    CHECK(csv.out.find("tables/" + table + ".csv\n") != std::string::npos);
    CHECK(std::to_string(lines_in(folder.path() / "tables" / (table + ".csv")) - 1) ==
          query(db, "SELECT count(*) FROM " + table)[0]);
  }
  CHECK(read(folder.path() / "tables/sweep.csv") ==
        "point,path,value,label\n0,materials.rock.friction.mu,0.5,\n1,materials.rock.friction.mu,0.7,\n");
  CHECK(read(folder.path() / "tables/gates.csv").find("0,0,0,road,") != std::string::npos);
  CHECK(read(folder.path() / "tables/expectations.csv").find("0,rocks.count,0,4,equals,4,,0,1,\n") !=
        std::string::npos);
  // The columns of rocks.csv, with the same text, and more of them.
  const std::string rocks = read(folder.path() / "r/rocks.csv"),
                    more = read(folder.path() / "tables/rocks.csv");
  const std::string first = rocks.substr(
      rocks.find("\n0,0,0,"), rocks.find(",0,", rocks.find("\n0,0,0,") + 60) - rocks.find("\n0,0,0,"));
  CHECK(more.find(first) != std::string::npos);
}

TEST_CASE("Trajectories are exported for ParaView") {
  const Folder folder;
  folder.write("s.yaml", fenced());
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output vtk = call(folder, "export r --to vtk");
  INFO(vtk.err);
  REQUIRE(vtk.code == 0);
  CHECK(vtk.out ==
        "r/vtk/trajectories-p0.vtp\nr/vtk/rocks-p0.pvd\nr/vtk/shapes-p0.pvd\nr/vtk/ground-p0.vtp\n"
        "r/vtk/trajectories-p1.vtp\nr/vtk/rocks-p1.pvd\nr/vtk/shapes-p1.pvd\nr/vtk/ground-p1.vtp\n");
  const std::string ground = read(folder.path() / "r/vtk/ground-p1.vtp");
  CHECK(ground.find("NumberOfPoints=\"6\" NumberOfVerts=\"0\" NumberOfLines=\"3\"") != std::string::npos);
  CHECK(ground.find("-20 10 0\n0 10 0\n0 10 0\n3 0 0\n3 0 0\n300 0 0\n") != std::string::npos);
  const std::string lines = read(folder.path() / "r/vtk/trajectories-p1.vtp");
  const std::string points =
      query(folder.path() / "r/results.db", "SELECT count(*) FROM trajectories WHERE point = 1")[0];
  CHECK(lines.find("NumberOfPoints=\"" + points + "\" NumberOfVerts=\"0\" NumberOfLines=\"4\"") !=
        std::string::npos);
  for (const char* name :
       {"time_s", "speed_m_s", "energy_J", "mode", "trial", "rock", "runout_m", "diameter_m"})
    CHECK(lines.find(std::string("Name=\"") + name + "\"") != std::string::npos);
  // The last offset is the number of points.
  CHECK(lines.find("\n" + points + "\n</DataArray>\n</Lines>") != std::string::npos);

  const std::string index = read(folder.path() / "r/vtk/rocks-p1.pvd");
  const std::regex entry("timestep=\"([^\"]+)\" part=\"0\" file=\"([^\"]+)\"");
  std::size_t steps = 0;
  std::string last;
  for (std::sregex_iterator at(index.begin(), index.end(), entry); at != std::sregex_iterator();
       ++at, ++steps) {
    last = (*at)[2];
    CHECK(fs::exists(folder.path() / "r/vtk" / last));
  }
  CHECK(steps > 100);
  CHECK(steps <= 501);
  CHECK(count_of(index, "<DataSet") == steps);
  // In the end every rock is where its row says.
  const std::string end = read(folder.path() / "r/vtk" / last);
  CHECK(end.find("NumberOfPoints=\"4\" NumberOfVerts=\"4\" NumberOfLines=\"0\"") != std::string::npos);
  const std::size_t at = end.find("<Points>");
  for (const std::string& x : query(folder.path() / "r/results.db",
                                    "SELECT x_m FROM trajectories t WHERE point = 1 AND time_s = "
                                    "(SELECT max(time_s) FROM trajectories u WHERE (u.point, u.trial, "
                                    "u.rock) = (t.point, t.trial, t.rock))"))
    CHECK(end.find(x.substr(0, 8), at) != std::string::npos);
}

TEST_CASE("ParaView gets the surfaces of rocks, where they are and as they are turned at stored samples",
          "[slow]") {
  const Folder folder;
  folder.write("s.yaml", thrown);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  const fs::path db = folder.path() / "r/results.db";
  std::size_t compared = 0;
  for (const auto& [time, file] : series_of(folder.path() / "r/vtk/shapes-p0.pvd")) {
    const Surfaces surfaces = read_surfaces(folder.path() / "r/vtk" / file);
    REQUIRE(surfaces.faces.size() == 6 + 4 + 128);
    // Faces that close a body and are seen from outside give its volume.
    CHECK(surfaces.volume(0) == Approx(0.6 * 0.5 * 0.4).epsilon(2e-3));
    CHECK(surfaces.volume(1) == Approx(1.0 / 6).epsilon(2e-3));
    CHECK(surfaces.volume(2) == Approx(4 * pi / 3 * 0.027).epsilon(0.1));
    for (const int rock : {0, 1, 2}) {
      const std::string of_rock = " WHERE trial = 0 AND rock = " + std::to_string(rock);
      const auto sample = query(db, "SELECT x_m, y_m, z_m, qw, qx, qy, qz FROM trajectories" + of_rock +
                                        " AND abs(time_s - " + std::to_string(time) + ") < 1e-9");
      if (sample.empty()) continue;
      const std::vector<double> at = numbers_in(sample.back());
      const Eigen::Quaterniond turn(at[3], at[4], at[5], at[6]);
      CHECK(turn.norm() == Approx(1).epsilon(1e-12));
      for (const std::string& row : query(db, "SELECT x_m, y_m, z_m, radius_m FROM shapes" + of_rock)) {
        const std::vector<double> corner = numbers_in(row);
        const Eigen::Vector3d place =
            Eigen::Vector3d(at[0], at[1], at[2]) + turn * Eigen::Vector3d(corner[0], corner[1], corner[2]);
        CHECK(surfaces.distance_to_vertices(rock, place) == Approx(corner[3]).margin(2e-4));
        ++compared;
      }
    }
  }
  CHECK(compared > 20 * (24 + 12 + 1));
}

TEST_CASE("ParaView gets the contacts that carry forces, as the series has them") {
  const Folder folder;
  folder.write("s.yaml", R"(
flyrock: 1
title: a box at rest on an incline
dimension: 2
method: nscd
terrain: { type: profile, points: [[-5, 1], [5, -1]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
bodies:
  - { name: box, shape: { type: polygon, vertices: [[-0.5, -0.25], [0.5, -0.25], [0.5, 0.25], [-0.5, 0.25]] }, mass: 3 kg, position: [0.049029034, 0.24514517], orientation: -0.19739555985 rad }
stop: { time: 1 s, speed: 0 }
output: { series: {} }
)");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  const auto series = series_of(folder.path() / "r/vtk/contacts-p0.pvd");
  REQUIRE(series.size() > 10);
  const std::string end = read(folder.path() / "r/vtk" / series.back().second);
  CHECK(end.find("NumberOfPoints=\"2\" NumberOfVerts=\"2\"") != std::string::npos);
  const std::string array = "Name=\"force_N\" NumberOfComponents=\"3\" format=\"ascii\">";
  const std::size_t at = end.find(array);
  REQUIRE(at != std::string::npos);
  std::istringstream numbers(end.substr(at + array.size()));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), force;
  for (int i = 0; i < 2; ++i) {
    numbers >> force.x() >> force.y() >> force.z();
    sum += force;
  }
  CHECK((sum - Eigen::Vector3d(0, 3 * 9.81, 0)).norm() < 1e-6);  // together they carry the weight
}

/// Three disks of 1 kg on each other between walls, of which every 50 ms of a settled column have rows.
constexpr const char* column_of_disks = R"(
flyrock: 1
title: a column of disks
dimension: 2
method: nscd
terrain: { type: profile, points: [[-5, 0], [5, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
bodies:
  - { name: low, shape: { type: disk, radius: 0.5 }, mass: 1 kg, material: rock, position: [0, 0.5] }
  - { name: middle, shape: { type: disk, radius: 0.5 }, mass: 1 kg, material: rock, position: [0, 1.5] }
  - { name: high, shape: { type: disk, radius: 0.5 }, mass: 1 kg, material: rock, position: [0, 2.5] }
stop: { time: 1 s, speed: 0 }
output: { series: { every: 50 ms } }
)";

TEST_CASE("ParaView gets the force network as lines from centre to centre") {
  const Folder folder;
  folder.write("s.yaml", column_of_disks);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  const auto series = series_of(folder.path() / "r/vtk/network-p0.pvd");
  REQUIRE(series.size() > 100);
  // Between its rows the series stands, also at the end.
  for (const std::size_t k : {std::size_t{77}, series.size() - 1}) {
    const std::string text = read(folder.path() / "r/vtk" / series[k].second);
    CHECK(text.find("NumberOfPoints=\"8\" NumberOfVerts=\"0\" NumberOfLines=\"3\"") != std::string::npos);
    const std::string array = "Name=\"normal_force_N\" NumberOfComponents=\"1\" format=\"ascii\">";
    const std::size_t at = text.find(array);
    REQUIRE(at != std::string::npos);
    std::istringstream numbers(text.substr(at + array.size()));
    std::multiset<long> weights;  // above a contact, in disks
    for (int i = 0; i < 3; ++i) {
      double force = 0;
      numbers >> force;
      CHECK(force / 9.81 == Approx(std::round(force / 9.81)).margin(1e-6));
      weights.insert(std::lround(force / 9.81));
    }
    CHECK(weights == std::multiset<long>{1, 2, 3});
  }
}

TEST_CASE("animate draws the force network with lines as wide as the forces") {
  const Folder folder;
  folder.write("s.yaml", column_of_disks);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "animate r -o end.svg --at 9s --forces network").code == 0);
  const std::string picture = read(folder.path() / "end.svg");
  CHECK(picture.find("widest line 29.4 N") != std::string::npos);
  // Of eight widths, those nearest to 1/3, 2/3 and 3/3 have a line: from centre to centre, and one to the
  // ground.
  for (int width = 1; width <= 8; ++width) {
    const std::size_t at = picture.find("<path stroke-width=\"" + std::to_string(width) + "\"");
    REQUIRE(at != std::string::npos);
    const std::string path = picture.substr(at, picture.find('>', at) - at);
    CHECK(count_of(path, "M") == (width == 3 || width == 5 || width == 8 ? 2u : 1u));
    CHECK(count_of(path, "L") == (width == 3 || width == 5 ? 2u : width == 8 ? 1u : 0u));
  }
  // Arrows are the default.
  REQUIRE(call(folder, "animate r -o arrows.svg --at 9s").code == 0);
  CHECK(read(folder.path() / "arrows.svg").find("longest arrow 29.4 N") != std::string::npos);
  CHECK(
      call(folder, "animate r --forces chains").err.find("--forces chains: expected `arrows` or `network`") !=
      std::string::npos);
}

TEST_CASE("In 2D ParaView gets polygons and disks, turned by their angle") {
  const Folder folder;
  folder.write("s.yaml", std::string(bench));
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  const fs::path db = folder.path() / "r/results.db";
  const auto series = series_of(folder.path() / "r/vtk/shapes-p0.pvd");
  const Surfaces end = read_surfaces(folder.path() / "r/vtk" / series.back().second);
  const std::vector<double> at =
      numbers_in(query(db,
                       "SELECT x_m, y_m, angle_rad FROM trajectories WHERE trial = 0 AND rock = 0 "
                       "ORDER BY time_s DESC LIMIT 1")[0]);
  const Eigen::Rotation2Dd turn(at[2]);
  int corners = 0;
  for (const std::string& row :
       query(db, "SELECT x_m, y_m, radius_m FROM shapes WHERE trial = 0 AND rock = 0")) {
    const std::vector<double> corner = numbers_in(row);
    const Eigen::Vector2d place =
        Eigen::Vector2d(at[0], at[1]) + turn * Eigen::Vector2d(corner[0], corner[1]);
    CHECK(end.distance_to_vertices(0, {place.x(), place.y(), 0}) == Approx(corner[2]).margin(2e-4));
    ++corners;
  }
  CHECK(corners >= 1);
}

TEST_CASE("Without stored trajectories there is nothing for ParaView") {
  const Folder folder;
  folder.write("s.yaml", std::string(bench) + "output: { trajectories: { first: 0 } }\n");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output vtk = call(folder, "export r --to vtk");
  CHECK(vtk.code == 0);
  CHECK(vtk.out.empty());
  CHECK(vtk.err.find("nothing written: no trajectory is stored") == 0);
}

TEST_CASE("An export says which formats there are and which folders are results") {
  const Folder folder;
  folder.write("s.yaml", bench);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const auto refused = [&](const std::string& arguments, const std::string& text) {
    const Output output = call(folder, arguments);
    INFO(arguments << "\n" << output.err);
    CHECK(output.code == 2);
    CHECK(output.err.find(text) != std::string::npos);
  };
  refused("export r --to vtx", "--to: unknown format `vtx`, did you mean `vtk`?");
  refused(
      "export r --to shapefile",
      "--to: unknown format `shapefile`, expected `asc`, `csv`, `dxf`, `geojson`, `gltf`, `gpkg`, `hdf5`, "
      "`obj`, `tif` or `vtk`");
  refused("export r",
          "expected --to FORMAT: flyrock export DIR --to csv|hdf5|vtk|gltf|obj|dxf|geojson|gpkg|asc|tif [-o "
          "PATH]");
  refused("export nowhere --to csv", "nowhere is not a result folder: it has no manifest.json");
  refused("report s.yaml", "s.yaml is not a result folder");
  CHECK(call(folder, "run s.yaml --shard 1/2 --quiet -o half").code == 0);
  refused("report half",
          "half has no results yet: `flyrock run --resume` goes on with a run that was interrupted");
}

TEST_CASE("In 3D ParaView gets the triangles of the ground where rocks were, with their parts") {
  const Folder folder;
  REQUIRE(call(folder, "run " FLYROCK_SOURCE_DIR "/plugins/terrain/mesh/example.yaml --trials 3 -o r --quiet")
              .code == 0);
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  const fs::path db = folder.path() / "r/results.db";
  const std::string vertices = query(db, "SELECT count(*) FROM ground_vertices")[0],
                    triangles = query(db, "SELECT count(*) FROM ground_triangles")[0];
  const std::string ground = read(folder.path() / "r/vtk/ground-p0.vtp");
  CHECK(ground.find("NumberOfPoints=\"" + vertices +
                    "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                    triangles + "\"") != std::string::npos);
  CHECK(ground.find("</Polys>") != std::string::npos);
  CHECK(query(db, "SELECT ground FROM points") == std::vector<std::string>{"0"});
  CHECK(query(db, "SELECT lattice_m FROM grounds") == std::vector<std::string>{"0.0"});
  CHECK(query(db, "SELECT count(*) FROM parts WHERE part IN (SELECT part FROM ground_triangles)")[0] > "1");
  // It lies under all places of the paths.
  CHECK(query(db,
              "SELECT min(x_m) < (SELECT min(x_m) FROM trajectories) AND max(x_m) > (SELECT max(x_m) FROM "
              "trajectories) AND min(z_m) < (SELECT min(z_m) FROM trajectories) FROM ground_vertices") ==
        std::vector<std::string>{"1"});
}

TEST_CASE("The ground of a raster in national coordinates is exported where its rocks are") {
  const Folder folder;
  REQUIRE(
      call(folder, "run " FLYROCK_SOURCE_DIR "/plugins/terrain/raster/example.yaml --trials 3 -o r --quiet")
          .code == 0);
  const fs::path db = folder.path() / "r/results.db";
  CHECK(query(db,
              "SELECT min(x_m) > 2599000, max(y_m) < 1201000, cell_m > 0, lattice_m = 0 FROM ground_vertices "
              "JOIN grounds USING (ground)") == std::vector<std::string>{"1|1|1|1"});
}

TEST_CASE("animate draws the stored motion without scripts") {
  const Folder folder;
  const std::string course = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/";
  for (const char* scenario : {"gauss_seidel.yaml", "dzhanibekov.yaml"}) {
    const std::string far = scenario == std::string("gauss_seidel.yaml")
                                ? ""
                                : " --set bodies.longest.position='[9, 0, 10]'";  // for another scale
    REQUIRE(call(folder, "run " + course + scenario + far + " -o out --force --quiet").code == 0);
    const Output output = call(folder, "animate out -o motion.svg");
    INFO(output.err);
    REQUIRE(output.code == 0);
    CHECK(output.out == "motion.svg\n");
    const std::string picture = read(folder.path() / "motion.svg");
    CHECK(picture.starts_with("<svg xmlns="));
    CHECK(picture.ends_with("</svg>\n"));
    CHECK(picture.find("<animate") != std::string::npos);
    CHECK(picture.find("nan") == std::string::npos);
    CHECK(picture.find("<script") == std::string::npos);
    // Its title is that of the scenario, and it has a length as a scale.
    CHECK(picture.find(scenario == std::string("gauss_seidel.yaml")
                           ? "<title>Gauss-Seidel: a stack of boxes, point 0"
                           : "<title>Dzhanibekov") != std::string::npos);
    CHECK(picture.find(scenario == std::string("gauss_seidel.yaml") ? ">0.2 m</text>" : ">1 m</text>") !=
          std::string::npos);
    // The contacts of the stack have an arrow each; of a body in free flight no series is stored.
    CHECK((picture.find("#c4531b") != std::string::npos) == (scenario == std::string("gauss_seidel.yaml")));
  }
  CHECK(call(folder, "animate out --point 9").code == 2);
  REQUIRE(call(folder, "animate out -o motion.svg --until 12s").code == 0);
  const std::string cut = read(folder.path() / "motion.svg");
  CHECK(cut.find(">10 s</text>") != std::string::npos);
  CHECK(cut.find(">20 s</text>") == std::string::npos);
  CHECK(call(folder, "animate out --until 3kg").err.find("--until 3kg: expected a positive time") !=
        std::string::npos);
  CHECK(call(folder, "animate nowhere").code == 2);
}

TEST_CASE("fixed and driven bodies are in pictures and in VTK, and move as they are driven") {
  const Folder folder;
  folder.write("plate.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-20, -5], [20, -5]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
bodies:
  - { name: box, shape: { type: polygon, vertices: [[-0.2, -0.2], [0.2, -0.2], [0.2, 0.2], [-0.2, 0.2]] }, mass: 3 kg, position: [0, 0.3], velocity: [1, 0], material: rock }
  - { name: plate, shape: { type: polygon, vertices: [[-1, -0.1], [1, -0.1], [1, 0.1], [-1, 0.1]] }, position: [0, 0], driven: { velocity: [1, 0], acceleration: [2, 0] }, material: rock }
  - { name: anvil, shape: { type: polygon, vertices: [[-1, -0.1], [1, -0.1], [1, 0.1], [-1, 0.1]] }, position: [-3, 0], fixed: true, material: rock }
stop: { time: 1 s, speed: 0 }
)");
  const Output ran = call(folder, "run plate.yaml -o r --quiet");
  INFO(ran.err);
  REQUIRE(ran.code == 0);
  CHECK(query(folder.path() / "r/results.db",
              "SELECT body, x_m, vx_m_s, ax_m_s2, (SELECT count(*) FROM fixture_shapes s WHERE s.body = "
              "f.body) FROM fixtures f") ==
        std::vector<std::string>{"plate|0.0|1.0|2.0|4", "anvil|-3.0|0.0|0.0|4"});
  REQUIRE(call(folder, "animate r -o motion.svg").code == 0);
  // The box stays on the plate: the lists of their places end as far from where they begin.
  const std::string picture = read(folder.path() / "motion.svg");
  std::vector<double> moved;
  const std::string mark = "type=\"translate\"", values = "values=\"";
  for (std::size_t at = picture.find(mark); at != std::string::npos; at = picture.find(mark, at + 1)) {
    const std::size_t begin = picture.find(values, at) + values.size(), end = picture.find('"', begin);
    const std::string list = picture.substr(begin, end - begin);
    moved.push_back(std::stod(list.substr(list.rfind(';') + 1)) - std::stod(list));
  }
  REQUIRE(moved.size() >= 2);
  const double pixels_a_metre = moved[0] / 2;  // 1 m/s for 1 s, and 2 m/s2
  CHECK(pixels_a_metre > 50);
  CHECK(moved[1] == Approx(moved[0]).margin(1e-3 * pixels_a_metre));
  CHECK(count_of(picture, "<polygon points=") == 4);  // the ground, the box, the plate, the anvil
  REQUIRE(call(folder, "export r --to vtk").code == 0);
  CHECK(fs::exists(folder.path() / "r/vtk/shapes-p0.pvd"));
}

TEST_CASE("an animated picture shows its first moment in programs that do not animate it") {
  const Folder folder;
  const std::string scenario = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/oblique_impact.yaml";
  REQUIRE(call(folder, "run " + scenario + " -o out --quiet").code == 0);
  REQUIRE(call(folder, "animate out -o motion.svg").code == 0);
  const std::string picture = read(folder.path() / "motion.svg");
  const std::string values = "values=\"";
  const std::size_t at = picture.find(values, picture.find("type=\"translate\"")) + values.size();
  const std::string first = picture.substr(at, picture.find(';', at) - at);
  CHECK(picture.find("<g transform=\"translate(" + first + ")\">") != std::string::npos);
}

TEST_CASE(
    "an animated picture names its few bodies, shows their ways, heights, fixed ends of links and a region") {
  const Folder folder;
  folder.write("two.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-20, 0], [20, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.6 } } }
bodies:
  - { name: left, shape: { type: disk, radius: 0.2 }, mass: 3 kg, position: [-2, 0.2], velocity: [1, 0], material: rock }
  - { name: bob, shape: { type: disk, radius: 0.2 }, mass: 3 kg, position: [2, 1], material: rock }
links:
  - { name: rope, type: rope, between: [bob, terrain], ends: [[2, 1], [2, 9]] }
stop: { time: 1 s, speed: 0 }
)");
  const Output ran = call(folder, "run two.yaml -o r --quiet");
  INFO(ran.err);
  REQUIRE(ran.code == 0);
  REQUIRE(call(folder, "animate r -o whole.svg").code == 0);
  const std::string whole = read(folder.path() / "whole.svg");
  CHECK(whole.find("</text>") != std::string::npos);
  CHECK(count_of(whole, "/>left</text>") + count_of(whole, "/>bob</text>") == 2);
  CHECK(count_of(whole, "stroke-opacity=\"0.35\"") == 1);
  CHECK(count_of(whole, ">5 m</text>") == 1);  // up to the end of the rope
  REQUIRE(call(folder, "animate r -o near.svg --region=-2.5,0,2.5,2").code == 0);
  const std::string near = read(folder.path() / "near.svg");
  CHECK(count_of(near, ">5 m</text>") == 0);
  CHECK(count_of(near, ">1.5 m</text>") == 1);
  for (const char* wrong : {"1,2,3", "0,0,1,1,", "0,0,-1,1", "0,0,1 kg,1", "a,b,c,d"}) {
    const Output refused = call(folder, "animate r --region '" + std::string(wrong) + "'");
    CHECK(refused.code == 2);
    CHECK(refused.err.find("expected X0,Y0,X1,Y1") != std::string::npos);
  }
  const Output away = call(folder, "animate r --region 100,0,110,5");
  CHECK(away.code == 2);
  CHECK(away.err.find("--region 100,0,110,5: no stored rock comes there") != std::string::npos);
}

TEST_CASE("animate writes one moment, films and frames") {
  const Folder folder;
  const std::string scenario = std::string(FLYROCK_SOURCE_DIR) + "/scenarios/course/bouncing_ball.yaml";
  REQUIRE(call(folder, "run " + scenario + " -o out --quiet").code == 0);
  REQUIRE(call(folder, "animate out -o moving.svg").code == 0);
  REQUIRE(call(folder, "animate out -o first.svg --at 1us").code == 0);
  REQUIRE(call(folder, "animate out -o floor.svg --at 1.4278s").code == 0);
  const std::string first = read(folder.path() / "first.svg"), floor = read(folder.path() / "floor.svg");
  CHECK(first.find("<animate") == std::string::npos);
  // The first moment is that of the moving picture; sqrt(2 H/g) later the ball is on the ground.
  const auto height = [](const std::string& picture) {
    return std::stod(picture.substr(picture.find("translate(120.00,") + 17));
  };
  CHECK(height(first) == Approx(height(read(folder.path() / "moving.svg"))).margin(0.01));
  CHECK(height(floor) == Approx(487.6).margin(0.3));  // the line of the ground is at 492.1, the radius is 4.6
  CHECK(call(folder, "animate out -o x.mp4 --at 1s").err.find("--at gives one picture") != std::string::npos);
  CHECK(call(folder, "animate out -o x.svg --at 1kg").code == 2);
  CHECK(shell(folder, "PATH=/nowhere '" FLYROCK_BINARY "' animate out -o x.mp4").err.find("librsvg2-bin") !=
        std::string::npos);
  if (shell(folder, "command -v rsvg-convert && command -v ffmpeg").code != 0) {
    WARN("SKIPPED: films need rsvg-convert and ffmpeg");
    return;
  }
  REQUIRE(call(folder, "animate out -o still.png --at 1s --width 321").code == 0);
  CHECK(read(folder.path() / "still.png").substr(1, 3) == "PNG");
  CHECK(read(folder.path() / "still.png").substr(16, 4) == std::string("\0\0\x01\x41", 4));
  const Output frames = call(folder, "animate out -o ball.png --width 100");
  CHECK(count_of(frames.out, ".png\n") == 113);  // 25 a second in 4.48 s, both ends
  CHECK(folder.has("ball-113.png"));
  CHECK(call(folder, "animate out -o ball.gif --width 101").out == "ball.gif\n");
  CHECK(read(folder.path() / "ball.gif").starts_with("GIF89a"));
  CHECK(call(folder, "animate out -o ball.mp4 --width 101").out == "ball.mp4\n");
  CHECK(read(folder.path() / "ball.mp4").substr(4, 4) == "ftyp");
  CHECK(shell(folder, "ls -d .frames-*").code != 0);
}

TEST_CASE("Maps are exported as ASCII grids with the values of the page") {
  const Folder folder;
  const std::string mapped = FLYROCK_SOURCE_DIR "/tests/unit/batch/mapped.yaml";
  REQUIRE(call(folder, "run '" + mapped + "' --trials 12 --quiet -o r").code == 0);
  const Output done = call(folder, "export r --to asc");
  REQUIRE(done.code == 0);
  CHECK(count_of(done.out, ".asc\n") == 10);
  const fs::path db = folder.path() / "r/results.db";
  const auto numbers_of = [&](const std::string& of) {
    std::vector<double> list;
    for (const std::string& row :
         query(db, "SELECT value FROM report, json_each(data, '$.points[0].map." + of + "')"))
      list.push_back(std::stod(row));
    return list;
  };
  const std::vector<double> steps = numbers_of("index");
  double deposited = 0;
  for (const char* name : {"Nr_passages", "Reach_probability", "E_mean", "E_p95", "E_max", "Ph_mean",
                           "Ph_p95", "Ph_max", "V_max", "Nr_deposited"}) {
    INFO(name);
    std::istringstream text(read(folder.path() / "r/asc" / (std::string(name) + "-p0.asc")));
    std::vector<std::string> header(6);
    for (std::string& line : header) std::getline(text, line);
    CHECK(header == std::vector<std::string>{"ncols 40", "nrows 20", "xllcorner 0", "yllcorner -5",
                                             "cellsize 1", "NODATA_value -9999"});
    const std::vector<double> cells{std::istream_iterator<double>(text), {}};
    REQUIRE(cells.size() == 800);
    const std::vector<double> page = numbers_of(name);
    REQUIRE(page.size() == steps.size());
    std::size_t index = 0;
    for (std::size_t i = 0; i < page.size(); ++i) {
      index += static_cast<std::size_t>(steps[i]);
      CHECK(cells[(19 - index / 40) * 40 + index % 40] == Approx(page[i]).epsilon(6e-4).margin(1e-12));
    }
    const auto empty = static_cast<std::size_t>(std::count(cells.begin(), cells.end(), -9999.0));
    CHECK(empty == 800 - page.size());
    if (std::string(name) == "Nr_deposited")
      for (const double rocks : cells) deposited += std::max(0.0, rocks);
  }
  CHECK(deposited ==
        std::stod(query(db,
                        "SELECT count(*) FROM rocks WHERE stop_reason = 'stopped' AND stop_x_m >= 0 "
                        "AND stop_x_m < 40 AND stop_y_m >= -5 AND stop_y_m < 15")
                      .front()));
  CHECK(deposited > 0);
  const Output tif = call(folder, "export r --to tif");
  if (!has_gdal()) {
    CHECK(tif.code == 2);
    CHECK(tif.err ==
          "error: --to tif needs GDAL, which this flyrock does not have (Debian: flyrock-gdal); --to asc "
          "writes "
          "the same maps without it\nSee `flyrock export --help`.\n");
    return;
  }
  REQUIRE(tif.code == 0);
  if (std::system("gdal_translate --version > /dev/null 2>&1") != 0) {
    WARN("SKIPPED: the programs of GDAL are not installed (Debian: gdal-bin)");
    return;
  }
  // GDAL reads the same numbers from both.
  for (const char* name : {"E_mean", "V_max", "Nr_deposited"}) {
    const auto numbers = [&](const std::string& file) {
      const std::string out = (folder.path() / "grid.xyz").string();
      REQUIRE(std::system(("gdal_translate -q -oo DATATYPE=Float64 -of XYZ '" +
                           (folder.path() / file).string() + "' '" + out + "' 2> /dev/null")
                              .c_str()) == 0);
      return read(out);
    };
    CHECK(numbers(std::string("r/tif/") + name + "-p0.tif") ==
          numbers(std::string("r/asc/") + name + "-p0.asc"));
  }
  CHECK_FALSE(folder.has("r/tif/E_mean-p0.asc"));
}

TEST_CASE("Maps have the same bytes after a resume and by any number of threads") {
  const Folder folder;
  const std::string mapped = FLYROCK_SOURCE_DIR "/tests/unit/batch/mapped.yaml";
  REQUIRE(call(folder, "run '" + mapped + "' --trials 300 --quiet -o one -j 1").code == 0);
  REQUIRE(call(folder, "run '" + mapped + "' --trials 300 --quiet -o three -j 3").code == 0);
  for (const char* part : {"1/2", "2/2"})
    REQUIRE(call(folder, "run '" + mapped + "' --trials 300 --quiet -o shard" + part[0] + " --shard " + part)
                .code == 0);
  REQUIRE(call(folder, "merge shard1 shard2 -o merged").code == 0);
  const auto maps = [&](const std::string& result) {
    return query(folder.path() / result / "results.db", "SELECT * FROM maps ORDER BY rowid");
  };
  CHECK(maps("one").size() > 100);
  CHECK(maps("one") == maps("three"));
  CHECK(maps("one") == maps("merged"));
}

namespace dxf_export_test {

/// The groups of a DXF file: code and value.
std::vector<std::pair<int, std::string>> groups_of(const fs::path& file) {
  std::istringstream lines(read(file));
  std::vector<std::pair<int, std::string>> groups;
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);)
    groups.emplace_back(std::stoi(code), value);
  return groups;
}

/// The places of each polyline of a layer.
std::vector<std::vector<Eigen::Vector3d>> lines_of(const fs::path& file, const std::string& layer) {
  std::vector<std::vector<Eigen::Vector3d>> lines;
  std::string entity;
  bool is_here = false;
  for (const auto& [code, value] : groups_of(file)) {
    if (code == 0) entity = value;
    if (code == 8) {
      is_here = value == layer;
      if (is_here && entity == "POLYLINE") lines.emplace_back();
      if (is_here && entity == "VERTEX") lines.back().emplace_back();
    }
    if (is_here && entity == "VERTEX" && code >= 10 && code <= 30 && code % 10 == 0)
      lines.back().back()[code / 10 - 1] = std::stod(value);
  }
  return lines;
}

}  // namespace dxf_export_test

TEST_CASE("A section as a drawing: the paths that are stored, the ground, envelopes above it") {
  using namespace dxf_export_test;
  const Folder folder;
  folder.write("s.yaml", fenced());
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const Output made = call(folder, "export r --to dxf");
  INFO(made.err);
  CHECK(made.out == "r/dxf/results-p0.dxf\nr/dxf/results-p1.dxf\n");
  const fs::path drawing = folder.path() / "r/dxf/results-p1.dxf", db = folder.path() / "r/results.db";
  const auto groups = groups_of(drawing);
  REQUIRE(groups.size() > 10);
  CHECK(groups[3] == std::pair<int, std::string>(1, "AC1009"));
  CHECK(groups.back() == std::pair<int, std::string>(0, "EOF"));
  const auto paths = lines_of(drawing, "PATHS");
  REQUIRE(
      std::to_string(paths.size()) ==
      query(db, "SELECT count(*) FROM (SELECT DISTINCT trial, rock FROM trajectories WHERE point = 1)")[0]);
  CHECK(std::to_string(paths[0].size()) ==
        query(db, "SELECT count(*) FROM trajectories WHERE point = 1 AND trial = 0 AND rock = 0")[0]);
  const auto last = numbers_in(query(db, "SELECT stop_x_m, stop_y_m FROM rocks WHERE point = 1 LIMIT 1")[0]);
  CHECK((paths[0].back() - Eigen::Vector3d(last[0], last[1], 0)).norm() < 1e-9);
  CHECK(std::to_string(lines_of(drawing, "GROUND").at(0).size()) ==
        query(db, "SELECT count(*) FROM ground WHERE point = 1")[0]);
  CHECK(lines_of(drawing, "BARRIERS").at(0).at(1).y() - lines_of(drawing, "BARRIERS").at(0).at(0).y() == 3.0);
  // Beyond the toe the ground is level, so an envelope is as high as the highest path.
  constexpr double beyond_toe = 5;
  std::size_t places = 0;
  double greatest = 0, highest = 0;
  for (const auto& line : lines_of(drawing, "ENVELOPE_MAX")) {
    places += line.size();
    for (const auto& place : line)
      if (place.x() > beyond_toe) greatest = std::max(greatest, place.y());
  }
  for (const auto& path : paths)
    for (const auto& place : path)
      if (place.x() > beyond_toe) highest = std::max(highest, place.y());
  CHECK(std::to_string(places) ==
        query(db, "SELECT count(*) FROM envelopes WHERE point = 1 AND \"group\" = ''")[0]);
  CHECK(greatest > 0.98 * highest);
  CHECK(greatest < 1.2 * highest);
}

TEST_CASE("A plan as a drawing has the layers of a GIS, with the same places") {
  using namespace dxf_export_test;
  const Folder folder;
  std::string thrown_at_fence =
      thrown + "barriers: [{ name: fence, line: [[5, -5], [6, 12]], height: 3, capacity: 5 kJ }]\n";
  folder.write("s.yaml", thrown_at_fence);
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  REQUIRE(call(folder, "export r --to dxf -o drawing").code == 0);
  const fs::path drawing = folder.path() / "drawing/results-p0.dxf";
  CHECK(lines_of(drawing, "PATHS").size() == 3);
  const auto fence = lines_of(drawing, "BARRIERS");
  REQUIRE(fence.size() == 1);
  CHECK(fence[0] == std::vector<Eigen::Vector3d>{{5, -5, 0}, {6, 12, 0}});
  CHECK(std::distance(fs::directory_iterator(folder.path() / "drawing"), fs::directory_iterator()) == 1);
}

TEST_CASE("a driven body whose velocity changes over time is drawn where it is") {
  const Folder folder;
  folder.write("gate.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-9, 0], [9, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.5 } } }
stop: { time: 2 s, speed: 0 }
bodies:
  - { name: gate, shape: { type: disk, radius: 0.5 }, position: [0, 1], material: rock,
      driven: { spin: 3, velocity: { table: [[0.5, [1, 0]], [1 s, [3, 0]]] } } }
  - { name: stone, shape: { type: disk, radius: 0.5 }, density: 2700, position: [-5, 0.5], material: rock }
)");
  const Output run = call(folder, "run gate.yaml --quiet -o r");
  INFO(run.err);
  REQUIRE(run.code == 0);
  // 1 m/s for 0.5 s, then 4 m/s2 for 0.5 s, then 3 m/s.
  CHECK(query(folder.path() / "r/results.db",
              "SELECT time_s, x_m, vx_m_s, ax_m_s2, round(angle_rad, 9) FROM fixtures ORDER BY rowid") ==
        std::vector<std::string>{"0.0|0.0|1.0|0.0|0.0", "0.5|0.5|1.0|4.0|1.5", "1.0|1.5|3.0|0.0|3.0"});
  CHECK(query(folder.path() / "r/results.db", "SELECT count(*) FROM fixture_shapes") ==
        std::vector<std::string>{"1"});
}
