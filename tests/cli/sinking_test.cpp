// Scenes whose bodies once sank into each other or into the ground.

#include "program.h"

using namespace flyrock::test;

TEST_CASE("Contacts that close again, or elsewhere, within a step let no body sink or gain energy",
          "[slow]") {
  const char* name = GENERATE(
      "cylinder_sinks_into_box", "cylinder_sinks_into_box_no_spin", "cylinder_sinks_into_free_block",
      "coin_through_thin_plate_depth", "coin_through_thin_plate_hangs", "disk_wobble_penetration_on_terrain",
      "pen-183", "pen-wall-301", "polyhedron_slides_off_plate", "box_tips_on_driven_cylinder",
      "box_slips_on_fixed_body", "coin_slips_off_cone", "corner_returns_to_ground", "rims_on_springs",
      "cone_on_driven_cone", "cone_on_free_block", "coin_on_driven_cone", "pill_rolls_and_turns",
      "pill_falls_along_edge", "block_pinched_by_two");
  const Folder folder;
  const Output run = call(folder, std::string("run " FLYROCK_SOURCE_DIR "/tests/data/sinking/") + name +
                                      ".yaml --quiet -o out -j1");
  INFO(name << '\n' << run.out << run.err);
  CHECK(run.code == 0);  // what they expect of depth and place holds
}
