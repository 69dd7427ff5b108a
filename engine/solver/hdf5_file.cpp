#include "solver/hdf5_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#ifdef FLYROCK_HAS_HDF5
#include <hdf5.h>
#endif

namespace flyrock {

#ifdef FLYROCK_HAS_HDF5

namespace {

/// An HDF5 identifier that is closed at the end of its scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints its stack of errors on the terminal unless it is told not to.
void be_silent() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

/// How files are opened: without locks, which some file systems do not have. A file is read only after its
/// writer has closed it.
Handle without_locks() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
#if H5_VERSION_GE(1, 10, 7)
  H5Pset_file_locking(access, false, true);
#endif
  return access;
}

/// A data set of a file that is read. A header of a few bytes can claim gigabytes, so the size is compared
/// with the bytes of the file before anything is allocated.
class DataSet {
 public:
  DataSet(hid_t file, const std::string& name, const std::string& path)
      : name_(name),
        where_(fmt::format("{}: {}", name, path)),
        set_(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose) {
    if (set_ < 0) fail("not in the file");
  }

  [[noreturn]] void fail(const char* what) const {
    throw std::runtime_error(fmt::format("{}: {}", where_, what));
  }

  /// The number of elements, which have the type `stored`.
  std::size_t count(hid_t stored) const {
    const Handle space(H5Dget_space(set_), H5Sclose), creation(H5Dget_create_plist(set_), H5Pclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 0) fail("has no sensible size");
    if (count == 0) return 0;
    if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) > 0)
      fail("has its numbers in another file");
    // HDF5 would fill a size without bytes in the file with zeros.
    const hsize_t stored_bytes = std::min(H5Dget_storage_size(set_), bytes_of_file());
    if (stored_bytes == 0) fail("has no data");
    const hsize_t most =
        H5Pget_nfilters(creation) > 0 ? std::max(most_compressed * stored_bytes, small) : stored_bytes;
    const hsize_t element = H5Tget_size(stored);
    if (element == 0) fail("has numbers of no size");
    if (static_cast<hsize_t>(count) > most / element || chunk_bytes(creation, element) > most)
      fail("promises more numbers than the file has bytes for");
    return static_cast<std::size_t>(count);
  }

  hid_t id() const { return set_; }

 private:
  /// Most bytes that one compressed byte of the file may expand to.
  static constexpr hsize_t most_compressed = 64;
  /// Bytes; data up to this size may compress better, because all its numbers may be equal.
  static constexpr hsize_t small = 1 << 16;

  hsize_t bytes_of_file() const {
    std::error_code code;
    const std::uintmax_t bytes = std::filesystem::file_size(name_, code);
    return code ? 0 : bytes;
  }

  /// The chunk size, because HDF5 reads whole chunks and these may be larger than the set. 0 if the set is
  /// not chunked.
  hsize_t chunk_bytes(hid_t creation, hsize_t element) const {
    if (H5Pget_layout(creation) != H5D_CHUNKED) return 0;
    std::array<hsize_t, H5S_MAX_RANK> sides{};
    const int rank = H5Pget_chunk(creation, H5S_MAX_RANK, sides.data());
    hsize_t bytes = element;
    for (int i = 0; i < rank; ++i) {
      if (sides[i] == 0 || sides[i] > std::numeric_limits<hsize_t>::max() / bytes)
        fail("has no sensible size");
      bytes *= sides[i];
    }
    return bytes;
  }

  std::string name_, where_;
  Handle set_;
};

/// The type of the elements of a set, which must be a number type.
Handle type_of_numbers(const DataSet& set, H5T_class_t kind) {
  Handle stored(H5Dget_type(set.id()), H5Tclose);
  const H5T_class_t found = H5Tget_class(stored);
  if (found != kind && !(kind == H5T_FLOAT && found == H5T_INTEGER))
    set.fail(kind == H5T_FLOAT ? "expected numbers" : "expected integers");
  if (H5Tget_size(stored) > sizeof(long double)) set.fail("has numbers of a size that nobody writes");
  return stored;
}

template <typename Number>
std::vector<Number> read(const DataSet& set, H5T_class_t kind, hid_t type) {
  std::vector<Number> numbers(set.count(type_of_numbers(set, kind)));
  if (!numbers.empty() && H5Dread(set.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
    set.fail("cannot be read");
  return numbers;
}

void write_set(hid_t file, const std::string& name, const std::string& path, hid_t type, hid_t space,
               const void* data) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose), creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  H5Pset_obj_track_times(creation, false);
  const Handle set(H5Dcreate2(file, path.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose);
  if (set < 0 || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    throw std::runtime_error(fmt::format("{}: {}: cannot be written", name, path));
}

template <typename Number>
void write_numbers(hid_t file, const std::string& name, const std::string& path, hid_t type,
                   const std::vector<Number>& numbers) {
  const hsize_t count = numbers.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  write_set(file, name, path, type, space, numbers.data());
}

}  // namespace

bool has_hdf5() { return true; }

Hdf5File Hdf5File::open(const std::string& name) {
  be_silent();
  std::error_code code;  // the library would wait forever on a pipe without a writer
  const hid_t file = std::filesystem::is_regular_file(name, code)
                         ? H5Fopen(name.c_str(), H5F_ACC_RDONLY, without_locks())
                         : H5I_INVALID_HID;
  if (file < 0) throw std::runtime_error(fmt::format("{}: cannot be opened as an HDF5 file", name));
  return {name, file};
}

Hdf5File Hdf5File::create(const std::string& name) {
  be_silent();
  const hid_t file = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, without_locks());
  if (file < 0) throw std::runtime_error(fmt::format("cannot write {}: no such file can be made", name));
  return {name, file};
}

Hdf5File::~Hdf5File() {
  if (handle_ >= 0) H5Fclose(handle_);
}

bool Hdf5File::has(const std::string& path) const {
  // Check each link of the path, because H5Lexists fails if a group on the path is missing.
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(handle_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::size_t Hdf5File::count(const std::string& path) const {
  const DataSet set(handle_, name_, path);
  return set.count(type_of_numbers(set, H5T_FLOAT));
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& path) const {
  return read<std::int64_t>(DataSet(handle_, name_, path), H5T_INTEGER, H5T_NATIVE_INT64);
}

std::vector<double> Hdf5File::doubles(const std::string& path) const {
  auto numbers = read<double>(DataSet(handle_, name_, path), H5T_FLOAT, H5T_NATIVE_DOUBLE);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      throw std::runtime_error(fmt::format("{}: {}: number {} is not finite", name_, path, i));
  return numbers;
}

std::string Hdf5File::text(const std::string& path) const {
  if (!has(path)) return {};
  const DataSet set(handle_, name_, path);
  const Handle type(H5Dget_type(set.id()), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || set.count(type) != 1) return {};
  std::string result(H5Tget_size(type), '\0');
  if (H5Dread(set.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) < 0) return {};
  return result.c_str();
}

void Hdf5File::write(const std::string& path, const std::vector<double>& numbers) {
  write_numbers(handle_, name_, path, H5T_NATIVE_DOUBLE, numbers);
}

void Hdf5File::write(const std::string& path, const std::vector<std::int32_t>& numbers) {
  write_numbers(handle_, name_, path, H5T_NATIVE_INT32, numbers);
}

void Hdf5File::write(const std::string& path, const std::vector<std::int64_t>& numbers) {
  write_numbers(handle_, name_, path, H5T_NATIVE_INT64, numbers);
}

void Hdf5File::write(const std::string& path, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type, text.size() + 1);
  write_set(handle_, name_, path, type, space, text.c_str());
}

void Hdf5File::write(const std::string& path, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  bytes.reserve(longest * texts.size());
  for (std::string text : texts) {
    text.resize(longest, '\0');
    bytes += text;
  }
  const hsize_t count = texts.size();
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  H5Tset_size(type, longest);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  write_set(handle_, name_, path, type, space, bytes.data());
}

#else

namespace {

[[noreturn]] void refuse(const std::string& name) {
  throw std::runtime_error(
      fmt::format("{}: this flyrock was built without HDF5 (Debian: libhdf5-dev)", name));
}

}  // namespace

bool has_hdf5() { return false; }
Hdf5File Hdf5File::open(const std::string& name) { refuse(name); }
Hdf5File Hdf5File::create(const std::string& name) { refuse(name); }
Hdf5File::~Hdf5File() = default;
bool Hdf5File::has(const std::string&) const { refuse(name_); }
std::vector<std::int64_t> Hdf5File::integers(const std::string&) const { refuse(name_); }
std::vector<double> Hdf5File::doubles(const std::string&) const { refuse(name_); }
std::size_t Hdf5File::count(const std::string&) const { refuse(name_); }
std::string Hdf5File::text(const std::string&) const { refuse(name_); }
void Hdf5File::write(const std::string&, const std::vector<double>&) { refuse(name_); }
void Hdf5File::write(const std::string&, const std::vector<std::int32_t>&) { refuse(name_); }
void Hdf5File::write(const std::string&, const std::vector<std::int64_t>&) { refuse(name_); }
void Hdf5File::write(const std::string&, const std::vector<std::string>&) { refuse(name_); }
void Hdf5File::write(const std::string&, const std::string&) { refuse(name_); }

#endif

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : name_(std::move(other.name_)), handle_(std::exchange(other.handle_, -1)) {}

std::int64_t Hdf5File::integer(const std::string& path) const {
  const std::vector<std::int64_t> numbers = integers(path);
  if (numbers.size() != 1)
    throw std::runtime_error(
        fmt::format("{}: {}: expected one integer, found {}", name_, path, numbers.size()));
  return numbers.front();
}

}  // namespace flyrock
