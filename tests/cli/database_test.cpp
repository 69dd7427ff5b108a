// results.db, as docs/results.md describes it.

#include <algorithm>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace {

/// The queries of docs/results.md: what stands between ```sql and ```.
std::vector<std::string> documented_queries() {
  const std::string text = read(FLYROCK_SOURCE_DIR "/docs/results.md");
  std::vector<std::string> queries;
  const std::string fence = "```sql\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
    at += fence.size();
    queries.push_back(text.substr(at, text.find("```", at) - at));
  }
  return queries;
}

}  // namespace

TEST_CASE("The database holds what the other tables hold, and every drawn number with its path") {
  const Folder folder;
  folder.write(
      "s.yaml",
      bench_with("mu: 0.6", "mu: { sweep: [0.5, 0.7] }") +
          "expect:\n  - { measure: rocks.count, equals: 4 }\n  - { measure: rocks.runout.p95, below: 1 }\n");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 1);
  const fs::path db = folder.path() / "r/results.db";
  CHECK(query(db, "SELECT * FROM points") == std::vector<std::string>{"0|4|NULL|NULL", "1|4|NULL|NULL"});
  CHECK(query(db, "SELECT * FROM sweep") ==
        std::vector<std::string>{"0|materials.rock.friction.mu|0.5|NULL",
                                 "1|materials.rock.friction.mu|0.7|NULL"});
  CHECK(query(db, "SELECT count(*) FROM rocks") == std::vector<std::string>{"8"});
  CHECK(query(db, "SELECT DISTINCT path FROM inputs ORDER BY path") ==
        std::vector<std::string>{"rock.elongation", "rock.orientation", "rock.volume",
                                 "rocks.blocks.launch.speed", "rocks.blocks.shape.sides"});
  CHECK(query(db,
              "SELECT count(*) FROM rocks JOIN inputs USING (point, trial, rock) WHERE path = "
              "'rock.volume' AND value = volume_m3 AND impact IS NULL") == std::vector<std::string>{"8"});
  // The launch draws its speed: the input is the rock's.
  CHECK(query(db,
              "SELECT count(*) FROM rocks JOIN inputs USING (point, trial, rock) WHERE path = "
              "'rocks.blocks.launch.speed' AND abs(value - launch_speed_m_s) < 1e-9") ==
        std::vector<std::string>{"8"});
  CHECK(query(db,
              "SELECT point, trial, rock FROM rocks GROUP BY point, trial, rock HAVING impacts <> (SELECT "
              "count(*) "
              "FROM impacts i WHERE i.point = rocks.point AND i.trial = rocks.trial AND i.rock = rocks.rock)")
            .empty());
  CHECK(query(db, "SELECT count(DISTINCT trial) FROM trajectories") == std::vector<std::string>{"4"});
  // Each rock has its own path: it starts with it, and ends where the rock has stopped, when it has not moved
  // for 0.2 s.
  CHECK(query(db,
              "SELECT count(*) FROM rocks JOIN (SELECT point, trial, rock, min(time_s) AS start_s, "
              "max(time_s) AS end_s, "
              "x_m FROM trajectories GROUP BY point, trial, rock) p USING (point, trial, rock) "
              "WHERE start_s = 0 AND end_s - time_s BETWEEN 0.2 - 1e-9 AND 0.202 AND abs(x_m - stop_x_m) < "
              "1e-9") == std::vector<std::string>{"8"});
  // Both points have the same rows, which are stored once.
  for (const auto& [view, rows] : {std::pair("trajectories", "trajectory_rows"), {"impacts", "impact_rows"}})
    CHECK(query(db, std::string("SELECT count(*) FROM ") + view + " WHERE point = 1") ==
          query(db, std::string("SELECT count(*) FROM ") + rows));
  // Envelopes: every rock passes the place where it starts, and somewhere the fastest is the fastest of all,
  // to 1 %.
  CHECK(query(db, "SELECT DISTINCT rocks FROM envelopes WHERE x_m <= 0 AND x_m + width_m > 0") ==
        std::vector<std::string>{"4"});
  CHECK(query(db,
              "SELECT point, abs(max(speed_max_m_s) / (SELECT max(max_speed_m_s) FROM rocks r WHERE r.point "
              "= e.point) - 1) < 0.011, "
              "abs(max(energy_max_J) / (SELECT max(max_energy_J) FROM rocks r WHERE r.point = e.point) - 1) "
              "< 0.011, "
              "min(height_p50_m <= height_p95_m AND height_p95_m <= height_max_m) FROM envelopes e GROUP BY "
              "point") == std::vector<std::string>{"0|1|1|1", "1|1|1|1"});
  CHECK(query(db, "SELECT x_m, y_m, part FROM ground WHERE point = 1") ==
        std::vector<std::string>{"-20.0|10.0|0", "0.0|10.0|0", "3.0|0.0|0", "300.0|0.0|NULL"});
  CHECK(query(db, "SELECT number, point, kind, passed FROM expectations") ==
        std::vector<std::string>{"0|0|equals|1", "1|1|equals|1", "2|0|below|0", "3|1|below|0"});
}

TEST_CASE(
    "Rocks that do the same at several points of a sweep share their rows, and each point has all of them") {
  const Folder folder;
  const auto scenario = [](const std::string& height) {
    return bench + ("barriers: [{ name: fence, x: 14, height: " + height + ", capacity: 1 MJ }]\n");
  };
  folder.write("sweep.yaml", scenario("{ sweep: [0.01, 30] }"));
  folder.write("low.yaml", scenario("0.01"));
  folder.write("high.yaml", scenario("30"));
  for (const std::string name : {"sweep", "low", "high"})
    REQUIRE(call(folder, "run " + name + ".yaml -o " + name + " --quiet").code == 0);
  const auto rows = [&](const std::string& of, const std::string& table, const std::string& point) {
    return query(folder.path() / of / "results.db",
                 "SELECT * FROM " + table + " WHERE point = " + point + " ORDER BY trial, rock");
  };
  const auto count = [&](const std::string& table) {
    return std::stoi(query(folder.path() / "sweep/results.db", "SELECT count(*) FROM " + table).front());
  };
  for (const std::string view : {"inputs", "impacts", "trajectories", "shapes"}) {
    INFO(view);
    std::vector<std::string> high = rows("high", view, "0"), of_sweep = rows("sweep", view, "1");
    REQUIRE_FALSE(high.empty());
    for (std::vector<std::string>* list : {&high, &of_sweep})
      for (std::string& row : *list) row.erase(0, row.find('|'));  // the number of the point
    CHECK(of_sweep == high);
    CHECK(rows("sweep", view, "0") == rows("low", view, "0"));
  }
  // The shape of a rock and what it draws are the same at both points; what it does is not where the fence
  // holds it.
  CHECK(2 * count("shape_rows") <= count("shapes"));
  CHECK(2 * count("input_rows") == count("inputs"));
  CHECK(count("impact_rows") < count("impacts"));
}

TEST_CASE("The database has who passed a gate, who met a barrier, and how rocks travelled") {
  const Folder folder;
  folder.write(
      "s.yaml",
      std::string(bench) +
          "gates: [{ name: road, x: 6 }]\nbarriers: [{ name: fence, x: 9, height: 30, capacity: 1 MJ }]\n");
  REQUIRE(call(folder, "run s.yaml -o r --quiet").code == 0);
  const fs::path db = folder.path() / "r/results.db";
  const std::string summary = read(folder.path() / "r/summary.json");
  CHECK(summary.find("\"rocks\": " + query(db, "SELECT count(*) FROM gates WHERE gate = 'road'")[0]) !=
        std::string::npos);
  CHECK(query(db, "SELECT count(*) FROM barriers WHERE barrier = 'fence' AND outcome = 'caught'") ==
        query(db, "SELECT count(*) FROM rocks WHERE stop_reason = 'caught'"));
  CHECK(query(db, "SELECT count(*) > 0 FROM barriers") == std::vector<std::string>{"1"});
  // A rock that is caught ends there and then.
  CHECK(query(db,
              "SELECT count(*) FROM barriers JOIN rocks r USING (point, trial, rock) WHERE outcome = "
              "'caught' AND "
              "abs(r.time_s - barriers.time_s) > 1e-9") == std::vector<std::string>{"0"});
  CHECK(query(db, "SELECT DISTINCT abs(flight_s + bounce_s + slide_s + roll_s - time_s) < 1e-9 FROM rocks") ==
        std::vector<std::string>{"1"});
}

TEST_CASE("The queries of docs/results.md run and give rows") {
  const Folder folder;
  const Output run = call(folder, "run '" FLYROCK_SOURCE_DIR
                                  "/scenarios/ninh_dan/benches_2d.yaml' --trials 20 -o r --quiet "
                                  "--set gates='[{ name: road, x: 20 }]' --set barriers='[{ name: fence, x: "
                                  "25, height: 3, capacity: 500 kJ }]'");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const std::vector<std::string> queries = documented_queries();
  CHECK(queries.size() == 7);
  for (const std::string& sql : queries) {
    INFO(sql);
    const fs::path db = folder.path() / "r/results.db";
    CHECK_FALSE(query(db, sql).empty());
    // An index that SQLite makes for one query would search all rows of all rocks once for each rock.
    for (const std::string& step : query(db, "EXPLAIN QUERY PLAN " + sql))
      CHECK(step.find(" r USING AUTOMATIC") == std::string::npos);
  }
}
