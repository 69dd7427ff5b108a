// flyrock report and flyrock export: what is made of a result later.

#include <algorithm>
#include <regex>

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
        "point,path,value\n0,materials.rock.friction.mu,0.5\n1,materials.rock.friction.mu,0.7\n");
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
        "r/vtk/trajectories-p0.vtp\nr/vtk/rocks-p0.pvd\nr/vtk/ground-p0.vtp\n"
        "r/vtk/trajectories-p1.vtp\nr/vtk/rocks-p1.pvd\nr/vtk/ground-p1.vtp\n");
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
  refused("export r --to geojson", "--to: unknown format `geojson`, expected `csv` or `vtk`");
  refused("export r", "expected --to FORMAT: flyrock export DIR --to csv|vtk [-o PATH]");
  refused("export nowhere --to csv", "nowhere is no result folder: it has no manifest.json");
  refused("report s.yaml", "s.yaml is no result folder");
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
