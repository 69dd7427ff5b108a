#include "document/yaml_reader.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

using namespace flyrock;

namespace yaml_reader_test {

namespace {

Value read(const std::string& text) {
  Diagnostics diagnostics;
  auto value = read_yaml(text, "s.yaml", diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(value);
  CHECK(diagnostics.all().empty());
  return *value;
}

/// The messages of a text that must not be read, without the quoted lines.
std::string refuse(const std::string& text) {
  Diagnostics diagnostics;
  CHECK_FALSE(read_yaml(text, "s.yaml", diagnostics));
  std::string lines;
  for (const Diagnostic& d : diagnostics.all())
    lines += fmt::format("{}:{}:{}:{}\n", d.at.line, d.at.column, d.path, d.text);
  return lines;
}

}  // namespace

TEST_CASE("plain scalars become numbers, true and false, nothing or text") {
  const Value root = read("a: 1.5\nb: true\nc: off\nd: \"7\"\ne:\nf: yes\ng: 12 m\nh: ~\ni: '.nan'\n");
  CHECK(*root.find("a")->number() == 1.5);
  CHECK(*root.find("b")->boolean());
  CHECK(*root.find("c")->text() == "off");
  CHECK(*root.find("d")->text() == "7");
  CHECK(root.find("e")->is_null());
  CHECK(*root.find("f")->text() == "yes");
  CHECK(*root.find("g")->text() == "12 m");
  CHECK(root.find("h")->is_null());
  CHECK(*root.find("i")->text() == ".nan");
  CHECK(root.find("z") == nullptr);
}

TEST_CASE("places count from 1, and characters") {
  const Value root = read("terrain:\n  type: benches\n  é: { ü: 3 }\n");
  const Value& type = *root.find("terrain")->find("type");
  CHECK(type.at.line == 2);
  CHECK(type.at.column == 9);
  CHECK(root.find("terrain")->find("é")->find("ü")->at.column == 11);
  CHECK(root.map()->front().at.line == 1);
  CHECK(root.map()->front().at.column == 1);
}

TEST_CASE("010 is text that is marked, never eight") {
  const Value root = read("a: 010\nb: 0.10\nc: -007\nd: 0\ne: '010'\n");
  CHECK(root.find("a")->leading_zero);
  CHECK(*root.find("a")->text() == "010");
  CHECK(*root.find("b")->number() == 0.1);
  CHECK(root.find("c")->leading_zero);
  CHECK_FALSE(root.find("d")->leading_zero);
  CHECK_FALSE(root.find("e")->leading_zero);
}

TEST_CASE("aliases are copies") {
  const Value root = read("a: &x { b: [1, 2] }\nc: *x\n");
  CHECK(root.find("c")->find("b")->list()->size() == 2);
}

TEST_CASE("what a scenario file must not hold") {
  CHECK(refuse("a: 1\nb: 2\na: 3\n") == "3:1:a:duplicate key, the first one is in line 1\n");
  CHECK(refuse("r:\n  - a: 1\n    a: 3\n") == "3:5:r.0.a:duplicate key, the first one is in line 2\n");
  CHECK(refuse("a: .nan\nb: -.inf\n") ==
        "1:4:a:`.nan` is not a finite number\n2:4:b:`-.inf` is not a finite number\n");
  CHECK(refuse("a: &x { b: 1 }\nc: { <<: *x }\n") ==
        "2:6:c:merge keys (`<<`) are not supported: write the keys out\n");
  CHECK(refuse("a: 1\n---\nb: 2\n") == "3:1::a second document: a scenario is one document\n");
  CHECK(refuse("12: a\n") == "1:1::a key must be text, this one is a number\n");
  CHECK(refuse("? [a, b]\n: c\n") == "1:3::a key must be text, this one is a list\n");
  CHECK(refuse("a: !!int 3\n") == "1:4::a tag (`tag:yaml.org,2002:int`) is not part of a scenario\n");
  CHECK(refuse("a:\n\tb: 1\n") == "2:1::a tab in the indentation, YAML takes blanks only\n");
  CHECK(refuse("a: &x [1, *x]\n") == "1:11::an alias inside its own anchor has no end\n");
  CHECK(refuse("") == "1:1::the file is empty\n");
  CHECK(refuse("# nothing\n") == "1:1::the file is empty\n");
  CHECK(refuse("a: [1, 2\nb: 3\n").find("not YAML: ") != std::string::npos);
}

TEST_CASE("an alias bomb is refused, quickly") {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 12; ++i) {
    std::string items;
    for (int k = 0; k < 10; ++k) items += fmt::format("{}*a{}", k ? ", " : "", i - 1);
    text += fmt::format("a{0}: &a{0} [{1}]\n", i, items);
  }
  CHECK(refuse(text).find("more than 100000 values, aliases expanded") != std::string::npos);
  CHECK(refuse(std::string(5000, '[')).find("not YAML: ") != std::string::npos);
}

}  // namespace yaml_reader_test
