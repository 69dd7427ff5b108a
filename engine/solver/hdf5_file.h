#pragma once
// An HDF5 file of numbers and texts: the few calls of the C library that the FCLIB layout and tables need.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flyrock {

/// Whether this build has HDF5. Without it, opening or creating a file throws an error that says so.
bool has_hdf5();

/// Every error is a std::runtime_error with a one-line message that names the file and, if there is one, the
/// path in the file.
class Hdf5File {
 public:
  static Hdf5File open(const std::string& name);    ///< for reading
  static Hdf5File create(const std::string& name);  ///< empty; replaces an existing file
  ~Hdf5File();
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  const std::string& name() const { return name_; }
  bool has(const std::string& path) const;

  /// How many numbers a data set holds. Throws if the bytes of the file cannot hold so many.
  std::size_t count(const std::string& path) const;
  /// All numbers of a data set, in the order of the file.
  std::vector<std::int64_t> integers(const std::string& path) const;
  std::vector<double> doubles(const std::string& path) const;  ///< throws if one is not finite
  /// The number of a data set that holds exactly one.
  std::int64_t integer(const std::string& path) const;
  /// A text; empty if the file has no text of known length there.
  std::string text(const std::string& path) const;

  /// Creates missing groups of the path. Writes integers with 32 bits, as FCLIB does. The file stores no
  /// times.
  void write(const std::string& path, const std::vector<double>& numbers);
  void write(const std::string& path, const std::vector<std::int32_t>& numbers);
  void write(const std::string& path, const std::vector<std::int64_t>& numbers);
  void write(const std::string& path, const std::string& text);
  /// Texts in UTF-8, filled up with zeros to the length of the longest.
  void write(const std::string& path, const std::vector<std::string>& texts);

 private:
  Hdf5File(std::string name, std::int64_t handle) : name_(std::move(name)), handle_(handle) {}

  std::string name_;
  std::int64_t handle_;
};

}  // namespace flyrock
