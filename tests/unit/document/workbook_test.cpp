#include "document/workbook.h"

#include <catch2/catch.hpp>

#include "../../temporary_file.h"
#include "../../workbook_file.h"
#include "document/table.h"
#include "document/value.h"

using namespace flyrock;
using namespace workbooks;

namespace workbook_test {

const std::vector<TableColumn> hole_columns = {{"hole", {}, true},
                                               {"x", dimension::length},
                                               {"burden", dimension::length, false, true},
                                               {"time", dimension::time},
                                               {"share", dimension::none}};

struct SheetRead {
  std::optional<TextTable> table;
  std::string errors;  ///< "line:column: text" each
  std::string sheet;   ///< of the first message
};

SheetRead read_workbook(const std::string& bytes, const std::string& sheet = "",
                        TableForm form = TableForm::heads) {
  const TemporaryFile file("holes.xlsx", bytes);
  Value value;
  Diagnostics diagnostics;
  SheetRead result;
  result.table =
      read_table(file.path + sheet, hole_columns, {}, Node{&value, {}, "holes", "", ""}, diagnostics, form);
  for (const Diagnostic& one : diagnostics.all()) {
    std::string text = one.text;
    if (const std::size_t at = text.find(file.path); at != text.npos)
      text.replace(at, file.path.size(), "FILE");
    result.errors += fmt::format("{}:{}: {}\n", one.at.line, one.at.column, text);
    if (result.sheet.empty() && one.at.source) result.sheet = one.at.source->name.substr(file.path.size());
  }
  return result;
}

std::string fault_of(const std::string& bytes, const std::string& sheet = "") {
  return read_workbook(bytes, sheet).errors;
}

const std::vector<std::vector<std::string>> three_holes = {
    {"Hole ID", "x", "Burden (m)", "time_ms", "note"},
    {"A1", "0", "3.0", "0", ""},
    {},
    {"A2", "3.2", "2.9", "17", "tight, &quot;near&quot;"},
    {"7", "6.4", "1.9", "34", ""}};

void check_three_holes(const SheetRead& read) {
  REQUIRE(read.errors == "");
  const TextTable& table = *read.table;
  REQUIRE(table.rows() == 3);
  CHECK(table.text(0, "hole") == "A1");
  CHECK(table.text(2, "hole") == "7");
  CHECK(table.number(1, "burden") == 2.9);
  CHECK(table.number(2, "time") == 0.034);
  CHECK(table.at(1, "hole").line == 4);
  CHECK(table.ignored() == std::vector<std::string>{"note"});
}

}  // namespace workbook_test
using namespace workbook_test;

TEST_CASE("a sheet of xlsx is a table: its rows are lines, its empty rows none") {
  const std::string sheet = xlsx_sheet(three_holes);
  check_three_holes(read_workbook(xlsx_of({{"Holes", sheet}})));
  check_three_holes(read_workbook(xlsx_of({{"Notes", xlsx_sheet({{"a"}})}, {"Holes", sheet}}), "#Holes"));
}

TEST_CASE("texts of xlsx are shared and formatted, and its elements may have a prefix") {
  const std::string texts =
      "<si><t>hole</t></si><si><r><t>bur</t></r><r><t>den</t></r><rPh><t>?</t></rPh></si><si><t>B 1</t></si>";
  const SheetRead shared = read_workbook(xlsx_of(
      {{"S", R"(<sheetData><row r="2"><c r="B2" t="s"><v>0</v></c><c r="D2" t="s"><v>1</v></c></row>)"
             R"(<row r="3"><c r="B3" t="s"><v>2</v></c><c r="D3" s="2"><v>2.5</v></c></row></sheetData>)"}},
      texts));
  REQUIRE(shared.errors == "");
  CHECK(shared.table->text(0, "hole") == "B 1");
  CHECK(shared.table->number(0, "burden") == 2.5);
  CHECK(shared.table->at(0, "hole").line == 3);
  Parts parts = xlsx_parts({{"S", ""}});
  parts[0].second =
      R"(<x:worksheet xmlns:x="s"><x:sheetData><x:row><x:c t="str"><x:v>burden</x:v></x:c></x:row>)"
      R"(<x:row><x:c><x:v>2</x:v></x:c></x:row></x:sheetData></x:worksheet>)";
  CHECK(read_workbook(zip_of(parts)).table->number(0, "burden") == 2.0);
}

TEST_CASE("a sheet of ods is the same table, with its repeated cells and rows") {
  const auto text = [](const std::string& content) {
    return "<table:table-cell office:value-type=\"string\"><text:p>" + content +
           "</text:p></table:table-cell>";
  };
  const auto number = [](const std::string& value) {
    return "<table:table-cell office:value-type=\"float\" office:value=\"" + value +
           "\"><text:p>shown</text:p></table:table-cell>";
  };
  const std::string head = "<table:table-header-rows><table:table-row>" + text("Hole<text:s/>ID") +
                           text("x") + text("Burden (m)") + text("time_ms") + text("note") +
                           "</table:table-row></table:table-header-rows>";
  const std::string none = "<table:table-cell table:number-columns-repeated=\"16380\"/>";
  const std::string rows =
      "<table:table-row>" + text("A1") + number("0") + number("3") + number("0") + none +
      "</table:table-row>" + "<table:table-row table:number-rows-repeated=\"1\">" + none +
      "</table:table-row><table:table-row-group>" + "<table:table-row>" + text("A2") + number("3.2") +
      number("2.9") + number("17") + text("near") + "</table:table-row><table:table-row>" +
      text("<text:span>7</text:span>") + number("6.4") + number("1.9") + number("34") +
      "</table:table-row></table:table-row-group>" +
      "<table:table-row table:number-rows-repeated=\"1048570\">" + none + "</table:table-row>";
  check_three_holes(
      read_workbook(ods_of("<table:table table:name=\"Holes\">" + head + rows + "</table:table>")));
  const SheetRead repeated =
      read_workbook(ods_of("<table:table table:name=\"S\"><table:table-row>" + text("burden") +
                           "</table:table-row><table:table-row table:number-rows-repeated=\"3\">" +
                           number("2") + "</table:table-row></table:table>"));
  REQUIRE(repeated.errors == "");
  CHECK(repeated.table->rows() == 3);
}

TEST_CASE("numbers with a comma in cells of text follow the rules of tables") {
  const SheetRead commas = read_workbook(xlsx_of({{"S", xlsx_sheet({{"hole", "burden"}, {"A", "2,5"}})}}));
  REQUIRE(commas.errors == "");
  CHECK(commas.table->number(0, "burden") == 2.5);
  CHECK(fault_of(xlsx_of({{"S", xlsx_sheet({{"hole", "burden"}, {"A", "2,5"}, {"B", "2.5"}})}}))
            .find("expected one sign in a table") != std::string::npos);
}

TEST_CASE("a date is no number, in each kind of workbook") {
  const SheetRead date = read_workbook(xlsx_of(
      {{"S", "<sheetData>" + xlsx_row({"burden"}) + R"(<row><c s="1"><v>46354</v></c></row></sheetData>)"}}));
  const std::string fault =
      "2:1: `2026-11-28` is not a number, expected `burden`: the format of the cell is a date, expected one "
      "of numbers\n";
  CHECK(date.errors == fault);
  CHECK(date.sheet == "#S");
  const std::string head =
      "<table:table "
      "table:name=\"S\"><table:table-row><table:table-cell><text:p>burden</text:p></table:table-cell>"
      "</table:table-row><table:table-row>";
  CHECK(
      fault_of(ods_of(head + R"(<table:table-cell office:value-type="date" office:date-value="2026-11-28"/>)"
                             "</table:table-row></table:table>")) == fault);
}

TEST_CASE("a share that a sheet shows as 25% is a quarter, and no mass") {
  const auto sheet = [](const std::string& head) {
    return xlsx_of({{"S", "<sheetData>" + xlsx_row({"burden", head}) +
                              R"(<row><c><v>1</v></c><c s="3"><v>0.25</v></c></row></sheetData>)"}});
  };
  for (const char* head : {"share", "share (%)"}) {
    const SheetRead read = read_workbook(sheet(head));
    INFO(read.errors);
    REQUIRE(read.table);
    CHECK(read.table->number(0, "share") == 0.25);
  }
  CHECK(fault_of(sheet("x")) == "2:3: `25%` is not a number, expected `x`\n");
  CHECK(fault_of(xlsx_of({{"S", xlsx_sheet({{"hole", "burden"}, {"(m)", "(m)"}, {"1", "2"}})}})) ==
        "2:5: `(m)` is a unit, expected it in the head of its column: `burden [m]`\n");
}

TEST_CASE("rows that a sheet hides count, and are counted") {
  const std::string head = xlsx_row({"hole", "burden"}), row = xlsx_row({"1", "2"});
  const std::string hidden = "<row hidden=\"1\">" + row.substr(5);
  const SheetRead xlsx =
      read_workbook(xlsx_of({{"S", "<sheetData>" + head + row + hidden + "</sheetData>"}}));
  REQUIRE(xlsx.table);
  CHECK(xlsx.table->summary().starts_with("2 rows, 1 of them hidden in the sheet; "));
  const auto ods_row = [](const std::string& attribute, const std::string& value) {
    return "<table:table-row" + attribute + "><table:table-cell><text:p>" + value +
           "</text:p></table:table-cell></table:table-row>";
  };
  const SheetRead ods =
      read_workbook(ods_of("<table:table table:name=\"S\">" + ods_row("", "burden") + ods_row("", "2") +
                           ods_row(" table:visibility=\"filter\"", "3") +
                           ods_row(" table:visibility=\"collapse\"", "") + "</table:table>"));
  REQUIRE(ods.table);
  CHECK(ods.table->summary().starts_with("2 rows, 1 of them hidden in the sheet; "));
}

TEST_CASE("a page, an XML, a DIF or SYLK file of a spreadsheet program is no table of text") {
  for (const std::string text : {"<html><table>", "\xef\xbb\xbf<?xml version=\"1.0\"?>", "ID;PSCALC3\n",
                                 "TABLE\r\n0,1\r\n\"EXCEL\"\r\n", "{\\rtf1"}) {
    INFO(text);
    CHECK(fault_of(text).find("is no table of text") != std::string::npos);
  }
}

TEST_CASE("merged cells and formulas without a value are refused with their row") {
  const std::string merged = xlsx_sheet({{"hole", "burden"}, {"A", "2"}, {"", "3"}});
  CHECK(
      fault_of(xlsx_of({{"S", merged + R"(<mergeCells><mergeCell ref="A2:A3"/></mergeCells>)"}})) ==
      "2:1: the cell A2 is merged with others, so their rows or columns have no value of their own: unmerge "
      "them\n");
  CHECK(fault_of(xlsx_of({{"S", merged + R"(<mergeCells><mergeCell ref="F2:F3"/></mergeCells>)"}})) == "");
  CHECK(fault_of(xlsx_of(
            {{"S", "<sheetData>" + xlsx_row({"burden"}) + "<row><c><f>1+1</f></c></row></sheetData>"}})) ==
        "2:1: the formula of the cell A2 was never computed: open the workbook in a spreadsheet program and "
        "save "
        "it\n");
}

TEST_CASE("a sheet is named where there are several, and the nearest name is suggested") {
  const std::string two = xlsx_of({{"Holes", xlsx_sheet(three_holes)}, {"Notes", xlsx_sheet({{"a"}})}});
  CHECK(fault_of(two) ==
        "0:0: the file FILE has 2 sheets, `Holes` or `Notes`: write the one that is the table as "
        "`FILE#Holes`\n");
  CHECK(fault_of(two, "#Hole") == "0:0: the file FILE has no sheet `Hole`, did you mean `Holes`?\n");
}

TEST_CASE("a workbook that is cut, damaged, protected or too large is refused in one line") {
  const std::string sound = xlsx_of({{"S", xlsx_sheet(three_holes)}});
  CHECK(fault_of(sound.substr(0, sound.size() / 2)) ==
        "0:0: the file FILE is cut: the list of its parts at its end is missing, copy it again\n");
  std::string damaged = sound;
  damaged[damaged.find("2.9")] = '7';
  CHECK(fault_of(damaged) == "0:0: the file FILE is damaged: a checksum is wrong, copy or save it again\n");
  const Parts parts = xlsx_parts({{"S", xlsx_sheet(three_holes)}});
  CHECK(fault_of(zip_of(parts, 1)) == "0:0: the file FILE is protected by a password: save it without one\n");
  CHECK(fault_of(zip_of(parts, 0, std::size_t{3} << 30))
            .find("3072 MiB when it is unpacked, expected at most") != std::string::npos);
  CHECK(fault_of(zip_of({{"a.txt", "b"}})) ==
        "0:0: the file FILE has no part `xl/workbook.xml`: it is no workbook\n");
  const std::string protected_xlsx =
      "\xd0\xcf\x11\xe0" + std::string("E\0n\0c\0r\0y\0p\0t\0e\0d\0P\0a\0c\0k\0a\0g\0e\0", 32);
  CHECK(fault_of(protected_xlsx) == "0:0: the file FILE is protected by a password: save it without one\n");
  CHECK(fault_of(xlsx_of({{"S", "<sheetData/>"}})).find("#S has no cell with a value") != std::string::npos);
  CHECK(
      fault_of(ods_of(R"(<table:table table:name="S"><table:table-row table:number-rows-repeated="1000000">)"
                      R"(<table:table-cell office:value-type="float" office:value="1")"
                      R"( table:number-columns-repeated="16000"/></table:table-row></table:table>)"))
          .find("of more than 2000000 cells") != std::string::npos);
}

TEST_CASE("points of a sheet without heads are its columns in their order") {
  const SheetRead read =
      read_workbook(xlsx_of({{"S", xlsx_sheet({{"1", "2", "3", "0", "0.5"}, {"5", "6", "7", "0", "0.5"}})}}),
                    "", TableForm::points);
  REQUIRE(read.errors == "");
  CHECK(read.table->rows() == 2);
  CHECK(read.table->number(1, "burden") == 7.0);
}
