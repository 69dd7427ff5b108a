#include "document/value.h"

#include <catch2/catch.hpp>

#include "document/yaml_reader.h"

using namespace flyrock;

namespace {
Value read(const std::string& text) {
  Diagnostics diagnostics;
  auto value = read_yaml(text, "s.yaml", diagnostics);
  INFO(text + diagnostics.to_text());
  REQUIRE(value);
  return *value;
}
}  // namespace

TEST_CASE("the shortest text of a number") {
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(3) == "3");
  CHECK(shortest(1e300) == "1e+300");
  CHECK(shortest(100000) == "100000");
  CHECK(shortest(1e-6) == "1e-06");
}

TEST_CASE("YAML text reads back as the same tree") {
  const std::string text =
      "a: [1, 2.5, true, \"true\", \"7\", \"010\", \"a: b\", 12 m, \"\", \" x\", \"-\", -3 m, "
      "\"line\\nbreak\"]\n"
      "b: { c: [], d: { e: off, f: \"#x\" } }\n"
      "rocks:\n"
      "  - { name: blocks, shape: { type: polygon, vertices: [[0, 0], [1, 0], [1, 1], [0, 1]] }, density: "
      "2700 }\n"
      "  - name: loose\n"
      "    list: [[0.111111111111, 0.222222222222], [0.3333333333333, 0.44444444444], [0.5555555555555, "
      "0.666666666]]\n";
  const Value root = read(text);
  const std::string once = to_yaml(root);
  CHECK(to_yaml(read(once)) == once);
  CHECK(to_json(read(once)) == to_json(root));
  CHECK(once.find("a: [1, 2.5, true") != std::string::npos);
}

TEST_CASE("JSON shows whole numbers without a point") {
  CHECK(to_json(read("{ a: 3, b: 0.5, c: [true, x] }"), -1) == R"({"a":3,"b":0.5,"c":[true,"x"]})");
}
