#pragma once
// Tables of records as columns of bytes. A table is described once, by a walk over its columns, and the same
// walk writes and reads it, so that the two cannot drift apart.

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace flyrock {

/// Bytes that are not what a column should be.
struct ColumnError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ColumnWriter {
 public:
  const std::string& bytes() const { return bytes_; }

  template <class T>
  void value(const T& v) {
    if constexpr (std::is_same_v<T, std::string>) {
      value(static_cast<std::uint64_t>(v.size()));
      bytes_ += v;
    } else if constexpr (std::is_same_v<T, double>) {
      value(std::bit_cast<std::uint64_t>(v));
    } else {
      const auto word = static_cast<std::uint64_t>(v);
      std::array<char, 8> little;  // at once: byte by byte takes most of the time of a table
      for (std::size_t i = 0; i < little.size(); ++i) little[i] = static_cast<char>(word >> 8 * i);
      bytes_.append(little.data(), little.size());
    }
  }

  template <class Row>
  void rows(const std::vector<Row>& rows) {
    value(static_cast<std::uint64_t>(rows.size()));
  }

  /// One column after the other; `get` is a member pointer or a function from a row to a reference.
  template <class Row, class... Get>
  void columns(const std::vector<Row>& rows, Get... get) {
    (column(rows, get), ...);
  }

 private:
  template <class Row, class Get>
  void column(const std::vector<Row>& rows, Get get) {
    for (const Row& row : rows) value(std::invoke(get, row));
  }

  std::string bytes_;
};

/// Throws ColumnError where the bytes end early.
class ColumnReader {
 public:
  explicit ColumnReader(std::string_view bytes) : rest_(bytes) {}
  bool at_end() const { return rest_.empty(); }

  template <class T>
  void value(T& v) {
    if constexpr (std::is_same_v<T, std::string>) {
      v = std::string(take(word()));
    } else if constexpr (std::is_same_v<T, double>) {
      v = std::bit_cast<double>(word());
    } else {
      v = static_cast<T>(word());
    }
  }

  template <class Row>
  void rows(std::vector<Row>& rows) {
    const std::uint64_t count = word();
    if (count > rest_.size() / 8) throw ColumnError("more rows than bytes");  // a row has a word at least
    rows.resize(count);
  }

  template <class Row, class... Get>
  void columns(std::vector<Row>& rows, Get... get) {
    (column(rows, get), ...);
  }

 private:
  template <class Row, class Get>
  void column(std::vector<Row>& rows, Get get) {
    for (Row& row : rows) value(std::invoke(get, row));
  }

  std::uint64_t word() {
    std::uint64_t w = 0;
    const std::string_view bytes = take(8);
    for (int i = 7; i >= 0; --i) w = w << 8 | static_cast<unsigned char>(bytes[i]);
    return w;
  }

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw ColumnError("cut short");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace flyrock
