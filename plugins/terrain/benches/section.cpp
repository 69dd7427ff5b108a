#include "plugins/terrain/benches/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plugin/params.h"

namespace flyrock::plugins {

namespace {

constexpr std::array<const char*, 8> part_names{"face", "berm",       "floor",      "ditch",
                                                "bund", "notch_back", "notch_base", "notch_end"};

/// The horizontal run of a slope [m]; 0 for an upright one.
double run_of(double height, double slope) {
  return height * std::max(0.0, std::cos(slope)) / std::sin(slope);
}

class Builder {
 public:
  explicit Builder(const BenchNumbers& numbers) : numbers_(numbers) {
    section_.parts = {"face", "berm", "floor"};
    if (numbers.ditch) section_.parts.push_back(part_names[3]);
    if (numbers.bund) section_.parts.push_back(part_names[4]);
    if (numbers.notch) section_.parts.insert(section_.parts.end(), part_names.begin() + 5, part_names.end());
  }

  Section build() {
    const BenchNumbers& n = numbers_;
    const double run = run_of(n.height, n.face_angle);
    section_.points.emplace_back(-n.top, n.count * n.height);
    go_to({0, n.count * n.height}, BenchPart::berm, 0);
    for (int below = n.count - 1; below >= 0; --below) {
      const int bench = n.count - below;
      const Vec2 crest = section_.points.back();
      if (n.notch && n.notch->bench == bench) {
        notch(*n.notch, {crest.x() + run, below * n.height});
        if (below > 0 && n.berm > 0) berm(bench);
        continue;
      }
      section_.crests.push_back(last());
      go_to({crest.x() + run, below * n.height}, BenchPart::face, bench);
      section_.toes.push_back(last());
      if (below > 0 && n.berm > 0) berm(bench);
    }
    const double end = section_.points.back().x() + n.floor;
    if (n.ditch) ditch(*n.ditch);
    if (n.bund && !n.bund->on_berms) {
      if (n.bund->distance > 0) go_by({n.bund->distance, 0}, BenchPart::floor, 0);
      bund(*n.bund, 0);
    }
    if (const double begin = section_.points.back().x(); !(begin < end))
      throw ParameterError(
          fmt::format("plugin benches: floor is {:.6g} m, the ditch and the bund on it take {:.6g} m: "
                      "expected a longer floor",
                      n.floor, begin - (end - n.floor)));
    go_to({end, 0}, BenchPart::floor, 0);
    return std::move(section_);
  }

 private:
  int last() const { return static_cast<int>(section_.points.size()) - 1; }

  void go_to(const Vec2& point, BenchPart part, int bench) {
    section_.points.push_back(point);
    section_.part.push_back(part);
    section_.bench.push_back(bench);
  }
  void go_by(const Vec2& step, BenchPart part, int bench) {
    go_to(section_.points.back() + step, part, bench);
  }

  /// The face of the bench gives way to the back and the base of its notch.
  void notch(const Notch& one, const Vec2& toe) {
    const Vec2 crest = section_.points.back();
    const double behind = crest.x() - section_.points[section_.points.size() - 2].x();
    if (!(one.depth < behind))
      throw ParameterError(
          fmt::format("plugin benches: notch.depth is {:.6g} m, the berm above bench {} is "
                      "{:.6g} m wide, expected less",
                      one.depth, one.bench, behind));
    const double cotangent = (toe.x() - crest.x()) / (crest.y() - toe.y()), slope = std::tan(one.base);
    const double rise = slope * one.depth / (1 - slope * cotangent);
    if (!(slope * cotangent < 1 && rise < crest.y() - toe.y()))
      throw ParameterError(
          fmt::format("plugin benches: notch.base is {:.6g} deg, so steep that its base comes "
                      "out above the bench, expected less",
                      one.base * 180 / pi));
    section_.points.back().x() -= one.depth;
    section_.crests.push_back(last());
    const int back = last();
    go_to({toe.x() - one.depth - rise * cotangent, toe.y() + rise}, BenchPart::notch_back, one.bench);
    section_.toes.push_back(last());
    go_to(toe, BenchPart::notch_base, one.bench);
    section_.notch = {back, back + 1, back + 2, crest};
  }

  void berm(int bench) {
    const bool has_bund = numbers_.bund && numbers_.bund->on_berms;
    if (!has_bund) return go_by({numbers_.berm, 0}, BenchPart::berm, bench);
    const double base = numbers_.bund->base();
    if (base > numbers_.berm)
      throw ParameterError(fmt::format("plugin benches: bund is {:.6g} m wide at its base, the berm {:.6g} m",
                                       base, numbers_.berm));
    if (base < numbers_.berm) go_by({numbers_.berm - base, 0}, BenchPart::berm, bench);
    bund(*numbers_.bund, bench);
  }

  void bund(const Bund& one, int bench) {
    const double run = run_of(one.height, one.slope);
    const double ground = section_.points.back().y();
    go_by({run, one.height}, BenchPart::bund, bench);
    if (one.top > 0) go_by({one.top, 0}, BenchPart::bund, bench);
    go_to({section_.points.back().x() + run, ground}, BenchPart::bund, bench);
  }

  void ditch(const Ditch& one) {
    go_by({run_of(one.depth, numbers_.face_angle), -one.depth}, BenchPart::ditch, 0);
    go_by({one.width, 0}, BenchPart::ditch, 0);
    go_to({section_.points.back().x() + run_of(one.depth, one.slope), 0}, BenchPart::ditch, 0);
  }

  const BenchNumbers& numbers_;
  Section section_;
};

void require(bool fine, const char* name, double value, const char* expected) {
  if (!fine)
    throw PluginError(fmt::format("plugin benches: {} is {:.6g}, must be {}", name, value, expected));
}

void check_slope(double slope, const char* name) {
  require(slope > 0 && slope <= pi / 2 * (1 + 1e-12), name, slope, "above 0 and at most pi/2 rad");
}

}  // namespace

double Bund::base() const { return top + 2 * run_of(height, slope); }

int Section::index_of(BenchPart one) const {
  const auto found = std::find(parts.begin(), parts.end(), part_names[static_cast<std::size_t>(one)]);
  return static_cast<int>(found - parts.begin());
}

Section section_of(const BenchNumbers& numbers) {
  require(numbers.count >= 1, "count", numbers.count, "at least 1");
  require(numbers.height > 0, "height", numbers.height, "above 0 m");
  check_slope(numbers.face_angle, "face_angle");
  require(numbers.berm >= 0, "berm", numbers.berm, "at least 0 m");
  require(numbers.floor > 0, "floor", numbers.floor, "above 0 m");
  require(numbers.top > 0, "top", numbers.top, "above 0 m");
  if (const auto& ditch = numbers.ditch) {
    require(ditch->width > 0, "ditch.width", ditch->width, "above 0 m");
    require(ditch->depth > 0, "ditch.depth", ditch->depth, "above 0 m");
    check_slope(ditch->slope, "ditch.slope");
  }
  if (const auto& bund = numbers.bund) {
    require(bund->height > 0, "bund.height", bund->height, "above 0 m");
    require(bund->top >= 0, "bund.top", bund->top, "at least 0 m");
    check_slope(bund->slope, "bund.slope");
    require(bund->base() > 0, "bund.top", bund->top, "above 0 m where its sides are upright");
    require(bund->distance >= 0, "bund.distance", bund->distance, "at least 0 m");
  }
  if (const auto& notch = numbers.notch) {
    if (notch->bench < 1 || notch->bench > numbers.count)
      throw ParameterError(fmt::format("plugin benches: notch.bench is {}, must be one of the {} benches",
                                       notch->bench, numbers.count));
    require(notch->depth > 0, "notch.depth", notch->depth, "above 0 m");
    require(notch->base >= 0 && notch->base < pi / 2, "notch.base", notch->base, "from 0 to below pi/2 rad");
    if (numbers.ditch) throw ParameterError("plugin benches: a `notch` goes with no `ditch`");
    if (numbers.bund && numbers.bund->on_berms)
      throw ParameterError("plugin benches: a `notch` goes with no `bund` on the berms");
  }
  return Builder(numbers).build();
}

std::string stretch_name(const Section& section, int stretch) {
  const char* part = part_names[static_cast<std::size_t>(section.part[stretch])];
  const int bench = section.bench[stretch];
  if (section.part[stretch] == BenchPart::berm && bench == 0) return "the berm behind the uppermost crest";
  if (bench == 0) return fmt::format("the {}", part);
  return fmt::format("the {} {} bench {}", part, section.part[stretch] == BenchPart::face ? "of" : "below",
                     bench);
}

}  // namespace flyrock::plugins
