#pragma once
// What `print` of Lua code says: for its author to look at, so a few lines of each place are enough.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// The first lines that were printed at each place of the Lua code, in their order.
class PrintLog {
 public:
  static constexpr int lines_of_a_place = 10;
  static constexpr std::size_t most_places = 50;

  /// Takes a text, which may have several lines, unless `place` ("my_law.lua:14", or empty) has had its
  /// lines. The line after the last one says that more was dropped. Each line is stored as `printable` makes
  /// it.
  void add(const std::string& place, std::string_view text, std::string (*printable)(std::string_view));
  /// Takes what a later log holds, as if it had been printed here.
  void add(const PrintLog& later);

  bool empty() const { return lines_.empty(); }
  /// The lines that came since they were taken last.
  std::vector<std::string> take();

 private:
  struct Line {
    std::string place, text;
  };
  void add_line(const std::string& place, std::string text);

  std::vector<Line> lines_;
  std::map<std::string, int> count_;  // lines of each place, the dropped ones included
};

}  // namespace flyrock
