#pragma once
// Workbooks for tests: archives with the least parts that a reader needs.

#include <fmt/format.h>
#include <zlib.h>

#include <string>
#include <utility>
#include <vector>

namespace workbooks {

using Parts = std::vector<std::pair<std::string, std::string>>;

inline std::string little_endian(std::size_t number, int bytes) {
  std::string result;
  for (int k = 0; k < bytes; ++k, number >>= 8) result += static_cast<char>(number & 0xff);
  return result;
}

/// Stored members. `flags` 1: encrypted; `claimed` above 0: the size that the list gives for each.
inline std::string zip_of(const Parts& parts, unsigned flags = 0, std::size_t claimed = 0) {
  std::string members, list;
  for (const auto& [name, content] : parts) {
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    const std::string fields = little_endian(flags, 2) + little_endian(0, 2) + little_endian(0, 4) +
                               little_endian(checksum, 4) + little_endian(content.size(), 4) +
                               little_endian(claimed > 0 ? claimed : content.size(), 4) +
                               little_endian(name.size(), 2) + little_endian(0, 2);
    list += "PK\x01\x02" + little_endian(20, 2) + little_endian(20, 2) + fields + little_endian(0, 10) +
            little_endian(members.size(), 4) + name;
    members += "PK\x03\x04" + little_endian(20, 2) + fields + name + content;
  }
  return members + list + "PK\x05\x06" + little_endian(0, 4) + little_endian(parts.size(), 2) +
         little_endian(parts.size(), 2) + little_endian(list.size(), 4) + little_endian(members.size(), 4) +
         little_endian(0, 2);
}

/// Sheets by name, each the rows of `sheetData` (`<row>...</row>`) and what follows it. Style 1 shows dates,
/// style 2 "0.00 m" with the unit in quotes, style 3 shares of 100.
inline Parts xlsx_parts(const Parts& sheets, const std::string& texts = "") {
  std::string names, links;
  Parts parts;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    names += fmt::format(R"(<sheet name="{}" sheetId="{}" r:id="rId{}"/>)", sheets[i].first, i + 1, i + 1);
    links += fmt::format(R"(<Relationship Id="rId{}" Type="worksheet" Target="worksheets/sheet{}.xml"/>)",
                         i + 1, i + 1);
    parts.emplace_back(fmt::format("xl/worksheets/sheet{}.xml", i + 1),
                       "<worksheet>" + sheets[i].second + "</worksheet>");
  }
  parts.emplace_back("xl/workbook.xml", "<workbook xmlns:r=\"r\"><sheets>" + names + "</sheets></workbook>");
  parts.emplace_back("xl/_rels/workbook.xml.rels", "<Relationships>" + links + "</Relationships>");
  parts.emplace_back("xl/sharedStrings.xml", "<sst>" + texts + "</sst>");
  parts.emplace_back(
      "xl/styles.xml",
      R"(<styleSheet><numFmts><numFmt numFmtId="164" formatCode="0.00&quot; m&quot;"/></numFmts>)"
      R"(<cellXfs><xf numFmtId="0"/><xf numFmtId="14"/><xf numFmtId="164"/><xf numFmtId="9"/></cellXfs></styleSheet>)");
  return parts;
}

inline std::string xlsx_of(const Parts& sheets, const std::string& texts = "") {
  return zip_of(xlsx_parts(sheets, texts));
}

/// A row of cells: numbers as they are, texts inline.
inline std::string xlsx_row(const std::vector<std::string>& cells) {
  std::string row = "<row>";
  for (const std::string& cell : cells) {
    const bool is_number = !cell.empty() && cell.find_first_not_of("0123456789.-") == cell.npos;
    row += cell.empty() ? std::string("<c/>")
           : is_number  ? "<c><v>" + cell + "</v></c>"
                        : "<c t=\"inlineStr\"><is><t>" + cell + "</t></is></c>";
  }
  return row + "</row>";
}

/// A sheet of one table.
inline std::string xlsx_sheet(const std::vector<std::vector<std::string>>& rows) {
  std::string data;
  for (const auto& row : rows) data += xlsx_row(row);
  return "<sheetData>" + data + "</sheetData>";
}

/// `tables`: elements table:table.
inline std::string ods_of(const std::string& tables) {
  return zip_of(
      {{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
       {"content.xml",
        "<office:document-content xmlns:office=\"o\" xmlns:table=\"t\" xmlns:text=\"x\"><office:body>"
        "<office:spreadsheet>" +
            tables + "</office:spreadsheet></office:body></office:document-content>"}});
}

}  // namespace workbooks
