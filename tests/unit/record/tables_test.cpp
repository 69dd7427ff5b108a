#include "record/tables.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

using namespace flyrock;

TEST_CASE("docs/results.md names every column of every table") {
  std::ifstream file(FLYROCK_SOURCE_DIR "/docs/results.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  int columns = 0;
  const auto visit = [&](const Column& column, auto) {
    if (!column.name) return;
    ++columns;
    INFO(column.name);
    CHECK(page.find(std::string("`") + column.name + "`") != std::string::npos);
  };
  visit_tables(none_of_the_records,
               [&](const Table&, const auto&, auto visit_columns) { visit_columns(visit); });
  CHECK(columns > 140);
}
