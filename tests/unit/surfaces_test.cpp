// Each pair has its own surface: what one pair meets does not change the draws and the memory of another.
#include <catch2/catch.hpp>

#include "batch/load.h"
#include "scenario/build_trial.h"

using namespace flyrock;

namespace {

/// The surface of the contacts of `lower` with the ground (other = -1) or with `upper` (other = 1).
const Surface* surface_of(const World<2>& world, int other) {
  for (const auto& contact : world.contacts())
    if (contact.candidate == 0 && contact.antagonist == other) return contact.surface;
  return nullptr;
}

struct Glued {
  Diagnostics diagnostics;
  std::optional<LoadedScenario> loaded = load_scenario(FLYROCK_SOURCE_DIR "/tests/unit/glued.yaml", {}, diagnostics);
  TrialBuilder<2> builder{loaded.value().plan.points.front()};
  Trial<2> trial = builder.build(0);
  World<2>& world = trial.worlds.front();

  void step(int steps) {
    for (int k = 0; k < steps; ++k) world.step(1e-3, false);
  }
};

bool torn(const Surface& surface) { return surface.unilateral.history.at(1) == 1; }

}  // namespace

TEST_CASE("a bond that tears leaves the others of its material whole, and their draws as they are") {
  Glued glued;
  glued.step(100);
  const Surface* ground = surface_of(glued.world, -1);
  const Surface* joint = surface_of(glued.world, 1);
  REQUIRE(ground);
  REQUIRE(joint);
  const double mu_of_ground = ground->friction.values.at(0), mu_of_joint = joint->friction.values.at(0);
  glued.world.bodies[1].v.y() = 1;  // flies for 0.2 s
  glued.step(300);
  CHECK(surface_of(glued.world, -1) == ground);
  CHECK(surface_of(glued.world, 1) == joint);
  CHECK(torn(*joint));
  CHECK_FALSE(torn(*ground));
  CHECK(joint->friction.values.at(0) != mu_of_joint);  // of its impact
  CHECK(ground->friction.values.at(0) == mu_of_ground);
}

TEST_CASE("bodies that first meet in a step that is done again meet with an empty memory") {
  Glued glued;
  glued.world.bodies[1].x.y() += 5e-3;
  glued.world.bodies[1].v.y() = -1;
  const auto outcome = glued.world.step(10e-3, true);
  CHECK(outcome.new_touch);
  CHECK(outcome.duration == Approx(5e-3).epsilon(0.03));
  glued.world.impact();
  REQUIRE(surface_of(glued.world, 1));
  CHECK(surface_of(glued.world, 1)->unilateral.history == std::vector<double>{0, 0});
}
