// The labs of the course notice a wrong step and a wrong scheme, not only a wrong law.

#include <catch2/catch.hpp>
#include <string>

#include "program.h"

using namespace flyrock::test;

TEST_CASE("the labs on steps fail with another scheme, restitution or step") {
  struct Mistake {
    const char* lab;
    const char* change;
  };
  const Folder folder;
  for (const Mistake& mistake : {
           Mistake{"moreau", "solver.flight=exact"},
           Mistake{"moreau", "solver.theta=1"},
           Mistake{"moreau", "materials.floor.restitution.en=0.52"},
           Mistake{"penalty_or_signorini", "solver.time_step=1ms"},
           Mistake{"penalty_or_signorini", "materials.springs.unilateral.stiffness=1e6"},
           Mistake{"penalty_or_signorini", "materials.constraint.restitution.en=0.9"},
       }) {
    INFO(mistake.lab << " --set " << mistake.change);
    const Output output =
        call(folder, std::string("run " FLYROCK_SOURCE_DIR "/scenarios/course/") + mistake.lab +
                         ".yaml -o out --force --quiet --set " + mistake.change);
    CHECK(output.code == 1);
  }
}
