#include "scenario/tree_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "document/printable.h"
#include "document/table.h"
#include "document/wording.h"
#include "scenario/layer_table.h"

namespace flyrock {

namespace {

const std::vector<TableColumn>& tree_columns() {
  static const std::vector<TableColumn> columns = {
      {.name = "x", .dimension = dimension::length, .required = true, .also = {"rechtswert"}},
      {.name = "y", .dimension = dimension::length, .required = true, .also = {"hochwert"}},
      {.name = "dbh",
       .dimension = dimension::length,
       .required = true,
       .also = {"diameter", "d", "d130", "d13", "bhd", "dap"}},
      {.name = "height",
       .dimension = dimension::length,
       .required = true,
       .also = {"h", "tree_height", "hoehe"}},
      {.name = "species", .dimension = {}, .is_text = true, .also = {"sp", "tree_species", "baumart"}},
  };
  return columns;
}

/// A size of trees: what one tree may have, and what the median of a wood may be [m].
struct TreeSize {
  const char* column;
  double least, most;
  double least_median, most_median;
};
constexpr std::array<TreeSize, 2> tree_sizes = {
    {{"dbh", 0.001, 10, 0.02, 3}, {"height", 0.1, 200, 0.5, 120}}};

class TreeReader {
 public:
  TreeReader(const TextTable& table, const std::map<std::string, double>& strengths, const Node& where,
             Diagnostics& diagnostics)
      : table_(table), strengths_(strengths), where_(where), diagnostics_(diagnostics) {}

  std::optional<TreeFile> read() {
    const std::size_t before = diagnostics_.errors_given();
    for (const TreeSize& size : tree_sizes) check_median(size);
    if (diagnostics_.errors_given() > before) return std::nullopt;
    TreeFile file;
    for (std::size_t row = 0; row < table_.rows(); ++row) file.stems.push_back(stem(row));
    file.other_heads = table_.ignored();
    file.summary = table_.summary();
    if (diagnostics_.errors_given() > before) return std::nullopt;
    return file;
  }

 private:
  /// The median shows numbers in another unit than their head says.
  void check_median(const TreeSize& size) {
    std::vector<double> values;
    for (std::size_t row = 0; row < table_.rows(); ++row)
      if (const auto value = table_.number(row, size.column)) values.push_back(*value);
    if (values.empty()) return;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    const double median = values[values.size() / 2];
    if (median >= size.least_median && median <= size.most_median) return;
    const std::string name = size.column;
    diagnostics_.error(
        table_.at(0, name), where_.path,
        fmt::format(
            "the median of `{}` is {:.4g} m, expected {:g} m to {:g} m of trees: name the unit of its "
            "numbers in its head, `{}_cm` or `{}_m`",
            name, median, size.least_median, size.most_median, name, name));
  }

  Stem stem(std::size_t row) {
    Stem stem;
    stem.place = {table_.number(row, "x").value_or(0), table_.number(row, "y").value_or(0)};
    if (!(stem.place.cwiseAbs().maxCoeff() <= 1e8))
      fail(row, "x", fmt::format("the place ({:.6g}, {:.6g}) is on no map", stem.place.x(), stem.place.y()));
    for (const TreeSize& size : tree_sizes) check_size(row, size);
    stem.radius = table_.number(row, "dbh").value_or(0) / 2;
    stem.height = table_.number(row, "height").value_or(0);
    stem.strength = strength(row);
    return stem;
  }

  void check_size(std::size_t row, const TreeSize& size) {
    const double value = table_.number(row, size.column).value_or(0);
    if (!(value >= size.least && value <= size.most))
      fail(row, size.column,
           fmt::format("`{}` is {:.6g} m, expected {:g} m to {:g} m", size.column, value, size.least,
                       size.most));
  }

  double strength(std::size_t row) {
    if (!table_.has("species") || strengths_.empty()) return 1;
    const std::string species(table_.text(row, "species"));
    const auto known = strengths_.find(species);
    if (known != strengths_.end()) return known->second;
    std::vector<std::string> names;
    for (const auto& [name, factor] : strengths_) names.push_back(name);
    fail(row, "species",
         fmt::format("`{}` is not a species of `forest.species`{}", printable(species),
                     suggestion(species, names)));
    return 1;
  }

  /// All lines may be wrong in the same way: the first 20 say so.
  void fail(std::size_t row, const char* column, const std::string& text) {
    constexpr int most = 20;
    if (++faults_ <= most) diagnostics_.error(table_.at(row, column), where_.path, text);
  }

  const TextTable& table_;
  const std::map<std::string, double>& strengths_;
  const Node& where_;
  Diagnostics& diagnostics_;
  int faults_ = 0;
};

}  // namespace

std::optional<TreeFile> read_trees(const std::string& path, const std::map<std::string, double>& strengths,
                                   const std::map<std::string, std::string>& heads, const Node& where,
                                   Diagnostics& diagnostics) {
  const auto table = read_any_table(path, tree_columns(), heads, where, diagnostics);
  if (!table) return std::nullopt;
  return TreeReader(*table, strengths, where, diagnostics).read();
}

}  // namespace flyrock
