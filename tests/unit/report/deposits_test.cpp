// Where the plan shows that rocks ended.

#include "report/page/deposits.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace flyrock;

TEST_CASE(
    "the plan has the first ends, some of the others at each distance, the farthest, and the extent of all") {
  Deposits deposits(500);  // and one at each step of distance
  TrialRecords records;
  for (int i = 0; i < 2000; ++i) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = static_cast<std::uint64_t>(i / 10);
    rock.rock = i % 10;
    rock.reason = i == 1999 ? StopReason::diverged : StopReason::stopped;
    rock.runout = i == 600 ? 900 : i == 700 ? 910 : i == 800 ? 200 : 1;
    rock.stop_x = i == 700 ? 910 : -i;
    rock.stop_y = i == 800 ? -200 : 1;
  }
  deposits.add(records);
  const nlohmann::ordered_json data = deposits.data();
  CHECK(data["count"] == 1999);
  // Of those near 1 m one more; one at 200 m, one at 900 m, and the farthest, which is in the same step.
  CHECK(data["far"] == 4);
  REQUIRE(data["rock"].size() == 504);
  std::uint64_t trial = 0;
  for (const auto& difference : data["trial"]) trial += difference.get<std::uint64_t>();
  CHECK(trial == 80);
  CHECK(data["extent"] == nlohmann::ordered_json({-1998, -200, 910, 1}));
}
