#include "scenario/diagnostics.h"

#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("messages name file, line, column and path, and quote the line") {
  auto source = std::make_shared<Source>();
  source->name = "q.yaml";
  source->lines = {"terrain:", "  höhe: 12 s"};
  Diagnostics diagnostics;
  diagnostics.error({source, 2, 9}, "terrain.höhe", "wrong");
  diagnostics.warning({source, 1, 1}, "terrain", "odd");
  diagnostics.error({source, 2, 9}, "terrain.höhe", "wrong");
  CHECK(diagnostics.to_text() ==
        "q.yaml:1:1: warning: terrain: odd\n"
        "  terrain:\n"
        "  ^\n"
        "q.yaml:2:9: error: terrain.höhe: wrong\n"
        "    höhe: 12 s\n"
        "          ^\n");
  CHECK(diagnostics.has_errors());
  CHECK(diagnostics.warnings() == std::vector<std::string>{"terrain: odd"});
}

TEST_CASE("a message without a place in a file") {
  auto source = std::make_shared<Source>();
  source->name = "--set seed=x";
  Diagnostics diagnostics;
  diagnostics.error({source, 0, 0}, "seed", "expected a whole number");
  CHECK(diagnostics.to_text() == "--set seed=x: error: seed: expected a whole number\n");
  CHECK(to_text(Diagnostic{Severity::error, {}, "", "no"}) == "error: no\n");
}
