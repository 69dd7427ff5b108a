#include "document/table_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "document/printable.h"
#include "document/table_lines.h"
#include "document/workbook.h"

namespace flyrock {

namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
  throw TableTextFault(fmt::format("the file {} {}", file, text), nullptr, 0);
}

TableText sheet_of(const SheetName& name, std::string_view bytes) {
  auto source = std::make_shared<Source>();
  TableText text{source, true, 0};
  source->name = name.sheet.empty() ? name.file : name.file + "#" + name.sheet;
  try {
    Sheet sheet = read_sheet(bytes, name.sheet);
    source->name = name.file + "#" + sheet.name;
    source->lines = std::move(sheet.lines);
    text.hidden_rows = sheet.hidden_rows;
  } catch (const WorkbookFault& fault) {
    if (fault.row == 0) refuse(name.file, fault.what());
    throw TableTextFault(fault.what(), source, fault.row);
  }
  if (source->lines.empty()) refuse(source->name, "has no cell with a value");
  return text;
}

TableText text_of(const std::string& file, const std::string& bytes) {
  auto source = std::make_shared<Source>();
  source->name = file;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    std::string line = bytes.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (source->lines.empty() && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
    source->lines.push_back(std::move(line));
    begin = end + 1;
  }
  return {source, false, 0};
}

}  // namespace

TableText read_table_text(const std::string& path) {
  const SheetName name = sheet_name(path);
  std::ifstream stream(name.file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(name.file))
    throw TableTextFault(fmt::format("cannot read the file {}", name.file), nullptr, 0);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (bytes.empty()) refuse(name.file, "is empty");
  const bool is_sheet = is_workbook(bytes);
  if (const std::string format = other_format(bytes); !is_sheet && !format.empty()) refuse(name.file, format);
  TableText text = is_sheet ? sheet_of(name, bytes) : text_of(name.file, bytes);
  for (std::size_t line = 0; line < text.source->lines.size(); ++line)
    if (const std::string fault = text_fault(text.source->lines[line]); !fault.empty())
      throw TableTextFault(fmt::format("the line {}, expected a table saved as UTF-8", fault), text.source,
                           static_cast<int>(line) + 1);
  return text;
}

}  // namespace flyrock
