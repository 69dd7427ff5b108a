// The native launches: their speeds, directions and what they say.

#include <catch2/catch.hpp>

#include "conformance/plugin_use.h"

using namespace flyrock;

namespace {

const LuaSession& session() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

Launch launch(const std::string& name, const std::map<std::string, Given>& given, const Blast& blast = {},
              int dimension = 2) {
  const auto made = make<VelocityModel>(session(), PluginKind::velocity, name, given, dimension);
  RockView rock;
  rock.dimension = dimension;
  RandomStream rng(1, "launch", {});
  return made.model->launch(made.values, rock, blast, rng);
}

Blast ninh_dan(double burden, bool anfo = true) {
  Blast blast;
  blast[BlastField::explosive_density] = 850;
  blast[BlastField::gurney_constant] = 0.44 * 4273;
  blast[BlastField::hole_diameter] = 0.102;
  blast[BlastField::burden] = burden;
  blast[BlastField::rock_density] = 2700;
  blast[BlastField::breakout_angle] = pi / 2;
  blast.is_anfo = anfo;
  return blast;
}

}  // namespace

TEST_CASE("fixed launches by components or by speed and direction") {
  const Launch components = launch("fixed", {{"velocity", std::vector<double>{2, -1}}, {"spin", 3.0}});
  CHECK(components.velocity == Vec3(2, -1, 0));
  CHECK(components.spin == Vec3(0, 0, 3));
  const Launch aimed = launch("fixed", {{"speed", 10.0}, {"elevation", pi / 6}});
  CHECK((aimed.velocity - Vec3(10 * std::cos(pi / 6), 5, 0)).norm() < 1e-14);
  CHECK(launch("fixed", {{"speed", 10.0}}).velocity == Vec3(10, 0, 0));
}

TEST_CASE("fixed launches refuse what does not go together") {
  const std::vector<double> velocity{2, -1};
  CHECK_THROWS_WITH(launch("fixed", {}), "plugin fixed: expected either `velocity` or `speed`");
  CHECK_THROWS_WITH(launch("fixed", {{"velocity", velocity}, {"speed", 1.0}}),
                    "plugin fixed: expected either `velocity` or `speed`");
  CHECK_THROWS_WITH(launch("fixed", {{"velocity", velocity}, {"elevation", 1.0}}),
                    "plugin fixed: a direction goes with `speed`; `velocity` has its own");
  CHECK_THROWS_WITH(launch("fixed", {{"speed", 1.0}, {"azimuth", 1.0}}),
                    "plugin fixed: `azimuth` turns a launch about the vertical, which needs dimension 3");
}

TEST_CASE("an azimuth turns launches of space about the vertical") {
  const Launch turned = launch("fixed", {{"speed", 10.0}, {"elevation", pi / 6}, {"azimuth", pi / 2}}, {}, 3);
  CHECK((turned.velocity - Vec3(0, 10 * std::cos(pi / 6), 5)).norm() < 1e-14);
}

TEST_CASE("gurney launches a burden of 2.7 m at 35.3 m/s") {
  const Launch level = launch("gurney", {{"elevation", 0.0}}, ninh_dan(2.7));
  CHECK(level.velocity.x() == Approx(35.32).epsilon(2e-4));
  CHECK(level.velocity.y() == 0);
  CHECK(level.note.empty());
  CHECK(launch("gurney", {{"geometry", "sphere"}}, ninh_dan(2.7)).velocity.norm() < level.velocity.norm());
  CHECK_THROWS_WITH(launch("gurney", {}, ninh_dan(-1)),
                    "plugin gurney: blast.burden is -1 m, must be above 0");
}

TEST_CASE("bench_fit launches by its two forms and says what is doubtful") {
  const Launch linear = launch("bench_fit", {{"rock", "limestone"}}, ninh_dan(2.7));
  CHECK(linear.velocity.norm() == Approx(29.3).epsilon(1e-3));
  CHECK(linear.note.empty());
  const Launch printed = launch("bench_fit", {{"rock", "limestone"}, {"form", "as_printed"}}, ninh_dan(2.7));
  CHECK(printed.velocity.norm() == Approx(237.0).epsilon(2e-4));
  CHECK(printed.note ==
        "bench_fit: form as_printed takes the square root of c/m; its speeds are those of no quarry");
  const Launch slow = launch("bench_fit", {{"rock", "granite"}}, ninh_dan(4));
  CHECK(slow.velocity == Vec3(0, 0, 0));
  CHECK(slow.note == "bench_fit: v0^2 < 0, the charge is too small for the fit; the rock starts at rest");
  const Launch other = launch("bench_fit", {{"rock", "limestone"}}, ninh_dan(2.7, false));
  CHECK(other.velocity == linear.velocity);
  CHECK(other.note ==
        "bench_fit: the fit of limestone is printed for ANFO only and is used here for another explosive");
  const Launch granite = launch("bench_fit", {{"rock", "granite"}}, ninh_dan(2.7));
  const Launch granite_other = launch("bench_fit", {{"rock", "granite"}}, ninh_dan(2.7, false));
  CHECK(granite.velocity.norm() == Approx(std::sqrt(3.487e6 * 3.529e-4 - 584)).epsilon(1e-3));
  CHECK(granite_other.velocity.norm() == Approx(std::sqrt(3.66e6 * 3.529e-4 - 518)).epsilon(1e-3));
  CHECK(granite_other.note.empty());
}
