#include "document/table.h"

#include <catch2/catch.hpp>

#include "../../temporary_file.h"
#include "document/value.h"

using namespace flyrock;

namespace {

const std::vector<TableColumn> test_columns = {{"name", {}, true},
                                               {"mass", dimension::mass, false, true},
                                               {"vx", dimension::speed},
                                               {"time", dimension::time},
                                               {"charge", {-1, 1, 0, 0}}};

struct TableRead {
  std::optional<TextTable> table;
  std::string errors;
};

TableRead read_csv(const std::string& text, const std::map<std::string, std::string>& heads = {}) {
  const TemporaryFile file("table.csv", text);
  Value value;
  Diagnostics diagnostics;
  TableRead result;
  result.table = read_table(file.path, test_columns, heads, Node{&value, {}, "rocks", "", ""}, diagnostics);
  for (const Diagnostic& one : diagnostics.all())
    result.errors +=
        std::to_string(one.at.line) + ":" + std::to_string(one.at.column) + ": " + one.text + "\n";
  return result;
}

}  // namespace

TEST_CASE("a table has heads in any order with units, and further columns") {
  const TableRead file =
      read_csv("vx_m_s,colour,charge_kg_per_m,mass_t,time_ms,name\n2,red,7.5,0.25,17,\"a, b\"\n,,,1e-3,,c\n");
  REQUIRE(file.errors == "");
  const TextTable& table = *file.table;
  CHECK(table.rows() == 2);
  CHECK(table.number(0, "vx") == 2.0);
  CHECK(table.number(0, "charge") == 7.5);
  CHECK(table.number(0, "mass") == 250.0);
  CHECK(table.number(0, "time") == 0.017);
  CHECK(table.text(0, "name") == "a, b");
  CHECK_FALSE(table.number(1, "vx"));
  CHECK(table.number(1, "mass") == 1.0);
  CHECK(table.ignored() == std::vector<std::string>{"colour"});
  CHECK(table.at(1, "name").column == 10);
}

TEST_CASE("a table of a spreadsheet: byte order mark, semicolons, commas of decimals, CRLF, other heads") {
  const TableRead file =
      read_csv("\xef\xbb\xbfGewicht [t];mass_old\r\n1,5;3\r\n\r\n", {{"mass", "Gewicht [t]"}});
  REQUIRE(file.errors == "");
  CHECK(file.table->rows() == 1);
  CHECK(file.table->number(0, "mass") == 1500.0);
}

TEST_CASE("a table names each fault with line and column") {
  CHECK(read_csv("mass,vx\n1,fast\n,2\n1,2,3\nnan,1\n").errors ==
        "2:3: `fast` is not a number, expected `vx`\n"
        "3:1: `mass` is empty\n"
        "4:1: the line has 3 values, the heads are 2\n"
        "5:1: `nan` is not a number, expected `mass`\n");
  CHECK(read_csv("mas,vx\n1,2\n").errors ==
        "1:1: no column is `mass` (in kg, or `mass` with a unit), did you mean `mas`?\n");
  CHECK(read_csv("mass,mass_kg\n1,2\n").errors == "1:6: `mass_kg` is a second column of `mass`\n");
  CHECK(read_csv("mass,H\xF6he\n1,2\n").errors ==
        "1:1: the line is not UTF-8, expected a table saved as UTF-8\n");
  CHECK(read_csv("mass\n").errors == "1:1: the table has no line but its heads\n");
  CHECK(read_csv("mass\n1\n", {{"vx", "speed"}}).errors ==
        "1:1: no head is `speed`, which `columns` names for `vx`, expected `mass`\n");
}

TEST_CASE("a table may be apart by blanks, and names the separator where it is another") {
  const TableRead blanks = read_csv("name mass_t   vx\n a 1,5 2\n");
  REQUIRE(blanks.errors == "");
  CHECK(blanks.table->number(0, "mass") == 1500.0);
  CHECK(read_csv("mass;vx\n1,2\n").errors ==
        "2:1: the line has 1 value, the heads are 2: its values are apart by commas, the heads by "
        "semicolons\n");
  CHECK(read_csv("mass,vx\n1 2\n").errors ==
        "2:1: the line has 1 value, the heads are 2: its values are apart by blanks, the heads by commas\n");
  CHECK(read_csv("mass,vx\n1,5,2,5\n").errors ==
        "2:1: the line has 4 values, the heads are 2: with commas in decimals, separate the values by "
        "semicolons\n");
}
