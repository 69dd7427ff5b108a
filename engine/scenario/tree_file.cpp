#include "scenario/tree_file.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "document/printable.h"
#include "document/wording.h"
#include "plugin/params.h"
#include "plugin/words.h"

namespace flyrock {

namespace {

constexpr std::array<std::string_view, 5> columns = {"x", "y", "dbh_cm", "height_m", "species"};
constexpr std::size_t numbers = 4;

class TreeFile {
 public:
  TreeFile(const std::string& path, const std::map<std::string, double>& strengths)
      : path_(path), strengths_(strengths), file_(path, std::ios::binary) {
    if (!file_) throw PluginError(fmt::format("cannot read the file {}", path));
  }

  std::vector<Stem> read() {
    if (!next_line()) fail(1, fmt::format("the file is empty, expected the header {}", header()));
    read_header();
    std::vector<Stem> stems;
    while (next_line()) stems.push_back(stem());
    return stems;
  }

 private:
  struct Field {
    std::string_view text;
    std::size_t column;  ///< from 1
  };

  [[noreturn]] void fail(std::size_t column, const std::string& text) const {
    throw PluginError(fmt::format("{}:{}:{}: {}", path_, std::max(line_, 1), column, text));
  }

  static std::string header() { return fmt::format("{}", fmt::join(columns, ",")); }

  /// The next line that is not empty, cut into its fields without blanks around them.
  bool next_line() {
    while (std::getline(file_, text_)) {
      ++line_;
      fields_.clear();
      std::string_view rest = text_;
      if (line_ == 1 && rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
      if (rest.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      for (std::size_t at = 0; at <= rest.size();) {
        const std::size_t end = std::min(rest.find(',', at), rest.size());
        const std::size_t first = std::min(rest.find_first_not_of(" \t\r", at), end);
        std::size_t last = end;
        while (last > first && std::string_view(" \t\r").find(rest[last - 1]) != std::string_view::npos)
          --last;
        fields_.push_back({rest.substr(first, last - first), first + 1});
        at = end + 1;
      }
      return true;
    }
    return false;
  }

  void read_header() {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (i >= columns.size() || fields_[i].text != columns[i])
        fail(fields_[i].column, fmt::format("`{}` is not the name of column {}, expected the header {}",
                                            printable(fields_[i].text), i + 1, header()));
    if (fields_.size() < numbers)
      fail(text_.size() + 1, fmt::format("the header ends here, expected {}", header()));
    count_ = fields_.size();
  }

  double number(std::size_t column, double least, double most) {
    double value = 0;
    const Field& field = fields_[column];
    if (!to_number(field.text, value))
      fail(field.column,
           fmt::format("`{}` is not a number, expected `{}`", printable(field.text), columns[column]));
    if (!(value >= least && value <= most))
      fail(field.column, fmt::format("`{}` is {:.10g}, expected a number from {:g} to {:g}", columns[column],
                                     value, least, most));
    return value;
  }

  Stem stem() {
    if (fields_.size() != count_)
      fail(fields_.size() < count_ ? text_.size() + 1 : fields_[count_].column,
           fmt::format("the line has {} values, expected {}", fields_.size(), count_));
    Stem stem;
    stem.place = {number(0, -1e8, 1e8), number(1, -1e8, 1e8)};
    stem.radius = number(2, 0.1, 1000) / 200;
    stem.height = number(3, 0.1, 200);
    if (count_ <= numbers || strengths_.empty()) return stem;
    const Field& species = fields_[numbers];
    const auto known = strengths_.find(std::string(species.text));
    if (known == strengths_.end()) {
      std::vector<std::string> names;
      for (const auto& [name, strength] : strengths_) names.push_back(name);
      fail(species.column, fmt::format("`{}` is not a species of `forest.species`{}", printable(species.text),
                                       suggestion(std::string(species.text), names)));
    }
    stem.strength = known->second;
    return stem;
  }

  const std::string& path_;
  const std::map<std::string, double>& strengths_;
  std::ifstream file_;
  std::string text_;
  int line_ = 0;
  std::vector<Field> fields_;
  std::size_t count_ = 0;  ///< of columns
};

}  // namespace

std::vector<Stem> read_trees(const std::string& path, const std::map<std::string, double>& strengths) {
  return TreeFile(path, strengths).read();
}

}  // namespace flyrock
