// The grounds of a 3D run for exports and for the page.
#include "report/pictures/ground_pictures.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "report/page/deposits.h"
#include "report/page/ground_data.h"

using namespace flyrock;

namespace {

std::shared_ptr<const Terrain3> slope_of(int side) {
  HeightGrid shape;
  shape.columns = shape.rows = side;
  for (int i = 0; i < side * side; ++i) shape.heights.push_back(0.5 * (i % side));
  return std::make_shared<const Terrain3>(std::move(shape));
}

/// A rock that went from (20, 20) to (x, 30), counted from the origin of the terrain.
PointResult rock_on(std::shared_ptr<const Terrain3> ground, double x) {
  PointResult point;
  point.terrain = {{""}, Profile{}, std::move(ground), {2.6e6, 1.2e6, 100}};
  TrialRecords records;
  records.rocks.resize(1);
  RockRecord& rock = records.rocks.front();
  rock.reason = StopReason::stopped;
  rock.start_x = 2.6e6 + 20;
  rock.start_y = 1.2e6 + 20;
  rock.stop_x = 2.6e6 + x;
  rock.stop_y = 1.2e6 + 30;
  point.reach.add(records);
  return point;
}

}  // namespace

TEST_CASE("Points that share a terrain share its picture, which reaches over the rocks of all") {
  const auto shared = slope_of(101), other = slope_of(101);
  const GroundPictures pictures =
      ground_pictures({rock_on(shared, 40), rock_on(other, 40), rock_on(shared, 60), PointResult()});
  CHECK(pictures.of_point == std::vector<int>{0, 1, 0, -1});
  REQUIRE(pictures.grounds.size() == 2);
  double far = 0;
  for (const Vec3& v : pictures.grounds[0].stored.mesh.vertices) {
    far = std::max(far, v.x());
    CHECK(v.z() == Approx(100 + 0.5 * (v.x() - 2.6e6)));
  }
  CHECK(far == Approx(2.6e6 + 64));
}

TEST_CASE("The page has at most as many triangles as it says, the export those of the ground") {
  const GroundPictures pictures = ground_pictures({rock_on(slope_of(401), 380)});
  const GroundPicture& picture = pictures.grounds.front();
  CHECK(picture.stored.lattice == 0);
  CHECK(picture.stored.mesh.triangles.size() > most_page_triangles);
  CHECK(picture.page.lattice == 2);
  CHECK(picture.page.mesh.triangles.size() <= most_page_triangles);
  const nlohmann::ordered_json data = grounds_data(pictures).at(0);
  CHECK(data.at("triangles").size() == 3 * picture.page.mesh.triangles.size());
  CHECK(data.at("cell") == 1);
}

TEST_CASE("The section of a point has the ground under the mean line of its rocks") {
  const PointResult point = rock_on(slope_of(101), 60);
  const nlohmann::ordered_json section = section_data(point);
  REQUIRE(section.at("lines").size() == 1);
  CHECK(section.at("x") == 2.6e6 + 20);
  const double dx = section.at("dx"), from = section.at("from"), to = section.at("to");
  const auto& [s, z] = std::pair(section.at("lines")[0].at("s"), section.at("lines")[0].at("z"));
  REQUIRE(s.size() == 2);  // the ground is plane there
  CHECK(s[0].get<double>() / 1000 == Approx(from).margin(1e-3));
  CHECK((s[0].get<double>() + s[1].get<double>()) / 1000 == Approx(to).margin(1e-3));
  CHECK(z[1].get<double>() / 1000 == Approx(0.5 * dx * (to - from)).margin(2e-3));
  CHECK(section_data(PointResult()).is_null());
}

TEST_CASE("The page holds the ends of the first rocks and of some others, without those that failed") {
  TrialRecords records;
  for (std::uint64_t trial = 0; trial < 5; ++trial) {
    RockRecord& rock = records.rocks.emplace_back();
    rock.trial = trial;
    rock.reason = trial == 1 ? StopReason::diverged : StopReason::stopped;
    rock.stop_x = static_cast<double>(trial);
  }
  Deposits deposits(3);
  deposits.add(records);
  const nlohmann::ordered_json data = deposits.data();
  CHECK(data.at("count") == 4);
  CHECK(data.at("x") == nlohmann::json({0, 2000, 1000, 1000}));
  CHECK(data.at("trial") == nlohmann::json({0, 2, 1, 1}));
  CHECK(data.at("far") == 1);  // after the first three
}
