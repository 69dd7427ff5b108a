#include "load/confined.h"

#include <fmt/format.h>

#include "document/node.h"
#include "document/printable.h"
#include "document/workbook.h"

namespace flyrock {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_path = 4096;

/// Whether there is something of this name, and it is outside of the folder, whose path is canonical.
bool leads_out(const std::string& name, const fs::path& folder) {
  if (name.empty() || name.size() > longest_path || name.find('\0') != name.npos) return false;
  std::error_code code;
  if (!fs::exists(fs::symlink_status(folder / name, code))) return false;
  const fs::path target = fs::weakly_canonical(folder / name, code);
  if (code) return true;
  const fs::path inside = target.lexically_relative(folder);
  return inside.empty() || *inside.begin() == "..";
}

void visit(const Node& node, const fs::path& folder, Diagnostics& diagnostics) {
  if (const std::string* text = node.value->text(); text && leads_out(sheet_name(*text).file, folder))
    node.error(diagnostics, fmt::format("`{}` is outside of the scenario's folder, which --confined refuses",
                                        printable(*text, 200)));
  if (node.value->list())
    for (const Node& item : node.items()) visit(item, folder, diagnostics);
  if (node.value->map())
    for (const Entry& entry : *node.value->map())
      if (const auto child = node.find(entry.key)) visit(*child, folder, diagnostics);
}

}  // namespace

void refuse_outer_files(const Value& tree, const fs::path& folder, Diagnostics& diagnostics) {
  visit(Node::root(tree), fs::canonical(folder.empty() ? fs::path(".") : folder), diagnostics);
}

}  // namespace flyrock
