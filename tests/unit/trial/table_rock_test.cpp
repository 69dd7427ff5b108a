// Rocks of tables: their forms, masses and scales.

#include "trial/table_rock.h"

#include <catch2/catch.hpp>

#include "geometry/volume_properties.h"
#include "load.h"
#include "trial/build_trial.h"
#include "unit/lua_fixture.h"

namespace flyrock::table_rock_test {

namespace {

constexpr RockForm all_forms[] = {RockForm::box, RockForm::cut, RockForm::ellipsoid, RockForm::sphere};
constexpr const char* form_names[] = {"box", "cut", "ellipsoid", "sphere"};

template <int D>
std::vector<Body<D>> bodies_of(const std::string& table, const std::string& rocks) {
  const LuaFixture folder;
  folder.write("t.csv", table);
  folder.write("s.yaml", fmt::format(R"(flyrock: 1
dimension: {}
method: nscd
terrain: {{ type: plane, material: rock }}
materials: {{ rock: {{ restitution: {{ type: newton, en: 0.3 }} }} }}
rocks:
  - {{ name: r, table: t.csv, {} }}
stop: {{ time: 1 s }}
)",
                                     D, rocks));
  Diagnostics diagnostics;
  const auto scenario = load_scenario((folder.folder / "s.yaml").string(), {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  const auto trial = TrialBuilder<D>(scenario->plan.points.front()).build(0);
  std::vector<Body<D>> list;
  for (const TrialRock& rock : trial.rocks) {
    INFO(rock.fault);
    REQUIRE(rock.world >= 0);
    list.push_back(trial.worlds[static_cast<std::size_t>(rock.world)].bodies.front());
  }
  return list;
}

}  // namespace

TEST_CASE("each form has the volume of its lengths, in 3D and as cross-section times thickness") {
  const Vec3 lengths(1.2, 0.5, 0.8);
  for (const RockForm form : all_forms) {
    INFO(static_cast<int>(form));
    CHECK(volume_properties(shape_of<3>(form, lengths).contactors).volume ==
          Approx(volume_of(form, lengths)).epsilon(1e-9));
    CHECK(area_properties(shape_of<2>(form, lengths).contactors).area * thickness_of(form, lengths) ==
          Approx(volume_of(form, lengths)).epsilon(1e-9));
  }
}

TEMPLATE_TEST_CASE_SIG("mass and form of a table hold, and its lengths are scaled to the density", "",
                       ((int D), D), 2, 3) {
  const std::string table = "mass_t,l1_cm,l2_cm,l3_cm,x_m,y_m,z_m\n0.5,100,60,40,1,2,5\n2,90,90,90,7,8,9\n";
  for (std::size_t f = 0; f < 4; ++f) {
    const auto rocks = bodies_of<D>(
        table, fmt::format("density: 2500, shape: {{ type: from_lengths, form: {} }}", form_names[f]));
    REQUIRE(rocks.size() == 2);
    CHECK(rocks[0].mass == Approx(500));
    CHECK(rocks[1].mass == Approx(2000));
    CHECK(rocks[0].volume == Approx(500.0 / 2500));
    CHECK(rocks[1].x[D - 1] == Approx(9));
    CHECK(rocks[1].x[0] == Approx(7));
  }
}

TEST_CASE("with the density of the table the lengths are as measured") {
  const auto rocks = bodies_of<3>("mass_kg,l1_m,l2_m,l3_m,x_m,y_m,z_m\n500,1,0.6,0.4,0,0,5\n",
                                  "density: from_table, shape: { type: from_lengths, form: box }");
  CHECK(rocks[0].volume == Approx(0.24));
  CHECK(rocks[0].mass == Approx(500));
}

TEST_CASE("without masses the density gives them, a diameter makes equal lengths, other shapes are scaled") {
  const auto boxes = bodies_of<3>("l1,l2,l3,x,y,z\n1,0.6,0.4,0,0,5\n",
                                  "density: 2500, shape: { type: from_lengths, form: box }");
  CHECK(boxes[0].mass == Approx(2500 * 0.24));
  const auto cut =
      bodies_of<3>("diameter,x,y,z\n0.7,0,0,5\n", "density: 2500, shape: { type: from_lengths, form: cut }");
  CHECK(cut[0].volume == Approx(pi / 6 * 0.343));
  const auto cone =
      bodies_of<3>("mass,x,y,z\n800,0,0,5\n", "density: 2000, shape: { type: box, size: [1, 1, 3] }");
  CHECK(cone[0].volume == Approx(0.4));
  CHECK(cone[0].mass == Approx(800));
}

TEST_CASE("a rock of a table starts with its velocity, without z it is lowered to the ground") {
  const auto rocks = bodies_of<3>("mass,x,y,z,vx,vy,vz\n100,1,2,,3,4,-5\n200,5,6,7,,,\n",
                                  "density: 2500, shape: { type: from_lengths, form: sphere }");
  CHECK(rocks[0].x.z() == Approx(rocks[0].radius).epsilon(1e-6));
  CHECK(rocks[0].v.isApprox(Vec3(3, 4, -5)));
  CHECK(rocks[1].x.isApprox(Vec3(5, 6, 7)));
  CHECK(rocks[1].v.isZero());
}

TEST_CASE("trials of a point of a table start alike, and those lowered in their attitude do not") {
  for (const char* form : {"sphere", "box"}) {
    const LuaFixture folder;
    folder.write("t.csv", "mass,l1,l2,l3,x,y\n100,1,0.5,0.3,0,0\n300,0.9,0.5,0.3,5,0\n");
    folder.write("s.yaml", fmt::format(R"(flyrock: 1
dimension: 3
method: lumped_mass
trials: 5
terrain: {{ type: plane, material: rock }}
materials: {{ rock: {{ restitution: {{ type: newton, en: 0.3 }} }} }}
rocks: [{{ name: r, table: t.csv, density: 2500, shape: {{ type: from_lengths, form: {} }} }}]
stop: {{ time: 1 s }}
)",
                                       form));
    Diagnostics diagnostics;
    const auto scenario = load_scenario((folder.folder / "s.yaml").string(), {}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(scenario);
    TrialBuilder<3> one(scenario->plan.points.front()), other(scenario->plan.points.front());
    Trial<3> again = one.build(0);
    one.build(3, again);  // in place of an earlier one
    const Trial<3> fresh = other.build(3);
    for (std::size_t i = 0; i < 2; ++i) {
      const Body<3>& a = again.worlds[i].bodies.front();
      const Body<3>& b = fresh.worlds[i].bodies.front();
      CHECK(a.x.isApprox(b.x, 1e-15));
      CHECK(a.mass == b.mass);
      CHECK((a.attitude.rotation.vector() - b.attitude.rotation.vector()).norm() < 1e-12);
    }
  }
}

}  // namespace flyrock::table_rock_test
