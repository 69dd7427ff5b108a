#include "document/diagnostics.h"

#include <catch2/catch.hpp>

#include "document/printable.h"

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

TEST_CASE("what a terminal would obey is shown as text") {
  CHECK(printable("a\x1b[2J\tb\r\n\x7f\xc2\x9b") == "a\\x1B[2J\tb\\x0D\\n\\x7F\\xC2\\x9B");
  CHECK(printable("h\xc3\xb6he caf\xe9 \xed\xa0\x80 \xc0\xaf \xf0\x9f\xaa\xa8") ==
        "h\xc3\xb6he caf\\xE9 \\xED\\xA0\\x80 \\xC0\\xAF \xf0\x9f\xaa\xa8");
  CHECK(printable(std::string(1000, 'x')) == std::string(500, 'x') + "...");
  CHECK(text_fault("h\xc3\xb6he\n\t") == "");
  CHECK(text_fault("\xf4\x90\x80\x80") == "is not UTF-8");
  CHECK(text_fault("x\x1b[2J") == "holds the control character \\x1B");
}

TEST_CASE("the first hundred messages are shown, and each once") {
  auto source = std::make_shared<Source>(Source{"q.yaml", {}});
  Diagnostics diagnostics;
  for (int i = 0; i < 100'000; ++i) diagnostics.error({source, i % 1000 + 1, 1}, "x", "wrong");
  CHECK(diagnostics.all().size() == 1000);
  CHECK(diagnostics.to_text().ends_with("q.yaml:100:1: error: x: wrong\nand 900 more\n"));
}
