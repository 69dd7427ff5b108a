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

TEST_CASE("messages name characters that are not what they look like") {
  const auto said = [](const std::string& text) {
    Diagnostics diagnostics;
    diagnostics.error({}, "", text);
    return diagnostics.to_text();
  };
  CHECK(said("found `1\u00a0kg`") ==
        "error: found `1<U+00A0>kg` (U+00A0 is a no-break space, write a blank)\n");
  CHECK(said("found `1 k\u200bg`") ==
        "error: found `1 k<U+200B>g` (U+200B is a space without a width, remove it)\n");
  CHECK(said("found `\ufeff1`") == "error: found `<U+FEFF>1` (U+FEFF is a byte order mark, remove it)\n");
  CHECK(said("found `\u22121`") == "error: found `\u22121` (U+2212 is the minus sign, write `-`)\n");
  CHECK(said("found `\u20131`") == "error: found `\u20131` (U+2013 is an en dash, write `-`)\n");
  CHECK(said("found `\uff15`") == "error: found `\uff15` (U+FF15 is a wide character, write `5`)\n");
  CHECK(said("h\u00f6he \u00b0 \u00b2 \u4e2d") == "error: h\u00f6he \u00b0 \u00b2 \u4e2d\n");
  for (int code = 0x202A; code <= 0x2069; code += code == 0x202E ? 0x2066 - 0x202E : 1) {
    const std::string mark{'\xE2', static_cast<char>(0x80 | (code >> 6 & 0x3F)),
                           static_cast<char>(0x80 | (code & 0x3F))};
    INFO(code);
    CHECK(printable(mark).find("U+20") == 1);
    CHECK(said(mark).find(mark) == std::string::npos);
  }
  // Bytes that are no UTF-8 are none of these characters.
  CHECK(said("a\xc2 b\xa0") == "error: a\\xC2 b\\xA0\n");
  Diagnostics diagnostics;  // a warning shows the codes, and tells nobody what to write
  diagnostics.warning({}, "", "`a\u00a0b`");
  CHECK(diagnostics.to_text() == "warning: `a<U+00A0>b`\n");
}

TEST_CASE("the first hundred messages are shown, and each once") {
  auto source = std::make_shared<Source>(Source{"q.yaml", {}});
  Diagnostics diagnostics;
  for (int i = 0; i < 100'000; ++i) diagnostics.error({source, i % 1000 + 1, 1}, "x", "wrong");
  CHECK(diagnostics.all().size() == 1000);
  CHECK(diagnostics.to_text().ends_with("q.yaml:100:1: error: x: wrong\nand 900 more\n"));
}
