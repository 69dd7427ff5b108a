#include <fmt/format.h>

#include <cmath>

#include "geometry/terrain_shape.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "plugins/terrain/benches/sweep.h"

namespace flyrock::plugins {

namespace {

constexpr double default_length = 100;  // m, along the crest

class Benches : public TerrainModel {
 public:
  explicit Benches(Params& params)
      : count_(params.slot("count")),
        height_(params.slot("height")),
        face_angle_(params.slot("face_angle")),
        berm_(params.slot("berm")),
        floor_(params.slot("floor")),
        top_(params.slot("top")),
        length_(params.slot("length")),
        azimuth_(params.slot("azimuth")),
        line_(params.points2("line")),
        ditch_{params.slot("ditch.width"), params.slot("ditch.depth"), params.slot("ditch.slope")},
        bund_{params.slot("bund.height"), params.slot("bund.top"), params.slot("bund.slope"),
              params.slot("bund.distance")},
        bund_on_berms_(params.text("bund.on") == "berm"),
        notch_{params.slot("notch.bench"), params.slot("notch.depth"), params.slot("notch.base"),
               params.slot("notch.from"), params.slot("notch.to")},
        roughness_{params.slot("roughness.sd"), params.slot("roughness.length"),
                   params.slot("roughness.hurst"), params.slot("roughness.cell")} {
    const bool has_line = params.given("line");
    for (const char* name : {"length", "azimuth", "line"})
      if (params.dimension() == 2 && params.given(name)) fail(fmt::format("`{}` needs dimension 3", name));
    for (const char* name : {"length", "azimuth"})
      if (has_line && params.given(name))
        fail(fmt::format("`line` says where the crest runs, expected it without `{}`", name));
    if (has_line && line_.size() < 2) fail("`line` needs at least two points");
    if (notch_[0] >= 0) check_notch(params);
    if (bund_on_berms_ && params.given("bund.distance")) fail("`distance` is only for a bund on the floor");
  }

  Profile build(Values values, RandomStream& rng) const override {
    return profile_of(section(values), roughness(values), rng);
  }

  TerrainShape3 build_3d(Values values, RandomStream& rng) const override {
    if (notch_[0] < 0) return mesh_of(section(values), crest(values), roughness(values), rng);
    const std::vector<Vec2> line = crest(values);
    return mesh_with_notch(section(values), line.front(), line.back(), values[notch_[3]], values[notch_[4]]);
  }

 private:
  [[noreturn]] static void fail(const std::string& text) { throw PluginError("plugin benches: " + text); }

  void check_notch(const Params& params) const {
    if (params.given("roughness.sd")) fail("a `notch` goes with no `roughness`");
    if (line_.size() > 2) fail("a `notch` needs a straight crest, expected a `line` of two points");
    const bool has_ends = params.given("notch.from") && params.given("notch.to");
    if (params.dimension() == 3 && !has_ends)
      fail("`notch` needs in 3D `from` and `to`, its ends along the crest");
    if (params.dimension() == 2 && (params.given("notch.from") || params.given("notch.to")))
      fail("`notch.from` and `notch.to` need dimension 3");
  }

  static double or_else(Values values, int slot, double otherwise) {
    return slot < 0 ? otherwise : values[slot];
  }

  Section section(Values values) const {
    BenchNumbers numbers;
    numbers.count = static_cast<int>(std::lround(values[count_]));
    numbers.height = values[height_];
    numbers.face_angle = values[face_angle_];
    numbers.berm = values[berm_];
    numbers.floor = values[floor_];
    numbers.top = or_else(values, top_, numbers.top);
    if (ditch_[0] >= 0) numbers.ditch = {values[ditch_[0]], values[ditch_[1]], values[ditch_[2]]};
    if (bund_[0] >= 0)
      numbers.bund = {values[bund_[0]], values[bund_[1]], values[bund_[2]], bund_on_berms_,
                      or_else(values, bund_[3], 0)};
    if (notch_[0] >= 0) {
      Notch& notch = numbers.notch.emplace();
      notch.bench = static_cast<int>(std::lround(values[notch_[0]]));
      notch.depth = values[notch_[1]];
      notch.base = values[notch_[2]];
    }
    return section_of(numbers);
  }

  /// The uppermost crest in plan. A straight one runs so that the faces to its right look to +x, turned by
  /// the azimuth.
  std::vector<Vec2> crest(Values values) const {
    if (!line_.empty()) return line_;
    const double length = or_else(values, length_, default_length);
    if (!(length > 0)) fail(fmt::format("length is {:.6g}, must be above 0 m", length));
    const Rotation2 turn = Rotation2::from_angle(or_else(values, azimuth_, 0));
    return {turn * Vec2(0, -length / 2), turn * Vec2(0, length / 2)};
  }

  std::optional<Roughness> roughness(Values values) const {
    if (roughness_[0] < 0) return std::nullopt;
    const double sd = values[roughness_[0]], length = values[roughness_[1]];
    const Roughness rough{sd, {length, values[roughness_[2]], or_else(values, roughness_[3], length / 4)}};
    if (!(sd >= 0)) fail(fmt::format("roughness.sd is {:.6g}, must be at least 0 m", sd));
    if (!(length > 0)) fail(fmt::format("roughness.length is {:.6g}, must be above 0 m", length));
    if (!(rough.spectrum.cell > 0))
      fail(fmt::format("roughness.cell is {:.6g}, must be above 0 m", rough.spectrum.cell));
    return rough;
  }

  int count_, height_, face_angle_, berm_, floor_, top_, length_, azimuth_;
  std::vector<Vec2> line_;
  int ditch_[3], bund_[4];
  bool bund_on_berms_;
  int notch_[5];
  int roughness_[4];
};

}  // namespace

std::unique_ptr<TerrainModel> make_benches(Params& params) { return std::make_unique<Benches>(params); }

}  // namespace flyrock::plugins
