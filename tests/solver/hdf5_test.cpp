// Files of HDF5 that promise more than they hold: a few kB of header that ask for gigabytes are refused
// before memory is.

#ifdef FLYROCK_HAS_HDF5

#include <hdf5.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "solver/hdf5_file.h"

using namespace flyrock;
namespace fs = std::filesystem;

namespace {

/// A file with one set of doubles, `numbers`, as the library writes it, removed at the end.
struct HostileFile {
  std::string name =
      (fs::temp_directory_path() / ("flyrock_hdf5_" + std::to_string(::getpid()) + ".hdf5")).string();

  /// `count` numbers of which `written` are in the file; chunks of `chunk` numbers, 0 for none; compressed or
  /// not.
  HostileFile(hsize_t count, std::vector<double> written, hsize_t chunk, bool compressed) {
    const hid_t file = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t unlimited = H5S_UNLIMITED;
    const hid_t space = H5Screate_simple(1, &count, chunk > 0 ? &unlimited : nullptr),
                creation = H5Pcreate(H5P_DATASET_CREATE);
    if (chunk > 0) H5Pset_chunk(creation, 1, &chunk);
    if (compressed) H5Pset_deflate(creation, 6);
    const hid_t set =
        H5Dcreate2(file, "numbers", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    REQUIRE(set >= 0);
    const hsize_t first = 0, some = written.size();
    const hid_t memory = H5Screate_simple(1, &some, nullptr);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &some, nullptr);
    REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, written.data()) >= 0);
    H5Sclose(memory), H5Dclose(set), H5Pclose(creation), H5Sclose(space), H5Fclose(file);
  }
  ~HostileFile() { fs::remove(name); }
  HostileFile(const HostileFile&) = delete;
  HostileFile& operator=(const HostileFile&) = delete;
};

std::string refusal(const HostileFile& file) {
  try {
    Hdf5File::open(file.name).doubles("numbers");
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).substr(file.name.size() + 2);
  }
  return "";
}

constexpr const char* too_many = "numbers: promises more numbers than the file has bytes for";

}  // namespace

TEST_CASE("a set of numbers that the bytes of its file cannot stand for is refused before memory is taken") {
  // 2 GB from a file of some kB: one chunk is there.
  CHECK(refusal({hsize_t{1} << 28, std::vector<double>(100, 1.0), 100, false}) == too_many);
  CHECK(refusal({hsize_t{1} << 40, std::vector<double>(100, 1.0), 100, true}) == too_many);
  // Compressed several hundredfold: 1 MB of zeros.
  CHECK(refusal({1 << 17, std::vector<double>(1 << 17, 0.0), 1 << 15, true}) == too_many);
  // Ten numbers in a chunk of 2 MB, which the library would make whole.
  CHECK(refusal({10, std::vector<double>(10, 1.0), 1 << 18, true}) == too_many);
}

TEST_CASE("a set whose numbers have no size is refused") {
  const HostileFile file(10, std::vector<double>(10, 1.0), 0, false);
  std::ifstream stream(file.name, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const std::string type("\x11\x20\x3f\0\x08\0\0\0",
                         8);  // the message of the type: a double, little-endian, of 8 bytes
  const std::size_t at = bytes.find(type);
  REQUIRE(at != std::string::npos);
  bytes[at + 4] = 0;
  std::ofstream(file.name, std::ios::binary) << bytes;
  CHECK(refusal(file) == "numbers: has numbers of no size");
}

TEST_CASE("sets in chunks, compressed ones too, are read where their numbers are in the file") {
  std::vector<double> numbers(10'000);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  for (const bool compressed : {false, true}) {
    const HostileFile file(numbers.size(), numbers, 1000, compressed);
    const Hdf5File open = Hdf5File::open(file.name);
    CHECK(open.count("numbers") == numbers.size());
    CHECK(open.doubles("numbers") == numbers);
  }
  const HostileFile equal(10, std::vector<double>(10, 2.0), 1000, true);
  CHECK(Hdf5File::open(equal.name).doubles("numbers") == std::vector<double>(10, 2.0));
}

TEST_CASE("numbers of another file are refused, and a text is read only where it is one") {
  const std::string name =
      (fs::temp_directory_path() / ("flyrock_hdf5_other_" + std::to_string(::getpid()))).string();
  std::ofstream(name) << std::string(80, 'x');
  const hid_t file = H5Fcreate((name + ".hdf5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t ten = 10;
  const hid_t space = H5Screate_simple(1, &ten, nullptr), creation = H5Pcreate(H5P_DATASET_CREATE),
              text = H5Tcopy(H5T_C_S1);
  H5Pset_external(creation, name.c_str(), 0, 80);
  H5Dclose(H5Dcreate2(file, "numbers", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Tset_size(text, 8);
  const hid_t texts = H5Dcreate2(file, "texts", text, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  REQUIRE(H5Dwrite(texts, text, H5S_ALL, H5S_ALL, H5P_DEFAULT, std::string(80, 't').c_str()) >= 0);
  H5Dclose(texts), H5Tclose(text), H5Pclose(creation), H5Sclose(space), H5Fclose(file);
  const Hdf5File open = Hdf5File::open(name + ".hdf5");
  CHECK_THROWS_WITH(open.doubles("numbers"), Catch::EndsWith("numbers: has its numbers in another file"));
  CHECK(open.text("texts").empty());
  fs::remove(name);
  fs::remove(name + ".hdf5");
}

#endif
