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

TEST_CASE("a table with a title line is refused, and the line of its heads named") {
  CHECK(read_csv("Blast 24,,\nname,mass_kg,vx\nA,1,2\n").errors ==
        "1:1: line 1 has no known head, line 2 has: delete the lines above line 2\n");
  CHECK(read_csv("A,1,2\nname,mass,vx\nB,1,2\n").errors ==
        "1:1: line 1 has no known head, line 2 has: delete the lines above line 2\n");
  CHECK(read_csv("Results of the blast\n\nname;mass;vx\nB;1;2\n").errors ==
        "1:1: line 1 has no known head, line 3 has: delete the lines above line 3\n");
}

TEST_CASE("rows of empty cells are none, rows that sum up others are an error") {
  const TableRead blank = read_csv("name,mass\nA,1\n,\n\nB,2\n,,,\n");
  REQUIRE(blank.errors == "");
  CHECK(blank.table->rows() == 2);
  CHECK(read_csv("name,mass\nA,1\nTotal,1\n").errors ==
        "3:1: the row `Total` sums up others, and is no record: delete it\n");
  CHECK(read_csv("colour,mass\nred,1\nMean:,1\n").errors ==
        "3:1: the row `Mean:` sums up others, and is no record: delete it\n");
}

TEST_CASE("times without a unit are an error, as angles are, but for 0") {
  CHECK(read_csv("mass,time\n1,0\n1,17\n").errors == "1:6: `time` needs a unit: `time_ms` or `time_s`?\n");
  CHECK(read_csv("mass,time\n1,0\n1,0\n").errors == "");
}

TEST_CASE("a table has one decimal sign") {
  CHECK(read_csv("mass;vx\n1.5;2\n1,5;2\n").errors ==
        "3:1: `1,5` has a decimal comma and `1.5` of line 2 a point, expected one sign in a table\n");
  CHECK(read_csv("mass;vx\n1,5;2\n1,5;2.5\n").errors ==
        "3:5: `2.5` has a decimal point and `1,5` of line 2 a comma, expected one sign in a table\n");
}

TEST_CASE("a table of a spreadsheet: its separator in the first line, line breaks in heads, hard blanks") {
  const TableRead named = read_csv("sep=;\nname;mass (t)\nA;2\n");
  REQUIRE(named.errors == "");
  CHECK(named.table->number(0, "mass") == 2000.0);
  const TableRead broken = read_csv("name,\"mass\n(t)\"\nA,2\n");
  REQUIRE(broken.errors == "");
  CHECK(broken.table->number(0, "mass") == 2000.0);
  CHECK(broken.table->at(0, "name").line == 3);
  const TableRead hard = read_csv("name;mass\xc2\xa0[t]\nA;2\xc2\xa0\n");
  REQUIRE(hard.errors == "");
  CHECK(hard.table->number(0, "mass") == 2000.0);
  CHECK(
      read_csv("name,mass\nA,\"2\n").errors.starts_with("2:1: the line opens a quote that is never closed"));
  CHECK(read_csv("mass;vx\nkg;m/s\n1;2\n").errors ==
        "2:1: `kg` is a unit, expected it in the head of its column: `mass [kg]`\n"
        "2:4: `m/s` is a unit, expected it in the head of its column: `vx [m/s]`\n");
}

TEST_CASE("a workbook and a text in UTF-16 are named") {
  CHECK(read_csv("\xd0\xcf\x11\xe0").errors.find("is a workbook of an old form (xls)") != std::string::npos);
  CHECK(read_csv("\xff\xfem\x01").errors.find("is a text in UTF-16") != std::string::npos);
}

TEST_CASE("a head that goes on with no unit is an error, and `columns` is the way out") {
  CHECK(read_csv("mass_kg,vx_mean\n1,2\n").errors ==
        "1:9: `vx_mean` begins as `vx` does, but `mean` is no unit like m/s: expected `vx [m/s]`, or another "
        "name; `columns: { vx: HEAD }` says which head it is\n");
  CHECK(read_csv("mass_kg,vx_mean\n1,2\n", {{"vx", "vx_mean"}}).errors == "");
}

TEST_CASE("what was read is summed up in a line") {
  const TableRead file = read_csv("name,mass (t),time_ms,colour,vx\nA,1.5,0,x,\nB,3,34,y,\n");
  REQUIRE(file.errors == "");
  CHECK(file.table->summary() == "2 rows; mass 1.5 to 3 t, time 0 to 34 ms, vx empty; not read: `colour`");
  CHECK(read_csv("mass,charg_kg_per_m\n1,2\n").table->summary() ==
        "1 row; mass 1 kg; not read: `charg_kg_per_m`, did you mean `charge`?");
}
