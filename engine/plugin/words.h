#pragma once
// The words of a large text file, read in blocks.

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace flyrock {

/// Reads words that are apart by blanks and line ends, a block at a time, so that the text of a file needs no
/// memory. Bytes below 33 are blanks. Lines and columns count from 1.
class Words {
 public:
  /// `who` begins each error: "plugin raster". Throws PluginError if the file cannot be opened.
  Words(std::string who, std::string path);

  /// The next word; empty at the end of the file. It is valid until the next call. Throws PluginError if a
  /// word is longer than any number (256 letters).
  std::string_view next();
  /// The next word without reading it.
  std::string_view peek();
  /// The next word as a number. `expected` is what an error says instead: "a height". Throws PluginError.
  double number(std::string_view expected);

  /// Throws PluginError: "plugin raster: FILE:3:17: TEXT", the place of the word that was read last.
  [[noreturn]] void fail(const std::string& text) const;

  std::int64_t line() const { return line_; }

 private:
  bool refill();

  std::string who_, path_;
  std::ifstream file_;
  std::vector<char> block_;
  std::size_t at_ = 0, end_ = 0;  ///< what is left of the block
  std::int64_t line_now_ = 1, line_ = 1;
  std::int64_t line_begin_ = 0;  ///< offset in the file of the present line
  std::int64_t read_ = 0;        ///< offset in the file of the end of the block
  std::int64_t column_ = 1;
  std::string_view ahead_;
  bool has_ahead_ = false;
};

/// A decimal number as programs write it (1, -2.5, +3.0e-4); false if the text is none, or not finite.
bool to_number(std::string_view text, double& number);

/// Whether a file that starts so is text of two bytes a letter ("Unicode text" in Windows programs).
bool is_utf16(std::string_view start);
constexpr const char* save_as_utf8 = "the text is UTF-16: save the file as UTF-8 or ASCII";

}  // namespace flyrock
