#pragma once
// Tables of records as columns of bytes. A table is described once, by a walk over its columns. The same walk
// writes and reads it, so writing and reading cannot differ.
//
// A column of numbers is a byte, then the number of each row. If the byte is 1, all rows have the same number
// and it is stored only once. (In 2D this saves the coordinates that are zero, a third of a trajectory.)

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "record/member_of.h"

namespace flyrock {

/// Bytes that are not a valid column.
struct ColumnError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A table may have this many rows even if the bytes after their count are too few for them, because every
/// column may hold one number for all rows. In a longer table the numbers of some column differ and take 8
/// bytes each.
inline constexpr std::uint64_t most_bare_rows = 1024;

/// One member of every row of a table: where it lies in the first row, and the bytes from one row to the
/// next. So a column is written and read by code for the type of its member, not by code of its own.
template <class Member>
class Members {
 public:
  template <class Rows, class Get>
  Members(Rows& rows, Get get) : size_(rows.size()), step_(sizeof(typename Rows::value_type)) {
    if (!rows.empty()) first_ = reinterpret_cast<Byte*>(&member_of(rows.front(), get));
  }

  std::size_t size() const { return size_; }
  Member& operator[](std::size_t row) const { return *reinterpret_cast<Member*>(first_ + row * step_); }

 private:
  using Byte = std::conditional_t<std::is_const_v<Member>, const char, char>;
  Byte* first_ = nullptr;
  std::size_t size_, step_;
};
template <class Rows, class Get>
Members(Rows& rows, Get get) -> Members<std::remove_reference_t<decltype(member_of(rows.front(), get))>>;

class ColumnWriter {
 public:
  explicit ColumnWriter(std::size_t expected = 0) { bytes_.reserve(expected); }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }
  void raw(std::string_view bytes) { bytes_ += bytes; }

  /// Replaces the whole number at byte `at`.
  void replace(std::size_t at, std::uint64_t word) {
    const Little little = little_endian(word);
    std::copy(little.begin(), little.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  template <class T>
  void value(const T& v) {
    if constexpr (std::is_same_v<T, std::string>) {
      value(static_cast<std::uint64_t>(v.size()));
      bytes_ += v;
    } else {
      const Little little = little_endian(word_of(v));
      bytes_.append(little.data(), little.size());
    }
  }

  template <class Row>
  void rows(const std::vector<Row>& rows) {
    value(static_cast<std::uint64_t>(rows.size()));
  }

  /// Writes one column after the other.
  template <class Row, class... Get>
  void columns(const std::vector<Row>& rows, Get... get) {
    (column(Members(rows, get)), ...);
  }

 private:
  using Little = std::array<char, 8>;
  static Little little_endian(std::uint64_t word) {
    Little little;
    for (std::size_t i = 0; i < little.size(); ++i) little[i] = static_cast<char>(word >> 8 * i);
    return little;
  }
  template <class T>
  static std::uint64_t word_of(const T& v) {
    if constexpr (std::is_same_v<T, double>)
      return std::bit_cast<std::uint64_t>(v);
    else
      return static_cast<std::uint64_t>(v);
  }

  template <class T>
  void column(Members<const T> members) {
    if constexpr (std::is_same_v<T, std::string>) {
      for (std::size_t i = 0; i < members.size(); ++i) value(members[i]);
    } else {
      bool same = true;
      for (std::size_t i = 1; same && i < members.size(); ++i)
        same = word_of(members[i]) == word_of(members[0]);
      bytes_.push_back(static_cast<char>(same));
      const std::size_t count = same ? std::min<std::size_t>(members.size(), 1) : members.size();
      char* at = grown(count * sizeof(Little));
      for (std::size_t i = 0; i < count; ++i, at += sizeof(Little)) {
        const Little little = little_endian(word_of(members[i]));
        std::copy(little.begin(), little.end(), at);
      }
    }
  }

  /// Makes room for `count` more bytes.
  char* grown(std::size_t count) {
    bytes_.resize(bytes_.size() + count);
    return bytes_.data() + bytes_.size() - count;
  }

  std::string bytes_;
};

/// Reads columns. Throws ColumnError if the bytes end early.
class ColumnReader {
 public:
  explicit ColumnReader(std::string_view bytes) : rest_(bytes) {}
  bool at_end() const { return rest_.empty(); }

  template <class T>
  void value(T& v) {
    if constexpr (std::is_same_v<T, std::string>) {
      v = std::string(take(word()));
    } else {
      v = number_of<T>(word());
    }
  }

  template <class Row>
  void rows(std::vector<Row>& rows) {
    const std::uint64_t count = word();
    if (count > std::max<std::uint64_t>(most_bare_rows, rest_.size() / 8))
      throw ColumnError("more rows than its bytes can hold");
    rows.resize(count);
  }

  template <class Row, class... Get>
  void columns(std::vector<Row>& rows, Get... get) {
    (column(Members(rows, get)), ...);
  }

 private:
  template <class T>
  void column(Members<T> members) {
    if constexpr (std::is_same_v<T, std::string>) {
      for (std::size_t i = 0; i < members.size(); ++i) value(members[i]);
    } else {
      const char same = take(1).front();
      if (same != 0 && same != 1) throw ColumnError("a column that is neither one number nor many");
      const std::size_t count = same ? std::min<std::size_t>(members.size(), 1) : members.size();
      const std::string_view words = take(count * sizeof(std::uint64_t));
      const std::size_t stride = same ? 0 : sizeof(std::uint64_t);
      const char* at = words.data();
      for (std::size_t i = 0; i < members.size(); ++i, at += stride) members[i] = number_of<T>(word_at(at));
    }
  }

  template <class T>
  static T number_of(std::uint64_t word) {
    if constexpr (std::is_same_v<T, double>)
      return std::bit_cast<double>(word);
    else
      return static_cast<T>(word);
  }

  /// The little-endian word at `bytes`.
  static std::uint64_t word_at(const char* bytes) {
    std::uint64_t word = 0;
    if constexpr (std::endian::native == std::endian::little)
      std::memcpy(&word, bytes, sizeof(word));
    else
      for (int i = 7; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
    return word;
  }
  std::uint64_t word() { return word_at(take(sizeof(std::uint64_t)).data()); }

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw ColumnError("cut short");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace flyrock
