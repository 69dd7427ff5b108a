#pragma once
// The output of `print` in Lua code. It is for the author of the code, so a few lines of each place are
// enough.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// The first lines printed at each place of the Lua code, in order.
class PrintLog {
 public:
  static constexpr int lines_of_a_place = 10;
  static constexpr std::size_t most_places = 50;

  /// Adds a text, which may have several lines, unless `place` ("my_law.lua:14", or empty) has reached its
  /// limit of lines. A line after the last one says that more was dropped. Each line is stored after
  /// `printable`.
  void add(const std::string& place, std::string_view text, std::string (*printable)(std::string_view));
  /// Adds the lines of a later log as if they had been printed here.
  void add(const PrintLog& later);

  bool empty() const { return lines_.empty(); }
  /// The lines added since the last take().
  std::vector<std::string> take();

 private:
  struct Line {
    std::string place, text;
  };
  void add_line(const std::string& place, std::string text);

  std::vector<Line> lines_;
  std::map<std::string, int> count_;  // lines of each place, including dropped ones
};

}  // namespace flyrock
