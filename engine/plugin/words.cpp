#include "plugin/words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>

#include "plugin/params.h"

namespace flyrock {

namespace {

constexpr std::size_t block_size = 1 << 20;
constexpr std::size_t longest_word = 256;

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

/// A number of at most 15 digits without an exponent: the quotient of
/// two numbers that a double holds exactly is rounded once, and so is the nearest double. Grids of heights
/// hold nothing else.
bool short_number(std::string_view text, double& number) {
  static constexpr double power[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > 16) return false;
  std::int64_t digits = 0;
  int count = 0, behind = 0;
  bool has_point = false;
  for (const char c : text) {
    if (c == '.' && !has_point) {
      has_point = true;
      continue;
    }
    if (c < '0' || c > '9') return false;
    digits = 10 * digits + (c - '0');
    ++count;
    behind += has_point;
  }
  if (count == 0 || count > 15) return false;
  number = static_cast<double>(digits) / power[behind];
  if (negative) number = -number;
  return true;
}

}  // namespace

bool to_number(std::string_view text, double& number) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  if (short_number(text, number)) return true;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && std::isfinite(number);
}

bool is_utf16(std::string_view start) {
  return start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF");
}

Words::Words(std::string who, std::string path)
    : who_(std::move(who)), path_(std::move(path)), file_(path_, std::ios::binary), block_(block_size) {
  if (!file_) throw PluginError(fmt::format("{}: cannot read the file {}", who_, path_));
  refill();
  if (is_utf16({block_.data(), end_})) fail(save_as_utf8);
  if (end_ >= 3 && std::memcmp(block_.data(), "\xEF\xBB\xBF", 3) == 0) at_ = 3;  // byte order mark
  line_begin_ = static_cast<std::int64_t>(at_);
}

/// Moves what is left of the block to its begin and reads on; false at the end of the file.
bool Words::refill() {
  const std::size_t left = end_ - at_;
  std::memmove(block_.data(), block_.data() + at_, left);
  file_.read(block_.data() + left, static_cast<std::streamsize>(block_.size() - left));
  const auto got = static_cast<std::size_t>(file_.gcount());
  at_ = 0;
  end_ = left + got;
  read_ += static_cast<std::int64_t>(got);
  return got > 0;
}

std::string_view Words::next() {
  if (has_ahead_) {
    has_ahead_ = false;
    return ahead_;
  }
  while (true) {
    for (; at_ < end_ && is_blank(block_[at_]); ++at_) {
      if (block_[at_] != '\n') continue;
      ++line_now_;
      line_begin_ = read_ - static_cast<std::int64_t>(end_ - at_) + 1;
    }
    if (at_ == end_) {
      if (refill()) continue;
      line_ = line_now_;
      column_ = read_ - line_begin_ + 1;
      return {};
    }
    std::size_t stop = at_;
    while (stop < end_ && !is_blank(block_[stop])) ++stop;
    if (const std::size_t length = stop - at_; stop == end_ && length <= longest_word) {
      if (refill()) continue;
      stop = at_ + length;  // the file ends with this word, which has moved to the begin of the block
    }
    line_ = line_now_;
    column_ = read_ - static_cast<std::int64_t>(end_ - at_) - line_begin_ + 1;
    if (stop - at_ > longest_word) fail("a word of more than 256 letters, expected a text file of numbers");
    const std::string_view word(block_.data() + at_, stop - at_);
    at_ = stop;
    return word;
  }
}

std::string_view Words::peek() {
  if (!has_ahead_) ahead_ = next();
  has_ahead_ = true;
  return ahead_;
}

double Words::number(std::string_view expected) {
  const std::string_view word = next();
  double number = 0;
  if (to_number(word, number)) return number;
  if (word.empty()) fail(fmt::format("the file ends, expected {}", expected));
  fail(fmt::format("`{}` is not a number, expected {}", word, expected));
}

void Words::fail(const std::string& text) const {
  throw PluginError(fmt::format("{}: {}:{}:{}: {}", who_, path_, line_, column_, text));
}

}  // namespace flyrock
