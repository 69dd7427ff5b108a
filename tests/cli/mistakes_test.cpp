// Typical mistakes in the labs of the course: each makes an expectation fail, or is none.

#include <catch2/catch.hpp>
#include <string>

#include "program.h"

using namespace flyrock::test;

namespace mistakes_test {

namespace {

struct Mistake {
  const char* lab;
  const char* options;
};

constexpr Mistake mistakes[] = {
    {"bouncing_ball", R"(--set materials.floor.restitution.en=0.6)"},
    {"bouncing_ball", R"(--set bodies.0.mass=2)"},
    {"bouncing_ball", R"(--set gravity=-9.81)"},
    {"bouncing_ball", R"(--set gravity=9.8)"},
    {"bouncing_ball", R"(--set 'bodies.0.position=[0,10]')"},
    {"bouncing_ball", R"(--set 'bodies.0.position=[0, "1010"]')"},
    {"bouncing_ball", R"(--set solver.rest_speed=0.02)"},
    {"bouncing_ball", R"(--set stop.time=3s)"},
    {"bouncing_ball", R"(--set 'bodies.0.velocity=[0,1]')"},
    {"signorini_coulomb", R"(--set materials.rock.friction.mu=0)"},
    {"signorini_coulomb", R"(--set 'materials.rock.friction={type: coulomb, angle: 0.2 rad}')"},
    {"signorini_coulomb", R"(--set bodies.0.mass=2)"},
    {"signorini_coulomb", R"(--set 'bodies.0.orientation=20 deg')"},
    {"signorini_coulomb", R"(--set bodies.0.orientation=-20)"},
    {"signorini_coulomb", R"(--set solver.time_step=10ms)"},
    {"signorini_coulomb", R"(--set materials.rock.friction.mu=0.36)"},
    {"oblique_impact", R"(--set 'bodies.0.velocity=[-3,-2]')"},
    {"oblique_impact", R"(--set bodies.0.shape.radius=0.5)"},
    {"oblique_impact", R"(--set bodies.0.mass=2)"},
    {"oblique_impact", R"(--set materials.floor.restitution.et=0.5)"},
    {"oblique_impact", R"(--set gravity=9.81)"},
    {"moreau", R"(--set solver.flight=exact)"},
    {"moreau", R"(--set materials.floor.restitution.en=0.52)"},
    {"moreau", R"(--set solver.theta=1)"},
    {"newton_poisson_energy", R"(--set materials.newton.friction.mu=0.2)"},
    {"newton_poisson_energy",
     R"(--set materials.poisson.restitution.form=energy --set materials.energy.restitution.form=poisson)"},
    {"newton_poisson_energy", R"(--set 'bodies.0.orientation=45 deg')"},
    {"newton_poisson_energy", R"(--set 'bodies.2.velocity=[0.6,-1]')"},
    {"own_law", R"(--set 'materials.floor.restitution={type: softening, power: 0.3}')"},
    {"own_law", R"(--set 'materials.floor.restitution={type: newton, en: 0.8}')"},
    {"own_law", R"(--set 'materials.floor.restitution={type: softening, en: 0.81}')"},
    {"rocking_block", R"(--set materials.floor.restitution.en=0.5)"},
    {"rocking_block", R"(--set materials.floor.friction.mu=0.1)"},
    {"rocking_block", R"(--set bodies.0.mass=50)"},
    {"rocking_block", R"(--set solver.time_step=5ms)"},
    {"rocking_block", R"(--set solver.time_step=20ms)"},
    {"rolling", R"(--set materials.floor.friction.mu=0.25)"},
    {"rolling", R"(--set 'bodies.0.spin=[0,10,0]')"},
    {"rolling", R"(--set bodies.0.mass=20)"},
    {"rolling", R"(--set bodies.0.shape.radius=0.3)"},
    {"painleve", R"(--set 'materials.floor.friction.mu={sweep: [1.2,1.4]}')"},
    {"painleve", R"(--set 'bodies.0.velocity=[-1,0]')"},
    {"cradle", R"(--set solver.impacts=one_by_one)"},
    {"gauss_seidel", R"(--set materials.rock.friction.mu=0)"},
    {"gauss_seidel", R"(--set bodies.3.density=2600)"},
    {"penalty_or_signorini", R"(--set materials.springs.unilateral.stiffness=1e6)"},
    {"penalty_or_signorini", R"(--set solver.time_step=1ms)"},
    {"penalty_or_signorini", R"(--set materials.constraint.restitution.en=0.9)"},
    {"arch", R"(--set materials.stone.friction.mu=0.3)"},
    {"arch", R"(--arg thin=0.1069)"},
    {"arch", R"(--set bodies.0.density=2600)"},
    {"dzhanibekov", R"(--set 'bodies.0.spin=[6.283185307179586,0.07,0]')"},
    {"dzhanibekov", R"(--set bodies.0.mass=10)"},
    {"clearance", R"(--set 'rocks.0.launch.speed=30 km/h')"},
    {"clearance",
     R"(--set 'rocks.0.launch.elevation={normal: {mean: 45 deg, sd: 26 deg}, min: 0 deg, max: 90 deg}')"},
    {"routh",
     R"(--set materials.poisson.friction.mu=0.29 --set materials.newton.friction.mu=0.29 --set materials.energy.friction.mu=0.29)"},
    {"routh", R"(--set 'bodies.1.orientation=30 deg')"},
};

/// Changes that are no mistakes, because the results are equal:
///  - One contact without friction: Newton's U+ = -e U- is one equation for r, r = -(1 + e) U-/W.
///    Poisson's compression ends at W r_c = -U-, and r = r_c + e r_c is the same.
///  - The order of the values of a sweep: the points are the same, and expectations name them by value.
///  - Equal balls in a row: in Newton's problem all contacts close, because U+ = -e U- holds with
///    r = -(1 + e) W^-1 U- >= 0. In Poisson's compression W r_c = -U-, with r_c = -W^-1 U- >= 0, and
///    (1 + e) r_c is the same r.
constexpr Mistake equal[] = {
    {"bouncing_ball", "--set materials.floor.restitution.form=poisson"},
    {"signorini_coulomb", "--set 'materials.rock.friction.mu={sweep: [0.5,0.2]}'"},
    {"oblique_impact", "--set 'materials.floor.friction.mu={sweep: [0.5,0.2]}'"},
    {"cradle", "--set materials.steel.restitution.form=poisson"},
};

int code_of(const Folder& folder, const std::string& lab, const std::string& options) {
  const std::string stem = FLYROCK_SOURCE_DIR "/scenarios/course/" + lab;
  const std::string file = stem + (fs::exists(stem + ".lua") ? ".lua " : ".yaml ");
  return call(folder, "run " + file + options + " -o out --force --quiet").code;
}

}  // namespace

TEST_CASE("each lab of the course fails with each typical mistake", "[slow]") {
  const Folder folder;
  for (const Mistake& mistake : mistakes) {
    INFO(mistake.lab << " " << mistake.options);
    const int code = code_of(folder, mistake.lab, mistake.options);
    CHECK((code == 1 || code == 2));
  }
  for (const Mistake& change : equal) {
    INFO(change.lab << " " << change.options);
    CHECK(code_of(folder, change.lab, change.options) == 0);
  }
}

TEST_CASE("the stack fails with one sweep a solve, and holds without this limit") {
  const Folder folder;
  const std::string brief = "--set stop.time=0.02s ";  // the forces hold from the first step on
  CHECK(code_of(folder, "gauss_seidel", brief + "--set solver.max_iterations=1") == 1);
}

}  // namespace mistakes_test
