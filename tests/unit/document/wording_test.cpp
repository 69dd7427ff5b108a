#include "document/wording.h"

#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("words for yes and no are taken by their meaning, not by their spelling") {
  const std::vector<std::string> on_off{"off", "on"}, booleans{"true", "false"};
  for (const char* no : {"no", "No", "NO", "n", "N", "false", "False", "OFF"}) {
    INFO(no);
    CHECK(did_you_mean(no, on_off) == ", did you mean `off`?");
    CHECK(did_you_mean(no, booleans) == ", did you mean `false`?");
  }
  for (const char* yes : {"yes", "Yes", "YES", "y", "Y", "true", "TRUE", "ON"}) {
    INFO(yes);
    CHECK(did_you_mean(yes, on_off) == ", did you mean `on`?");
    CHECK(did_you_mean(yes, booleans) == ", did you mean `true`?");
  }
  CHECK(did_you_mean("no", {"floor", "on"}).empty());  // a key `on` that is no answer
  CHECK(did_you_mean("of", on_off) == ", did you mean `off`?");
  CHECK(did_you_mean("noo", {"nook"}) == ", did you mean `nook`?");
}
