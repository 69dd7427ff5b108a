#include "survey/point_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>

#include "plugin/params.h"
#include "plugin/words.h"
#include "survey/file_form.h"
#include "survey/projection_file.h"
#include "survey/xyz_lines.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::size_t most_points = 100'000'000;

class CloudFile {
 public:
  CloudFile(const std::string& who, const std::string& path)
      : who_(who), path_(path), file_(path, std::ios::binary | std::ios::ate) {
    if (!file_) throw PluginError(fmt::format("{}: cannot read the file {}", who, path));
    size_ = static_cast<std::uint64_t>(file_.tellg());
    file_.seekg(0);
  }

 protected:
  [[noreturn]] void fail(const std::string& text) const {
    throw PluginError(fmt::format("{}: {}: {}", who_, path_, text));
  }
  void add(const Vec3& place) {
    if (cloud_.points.size() >= most_points) fail(fmt::format("has more than {} points", most_points));
    cloud_.points.push_back(place);
  }

  std::string who_, path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  PointCloud cloud_;
};

// ---------------------------------------------------------------------------------------------------- LAS

/// Numbers of a file are little-endian, as those of the processors for which flyrock is built.
template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// The least length of a record of each point format, ASPRS LAS 1.4 R15, tables 7 to 17.
constexpr std::array<std::size_t, 11> least_lengths = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

class LasFile : CloudFile {
 public:
  using CloudFile::CloudFile;

  PointCloud read(std::optional<int> of_class) {
    read_head();
    read_system();
    read_points(of_class);
    return std::move(cloud_);
  }

 private:
  std::string bytes_of(std::uint64_t at, std::size_t count, const char* what) {
    if (at + count > size_) fail(fmt::format("is cut: {} is missing", what));
    std::string bytes(count, '\0');
    file_.seekg(static_cast<std::streamoff>(at));
    file_.read(bytes.data(), static_cast<std::streamsize>(count));
    return bytes;
  }

  void read_head() {
    constexpr std::size_t least_head = 227, head_of_1_4 = 375;
    const std::string begin = bytes_of(0, std::min<std::uint64_t>(size_, 4), "its head");
    if (begin != "LASF") fail("is no LAS file, which begins with `LASF`");
    std::string head = bytes_of(0, least_head, "its head");
    const int major = static_cast<unsigned char>(head[24]), minor = static_cast<unsigned char>(head[25]);
    if (major != 1 || minor > 4) fail(fmt::format("is LAS {}.{}, expected 1.2 to 1.4", major, minor));
    if (minor == 4) head = bytes_of(0, head_of_1_4, "its head");
    head_size_ = number_at<std::uint16_t>(head, 94);
    first_ = number_at<std::uint32_t>(head, 96);
    records_ = number_at<std::uint32_t>(head, 100);
    const unsigned format = static_cast<unsigned char>(head[104]);
    constexpr unsigned compressed = 0xc0;
    if ((format & compressed) != 0) refuse_compressed();
    if (format >= least_lengths.size())
      fail(fmt::format("has points of format {}, expected 0 to 10", format));
    format_ = format;
    length_ = number_at<std::uint16_t>(head, 105);
    if (length_ < least_lengths[format_])
      fail(fmt::format("has records of {} bytes, expected at least {} in format {}", length_,
                       least_lengths[format_], format_));
    count_ = number_at<std::uint32_t>(head, 107);
    if (minor == 4 && number_at<std::uint64_t>(head, 247) > 0) count_ = number_at<std::uint64_t>(head, 247);
    for (int k = 0; k < 3; ++k) {
      scale_[k] = number_at<double>(head, 131 + 8 * static_cast<std::size_t>(k));
      offset_[k] = number_at<double>(head, 155 + 8 * static_cast<std::size_t>(k));
    }
    if (!scale_.allFinite() || !offset_.allFinite() || !(scale_.minCoeff() > 0))
      fail("has a scale or an offset that is no number above 0 in its head");
    if (first_ < head_size_ || count_ > (size_ - std::min<std::uint64_t>(first_, size_)) / length_)
      fail(fmt::format(
          "announces {} points of {} bytes from byte {} on, it ends at {}: it was cut, copy it again", count_,
          length_, first_, size_));
  }

  [[noreturn]] void refuse_compressed() const {
    const std::string stem = path_.substr(path_.rfind('/') + 1);
    fail(fmt::format(
        "is compressed (LAZ): `pdal translate {0} points.las` or `laszip -i {0} -o points.las` unpacks it",
        stem));
  }

  /// The system of coordinates, in well-known text or as keys of GeoTIFF.
  void read_system() {
    constexpr std::size_t record_head = 54;
    constexpr unsigned geo_keys = 34735, well_known_text = 2112;
    std::uint64_t at = head_size_;
    for (std::uint32_t i = 0; i < records_ && at + record_head <= first_; ++i) {
      const std::string head = bytes_of(at, record_head, "a record of its head");
      const std::size_t length = number_at<std::uint16_t>(head, 20);
      at += record_head;
      if (at + length > first_) return;
      const unsigned id = number_at<std::uint16_t>(head, 18);
      if (std::string_view(head).substr(2).starts_with("LASF_Projection")) {
        if (id == geo_keys) read_geo_keys(bytes_of(at, length, "its system"));
        if (id == well_known_text) read_text(bytes_of(at, length, "its system"));
      }
      at += length;
    }
  }

  void read_text(std::string text) {
    text.resize(std::min(text.find('\0'), text.size()));
    const Projection system = projection_of(text);
    if (system.is_geographic)
      fail("is in degrees, expected metres: project it first, for example with `pdal`");
    if (!system.fault.empty()) return;
    cloud_.crs = system.crs;
    cloud_.plan_unit = system.plan_unit;
  }

  void read_geo_keys(const std::string& bytes) {
    constexpr unsigned model_type = 1024, projected_code = 3072, linear_unit = 3076;
    constexpr unsigned geographic = 2, metre = 9001, foot = 9002, us_foot = 9003;
    for (std::size_t at = 8; at + 8 <= bytes.size(); at += 8) {
      const unsigned key = number_at<std::uint16_t>(bytes, at),
                     place = number_at<std::uint16_t>(bytes, at + 2),
                     value = number_at<std::uint16_t>(bytes, at + 6);
      if (place != 0) continue;  // no short number
      if (key == model_type && value == geographic)
        fail("is in degrees, expected metres: project it first, for example with `pdal`");
      if (key == projected_code && value > 0 && value < 32767) cloud_.crs = fmt::format("EPSG:{}", value);
      if (key == linear_unit)
        cloud_.plan_unit = value == metre ? "m" : value == foot ? "ft" : value == us_foot ? "us_ft" : "";
    }
  }

  void read_points(std::optional<int> of_class) {
    constexpr std::size_t bytes_of_block = 1 << 20;
    const bool is_new_form = format_ >= 6;
    const std::size_t per_block = std::max<std::size_t>(bytes_of_block / length_, 1);
    std::map<int, std::size_t> counts;
    cloud_.all = count_;
    for (std::uint64_t done = 0; done < count_; done += per_block) {
      const std::size_t here = static_cast<std::size_t>(std::min<std::uint64_t>(per_block, count_ - done));
      const std::string block = bytes_of(first_ + done * length_, here * length_, "a block of points");
      for (std::size_t i = 0; i < here; ++i) {
        const std::size_t at = i * length_;
        const unsigned char code = static_cast<unsigned char>(block[at + (is_new_form ? 16 : 15)]);
        const bool is_withheld =
            is_new_form ? (static_cast<unsigned char>(block[at + 15]) & 4) != 0 : (code & 0x80) != 0;
        const int group = is_new_form ? code : code & 0x1f;
        if (is_withheld) continue;
        ++counts[group];
        if (of_class && group != *of_class) continue;
        Vec3 place;
        for (int k = 0; k < 3; ++k)
          place[k] =
              offset_[k] + scale_[k] * number_at<std::int32_t>(block, at + 4 * static_cast<std::size_t>(k));
        add(place);
      }
    }
    say_classes(counts, of_class);
  }

  void say_classes(const std::map<int, std::size_t>& counts, std::optional<int> of_class) {
    std::string list;
    for (const auto& [group, count] : counts)
      list += fmt::format("{}{} ({} points)", list.empty() ? "" : ", ", group, count);
    if (of_class && !counts.contains(*of_class))
      fail(list.empty() ? std::string("has no point")
                        : fmt::format("has no point of class {}, it has {}", *of_class, list));
    if (!of_class && counts.size() > 1)
      cloud_.notes.push_back(
          fmt::format("all its points count, of the classes {}: `class: 2` takes the ground alone", list));
  }

  std::uint32_t head_size_ = 0, records_ = 0;
  std::uint64_t first_ = 0, count_ = 0;
  std::size_t format_ = 0, length_ = 0;
  Vec3 scale_ = Vec3::Ones(), offset_ = Vec3::Zero();
};

// ---------------------------------------------------------------------------------------------------- XYZ

class XyzFile : CloudFile {
 public:
  using CloudFile::CloudFile;

  PointCloud read() {
    std::int64_t number = 0;
    for (std::string line; std::getline(file_, line);) {
      ++number;
      if (number == 1 && is_utf16(line)) fail(save_as_utf8);
      if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
      try {
        if (const std::optional<Vec3> place = lines_.read(line)) add(*place);
      } catch (const std::invalid_argument& wrong) {
        throw PluginError(fmt::format("{}: {}:{}: {}", who_, path_, number, wrong.what()));
      }
    }
    cloud_.all = cloud_.points.size();
    if (cloud_.points.empty()) fail("has no point");
    if (const std::string wrong = lines_.fault(); !wrong.empty()) fail(wrong);
    if (const std::string note = lines_.note(); !note.empty()) cloud_.notes.push_back(note);
    cloud_.plan_unit = lines_.unit();
    return std::move(cloud_);
  }

 private:
  XyzLines lines_;
};

}  // namespace

bool is_point_cloud(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".xyz" || ending == ".pts" || ending == ".las" || ending == ".laz";
}

PointCloud read_point_cloud(const std::string& who, const std::string& path, std::optional<int> of_class) {
  const std::string ending = ending_of(path);
  if (ending == ".las" || ending == ".laz") return LasFile(who, path).read(of_class);
  // Text has any ending; CloudCompare's is .asc.
  if (const std::string other = other_form(path, "points"); !other.empty() && ending != ".asc")
    throw PluginError(fmt::format("{}: {}: {}", who, path, other));
  if (of_class) throw PluginError(fmt::format("{}: {}: has no classes, leave `class` out", who, path));
  return XyzFile(who, path).read();
}

}  // namespace flyrock
