#include "report/exports/dxf_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/value.h"

namespace flyrock {

namespace {

/// The three coordinates of a place: groups `10`, `20`, `30`.
std::string groups_of(const Vec3& place) {
  return fmt::format("10\n{}\n20\n{}\n30\n{}\n", shortest(place.x()), shortest(place.y()),
                     shortest(place.z()));
}

}  // namespace

void DxfFile::begin(const char* entity, const std::string& layer) {
  if (std::find(layers_.begin(), layers_.end(), layer) == layers_.end()) layers_.push_back(layer);
  entities_ += fmt::format("0\n{}\n8\n{}\n", entity, layer);
}

void DxfFile::add_place(const Vec3& place) {
  entities_ += groups_of(place);
  extent_.extend(place);
}

void DxfFile::add_point(const std::string& layer, const Vec3& place) {
  begin("POINT", layer);
  add_place(place);
}

void DxfFile::add_line(const std::string& layer, std::span<const Vec3> places, bool is_closed) {
  constexpr int closed_flag = 1, in_3d_flag = 8, vertex_in_3d_flag = 32;
  begin("POLYLINE", layer);
  entities_ +=
      fmt::format("66\n1\n70\n{}\n{}", in_3d_flag | (is_closed ? closed_flag : 0), groups_of(Vec3::Zero()));
  for (const Vec3& place : places) {
    begin("VERTEX", layer);
    add_place(place);
    entities_ += fmt::format("70\n{}\n", vertex_in_3d_flag);
  }
  begin("SEQEND", layer);
}

std::string DxfFile::text() const {
  constexpr std::size_t colours = 6;  // red, yellow, green, cyan, blue, magenta
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n";
  if (!extent_.isEmpty())
    text += fmt::format("9\n$EXTMIN\n{}9\n$EXTMAX\n{}", groups_of(extent_.min()), groups_of(extent_.max()));
  text += "0\nENDSEC\n";
  text += fmt::format("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n{}\n", layers_.size());
  for (std::size_t i = 0; i < layers_.size(); ++i)
    text += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layers_[i], 1 + i % colours);
  return text + "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities_ + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace flyrock
